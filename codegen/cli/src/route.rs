//! The routes that a run takes: those asked for, else all that are ready.

use crate::fail::Fail;
use lobe_backends::executor::Executor;
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, OpenError, State};
use lobe_tests::report::Skipped;

/// Options of the subcommands that run kernels.
#[derive(Debug, Default, clap::Args)]
pub(crate) struct RouteArgs {
    /// Take only these routes, as `interp` or `spirv@lavapipe`
    #[arg(long = "route", value_name = "ROUTE")]
    routes: Vec<Route>,
    /// End with exit code 3 if one of these routes is missing
    #[arg(long = "require", value_name = "ROUTE")]
    require: Vec<Route>,
}

/// Opened routes, and those that are missing.
pub(crate) struct Opened {
    pub(crate) executors: Vec<Box<dyn Executor>>,
    pub(crate) skipped: Vec<Skipped>,
}

/// Opens what `args` asks for; a route asked for by name that is missing is an error.
pub(crate) fn open(args: &RouteArgs) -> Result<Opened, Fail> {
    open_usual(args, |_| true)
}

/// The same; where none is asked for, only those that are `usual`.
pub(crate) fn open_usual(args: &RouteArgs, usual: impl Fn(&Route) -> bool) -> Result<Opened, Fail> {
    let machine = Machine::look();
    for route in &args.require {
        if let State::Missing { what, mend } = machine.state(route) {
            return Err(OpenError::Missing { route: route.clone(), what, mend }.into());
        }
    }
    let mut opened = Opened { executors: Vec::new(), skipped: Vec::new() };
    if args.routes.is_empty() {
        let is_meant = |route: &Route| usual(route) || args.require.contains(route);
        for (route, state) in machine.routes().into_iter().filter(|(route, _)| is_meant(route)) {
            opened.take(&machine, route, state, &args.require)?;
        }
        return Ok(opened);
    }
    for (index, route) in args.routes.iter().chain(&args.require).enumerate() {
        let again = args.routes.iter().chain(&args.require).take(index).any(|r| r == route);
        if !again {
            opened.executors.push(machine.open(route)?);
        }
    }
    Ok(opened)
}

impl Opened {
    fn take(
        &mut self,
        machine: &Machine,
        route: Route,
        state: State,
        required: &[Route],
    ) -> Result<(), Fail> {
        let opened = match state {
            State::Ready => machine.open(&route),
            State::Missing { what, mend } => Err(OpenError::Missing { route: route.clone(), what, mend }),
        };
        match opened {
            Ok(executor) => self.executors.push(executor),
            Err(error) if required.contains(&route) => return Err(error.into()),
            Err(OpenError::Missing { route, what, mend }) => {
                self.skipped.push(Skipped { route: route.to_string(), what, mend });
            }
            Err(OpenError::Driver { route, cause }) => self.skipped.push(Skipped {
                route: route.to_string(),
                what: cause.to_string(),
                mend: "reinstall or repair the driver".to_owned(),
            }),
        }
        Ok(())
    }
}
