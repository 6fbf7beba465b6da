//! What kernels cost, in scalar operations of the lowered module: a change of form is noticed.

use lobe_backends::executor::Program;
use lobe_kernels::registry::KERNELS;
use lobe_tests::cost;

#[test]
fn show() {
    for kernel in KERNELS.iter().filter(|k| k().name.starts_with("rect_laplace")) {
        let program = Program::new(*kernel).expect("lowers");
        println!("{}: {}", program.name(), cost::of(&program));
        for (_, f) in program.module().module().functions.iter() {
            let name = f.name.clone().unwrap_or_default();
            println!("    {name}: {}", cost::of_callee(&program, &name).expect("is there"));
        }
    }
}
