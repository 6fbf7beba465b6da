//! How the truth of a picture that passes make is found, and routes are brought to where it can be judged.
//!
//! The last passes write what pixels are the sum of; their results have bounds. The passes before them decide what a ray
//! meets: drivers may decide otherwise where two are near, of which nothing is promised, so bounds cannot be carried through
//! them. So all routes are given what the interpreter decides, and are judged in the last passes.

use lobe_backends::executor::ExecError;
use lobe_backends::interp::ShadowWord;
use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pass, Pipeline};
use lobe_backends::route::Route;
use lobe_golden::Golden;
use std::collections::BTreeMap;

/// What pixels are the sum of: the buffer, and the vectors of its element. The last passes write one of the latter two.
const TERMS: [(&str, &[&str]); 3] = [
    ("direct", &["shadowed"]),
    ("indirect", &["specular", "diffuse", "diffuse_of_diffuse", "specular_of_diffuse"]),
    (
        "virtual_pixels",
        &[
            "parts.diffuse_of_diffuse",
            "parts.diffuse_of_glossy",
            "parts.glossy_of_diffuse",
            "parts.glossy_of_glossy",
        ],
    ),
];
/// What an addition in f32 errs by, over the sum of magnitudes; a hair more for the product of such.
const ADDITION: f64 = (1.0 + 1e-6) / (1_u64 << 24) as f64;

/// Runs nothing, and notes the passes.
#[derive(Default)]
pub(super) struct Listing {
    pub(super) passes: Vec<&'static str>,
}

impl<'p> Dispatcher<'p> for Listing {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn dispatch(&mut self, pass: &'p Pass, _: u32, _: &mut Memory) -> Result<(), ExecError> {
        if !self.passes.contains(&pass.name()) {
            self.passes.push(pass.name());
        }
        Ok(())
    }
}

/// Runs passes on the interpreter, the last ones also on its shadow lane.
pub(super) struct Truth<'p> {
    interp: Interpreted<'p>,
    last: Vec<&'static str>,
    left: BTreeMap<String, Vec<ShadowWord>>,
    /// A buffer that was written twice, so that its bound is of the last time alone.
    twice: Option<String>,
}

impl Truth<'_> {
    pub(super) fn new(last: Vec<&'static str>) -> Self {
        Self { interp: Interpreted::default(), last, left: BTreeMap::new(), twice: None }
    }

    /// The sum of what the last passes left.
    pub(super) fn golden(&self, pipeline: &Pipeline, size: [u32; 2]) -> Result<Golden, String> {
        if let Some(buffer) = &self.twice {
            return Err(format!(
                "`{buffer}` is written in several turns, and only the last one would have a bound"
            ));
        }
        let count = 3 * (size[0] * size[1]) as usize;
        let mut sums = vec![Sum::default(); count];
        for (buffer, vectors) in TERMS {
            let Some(words) = self.left.get(buffer) else { continue };
            let layout = pipeline.layout(buffer).map_err(|error| error.to_string())?;
            for vector in vectors {
                for (channel, axis) in ["x", "y", "z"].iter().enumerate() {
                    let path = format!("{vector}.{axis}");
                    let leaf = layout.leaves.iter().find(|leaf| leaf.path == path);
                    let leaf = leaf.ok_or_else(|| format!("`{buffer}` has no {path}"))?;
                    for pixel in 0..count / 3 {
                        let at = (pixel * layout.stride as usize + leaf.offset as usize) / 4;
                        sums[3 * pixel + channel].add(words.get(at));
                    }
                }
            }
        }
        let (truth, permitted): (Vec<f64>, Vec<f64>) = sums.iter().map(Sum::told).unzip();
        Golden::new(size, &truth, &permitted).map_err(|error| error.to_string())
    }
}

/// A sum of floats that drivers err in, which is added in f32.
#[derive(Clone, Default)]
struct Sum {
    exact: f64,
    bound: f64,
    magnitude: f64,
    terms: u32,
}

impl Sum {
    fn add(&mut self, word: Option<&ShadowWord>) {
        let (exact, bound) = match word {
            Some(ShadowWord::Float { exact, bound, .. }) => (*exact, *bound),
            // A word that was never written is the 0 that was there; one that is no float is none of a picture's.
            Some(ShadowWord::Word { value: 0, known: true }) => (0.0, 0.0),
            Some(ShadowWord::Word { .. }) | None => (0.0, f64::INFINITY),
        };
        self.exact += exact;
        self.bound += bound;
        self.magnitude += exact.abs() + bound;
        self.terms += 1;
    }

    fn told(&self) -> (f64, f64) {
        let additions = f64::from(self.terms.saturating_sub(1));
        (self.exact, self.bound + additions * ADDITION * self.magnitude)
    }
}

impl<'p> Dispatcher<'p> for Truth<'p> {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        if self.last.contains(&pass.name()) {
            for (name, words) in pass.permitted(invocations, memory)? {
                if self.left.insert(name.to_owned(), words).is_some() {
                    self.twice = Some(name.to_owned());
                }
            }
        }
        self.interp.dispatch(pass, invocations, memory)
    }
}

/// Runs passes on the interpreter, the last ones on a route.
pub(super) struct Finals<'p, 'd> {
    interp: Interpreted<'p>,
    last: Vec<&'static str>,
    route: &'d mut (dyn Dispatcher<'p> + 'p),
}

impl<'p, 'd> Finals<'p, 'd> {
    pub(super) fn new(last: Vec<&'static str>, route: &'d mut (dyn Dispatcher<'p> + 'p)) -> Self {
        Self { interp: Interpreted::default(), last, route }
    }
}

impl<'p> Dispatcher<'p> for Finals<'p, '_> {
    fn route(&self) -> &Route {
        self.route.route()
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        match self.last.contains(&pass.name()) {
            true => self.route.dispatch(pass, invocations, memory),
            false => self.interp.dispatch(pass, invocations, memory),
        }
    }
}
