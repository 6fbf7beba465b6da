//! A page in a browser without a window.

use lobe_backends::translate::web;
use std::process::{Command, Stdio};

/// The document after `script` ran at the end of `page`, at an address that ends in `hash`; `None`, said aloud, where
/// there is no browser.
pub(crate) fn show(page: &str, hash: &str, script: &str) -> Option<String> {
    let browser = match web::browser() {
        Ok(browser) => browser,
        Err(error) => {
            super::say(&format!("pages were not looked at: {error}"));
            return None;
        }
    };
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("page.html");
    // Within the page's own script, whose names it uses.
    let (before, after) = page.rsplit_once("</script>").expect("a script");
    std::fs::write(&path, format!("{before}\n{script}\n</script>{after}")).expect("writable");
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--virtual-time-budget=5000"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .arg(format!("--user-data-dir={}", folder.path().join("profile").display()))
        .args(["--dump-dom".to_owned(), format!("file://{}{hash}", path.display())])
        .stdin(Stdio::null())
        .output()
        .expect("the browser runs");
    let shown = String::from_utf8_lossy(&output.stdout).into_owned();
    // What was put in as data is not what is shown.
    let (before, rest) = shown.split_once("<script type=\"application/json\"").expect("the page");
    Some(before.to_owned() + rest.split_once("</html>").map_or("", |(_, after)| after))
}
