//! What the documentation of a kernel says was measured, was measured of this definition.
//!
//! Here stands what takes no time; `lobe measure --check` (a step of `tests/ci.sh`) measures again.

use lobe_backends::executor::Program;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_kernels::registry::KERNELS;
use lobe_tests::measure;
use lobe_tests::measure::file::{self, File};
use lobe_tests::subject::Subject;

#[test]
fn every_kernel_shows_what_was_measured_of_it() {
    for kernel in KERNELS {
        let def = kernel();
        let mend = format!("lobe measure {} --write", def.name);
        let Some(shown) = def.contract.measured else {
            panic!("{}: its #[kernel(..)] does not say `measured`; {mend}", def.name);
        };
        let path = file::path(&measure::folder(), def.name);
        let name = path.display();
        let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{name}: {e}; {mend}"));
        assert_eq!(shown, text, "{name}: changed since this test was built");
        let file = File::parse(&text).unwrap_or_else(|| panic!("{name}: is damaged; {mend}"));
        let subject = Subject::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let definition = measure::definition(&subject).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(file.definition, format!("{definition:016x}"), "{name}: is of another definition; {mend}");
    }
}

#[test]
fn every_file_has_its_kernel() {
    for entry in std::fs::read_dir(measure::folder()).expect("the folder").flatten() {
        let is_one = KERNELS.iter().any(|k| file::path(&measure::folder(), k().name) == entry.path());
        assert!(is_one, "{} outlived its kernel: remove it", entry.path().display());
    }
}

#[test]
fn an_emitted_comment_says_what_holds_on_every_machine() {
    for kernel in KERNELS {
        let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let text =
            emit(program.module(), Target::Wgsl, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
        let text = text.content.text().expect("text");
        assert!(text.contains("/// Permitted error") && text.contains("/// Worst error: "), "{text}");
        assert!(!text.contains("lavapipe") && !text.contains("<!--"), "{text}");
    }
}
