//! Which routes this machine has, which it lacks and why, and how one is opened.

use crate::executor::{Executor, GpuRoute, Interp, Native};
use crate::gpu::{self, AnyGpu, Api, DawnGpu, Driver, Gpu, GpuError};
use crate::pipeline::{Dispatcher, Interpreted, OnDriver};
use crate::route::{Road, Route};
use crate::translate::{Dawn, TranslateError, Translators};
use std::sync::{Arc, OnceLock};

/// The drivers that are spoken of even where they are missing, with the way to get them.
const EXPECTED: [(&str, Api, &str); 3] = [
    ("lavapipe", Api::Vulkan, "run tests/setup.sh, or install your system's mesa-vulkan-drivers package"),
    ("swiftshader", Api::Vulkan, "run tests/setup.sh"),
    (
        "llvmpipe",
        Api::OpenGl,
        "run tests/setup.sh, or install your system's EGL of Mesa (libegl1, libegl-mesa0)",
    ),
];

/// Whether a route can be taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum State {
    /// Everything that it needs was found.
    Ready,
    /// Something is missing.
    Missing {
        /// What.
        what: String,
        /// How to get it.
        mend: String,
    },
}

/// What was found on this machine. Finding it opens no device.
#[derive(Clone, Debug)]
pub struct Machine {
    drivers: Vec<Driver>,
    /// Looked for when first asked for: that takes a context.
    gl_drivers: OnceLock<Vec<Driver>>,
    translators: Arc<Translators>,
    dawn: Result<Dawn, TranslateError>,
}

/// Why a route was not opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// It is not there.
    #[error("the route {route} is missing: {what}; {mend}")]
    Missing {
        /// The route.
        route: Route,
        /// What is missing.
        what: String,
        /// How to get it.
        mend: String,
    },
    /// Its driver was found but does not open.
    #[error("the route {route} does not open: {cause}")]
    Driver {
        /// The route.
        route: Route,
        /// What happened.
        cause: GpuError,
    },
}

/// The routes of this machine, and the expected ones that it lacks.
#[must_use]
pub fn ready() -> Vec<(Route, State)> {
    Machine::look().routes()
}

impl Machine {
    /// Looks for drivers and translators.
    #[must_use]
    pub fn look() -> Self {
        Self {
            drivers: gpu::drivers(),
            gl_drivers: OnceLock::new(),
            translators: Arc::new(Translators::find()),
            dawn: Dawn::find(),
        }
    }

    /// The Vulkan drivers that were found.
    #[must_use]
    pub fn drivers(&self) -> &[Driver] {
        &self.drivers
    }

    /// The OpenGL drivers that were found.
    #[must_use]
    pub fn gl_drivers(&self) -> &[Driver] {
        self.gl_drivers.get_or_init(gpu::gl_drivers)
    }

    /// The compilers, each as it was found.
    #[must_use]
    pub fn translators(&self) -> &Arc<Translators> {
        &self.translators
    }

    /// Dawn, or why there is none.
    ///
    /// # Errors
    /// When it or node was not found, or is something else.
    pub fn dawn(&self) -> Result<&Dawn, &TranslateError> {
        self.dawn.as_ref()
    }

    /// Every route with its state: native and interp first, then driver by driver.
    #[must_use]
    pub fn routes(&self) -> Vec<(Route, State)> {
        let found = self.drivers.iter().chain(self.gl_drivers()).map(|d| (d.name.as_str(), d.api));
        let missing = EXPECTED.iter().map(|(name, api, _)| (*name, *api));
        let missing = missing.filter(|(name, api)| self.driver(*api, name).is_none());
        let names: Vec<(&str, Api)> = found.chain(missing).collect();
        let gpu = names.into_iter().flat_map(|(driver, api)| {
            let roads = Road::ALL.into_iter().filter(move |road| road.api() == api);
            roads.map(|road| Route::Gpu { road, driver: driver.to_owned() })
        });
        let all = [Route::Native, Route::Interp].into_iter().chain(gpu);
        all.map(|route| (route.clone(), self.state(&route))).collect()
    }

    /// Whether `route` can be taken.
    #[must_use]
    pub fn state(&self, route: &Route) -> State {
        let Route::Gpu { road, driver: name } = route else { return State::Ready };
        let Some(driver) = self.driver(road.api(), name) else { return self.no_driver(road.api(), name) };
        if road.ends_in_spirv() && !driver.has_passthrough {
            return State::Missing {
                what: format!("{name} takes no SPIR-V unchanged"),
                mend: format!("use wgsl+naga@{name}"),
            };
        }
        match road {
            Road::WgslTint => match self.twin(driver) {
                Some(twin) => State::Missing {
                    what: format!("Dawn knows devices by their names, and {name} has that of {twin}"),
                    mend: format!("use wgsl+tint@{twin}"),
                },
                None => of_tool(&self.dawn, "LOBE_DAWN to the folder of the npm package webgpu"),
            },
            Road::Spirv
            | Road::WgslNaga
            | Road::HlslDxc
            | Road::HlslSlang
            | Road::GlslGlslang
            | Road::Glsl => match self.translators.missing(*road) {
                Some((what, mend)) => State::Missing { what, mend: mend.to_owned() },
                None => State::Ready,
            },
        }
    }

    /// A driver that comes before `driver` and whose device has the same name.
    fn twin(&self, driver: &Driver) -> Option<&str> {
        let is_same =
            |d: &&Driver| d.adapter_name == driver.adapter_name && d.vulkan_icd == driver.vulkan_icd;
        self.drivers.iter().find(is_same).map(|first| first.name.as_str()).filter(|name| *name != driver.name)
    }

    /// Opens `route`, and its device if it has one.
    ///
    /// # Errors
    /// When something that it needs is missing, or the device does not open.
    pub fn open(&self, route: &Route) -> Result<Box<dyn Executor>, OpenError> {
        if let State::Missing { what, mend } = self.state(route) {
            return Err(OpenError::Missing { route: route.clone(), what, mend });
        }
        match route {
            Route::Native => Ok(Box::new(Native)),
            Route::Interp => Ok(Box::new(Interp)),
            Route::Gpu { road, driver } => {
                let Some(driver) = self.driver(road.api(), driver) else { return self.open(&Route::Interp) };
                let opened = self.device(*road, driver);
                let gpu = opened.map_err(|cause| OpenError::Driver { route: route.clone(), cause })?;
                let translators = Arc::clone(&self.translators);
                Ok(Box::new(GpuRoute::new(route.clone(), *road, gpu, translators)))
            }
        }
    }

    /// Opens `route` for passes. Native code runs none: its place is taken by the interpreter, which gives the same bits.
    ///
    /// # Errors
    /// When something that it needs is missing, or the device does not open.
    pub fn dispatcher<'p>(&self, route: &Route) -> Result<Box<dyn Dispatcher<'p> + 'p>, OpenError> {
        if let State::Missing { what, mend } = self.state(route) {
            return Err(OpenError::Missing { route: route.clone(), what, mend });
        }
        let Route::Gpu { road, driver: name } = route else { return Ok(Box::new(Interpreted::default())) };
        let Some(driver) = self.driver(road.api(), name) else { return self.dispatcher(&Route::Interp) };
        let opened = self.device(*road, driver);
        let gpu = opened.map_err(|cause| OpenError::Driver { route: route.clone(), cause })?;
        Ok(Box::new(OnDriver::new(route.clone(), *road, gpu, Arc::clone(&self.translators))))
    }

    /// Opens a device for `road`.
    ///
    /// # Errors
    /// When it does not open, or there is no Dawn to open it.
    pub fn device(&self, road: Road, driver: &Driver) -> Result<AnyGpu, GpuError> {
        match road {
            Road::Spirv
            | Road::WgslNaga
            | Road::HlslDxc
            | Road::HlslSlang
            | Road::GlslGlslang
            | Road::Glsl => Gpu::open(driver).map(|gpu| AnyGpu::Wgpu(Box::new(gpu))),
            Road::WgslTint => match &self.dawn {
                Ok(dawn) => DawnGpu::open(dawn, driver).map(|gpu| AnyGpu::Dawn(Box::new(gpu))),
                Err(error) => Err(GpuError::Open { driver: driver.name.clone(), reason: error.to_string() }),
            },
        }
    }

    /// The drivers that are reached by `api`.
    #[must_use]
    pub fn drivers_of(&self, api: Api) -> &[Driver] {
        match api {
            Api::Vulkan => &self.drivers,
            Api::OpenGl => self.gl_drivers(),
        }
    }

    fn driver(&self, api: Api, name: &str) -> Option<&Driver> {
        self.drivers_of(api).iter().find(|d| d.name == name)
    }

    fn no_driver(&self, api: Api, name: &str) -> State {
        let known = EXPECTED.iter().find(|(expected, its, _)| (*expected, *its) == (name, api));
        let names: Vec<&str> = self.drivers_of(api).iter().map(|d| d.name.as_str()).collect();
        let here = if names.is_empty() { "there is none".to_owned() } else { names.join(", ") };
        State::Missing {
            what: format!("no {api} driver `{name}` was found (here: {here})"),
            mend: match known {
                Some((_, _, mend)) => (*mend).to_owned(),
                None => "`lobe doctor` lists the drivers of this machine".to_owned(),
            },
        }
    }
}

/// Whether a tool was found; `variable` names it, and says what it is to be.
fn of_tool<T>(found: &Result<T, TranslateError>, variable: &str) -> State {
    match found {
        Ok(_) => State::Ready,
        Err(TranslateError::NotFound { tool, mend, .. }) => {
            State::Missing { what: format!("{tool} was not found"), mend: (*mend).to_owned() }
        }
        Err(error) => {
            State::Missing { what: error.to_string(), mend: format!("run tests/setup.sh, or set {variable}") }
        }
    }
}
