//! Passes on a driver: what is emitted of them, translated and dispatched.

use super::{Access, Dispatcher, Memory, Pass, PassBuffer};
use crate::executor::{ExecError, Source};
use crate::gpu::{AnyGpu, Binding, BindingKind, Job};
use crate::route::{Road, Route};
use crate::translate::Translators;
use std::sync::Arc;

/// Runs passes on one driver, through one target and translator.
pub struct OnDriver {
    route: Route,
    road: Road,
    gpu: AnyGpu,
    translators: Arc<Translators>,
}

impl OnDriver {
    /// The route by `road` to the device `gpu`, which is Dawn's for [`Road::WgslTint`], through the road's own of
    /// `translators`.
    #[must_use]
    pub fn new(route: Route, road: Road, gpu: AnyGpu, translators: Arc<Translators>) -> Self {
        Self { route, road, gpu, translators }
    }
}

impl<'p> Dispatcher<'p> for OnDriver {
    fn route(&self) -> &Route {
        &self.route
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        let source = Source { kernel: pass.name(), module: pass.module(), entry: pass.name() };
        let words = pass.artifacts.words(self.road, || source.words(self.road, &self.translators))?;
        let bytes = memory.of(pass)?;
        let bindings: Vec<Binding<'_>> =
            pass.buffers().iter().zip(bytes).map(|(at, data)| bind(at, data)).collect();
        let job = Job {
            shader: words.shader(),
            entry: self.road.target().entry_name(pass.name()),
            workgroup_size: pass.workgroup_size(),
            groups: pass.groups(invocations),
            bindings: &bindings,
            immediates: &[],
        };
        let outputs = self.gpu.run(&job).map_err(|cause| ExecError::Gpu { kernel: pass.name(), cause })?;
        let written = pass.buffers().iter().filter(|at| at.access == Access::ReadWrite);
        written.zip(outputs).for_each(|(at, bytes)| memory.put(&at.name, bytes));
        Ok(())
    }
}

fn bind<'m>(at: &PassBuffer, data: &'m [u8]) -> Binding<'m> {
    let kind = match at.access {
        Access::Uniform => BindingKind::Uniform,
        Access::Read => BindingKind::StorageRead,
        Access::ReadWrite => BindingKind::StorageReadWrite,
    };
    Binding { group: at.layout.group, binding: at.layout.binding, element: None, kind, data }
}

impl std::fmt::Debug for OnDriver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("OnDriver").field("route", &self.route).finish_non_exhaustive()
    }
}
