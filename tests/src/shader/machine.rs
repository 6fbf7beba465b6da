//! The interpreter's part: results, what drivers may return instead, and mistakes of the program.

use super::compare::Permit;
use super::given::{Given, Owned};
use super::number;
use super::report::Mistake;
use lobe_backends::interp::{
    Checks, InterpError, Interpreter, Invocation, ShadowBuffer, ShadowFloat, ShadowRun, ShadowTexture,
    ShadowWord,
};
use lobe_backends::texture::{Format, Kind};
use lobe_codegen::ValidModule;
use lobe_codegen::accuracy::Model;
use lobe_codegen::validate::lacking;
use naga::Scalar;
use naga::valid::Capabilities;

/// One entry point on the interpreter.
#[derive(Debug, Clone, Copy)]
pub struct Machine<'m> {
    /// Its module.
    pub module: &'m ValidModule,
    /// Its place among the entry points.
    pub entry: usize,
    /// Workgroups.
    pub workgroups: [u32; 3],
    /// Rounds of loops that a batch may run.
    pub fuel: u64,
    /// What drivers are permitted.
    pub accuracy: &'static Model,
    /// What it is given.
    pub given: &'m [Given],
}

/// Why the interpreter has no answer.
#[derive(Debug, thiserror::Error)]
pub enum MachineError {
    /// It gave up.
    #[error(transparent)]
    Interp(#[from] InterpError),
    /// A texture that is none.
    #[error(transparent)]
    Texture(#[from] lobe_backends::texture::TextureError),
    /// It panicked.
    #[error("the interpreter panicked: {0}")]
    Panicked(String),
}

impl Machine<'_> {
    /// What is left of the resources, with so many invocations in a subgroup.
    ///
    /// # Errors
    /// When the interpreter gives up or panics.
    pub fn run(&self, subgroup: Option<u32>) -> Result<Owned, MachineError> {
        let mut owned = Owned::of(self.given)?;
        self.guarded(subgroup, |machine| machine.run(self.entry, self.workgroups, owned.lend()))?;
        Ok(owned)
    }

    /// The same by the interpreter's judge.
    ///
    /// # Errors
    /// When the judge gives up or panics.
    pub fn judged(&self) -> Result<Owned, MachineError> {
        let mut owned = Owned::of(self.given)?;
        self.guarded(None, |machine| machine.run_judged(self.entry, self.workgroups, owned.lend()))?;
        Ok(owned)
    }

    /// What a driver leaves that takes liberties as `seed` says.
    ///
    /// # Errors
    /// When the judge gives up or panics.
    pub fn perturbed(&self, seed: u64) -> Result<Owned, MachineError> {
        let mut owned = Owned::of(self.given)?;
        self.guarded(None, |machine| machine.perturbed_run(self.entry, self.workgroups, owned.lend(), seed))?;
        Ok(owned)
    }

    /// What permitted drivers may leave in the buffers.
    ///
    /// # Errors
    /// When the interpreter gives up or panics.
    pub fn bounds(&self, subgroup: Option<u32>) -> Result<Bounds, MachineError> {
        let mut owned = Owned::of(self.given)?;
        self.guarded(subgroup, |machine| machine.shadow_run(self.entry, self.workgroups, owned.lend()))
            .map(Bounds)
    }

    /// Mistakes of the program, and on request its uses of variables that nothing was written to; their places are those
    /// of `text`.
    ///
    /// # Errors
    /// When the interpreter gives up or panics.
    pub fn mistakes(&self, text: Option<&str>, unwritten: bool) -> Result<Vec<Mistake>, MachineError> {
        let mut owned = Owned::of(self.given)?;
        let checks = Checks { unwritten, ..Checks::default() };
        let found = self
            .guarded(None, |machine| machine.sanitize(self.entry, self.workgroups, owned.lend(), checks))?;
        let mistake = |finding: lobe_backends::interp::Finding| {
            let who = match finding.invocation {
                Invocation::Row(row) => format!("row {row}"),
                Invocation::Global { group, local } => {
                    let shown = |at: [u32; 3]| at.map(|n| n.to_string()).join(",");
                    format!("invocation {} of workgroup {}", shown(local), shown(group))
                }
            };
            Mistake {
                kind: format!("{:?}", finding.kind),
                at: text.and_then(|text| finding.line(text)),
                message: format!("{} ({who})", finding.message),
            }
        };
        Ok(found.into_iter().map(mistake).collect())
    }

    fn guarded<T>(
        &self,
        subgroup: Option<u32>,
        work: impl FnOnce(Interpreter<'_>) -> Result<T, InterpError>,
    ) -> Result<T, MachineError> {
        let outcome = lobe_codegen::quietly(|| {
            let machine = Interpreter::new(self.module)?.with_fuel(self.fuel).with_accuracy(self.accuracy);
            work(subgroup.map_or_else(|| machine.clone(), |n| machine.clone().with_subgroup_size(n)))
        });
        Ok(outcome.map_err(MachineError::Panicked)??)
    }
}

/// Whether the size of subgroups can show: the validator has to allow them.
#[must_use]
pub fn uses_subgroups(module: &ValidModule) -> bool {
    let without = Capabilities::all() - Capabilities::SUBGROUP - Capabilities::SUBGROUP_BARRIER;
    lacking(module, without).is_some()
}

/// What permitted drivers may leave.
#[derive(Debug)]
pub struct Bounds(ShadowRun);

impl Bounds {
    fn permit(&self, given: &Given, at: usize, scalar: Scalar, theirs: &[u8]) -> Option<Permit> {
        let place = (given.group, given.binding);
        let element = given.element.unwrap_or(0);
        let is_it = |t: &&ShadowTexture| (t.group, t.binding) == place && t.element == element;
        if let Some(texture) = self.0.textures.iter().find(is_it) {
            return texel(texture, given.format()?, at, theirs);
        }
        let buffer = self.0.buffers.iter().find(|b| (b.group, b.binding) == place && b.element == element)?;
        if scalar.width != 4 {
            return other(buffer, at, scalar);
        }
        let word = buffer.words.get(at / 4)?;
        Some(match *word {
            ShadowWord::Float { exact, bound, .. } if number::is_float(scalar) => {
                Permit::Around { exact, bound }
            }
            ShadowWord::Word { known: true, .. } => Permit::Bits,
            ShadowWord::Float { .. } | ShadowWord::Word { .. } => Permit::Unknown,
        })
    }
}

/// What may stand in the texel around byte `at`, where `theirs` stands, if its format is one of floats.
fn texel(texture: &ShadowTexture, format: Format, at: usize, theirs: &[u8]) -> Option<Permit> {
    if matches!(format.kind(), Kind::Sint | Kind::Uint) || !texture.is_known {
        return None;
    }
    let begin = at - at % format.bytes();
    let Ok(found) = texture.texels.binary_search_by(|texel| texel.at.cmp(&begin)) else {
        return Some(Permit::Bits);
    };
    let ranges = texture.texels[found].ranges?;
    let bytes = theirs.get(begin..begin + format.bytes())?;
    let texel = bytes.iter().rev().fold(0, |texel, byte| texel << 8 | u128::from(*byte));
    Some(Permit::Texel { is_near: format.admits(texel, ranges), bound: format.spread(ranges) })
}

/// What may stand in the place of a number of 16 or 64 bits, if that is known.
fn other(buffer: &ShadowBuffer, at: usize, scalar: Scalar) -> Option<Permit> {
    let place = |f: &ShadowFloat| f.at.cmp(&at);
    if let (true, Ok(found)) = (number::is_float(scalar), buffer.floats.binary_search_by(place)) {
        let ShadowFloat { exact, bound, .. } = buffer.floats[found];
        return Some(Permit::Around { exact, bound });
    }
    let words = buffer.words.get(at / 4..(at + usize::from(scalar.width)).div_ceil(4))?;
    let is_known = |word: &ShadowWord| matches!(word, ShadowWord::Word { known: true, .. });
    words.iter().all(is_known).then_some(Permit::Bits)
}

/// What may stand at a place of a resource, where a route left `theirs`: integers have one value unless the bounds say otherwise.
#[must_use]
pub fn permit(bounds: Option<&Bounds>, given: &Given, at: usize, scalar: Scalar, theirs: &[u8]) -> Permit {
    let known = bounds.and_then(|b| b.permit(given, at, scalar, theirs));
    let plain = if given.is_coded || number::is_float(scalar) { Permit::Unknown } else { Permit::Bits };
    known.unwrap_or(plain)
}
