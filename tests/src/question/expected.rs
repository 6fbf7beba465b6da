//! What known faults of drivers make of the answers on a kernel.
//!
//! A fault that is listed and there is expected; one that is listed and gone falls short, as one that is not listed.

use super::Verdict;
use crate::expectation::{Expectation, Fault};

/// The expectations of one kernel or shader, and the drivers that it ran on.
#[derive(Debug)]
pub struct Expected<'e> {
    listed: Vec<&'e Expectation>,
    /// What the driver of each route says of itself.
    drivers: Vec<(String, String)>,
}

impl<'e> Expected<'e> {
    /// Those of `all` that are about `subject`, where the driver of each route says this of itself.
    #[must_use]
    pub fn new(subject: &str, all: &'e [Expectation], drivers: Vec<(String, String)>) -> Self {
        Self { listed: all.iter().filter(|e| e.is_of(subject)).collect(), drivers }
    }

    /// The verdict on a route that ended with `fault`, or without one.
    #[must_use]
    pub fn of_route(&self, route: &str, fault: Option<Fault>, verdict: Verdict) -> Verdict {
        let is_about = |e: &&&Expectation| e.fails != Fault::Differs && self.is_by(e, route);
        let Some(expectation) = self.listed.iter().find(is_about) else { return verdict };
        match (expectation.excuse(fault.map_or("within the bound", Fault::name)), verdict) {
            (Ok(reason), _) => Verdict::ExpectedFailure(reason),
            (Err(why), Verdict::FallsShort(found)) => Verdict::FallsShort(format!("{found}; {why}")),
            (Err(why), _) => Verdict::FallsShort(why),
        }
    }

    /// The verdict on routes that must be equal, of which `differing` are not equal to the first.
    #[must_use]
    pub fn of_group(&self, ran: &[String], differing: &[String], verdict: Verdict) -> Verdict {
        let Some(first) = ran.first().filter(|_| ran.len() > 1) else { return verdict };
        let is_at_fault = |e: &Expectation| {
            !differing.is_empty()
                && [differing, std::slice::from_ref(first)].concat().iter().any(|r| self.is_by(e, r))
        };
        let listed = self.listed.iter().filter(|e| e.fails == Fault::Differs);
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
    fn excuse(&self, route: &str, first: &str) -> Option<String> {
        let is_excuse = |e: &&&Expectation| {
            matches!(e.fails, Fault::Differs | Fault::Beyond)
                && (self.is_by(e, route) || self.is_by(e, first))
        };
        self.listed.iter().find(is_excuse).map(|e| e.told())
    }

    fn is_by(&self, expectation: &Expectation, route: &str) -> bool {
        let driver = self.drivers.iter().find(|(known, _)| known == route);
        expectation.is_by(route, driver.map_or("", |(_, info)| info))
    }
}
