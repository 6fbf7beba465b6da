//! Every pass of a picture on many routes, each judged by what drivers may leave.
//!
//! A pass is given the interpreter's buffers on every route, so that what a route does wrong is seen where it does it, and
//! what one pass decides does not come back as the error of the next.

use lobe_backends::executor::ExecError;
use lobe_backends::interp::ShadowWord;
use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pass};
use lobe_backends::route::Route;

/// Runs passes on the interpreter, and besides on other routes for comparison.
pub struct Judged<'p> {
    interp: Interpreted<'p>,
    routes: Vec<Box<dyn Dispatcher<'p> + 'p>>,
    /// What was found, pass by pass and route by route.
    pub verdicts: Vec<PassVerdict>,
}

/// How a route did a pass.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct PassVerdict {
    /// The pass.
    pub pass: String,
    /// The route.
    pub route: String,
    /// Words that the pass may write.
    pub words: usize,
    /// Those that differ from the interpreter's.
    pub differing: usize,
    /// Those of which nothing is promised.
    pub unknown: usize,
    /// Those that no permitted driver leaves.
    pub outside: usize,
    /// The largest distance from the exact value, as a share of the permitted one.
    pub share: f64,
    /// Where the first word is that no permitted driver leaves, and both values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first: Option<String>,
    /// Routes before it on the same driver that left other bits.
    pub disagrees_with: Vec<String>,
}

impl PassVerdict {
    /// Whether every word is one that a permitted driver may leave.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.outside == 0
    }
}

impl<'p> Judged<'p> {
    /// Judges `routes`.
    #[must_use]
    pub fn new(routes: Vec<Box<dyn Dispatcher<'p> + 'p>>) -> Self {
        Self { interp: Interpreted::default(), routes, verdicts: Vec::new() }
    }
}

impl<'p> Dispatcher<'p> for Judged<'p> {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        let permitted = pass.permitted(invocations, memory)?;
        let mut left: Vec<(Route, Memory)> = Vec::new();
        for route in &mut self.routes {
            let mut own = memory.clone();
            route.dispatch(pass, invocations, &mut own)?;
            let mut verdict = verdict(pass, route.route(), &permitted, &own);
            let same =
                |other: &Memory| permitted.iter().all(|(name, _)| other.bytes(name) == own.bytes(name));
            let others = left.iter().filter(|(other, _)| driver(other) == driver(route.route()));
            verdict.disagrees_with =
                others.filter(|(_, memory)| !same(memory)).map(|(other, _)| other.to_string()).collect();
            self.verdicts.push(verdict);
            left.push((route.route().clone(), own));
        }
        self.interp.dispatch(pass, invocations, memory)
    }
}

fn driver(route: &Route) -> Option<&str> {
    match route {
        Route::Gpu { driver, .. } => Some(driver),
        Route::Native | Route::Interp => None,
    }
}

fn verdict(pass: &Pass, route: &Route, permitted: &[(&str, Vec<ShadowWord>)], found: &Memory) -> PassVerdict {
    let mut verdict = PassVerdict {
        pass: pass.name().to_owned(),
        route: route.to_string(),
        words: 0,
        differing: 0,
        unknown: 0,
        outside: 0,
        share: 0.0,
        first: None,
        disagrees_with: Vec::new(),
    };
    for (name, words) in permitted {
        let found = found.bytes(name).as_chunks::<4>().0;
        for (at, (word, found)) in words.iter().zip(found).enumerate() {
            verdict.take(word, u32::from_le_bytes(*found), || format!("{name}, word {at}"));
        }
    }
    verdict
}

impl PassVerdict {
    fn take(&mut self, word: &ShadowWord, found: u32, place: impl Fn() -> String) {
        self.words += 1;
        let (ours, share) = match *word {
            ShadowWord::Float { value, exact, bound } => {
                let error = (f64::from(f32::from_bits(found)) - exact).abs();
                (value.to_bits(), if bound.is_infinite() { None } else { Some(share(error, bound)) })
            }
            ShadowWord::Word { value, known } => {
                (value, known.then_some(if value == found { 0.0 } else { f64::INFINITY }))
            }
        };
        self.differing += usize::from(ours != found);
        match share {
            None => self.unknown += 1,
            Some(share) if share <= 1.0 => self.share = self.share.max(share),
            Some(share) => {
                self.outside += 1;
                self.share = self.share.max(share);
                self.first.get_or_insert_with(|| {
                    let (ours, found) = (f32::from_bits(ours), f32::from_bits(found));
                    format!("{}: {found:?} where the interpreter has {ours:?}", place())
                });
            }
        }
    }
}

/// An error in units of what is permitted; NaN is infinitely far.
fn share(error: f64, bound: f64) -> f64 {
    match error {
        error if error.is_nan() => f64::INFINITY,
        0.0 => 0.0,
        error => error / bound,
    }
}

/// The worst of each pass and route, in the order in which they were met.
#[must_use]
pub fn summary(verdicts: &[PassVerdict]) -> Vec<PassVerdict> {
    let mut joined: Vec<PassVerdict> = Vec::new();
    for verdict in verdicts {
        match joined.iter_mut().find(|known| (&known.pass, &known.route) == (&verdict.pass, &verdict.route)) {
            Some(known) => known.join(verdict),
            None => joined.push(verdict.clone()),
        }
    }
    joined
}

impl PassVerdict {
    fn join(&mut self, other: &Self) {
        self.words += other.words;
        self.differing += other.differing;
        self.unknown += other.unknown;
        self.outside += other.outside;
        self.share = self.share.max(other.share);
        if self.first.is_none() {
            self.first.clone_from(&other.first);
        }
        for route in &other.disagrees_with {
            if !self.disagrees_with.contains(route) {
                self.disagrees_with.push(route.clone());
            }
        }
    }
}
