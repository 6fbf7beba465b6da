//! A test for each kernel and route: `check::fog_apply::robust`, `check::fog_apply::spirv_lavapipe`, ..

use fog_kernels::{fog_apply, fog_in_scattering, fog_optical_depth};

lobe_tests::check!(fog_optical_depth, fog_in_scattering, fog_apply, inputs = 2_000);
