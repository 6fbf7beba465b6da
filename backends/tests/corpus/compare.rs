//! Whether two executors left the same.

use lobe_backends::gpu::BindingKind;
use lobe_backends::texture::{Format, Kind};

/// Says where `ours` and `theirs` differ, by more than `within` if that is given.
pub(crate) fn agree(
    kind: BindingKind,
    ours: &[u8],
    theirs: &[u8],
    within: Option<f64>,
) -> Result<(), String> {
    if ours.len() != theirs.len() {
        return Err(format!("{} bytes against {}", ours.len(), theirs.len()));
    }
    match kind {
        BindingKind::StorageTexture(shape, _) | BindingKind::Texture(shape) => {
            texels(shape.format, ours, theirs, within)
        }
        BindingKind::Uniform
        | BindingKind::StorageRead
        | BindingKind::StorageReadWrite
        | BindingKind::Sampler(_) => words(ours, theirs, within),
    }
}

fn words(ours: &[u8], theirs: &[u8], within: Option<f64>) -> Result<(), String> {
    let words =
        |bytes: &[u8]| bytes.as_chunks().0.iter().map(|c| u32::from_le_bytes(*c)).collect::<Vec<u32>>();
    let mut pairs = words(ours).into_iter().zip(words(theirs)).enumerate();
    pairs.try_for_each(|(at, (a, b))| {
        same(a, b, within).map_err(|difference| format!("word {at}: {difference}"))
    })
}

fn same(a: u32, b: u32, within: Option<f64>) -> Result<(), String> {
    let [x, y] = [a, b].map(f32::from_bits);
    // What a NaN carries is nobody's promise.
    let close = |within| x.is_nan() && y.is_nan() || (f64::from(x) - f64::from(y)).abs() <= within;
    let equal = a == b || within.is_some_and(close);
    equal.then_some(()).ok_or_else(|| format!("{a:#x} ({x}) here, {b:#x} ({y}) there"))
}

fn texels(format: Format, ours: &[u8], theirs: &[u8], within: Option<f64>) -> Result<(), String> {
    let size = format.bytes();
    for (at, (a, b)) in ours.chunks(size).zip(theirs.chunks(size)).enumerate() {
        if a == b {
            continue;
        }
        let texel = |bytes: &[u8]| bytes.iter().rev().fold(0u128, |sum, byte| sum << 8 | u128::from(*byte));
        let (a, b) = (format.decode(texel(a)), format.decode(texel(b)));
        let floats = matches!(format.kind(), Kind::Float | Kind::Depth);
        for (channel, (a, b)) in a.into_iter().zip(b).enumerate() {
            if floats {
                same(a as u32, b as u32, within)
                    .map_err(|d| format!("texel {at}, channel {channel}: {d}"))?;
            } else if a != b {
                return Err(format!("texel {at}, channel {channel}: {a} here, {b} there"));
            }
        }
    }
    Ok(())
}
