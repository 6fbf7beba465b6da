//! Every kernel of the library on every instruction set that the machine has, and by the judge of the
//! machine that is fast: the same bits.

use lobe_backends::interp::{Interpreter, Isa};
use lobe_codegen::data::Columns;
use lobe_kernels::registry::KERNELS;
use lobe_tests::domain::Inputs;

/// Rows that fill some batches, and one in part.
const ROWS: usize = 700;

#[test]
fn all_instruction_sets_give_the_same_bits() {
    let isas = Isa::available();
    println!("instruction sets: {}", isas.iter().map(Isa::to_string).collect::<Vec<_>>().join(", "));
    for kernel in KERNELS {
        let def = kernel();
        let module = lobe_codegen::lower(&[*kernel]).unwrap_or_else(|e| panic!("{}: {e}", def.name));
        let f = module.function(def.name).unwrap_or_else(|| panic!("{}: not in its module", def.name));
        let inputs = Inputs::draw(def, ROWS, 5, &Columns::zeros(0, 0)).unwrap_or_else(|e| panic!("{e}"));
        let interpreter = Interpreter::new(&module).unwrap_or_else(|e| panic!("{}: {e}", def.name));
        let judged = interpreter.call_judged(f, &inputs.args).unwrap_or_else(|e| panic!("{}: {e}", def.name));
        for isa in &isas {
            let called = interpreter.clone().with_isa(*isa).call(f, &inputs.args);
            let called = called.unwrap_or_else(|e| panic!("{} on {isa}: {e}", def.name));
            assert!(called == judged, "{}: {isa} differs from the judge", def.name);
        }
    }
}
