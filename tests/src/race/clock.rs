//! A dispatcher with a clock.

use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::{Dispatcher, Memory, Pass};
use lobe_backends::route::Route;
use std::time::Instant;

/// Runs passes by another dispatcher and notes how long each takes.
pub(super) struct Clock<'d, 'p> {
    dispatcher: &'d mut dyn Dispatcher<'p>,
    laps: Vec<(&'p str, f64)>,
}

impl<'d, 'p> Clock<'d, 'p> {
    /// Nothing noted yet.
    pub(super) fn new(dispatcher: &'d mut dyn Dispatcher<'p>) -> Self {
        Self { dispatcher, laps: Vec::new() }
    }

    /// The time of all passes that `counts` by their names.
    pub(super) fn seconds(&self, counts: impl Fn(&str) -> bool) -> f64 {
        self.laps.iter().filter(|(pass, _)| counts(pass)).map(|(_, seconds)| seconds).sum()
    }

    /// The time of all passes from the first on that is one of `first`.
    pub(super) fn seconds_from(&self, first: &[&str]) -> f64 {
        self.laps.iter().skip_while(|(pass, _)| !first.contains(pass)).map(|(_, seconds)| seconds).sum()
    }
}

impl<'p> Dispatcher<'p> for Clock<'_, 'p> {
    fn route(&self) -> &Route {
        self.dispatcher.route()
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        let begin = Instant::now();
        self.dispatcher.dispatch(pass, invocations, memory)?;
        self.laps.push((pass.name(), begin.elapsed().as_secs_f64()));
        Ok(())
    }
}
