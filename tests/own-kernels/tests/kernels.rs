//! A test for each kernel and route: `check::falloff::robust`, `check::falloff::spirv_lavapipe`, ..

use own_kernels::{falloff, reflected};

lobe_tests::check!(falloff, reflected, inputs = 2_000);
