//! Every pass is emitted for every target, and every method has its pass.

use lobe_backends::pipeline::Pipeline;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_kernels::registry::PASSES;
use lobe_tests::render::Method;

#[test]
fn every_pass_is_emitted_for_every_target() {
    for pass in PASSES {
        let module = lobe_codegen::lower(&[*pass]).unwrap_or_else(|e| panic!("{e}"));
        for target in Target::ALL {
            emit(&module, target, &Options::default())
                .unwrap_or_else(|e| panic!("{}, {target}: {e}", pass().name));
        }
        assert!(!pass().docs.is_empty(), "{} has no doc comment", pass().name);
    }
}

#[test]
fn passes_that_share_a_name_share_a_layout() {
    let pipeline = Pipeline::new(PASSES).unwrap_or_else(|e| panic!("{e}"));
    for pass in Method::ALL.into_iter().filter_map(Method::rect_pass) {
        assert!(pipeline.pass(pass).is_ok(), "{pass}");
    }
}
