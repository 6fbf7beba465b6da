//! Scripts that hand over data.

use serde_json::Value;

/// A short hash of a report (FNV-1a, 64 bits): it tells reports apart, and need not withstand an attack.
pub(super) fn stamp(report: &Value) -> String {
    let text = report.to_string();
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", text.as_bytes().iter().fold(0xcbf2_9ce4_8422_2325, step))
}

/// A script that hands `value` over under `key`.
pub(super) fn handing_over(key: &str, stamp: &str, value: &Value) -> String {
    format!("lobe_golden('{}', '{}', '{}');\n", quoted(key), quoted(stamp), quoted(&value.to_string()))
}

/// A text within a string of JavaScript in single quotes: nothing in it ends the string, the line, or a `<script>`.
fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 16);
    for c in text.chars() {
        match c {
            '\\' => out += "\\\\",
            '\'' => out += "\\'",
            '<' => out += "\\x3c",
            '\n' => out += "\\n",
            '\r' => out += "\\r",
            '\u{2028}' => out += "\\u2028",
            '\u{2029}' => out += "\\u2029",
            c => out.push(c),
        }
    }
    out
}

/// The page's scripts as one, whose names are nobody else's.
pub(super) fn joined(scripts: &[&str]) -> String {
    format!("(() => {{\n\"use strict\";\n{}\n}})();\n", scripts.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn no_text_ends_the_string_that_it_is_in() {
        for text in ["'", "\\", "\\'", "</script><script>alert(1)</script>", "<!--", "\u{2028}\u{2029}\n\r"] {
            let script = handing_over("0/item", "0", &json!({ "name": text }));
            let inner =
                script.strip_prefix("lobe_golden('0/item', '0', '").and_then(|s| s.strip_suffix("');\n"));
            let inner = inner.unwrap_or_else(|| panic!("{script}"));
            assert!(!inner.contains(['<', '\n', '\r', '\u{2028}', '\u{2029}']), "{script}");
            // Every quote has an odd number of backslashes before it.
            let ends = inner.match_indices('\'').filter(|(at, _)| {
                let before = inner[..*at].bytes().rev().take_while(|byte| *byte == b'\\').count();
                before % 2 == 0
            });
            assert_eq!(ends.count(), 0, "{script}");
        }
    }

    #[test]
    fn other_reports_have_other_stamps() {
        assert_ne!(stamp(&json!({ "a": 1 })), stamp(&json!({ "a": 2 })));
    }
}
