//! Which routes this machine has, which it lacks and why, and how one is opened.

use crate::executor::{Executor, GpuRoute, Interp, Native};
use crate::gpu::{self, AnyGpu, DawnGpu, Driver, Gpu, GpuError};
use crate::route::{Road, Route};
use crate::translate::{Dawn, Dxc, TranslateError};
use std::sync::Arc;

/// The drivers that are spoken of even where they are missing, with the way to get them.
const EXPECTED: [(&str, &str); 2] = [
    ("lavapipe", "run tests/setup.sh, or install your system's mesa-vulkan-drivers package"),
    ("swiftshader", "run tests/setup.sh"),
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
    dxc: Result<Arc<Dxc>, TranslateError>,
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
        Self { drivers: gpu::drivers(), dxc: Dxc::find().map(Arc::new), dawn: Dawn::find() }
    }

    /// The Vulkan drivers that were found.
    #[must_use]
    pub fn drivers(&self) -> &[Driver] {
        &self.drivers
    }

    /// DXC, or why there is none.
    ///
    /// # Errors
    /// When it was not found or does not load.
    pub fn dxc(&self) -> Result<&Dxc, &TranslateError> {
        self.dxc.as_deref()
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
        let found = self.drivers.iter().map(|d| d.name.as_str());
        let missing = EXPECTED.iter().map(|(name, _)| *name);
        let missing = missing.filter(|name| self.driver(name).is_none());
        let names: Vec<&str> = found.chain(missing).collect();
        let gpu = names.into_iter().flat_map(|driver| {
            Road::ALL.into_iter().map(|road| Route::Gpu { road, driver: driver.to_owned() })
        });
        let all = [Route::Native, Route::Interp].into_iter().chain(gpu);
        all.map(|route| (route.clone(), self.state(&route))).collect()
    }

    /// Whether `route` can be taken.
    #[must_use]
    pub fn state(&self, route: &Route) -> State {
        let Route::Gpu { road, driver: name } = route else { return State::Ready };
        let Some(driver) = self.driver(name) else { return self.no_driver(name) };
        match road {
            Road::Spirv | Road::HlslDxc if !driver.has_passthrough => State::Missing {
                what: format!("{name} takes no SPIR-V unchanged"),
                mend: format!("use wgsl+naga@{name}"),
            },
            Road::HlslDxc => of_tool(&self.dxc, "LOBE_DXC to the path of a libdxcompiler.so"),
            Road::WgslTint => match self.twin(driver) {
                Some(twin) => State::Missing {
                    what: format!("Dawn knows devices by their names, and {name} has that of {twin}"),
                    mend: format!("use wgsl+tint@{twin}"),
                },
                None => of_tool(&self.dawn, "LOBE_DAWN to the folder of the npm package webgpu"),
            },
            Road::Spirv | Road::WgslNaga => State::Ready,
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
                let Some(driver) = self.driver(driver) else { return self.open(&Route::Interp) };
                let opened = self.device(*road, driver);
                let gpu = opened.map_err(|cause| OpenError::Driver { route: route.clone(), cause })?;
                let dxc = self.dxc.as_ref().ok().cloned();
                Ok(Box::new(GpuRoute::new(route.clone(), *road, gpu, dxc)))
            }
        }
    }

    /// Opens a device for `road`.
    ///
    /// # Errors
    /// When it does not open, or there is no Dawn to open it.
    pub fn device(&self, road: Road, driver: &Driver) -> Result<AnyGpu, GpuError> {
        match road {
            Road::Spirv | Road::WgslNaga | Road::HlslDxc => Gpu::open(driver).map(AnyGpu::Wgpu),
            Road::WgslTint => match &self.dawn {
                Ok(dawn) => DawnGpu::open(dawn, driver).map(|gpu| AnyGpu::Dawn(Box::new(gpu))),
                Err(error) => Err(GpuError::Open { driver: driver.name.clone(), reason: error.to_string() }),
            },
        }
    }

    fn driver(&self, name: &str) -> Option<&Driver> {
        self.drivers.iter().find(|d| d.name == name)
    }

    fn no_driver(&self, name: &str) -> State {
        let known = EXPECTED.iter().find(|(expected, _)| *expected == name);
        let names: Vec<&str> = self.drivers.iter().map(|d| d.name.as_str()).collect();
        let here = if names.is_empty() { "there is none".to_owned() } else { names.join(", ") };
        State::Missing {
            what: format!("no Vulkan driver `{name}` was found (here: {here})"),
            mend: match known {
                Some((_, mend)) => (*mend).to_owned(),
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
