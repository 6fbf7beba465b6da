//! Seeded faults: what a harness is worth is the share of them that it notices.
//!
//! A fault is one small change of a kernel's IR ([`sites`] finds the places, [`fault`] says what kinds there are) or of
//! the text that is emitted ([`text`]). The kernel with the fault is run on the inputs that `lobe check` draws, as if a
//! translator had made it ([`trial`]): each result is held against the bound that was derived for the kernel without it,
//! and against the bits of the other roads to the same driver, which have to agree.
//! A fault that all roads have is judged by the bound alone: that score is told beside the other.
//!
//! What a check does not notice is run on many more inputs ([`proof`]): a fault that never changes a bit is equivalent,
//! and counts for nothing.

pub mod fault;
pub(crate) mod operator;
pub mod proof;
pub mod report;
pub mod sites;
pub mod text;
pub mod trial;

use crate::cases::Cases;
use crate::judge::JudgeError;
use fault::Mutant;
use lobe_codegen::def::FunctionRef;
use rayon::prelude::*;
use report::{KernelFaults, Outcome};
use std::time::Instant;
use trial::Reference;

/// How faults are sought.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Rows that each kernel with a fault is run on.
    pub inputs: usize,
    /// Where the drawing begins.
    pub seed: u64,
    /// Rows on which a fault that shows nowhere counts as none.
    pub equivalence: usize,
    /// Listed cases.
    pub cases: Cases,
    /// When to stop.
    pub until: Option<Instant>,
}

impl Plan {
    fn is_over(&self) -> bool {
        self.until.is_some_and(|until| Instant::now() >= until)
    }
}

/// Seeds every fault into `kernel`, and tells what becomes of each.
///
/// # Errors
/// When the kernel cannot be run at all.
pub fn mutate(kernel: FunctionRef, plan: &Plan) -> Result<KernelFaults, JudgeError> {
    let reference = Reference::new(kernel, plan)?;
    let mut mutants = sites::faults(reference.program());
    mutants.extend(text::faults(reference.program()));
    let try_one = |mutant: &Mutant| {
        if plan.is_over() { Outcome::NotTried } else { trial::judge(&reference, mutant) }
    };
    let mut outcomes: Vec<Outcome> = mutants.par_iter().map(try_one).collect();
    proof::look_again(&reference, plan, &mutants, &mut outcomes);
    Ok(KernelFaults::new(reference.program().name(), mutants, outcomes))
}
