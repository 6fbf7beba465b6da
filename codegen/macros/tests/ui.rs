//! What the macro says: each file in `ui/` is refused with the text beside it, and those in
//! `ui/pass/` compile without a warning.
//!
//! `TRYBUILD=overwrite cargo test -p lobe-macros --test ui` writes the texts anew; read the difference.

#[test]
fn messages() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/pass/*.rs");
    cases.compile_fail("tests/ui/*.rs");
}
