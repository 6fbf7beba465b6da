//! The routes of a run, opened when they are first used.

use super::report::RouteName;
use crate::measure::driver;
use lobe_backends::executor::Executor;
use lobe_backends::pipeline::Dispatcher;
use lobe_backends::route::Route;
use lobe_backends::routes::Machine;

/// The routes of a run.
pub struct Routes<'r> {
    machine: Machine,
    routes: Vec<One<'r>>,
}

struct One<'r> {
    route: Route,
    driver: String,
    executor: Option<Box<dyn Executor>>,
    dispatcher: Option<Box<dyn Dispatcher<'r> + 'r>>,
}

impl<'r> Routes<'r> {
    /// These routes of a machine.
    #[must_use]
    pub fn new(machine: Machine, routes: Vec<Route>) -> Self {
        let named = |route: Route| {
            let driver = route.driver().map(|name| driver(&machine, name)).unwrap_or_default();
            One { route, driver, executor: None, dispatcher: None }
        };
        let routes = routes.into_iter().map(named).collect();
        Self { machine, routes }
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.routes.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.routes.is_empty()
    }

    /// One of them.
    #[must_use]
    pub fn route(&self, at: usize) -> &Route {
        &self.routes[at].route
    }

    /// What decides its results.
    #[must_use]
    pub fn driver(&self, at: usize) -> &str {
        &self.routes[at].driver
    }

    /// All, with what decides their results.
    #[must_use]
    pub fn names(&self) -> Vec<RouteName> {
        let named = |one: &One<'r>| RouteName { route: one.route.to_string(), driver: one.driver.clone() };
        self.routes.iter().map(named).collect()
    }

    pub(super) fn executor(&mut self, at: usize) -> Result<&mut dyn Executor, String> {
        let One { route, executor, .. } = &mut self.routes[at];
        if executor.is_none() {
            *executor = Some(self.machine.open(route).map_err(|error| error.to_string())?);
        }
        executor.as_deref_mut().map(|e| e as &mut dyn Executor).ok_or_else(|| "it is not open".to_owned())
    }

    pub(super) fn dispatcher(&mut self, at: usize) -> Result<&mut (dyn Dispatcher<'r> + 'r), String> {
        let One { route, dispatcher, .. } = &mut self.routes[at];
        if dispatcher.is_none() {
            *dispatcher = Some(self.machine.dispatcher(route).map_err(|error| error.to_string())?);
        }
        dispatcher.as_deref_mut().ok_or_else(|| "it is not open".to_owned())
    }
}
