//! The report as a page: a matrix of kernels and questions, with the details of each answer.
//!
//! One file that loads nothing: style, script and the report itself, as JSON, stand in it.
//! The script makes every element and puts texts in as texts, so no name or message of a report becomes markup.

use super::{Report, json};

const PAGE: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");
const SCRIPTS: [&str; 7] = [
    include_str!("dom.js"),
    include_str!("model.js"),
    include_str!("commands.js"),
    include_str!("summary.js"),
    include_str!("matrix.js"),
    include_str!("detail.js"),
    include_str!("main.js"),
];

/// The report as HTML.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut out = String::new();
    // Each part of the page ends where something belongs; what is put in is never looked at again.
    for (index, part) in PAGE.split("{{").enumerate() {
        let (name, rest) = if index == 0 { ("", part) } else { part.split_once("}}").unwrap_or(("", part)) };
        match name {
            "style" => out += STYLE,
            "report" => out += &within_script(&json::compact(report)),
            "script" => SCRIPTS.iter().for_each(|script| out += script),
            _ => {}
        }
        out += rest;
    }
    out
}

/// JSON that no `</script>` or `<!--` in a text of it ends early.
fn within_script(json: &str) -> String {
    json.replace('<', "\\u003c")
}
