//! What known faults of drivers make of the answers on a kernel.
//!
//! A fault that is listed and there is expected; one that is listed and gone falls short, as one that is not listed.

use super::Verdict;
use crate::expectation::{Expectation, Fault};
use lobe_backends::executor::Executor;
use lobe_backends::route::Route;

/// The expectations of one kernel, and the drivers that it ran on.
#[derive(Debug)]
pub struct Expected<'e> {
    of_kernel: Vec<&'e Expectation>,
    /// What the driver of each route says of itself.
    drivers: Vec<(Route, String)>,
}

impl<'e> Expected<'e> {
    /// Those of `all` that are about `kernel`, on `routes`.
    #[must_use]
    pub fn new(kernel: &str, all: &'e [Expectation], routes: &[Box<dyn Executor>]) -> Self {
        Self {
            of_kernel: all.iter().filter(|e| e.is_of(kernel)).collect(),
            drivers: routes.iter().map(|r| (r.route().clone(), r.driver_info().to_owned())).collect(),
        }
    }

    /// The verdict on a route that ended with `fault`, or without one.
    #[must_use]
    pub fn of_route(&self, route: &Route, fault: Option<Fault>, verdict: Verdict) -> Verdict {
        let is_about = |e: &&&Expectation| e.fails != Fault::Differs && self.is_by(e, route);
        let Some(expectation) = self.of_kernel.iter().find(is_about) else { return verdict };
        match (expectation.excuse(fault.map_or("within the bound", Fault::name)), verdict) {
            (Ok(reason), _) => Verdict::ExpectedFailure(reason),
            (Err(why), Verdict::FallsShort(found)) => Verdict::FallsShort(format!("{found}; {why}")),
            (Err(why), _) => Verdict::FallsShort(why),
        }
    }

    /// The verdict on routes that must be equal, of which `differing` are not equal to the first.
    #[must_use]
    pub fn of_group(&self, ran: &[Route], differing: &[Route], verdict: Verdict) -> Verdict {
        let Some(first) = ran.first().filter(|_| ran.len() > 1) else { return verdict };
        let is_at_fault = |e: &Expectation| {
            !differing.is_empty()
                && [differing, std::slice::from_ref(first)].concat().iter().any(|r| self.is_by(e, r))
        };
        let listed = self.of_kernel.iter().filter(|e| e.fails == Fault::Differs);
        let mut listed = listed.filter(|e| ran.iter().any(|route| self.is_by(e, route)));
        if let Some(gone) = listed.find(|e| !is_at_fault(e)) {
            let why = gone.excuse("equal to the other routes").err().unwrap_or_default();
            return Verdict::FallsShort(why);
        }
        let excuses: Option<Vec<String>> = differing.iter().map(|route| self.excuse(route, first)).collect();
        match excuses {
            Some(mut reasons) if !differing.is_empty() => {
                reasons.dedup();
                Verdict::ExpectedFailure(reasons.join("; "))
            }
            _ => verdict,
        }
    }

    /// Why it is no matter that `route` differs from `first`; results that are known to be wrong may differ.
    fn excuse(&self, route: &Route, first: &Route) -> Option<String> {
        let is_excuse = |e: &&&Expectation| {
            matches!(e.fails, Fault::Differs | Fault::Beyond)
                && (self.is_by(e, route) || self.is_by(e, first))
        };
        self.of_kernel.iter().find(is_excuse).map(|e| e.told())
    }

    fn is_by(&self, expectation: &Expectation, route: &Route) -> bool {
        let driver = self.drivers.iter().find(|(known, _)| known == route);
        expectation.is_by(&route.to_string(), driver.map_or("", |(_, info)| info))
    }
}
