//! The report as a page: a folder of static files that a browser opens as they lie there.
//!
//! A page that was opened as a file may load nothing but scripts and styles. So what it shows are scripts that hand
//! over a text: one for the list of all cases, one for each case, and one for each picture, loaded when it is looked at.
//! Names and texts of a report travel as JSON in a quoted string, and the page puts them in as texts: none becomes markup
//! or code. Paths are made of numbers, so that no name becomes a path.
//!
//! The page's own script and style are the files of `web/`, joined in the order of [`SCRIPTS`].

mod encode;
mod evidence;
mod row;
mod script;

pub use evidence::Evidence;

use evidence::Slots;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};

const HTML: &str = include_str!("web/page.html");
const STYLES: [&str; 3] =
    [include_str!("web/page.css"), include_str!("web/viewer.css"), include_str!("web/panels.css")];
const SCRIPTS: [&str; 24] = [
    include_str!("web/dom.js"),
    include_str!("web/numbers.js"),
    include_str!("web/decode.js"),
    include_str!("web/data.js"),
    include_str!("web/judge.js"),
    include_str!("web/colour.js"),
    include_str!("web/state.js"),
    include_str!("web/evidence.js"),
    include_str!("web/filters.js"),
    include_str!("web/list.js"),
    include_str!("web/layers.js"),
    include_str!("web/view.js"),
    include_str!("web/gestures.js"),
    include_str!("web/tools.js"),
    include_str!("web/inspect.js"),
    include_str!("web/lines.js"),
    include_str!("web/texts.js"),
    include_str!("web/figures.js"),
    include_str!("web/decide.js"),
    include_str!("web/dialogs.js"),
    include_str!("web/item.js"),
    include_str!("web/summary.js"),
    include_str!("web/keys.js"),
    include_str!("web/main.js"),
];

/// Why there is no page.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// A file could not be written.
    #[error("{} could not be written: {cause}", path.display())]
    Io {
        /// Which one.
        path: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// It is no report.
    #[error("this is no report of golden images: it has no list `items`")]
    NoItems,
    /// A picture could not be packed.
    #[error("a picture could not be packed: {0}")]
    Pack(std::io::Error),
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The file to open.
    pub page: PathBuf,
    /// Pictures in the page's folder.
    pub pictures: usize,
    /// Cases that lack a picture that the report names, or one that should be there.
    pub lacking: usize,
    /// Bytes of all pictures.
    pub bytes: u64,
}

/// Writes the page of a report (`tests/schema/golden-1.json`) into `folder`: `index.html`, and `page/` with all that it loads.
///
/// What cannot be read of the evidence is said on the page, at its case; a case that lacks evidence is never shown as fine.
///
/// # Errors
/// When it is no report, or a file cannot be written.
pub fn write(report: &Value, evidence: &dyn Evidence, folder: &Path) -> Result<Written, PageError> {
    let items = report.get("items").and_then(Value::as_array).ok_or(PageError::NoItems)?;
    let mut out = Out::new(folder, script::stamp(report));
    let mut rows = Vec::with_capacity(items.len());
    let routes = row::routes(report);
    let mut lacking = 0;
    for (at, item) in items.iter().enumerate() {
        let slots = out.pictures(at, item, evidence)?;
        lacking += usize::from(slots.is_lacking());
        rows.push(row::of(item, &routes, slots.is_lacking()));
        let fresh = slots.fresh().map(crate::Hash::as_str);
        let detail =
            json!({ "item": item, "pictures": slots.describe(), "doubts": slots.doubts(), "exr": fresh });
        out.script(&format!("{at}/item"), &detail)?;
    }
    let mut head: Map<String, Value> = report.as_object().cloned().unwrap_or_default();
    head.remove("items");
    out.script("index", &json!({ "report": head, "route_names": routes, "rows": rows }))?;
    out.file("page/page.css", &STYLES.concat())?;
    out.file("page/page.js", &script::joined(&SCRIPTS))?;
    out.file("index.html", &HTML.replace("{{stamp}}", &out.stamp))?;
    Ok(Written { page: folder.join("index.html"), pictures: out.pictures, lacking, bytes: out.bytes })
}

/// Where files go.
struct Out<'a> {
    folder: &'a Path,
    /// What all scripts of this report say, so that none of another report is taken for one of this.
    stamp: String,
    pictures: usize,
    bytes: u64,
}

impl<'a> Out<'a> {
    fn new(folder: &'a Path, stamp: String) -> Self {
        Self { folder, stamp, pictures: 0, bytes: 0 }
    }

    fn file(&self, name: &str, text: &str) -> Result<(), PageError> {
        let path = self.folder.join(name);
        let parent = path.parent().unwrap_or(self.folder);
        let written = std::fs::create_dir_all(parent).and_then(|()| std::fs::write(&path, text));
        written.map_err(|cause| PageError::Io { path, cause })
    }

    fn script(&self, key: &str, value: &Value) -> Result<(), PageError> {
        self.file(&format!("page/data/{key}.js"), &script::handing_over(key, &self.stamp, value))
    }

    /// Writes the pictures of a case; returns what became of each.
    fn pictures(&mut self, at: usize, item: &Value, evidence: &dyn Evidence) -> Result<Slots, PageError> {
        let slots = Slots::of(item, evidence);
        for slot in slots.found() {
            let packed = encode::pack(&slot.picture.values, slot.channels, slots.base(slot));
            let packed = packed.map_err(PageError::Pack)?;
            self.pictures += 1;
            self.bytes += packed.len() as u64;
            let value = json!({
                "size": slot.picture.size, "channels": slot.channels, "base": slot.base, "packed": packed,
            });
            self.script(&format!("{at}/{}", slot.name), &value)?;
        }
        Ok(slots)
    }
}
