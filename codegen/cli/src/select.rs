//! Kernels by name.

use crate::fail::Fail;
use lobe_codegen::def::FunctionRef;
use lobe_kernels::registry::{KERNELS, PARTS};
use lobe_tests::oracle::lists;

/// Below this similarity a name is no suggestion.
const ALIKE: f64 = 0.7;

/// The kernel `name`.
pub(crate) fn kernel(name: &str) -> Result<FunctionRef, Fail> {
    find(name).ok_or_else(|| Fail::UnknownKernel {
        name: name.to_owned(),
        suggestion: nearest(name),
        count: KERNELS.len(),
    })
}

/// The kernels of these names, each once; all when there are none.
pub(crate) fn kernels(names: &[String]) -> Result<Vec<FunctionRef>, Fail> {
    if names.is_empty() {
        return Ok(KERNELS.to_vec());
    }
    let mut chosen: Vec<FunctionRef> = Vec::new();
    for name in names {
        let kernel = kernel(name)?;
        if !chosen.iter().any(|k| std::ptr::eq(k(), kernel())) {
            chosen.push(kernel);
        }
    }
    Ok(chosen)
}

/// The kernel `name`, if there is one: of the library, a part of one, or one that tables of lists are judged by.
pub(crate) fn find(name: &str) -> Option<FunctionRef> {
    KERNELS.iter().chain(PARTS).copied().find(|k| k().name == name).or_else(|| lists::find(name))
}

fn nearest(name: &str) -> Option<String> {
    let scored = KERNELS.iter().chain(PARTS).map(|k| (strsim::jaro_winkler(name, k().name), k().name));
    let best = scored.max_by(|(a, _), (b, _)| a.total_cmp(b))?;
    (best.0 >= ALIKE).then(|| best.1.to_owned())
}
