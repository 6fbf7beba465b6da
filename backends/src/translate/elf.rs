//! Tells a whole ELF library from a cut one before the dynamic linker maps it.
//!
//! The linker maps what the headers promise, so a library that was cut short (a full disk, a download that stopped)
//! kills the process at the first touch of a missing page, which no error handling can catch.

use std::error::Error;
use std::fs::File;
use std::io::Read;
use std::path::Path;

const HEADER: usize = 64;

/// Checks that the file is as long as its ELF header says. Files that are not 64-bit ELF are left to the linker, as
/// are names without a folder, which only the linker can find.
pub(crate) fn check_complete(path: &Path) -> Result<(), String> {
    let is_bare = path.parent().is_none_or(|parent| parent.as_os_str().is_empty());
    if is_bare {
        return Ok(());
    }
    let mut file = File::open(path).map_err(|error| error.to_string())?;
    let length = file.metadata().map_err(|error| error.to_string())?.len();
    let mut header = [0; HEADER];
    if file.read_exact(&mut header).is_err() {
        return Err(format!("it has {length} bytes, too few for a library"));
    }
    let is_elf64_little_endian = header.starts_with(b"\x7fELF\x02\x01");
    let end = section_headers_end(&header);
    if is_elf64_little_endian && end > length {
        return Err(format!("it is cut short: {length} bytes of at least {end}; install it again"));
    }
    Ok(())
}

/// libloading's message together with the dynamic linker's own, which is its source.
pub(crate) fn explain(error: &libloading::Error) -> String {
    match error.source() {
        Some(source) => source.to_string(),
        None => error.to_string(),
    }
}

/// Linkers put the section headers last, so where they end the file ends.
fn section_headers_end(header: &[u8; HEADER]) -> u64 {
    let offset = u64::from_le_bytes(std::array::from_fn(|i| header[0x28 + i]));
    let size = u16::from_le_bytes([header[0x3a], header[0x3b]]);
    let count = u16::from_le_bytes([header[0x3c], header[0x3d]]);
    offset.saturating_add(u64::from(size) * u64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(bytes: &[u8], expected: Result<(), &str>) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("lib.so");
        std::fs::write(&path, bytes).expect("writable");
        match (check_complete(&path), expected) {
            (Ok(()), Ok(())) => {}
            (Err(message), Err(part)) => assert!(message.contains(part), "{message}"),
            (result, expected) => panic!("{result:?}, not {expected:?}"),
        }
    }

    #[test]
    fn a_cut_library_is_told_from_a_whole_one() {
        let whole = std::fs::read(std::env::current_exe().expect("this test")).expect("readable");
        check(&whole, Ok(()));
        check(&whole[..whole.len() / 2], Err("cut short"));
        check(&whole[..10], Err("10 bytes, too few"));
    }

    #[test]
    fn other_files_are_left_to_the_linker() {
        check(&[7; 100], Ok(()));
        assert_eq!(check_complete(Path::new("libc.so.6")), Ok(()));
    }
}
