//! The trace beside the interpreter's: where it leaves what any driver may compute from the arguments.

use super::ExplainError;
use lobe_backends::executor::trace;
use lobe_backends::interp::ShadowWord;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::{Record, Traced};
use naga::ScalarKind;

/// What is permitted for a record, whatever came before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Total {
    /// A float.
    Float {
        /// In real numbers.
        exact: f64,
        /// Largest permitted distance from it.
        bound: f64,
    },
    /// An integer or a boolean.
    Word {
        /// In strict f32.
        wanted: u32,
        /// Whether every permitted driver has it.
        is_known: bool,
    },
}

impl Total {
    fn permits(self, bits: u32) -> bool {
        match self {
            Self::Float { exact, bound } => {
                !bound.is_finite() || (f64::from(f32::from_bits(bits)) - exact).abs() <= bound
            }
            Self::Word { wanted, is_known } => !is_known || bits == wanted,
        }
    }
}

/// A trace held against the interpreter's.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chain {
    /// What is permitted, record by record; nothing is known past a decision that drivers may take either way.
    pub totals: Vec<Option<Total>>,
    /// The first record outside.
    pub outside: Option<usize>,
    /// The decision after which the route computed something else.
    pub decision: Option<usize>,
}

/// Holds `found` against the interpreter's trace of the same arguments.
///
/// # Errors
/// When the interpreter gives up.
pub fn chain(traced: &Traced, args: &Columns, found: &[Record]) -> Result<Chain, ExplainError> {
    let strict = trace::interpret(traced, args)?.records;
    let shadow = trace::shadow(traced, args)?;
    let words = shadow.as_ref().map_or(&[][..], |buffer| &buffer.words);
    let totals: Vec<Option<Total>> = strict
        .iter()
        .zip(words.chunks_exact(3))
        .map(|(record, words)| total(traced, *record, words))
        .collect();
    let parted = strict.iter().zip(found).position(|(a, b)| a.site != b.site);
    let parted = parted.or((strict.len() != found.len()).then_some(strict.len().min(found.len())));
    let common = parted.unwrap_or(found.len());
    let outside =
        (0..common).find(|&i| totals.get(i).copied().flatten().is_some_and(|t| !t.permits(found[i].bits)));
    let is_word = |i: &usize| traced.sites[found[*i].site as usize].kind != ScalarKind::Float;
    let decision =
        parted.and_then(|end| (0..end).rev().find(|i| is_word(i) && strict[*i].bits != found[*i].bits));
    Ok(Chain { totals, outside, decision })
}

fn total(traced: &Traced, record: Record, words: &[ShadowWord]) -> Option<Total> {
    let [ShadowWord::Word { value, known: true }, bits, number] = *words else { return None };
    if value != record.site + 1 {
        return None;
    }
    let site = traced.sites.get(record.site as usize)?;
    Some(match (site.kind, bits, number) {
        (ScalarKind::Float, _, ShadowWord::Float { exact, bound, .. }) => Total::Float { exact, bound },
        (_, ShadowWord::Word { value, known }, _) => Total::Word { wanted: value, is_known: known },
        _ => return None,
    })
}
