//! Shaders on a driver, with buffers by binding.

use super::common::skip;
use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, Job, Shader};

/// A buffer: its binding, whether it is a uniform, its words.
pub(crate) type Bound = (u32, bool, Vec<u32>);

/// The driver; `None`, said aloud, where there is none.
pub(crate) fn open() -> Option<Gpu> {
    let Some(driver) = gpu::drivers().into_iter().find(|driver| driver.name == "lavapipe") else {
        skip("lavapipe", "run tests/setup.sh");
        return None;
    };
    Some(Gpu::open(&driver).expect("it opens"))
}

/// What `entry` leaves in the buffer at `results`, whose size is given in words.
pub(crate) fn run(
    driver: &mut Gpu,
    (words, entry): (&[u32], &str),
    groups: u32,
    inputs: &[Bound],
    (results, size): (u32, usize),
) -> Vec<u32> {
    let bytes = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let held: Vec<Vec<u8>> = inputs.iter().map(|(_, _, words)| bytes(words)).collect();
    let zeros = vec![0; size * 4];
    let bind = |binding, kind, data| Binding { group: 0, binding, element: None, kind, data };
    let mut bindings: Vec<Binding<'_>> = Vec::new();
    for ((binding, is_uniform, _), data) in inputs.iter().zip(&held) {
        let kind = if *is_uniform { BindingKind::Uniform } else { BindingKind::StorageRead };
        bindings.push(bind(*binding, kind, data));
    }
    bindings.push(bind(results, BindingKind::StorageReadWrite, &zeros));
    let job = Job {
        shader: Shader::Spirv(words),
        entry,
        workgroup_size: [64, 1, 1],
        groups: [groups, 1, 1],
        bindings: &bindings,
        immediates: &[],
    };
    let output = driver.run(&job).unwrap_or_else(|e| panic!("{entry}: {e}")).remove(0);
    output.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
}
