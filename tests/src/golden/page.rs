//! The page of a report: what `lobe golden report` leaves for people to look at.

use super::check::looked_at;
use super::report::Report;
use crate::metrics::{Pair, Range, Viewing, compare};
use lobe_golden::image::{MOST_BYTES, Picture};
use lobe_golden::page::{self, PageError, Written};
use std::io::Read;
use std::path::{Component, Path};

/// Writes the page of a report beside the pictures, into the folder that they are in.
///
/// # Errors
/// When a file cannot be written.
pub fn write(report: &Report, folder: &Path) -> Result<Written, PageError> {
    let report = serde_json::from_str(&report.json()).unwrap_or_default();
    page::write(&report, &Folder(folder), folder)
}

/// Pictures in a folder.
struct Folder<'a>(&'a Path);

impl page::Evidence for Folder<'_> {
    fn bytes(&self, file: &str) -> Result<Vec<u8>, String> {
        let is_within = Path::new(file).components().all(|part| matches!(part, Component::Normal(_)));
        if !is_within {
            return Err(format!("{file} is not within the folder"));
        }
        let mut bytes = Vec::new();
        let opened = std::fs::File::open(self.0.join(file));
        let read = opened.and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes));
        read.map(|_| bytes).map_err(|cause| format!("{file}: {cause}"))
    }

    /// HDR-FLIP, as the report's own figures; 1 where the picture has what is no number.
    fn flip(&self, truth: &Picture, found: &Picture) -> Option<Vec<f32>> {
        let [seen, wanted] = [found, truth].map(|picture| looked_at(picture.size, &picture.values));
        let pair = Pair::new(&seen, &wanted).ok()?;
        let mut map = compare(&pair, Range::High, &Viewing::default()).map.values;
        for (flip, pixel) in map.iter_mut().zip(found.values.as_chunks::<3>().0) {
            if pixel.iter().any(|value| !value.is_finite()) {
                *flip = 1.0;
            }
        }
        Some(map)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lobe_golden::page::Evidence;

    #[test]
    fn no_file_outside_the_folder_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        std::fs::create_dir(&inner).unwrap();
        std::fs::write(folder.path().join("a"), "a").unwrap();
        std::fs::write(inner.join("b"), "b").unwrap();
        let bytes = |file: &str| Folder(&inner).bytes(file);
        assert_eq!(bytes("b"), Ok(b"b".to_vec()));
        assert!(bytes("../a").is_err_and(|why| why.contains("not within")));
        assert!(
            bytes(&folder.path().join("a").display().to_string())
                .is_err_and(|why| why.contains("not within"))
        );
        assert!(bytes("c").is_err());
    }

    #[test]
    fn what_is_no_number_is_another_in_flip() {
        let picture = |value: f32| Picture { size: [8, 8], values: vec![value; 192] };
        let flip = |found: f32| Folder(Path::new(".")).flip(&picture(0.25), &picture(found)).unwrap();
        assert_eq!(flip(0.25), vec![0.0; 64]);
        assert_eq!(flip(f32::NAN), vec![1.0; 64]);
    }
}
