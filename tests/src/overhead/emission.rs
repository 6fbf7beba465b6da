//! How long emission takes, beside a compiler that emits as well.

use super::{Listing, OverheadError, Part};
use lobe_backends::executor::Program;
use lobe_backends::translate::Slang;
use lobe_codegen::emit::{Options, Target, emit};
use std::time::Instant;

/// How many times as long as ours slang shall need.
pub const GOAL: f64 = 200.0;

/// What it takes to write a kernel, with all that it calls and its entry point, in one language.
#[derive(Debug, Clone, serde::Serialize)]
pub struct Emission {
    /// The kernel.
    pub kernel: &'static str,
    /// Median seconds for each target, from the validated module to the finished text or words.
    pub seconds: Vec<(Target, f64)>,
    /// Median seconds that slang takes from the kernel's HLSL to SPIR-V, in this process and session.
    pub slang_seconds: f64,
    /// Slang's time over that of the slowest target.
    pub ratio: f64,
}

/// Times the emission of a listing's kernel, so often.
///
/// # Errors
/// When the kernel cannot be emitted, or slang refuses it.
pub fn emission(
    listing: &Listing,
    program: &Program,
    slang: &Slang,
    rounds: usize,
) -> Result<Emission, OverheadError> {
    let kernel = listing.kernel;
    let (module, layout) = program.entry()?;
    let write = |target| {
        emit(module, target, &Options::default()).map_err(|cause| OverheadError::Emit { kernel, cause })
    };
    let hlsl = write(Target::Hlsl)?;
    let text = hlsl.content.text().unwrap_or_default();
    let translate = || {
        let compiled = slang.compile(text, &layout.entry_name);
        compiled.map_err(|cause| OverheadError::Translate { kernel, part: Part::Entry, cause })
    };
    let mut seconds = Vec::new();
    for target in Target::ALL {
        seconds.push((target, timed(rounds * 10, || write(target))?));
    }
    let slang_seconds = timed(rounds, translate)?;
    let slowest = seconds.iter().map(|(_, seconds)| *seconds).fold(0.0, f64::max);
    Ok(Emission { kernel, seconds, slang_seconds, ratio: slang_seconds / slowest })
}

/// The median time of some work, after once that is not counted.
fn timed<T, E>(rounds: usize, mut work: impl FnMut() -> Result<T, E>) -> Result<f64, E> {
    std::hint::black_box(work()?);
    let mut times = Vec::with_capacity(rounds);
    for _ in 0..rounds {
        let begin = Instant::now();
        std::hint::black_box(work()?);
        times.push(begin.elapsed().as_secs_f64());
    }
    Ok(crate::throughput::median(times))
}
