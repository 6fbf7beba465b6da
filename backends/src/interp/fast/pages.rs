//! Memory in large pages, where the system has them: with small ones, how fast a large buffer is read depends on where
//! its pages happen to lie.

/// The size of a large page.
const PAGE: usize = 2 << 20;

/// A copy of `bytes`, in large pages if it fills some.
pub(crate) fn copied(bytes: &[u8]) -> Vec<u8> {
    let mut copy = Vec::with_capacity(bytes.len());
    advise(copy.spare_capacity_mut());
    copy.extend_from_slice(bytes);
    copy
}

/// Asks for large pages below `memory`, which nobody has touched. The system may refuse: nothing depends on it.
#[cfg(target_os = "linux")]
fn advise(memory: &mut [std::mem::MaybeUninit<u8>]) {
    let start = memory.as_mut_ptr();
    let skipped = start.align_offset(PAGE);
    let length = memory.len().saturating_sub(skipped) / PAGE * PAGE;
    if length > 0 {
        // SAFETY: the range lies within `memory`, whose contents this advice leaves alone.
        unsafe { libc::madvise(start.add(skipped).cast(), length, libc::MADV_HUGEPAGE) };
    }
}

#[cfg(not(target_os = "linux"))]
fn advise(_: &mut [std::mem::MaybeUninit<u8>]) {}

#[cfg(test)]
mod tests {
    #[test]
    fn copies_of_all_sizes() {
        for size in [0, 1, 4096, super::PAGE, 3 * super::PAGE + 5] {
            let bytes: Vec<u8> = (0..size).map(|i| ((i * 7) >> 3) as u8).collect();
            assert!(super::copied(&bytes) == bytes, "{size}");
        }
    }
}
