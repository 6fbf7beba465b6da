//! What one test asks.

use crate::question::sanitized::SANITIZED;
use crate::question::{Answer, Question};
use crate::report::Skipped;
use lobe_backends::executor::{Executor, Interp, Native};
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::{Machine, OpenError};
use std::cell::LazyCell;

/// What one test asks of a kernel, by the test's name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Asked {
    Correct,
    Robust,
    Sanitized,
    Conformant(Route),
    Agree,
}

/// The driver that stands for the first that is hardware.
const HARDWARE: &str = "gpu";

/// The names of roads in names of tests.
const ROADS: [(&str, Road); Road::ALL.len()] = [
    ("spirv_", Road::Spirv),
    ("wgsl_naga_", Road::WgslNaga),
    ("hlsl_dxc_", Road::HlslDxc),
    ("hlsl_slang_", Road::HlslSlang),
    ("wgsl_tint_", Road::WgslTint),
    // Before the road whose name it begins with.
    ("glsl_glslang_", Road::GlslGlslang),
    ("glsl_", Road::Glsl),
];

impl Asked {
    pub(super) fn of(test: &str) -> Result<Self, String> {
        match test {
            "correct" => Ok(Self::Correct),
            "robust" => Ok(Self::Robust),
            "sanitized" => Ok(Self::Sanitized),
            "agree" => Ok(Self::Agree),
            _ => route(test).map(Self::Conformant),
        }
    }

    /// Whether an answer is one to it.
    pub(super) fn is_answered_by(&self, answer: &Answer) -> bool {
        match self {
            Self::Correct => answer.question == Question::Correct,
            Self::Robust => answer.question == Question::Robust && answer.subject.is_empty(),
            Self::Sanitized => answer.subject == SANITIZED,
            Self::Conformant(_) => answer.question == Question::Conformant,
            Self::Agree => answer.question == Question::Agree,
        }
    }

    /// Opens the routes that it needs, of those that the tests are for, and no device beside them.
    pub(super) fn open(&self, routes: &[&str]) -> Result<Opened, String> {
        let mut opened = Opened::default();
        match self {
            Self::Correct => opened.executors.push(Box::new(Native)),
            Self::Robust | Self::Sanitized => {}
            Self::Conformant(route) => opened.take(vec![route.clone()])?,
            Self::Agree => opened.take(routes.iter().map(|name| route(name)).collect::<Result<_, _>>()?)?,
        }
        Ok(opened)
    }
}

/// The route that a test is named after: `hlsl_dxc_lavapipe` is `hlsl+dxc@lavapipe`.
pub(super) fn route(test: &str) -> Result<Route, String> {
    let gpu = ROADS.iter().find_map(|(prefix, road)| Some((*road, test.strip_prefix(prefix)?)));
    match (test, gpu) {
        ("native", _) => Ok(Route::Native),
        ("interp", _) => Ok(Route::Interp),
        (_, Some((road, driver))) if !driver.is_empty() => {
            Ok(Route::Gpu { road, driver: driver.replace('_', "-") })
        }
        _ => Err(format!(
            "`{test}` names no route; write native, interp, or spirv_, wgsl_naga_, wgsl_tint_, hlsl_dxc_, hlsl_slang_, \
             glsl_glslang_ or glsl_ and a driver, as spirv_lavapipe or spirv_gpu, the first driver of hardware \
             (`lobe doctor` lists those of this machine)"
        )),
    }
}

/// Opened routes, and those that are missing.
#[derive(Default)]
pub(super) struct Opened {
    pub(super) executors: Vec<Box<dyn Executor>>,
    pub(super) skipped: Vec<Skipped>,
}

impl Opened {
    fn take(&mut self, routes: Vec<Route>) -> Result<(), String> {
        let machine = LazyCell::new(Machine::look);
        for route in routes {
            let opened = match route {
                Route::Native => Ok(Box::new(Native) as Box<dyn Executor>),
                Route::Interp => Ok(Box::new(Interp) as Box<dyn Executor>),
                Route::Gpu { .. } => open(route, &machine),
            };
            match opened {
                Ok(executor) => self.executors.push(executor),
                Err(OpenError::Missing { route, what, mend }) => {
                    self.skipped.push(Skipped { route: route.to_string(), what, mend });
                }
                Err(error @ OpenError::Driver { .. }) => return Err(error.to_string()),
            }
        }
        Ok(())
    }
}

/// Opens `route`, by the first driver of hardware where that is meant.
fn open(route: Route, machine: &Machine) -> Result<Box<dyn Executor>, OpenError> {
    let Route::Gpu { road, driver } = route else { return machine.open(&route) };
    if driver != HARDWARE {
        return machine.open(&Route::Gpu { road, driver });
    }
    match machine.drivers_of(road.api()).iter().find(|driver| !driver.is_software) {
        Some(found) => machine.open(&Route::Gpu { road, driver: found.name.clone() }),
        None => Err(OpenError::Missing {
            route: Route::Gpu { road, driver },
            what: format!("no {} driver of hardware was found", road.api()),
            mend: "install your graphics card's, or leave its tests out with `routes = [..]`".to_owned(),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_named_after_routes() {
        for (test, name) in [
            ("native", "native"),
            ("interp", "interp"),
            ("spirv_lavapipe", "spirv@lavapipe"),
            ("wgsl_naga_swiftshader", "wgsl+naga@swiftshader"),
            ("hlsl_dxc_nvidia_h100", "hlsl+dxc@nvidia-h100"),
            ("hlsl_slang_lavapipe", "hlsl+slang@lavapipe"),
            ("glsl_glslang_lavapipe", "glsl+glslang@lavapipe"),
            ("wgsl_tint_lavapipe", "wgsl+tint@lavapipe"),
            ("glsl_llvmpipe", "glsl@llvmpipe"),
        ] {
            assert_eq!(route(test).map(|route| route.to_string()), Ok(name.to_owned()));
        }
        for test in ["metal_m1", "spirv_", "spirv", ""] {
            assert!(route(test).is_err_and(|why| why.contains("names no route")), "{test}");
        }
    }
}
