//! All kernels lower together into one valid module.

#[test]
fn all_kernels_lower() {
    let module = lobe_codegen::lower(lobe_kernels::registry::KERNELS).unwrap_or_else(|e| panic!("{e}"));
    for kernel in lobe_kernels::registry::KERNELS {
        assert!(module.function(kernel().name).is_some(), "{}", kernel().name);
        for budget in kernel().contract.budget {
            lobe_codegen::lower(&[budget.function]).unwrap_or_else(|e| panic!("{e}"));
        }
    }
}
