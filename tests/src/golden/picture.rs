//! A case, opened: what it depends on, its truth with what is permitted, and what routes make of it.

use super::cases::{Case, Subject, open_scene};
use super::truth::{Finals, Listing, Truth};
use super::{Axis, Routes, plot};
use crate::measure::source;
use crate::proxies::Proxies;
use crate::render::{Renderer, Settings};
use crate::scene::Scene;
use lobe_backends::executor::Program;
use lobe_backends::pipeline::Pass;
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_golden::image::Picture;
use lobe_golden::{Chain, Golden, Hash, Kernel};
use std::collections::BTreeMap;

/// A case, opened.
pub struct Opened<'r> {
    size: [u32; 2],
    chain: Chain,
    shown: Shown<'r>,
}

enum Shown<'r> {
    Render { renderer: &'r Renderer, scene: Box<Scene>, proxies: Box<Proxies>, settings: Settings },
    Plot { program: Box<Program>, args: Columns },
}

impl<'r> Opened<'r> {
    /// Opens a case.
    ///
    /// # Errors
    /// When its scene or kernel is not there, or is something else, in words.
    pub fn new(case: &Case, renderer: &'r Renderer) -> Result<Self, String> {
        match &case.subject {
            Subject::Render { file, settings } => {
                let (scene, proxies, hash) = open_scene(file, case.size)?;
                let (scene, proxies) = (Box::new(scene), Box::new(proxies));
                let shown = Shown::Render { renderer, scene, proxies, settings: *settings };
                let mut opened =
                    Self { size: case.size, chain: Chain::new(None, case.settings_hash(), vec![]), shown };
                opened.chain = Chain::new(Some(hash), case.settings_hash(), opened.passes()?);
                Ok(opened)
            }
            Subject::Plot { kernel, columns, rows, fixed } => {
                Self::of_plot(case, plot::program(kernel)?, [columns, rows], fixed)
            }
        }
    }

    /// Opens a plot of another kernel than its own, with the same arguments: for tests of what notices a change.
    ///
    /// # Errors
    /// When the case is no plot, or the kernel has other arguments.
    #[doc(hidden)]
    pub fn of_program(case: &Case, program: Program) -> Result<Self, String> {
        match &case.subject {
            Subject::Plot { columns, rows, fixed, .. } => {
                Self::of_plot(case, program, [columns, rows], fixed)
            }
            Subject::Render { .. } => Err(format!("{} is no plot", case.name)),
        }
    }

    fn of_plot(
        case: &Case,
        program: Program,
        axes: [&Axis; 2],
        fixed: &BTreeMap<String, f64>,
    ) -> Result<Self, String> {
        let args = plot::arguments(&program, case.size, axes, fixed)?;
        let kernels = vec![kernel(program.name(), program.module(), true)?];
        let chain = Chain::new(None, case.settings_hash(), kernels);
        Ok(Self { size: case.size, chain, shown: Shown::Plot { program: Box::new(program), args } })
    }

    /// What the picture depends on.
    #[must_use]
    pub fn chain(&self) -> &Chain {
        &self.chain
    }

    /// The passes, in the order in which each runs first.
    fn passes(&self) -> Result<Vec<Kernel>, String> {
        let Shown::Render { renderer, scene, proxies, settings } = &self.shown else { return Ok(Vec::new()) };
        let mut listing = Listing::default();
        let told = |error: lobe_backends::executor::ExecError| error.to_string();
        renderer.render(scene, proxies, settings, &mut listing, &|_| {}).map_err(told)?;
        let last = settings.method.last_passes(&settings.virtual_lights);
        let of = |name: &&str| -> Result<Kernel, String> {
            let pass = renderer.pipeline().pass(name).map_err(told)?;
            kernel(name, pass.module(), last.contains(name))
        };
        listing.passes.iter().map(of).collect()
    }

    /// The true picture and what is permitted.
    ///
    /// # Errors
    /// When it cannot be computed, in words.
    pub fn truth(&self) -> Result<Golden, String> {
        match &self.shown {
            Shown::Plot { program, args } => plot::truth(program, args, self.size),
            Shown::Render { renderer, scene, proxies, settings } => {
                let mut truth = Truth::new(settings.method.last_passes(&settings.virtual_lights));
                let done = renderer.render(scene, proxies, settings, &mut truth, &|_| {});
                done.map_err(|error| error.to_string())?;
                truth.golden(renderer.pipeline(), self.size)
            }
        }
    }

    /// What a route makes of it; the passes before the last ones run on the interpreter.
    ///
    /// # Errors
    /// When it does not run there, in words.
    pub fn picture(&self, routes: &mut Routes<'r>, at: usize) -> Result<Picture, String> {
        match &self.shown {
            Shown::Plot { program, args } => {
                let found = routes.executor(at)?.run(program, args).map_err(|error| error.to_string())?;
                plot::picture(&found, self.size)
            }
            Shown::Render { renderer, scene, proxies, settings } => {
                let last = settings.method.last_passes(&settings.virtual_lights);
                let mut finals = Finals::new(last, routes.dispatcher(at)?);
                let done = renderer.render(scene, proxies, settings, &mut finals, &|_| {});
                let picture = done.map_err(|error| error.to_string())?;
                let values = picture.radiance.iter().flat_map(|pixel| pixel.to_array()).collect();
                Ok(Picture { size: picture.size, values })
            }
        }
    }

    /// Whether a route runs passes where this is one of a scene: native code runs none.
    #[must_use]
    pub fn is_render(&self) -> bool {
        matches!(self.shown, Shown::Render { .. })
    }

    /// The hash of what a target is given of the kernels that are judged.
    ///
    /// # Errors
    /// When they cannot be emitted, in words.
    pub fn emitted(&self, target: Target) -> Result<Hash, String> {
        let mut bytes = Vec::new();
        match &self.shown {
            Shown::Plot { program, .. } => {
                let artifact = program.artifact(target).map_err(|error| error.to_string())?;
                bytes.extend(artifact.content.bytes());
            }
            Shown::Render { renderer, settings, .. } => {
                for name in settings.method.last_passes(&settings.virtual_lights) {
                    let pass: &Pass = renderer.pipeline().pass(name).map_err(|error| error.to_string())?;
                    let artifact = emit(pass.module(), target, &Options::default());
                    bytes.extend(artifact.map_err(|error| error.to_string())?.content.bytes());
                }
            }
        }
        Ok(Hash::of(&bytes))
    }
}

fn kernel(name: &str, module: &ValidModule, is_judged: bool) -> Result<Kernel, String> {
    let text = source(module).map_err(|error| format!("{name}: {error}"))?;
    Ok(Kernel { name: name.to_owned(), module: Hash::of(text.as_bytes()), is_judged })
}
