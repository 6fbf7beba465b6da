//! A crate of its own defines kernels on those of another: types, calls, emission, execution.

use lobe_backends::executor::{Executor, Interp, Native, Program};
use lobe_codegen::emit::Target;
use lobe_codegen::prelude::*;
use lobe_kernels::hsg;
use lobe_kernels::sg::{Sg, sg_eval};
use lobe_tests::domain::Inputs;

/// A lobe and what it shines on.
#[kernel]
pub struct Patch {
    /// The light.
    pub light: Sg,
    /// Unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// Diffuse reflectance.
    #[domain(0.0..=1.0)]
    pub albedo: f32,
}

/// Diffuse radiance of a patch, plus the light's own where one looks along it.
#[kernel(family = "example", domain(p.light.sharpness = 0.0..=1e3, view = unit))]
pub fn patch_radiance(p: Patch, view: Vec3) -> f32 {
    let diffuse = p.albedo / 3.14159274 * hsg::hsg_cosine_product_integral(p.light, p.normal);
    diffuse + sg_eval(view, p.light)
}

#[test]
fn it_runs_and_is_emitted_under_its_names() {
    let kernel = lobe_codegen::kernels![patch_radiance][0];
    let program = Program::new(kernel).unwrap_or_else(|e| panic!("{e}"));
    let inputs = Inputs::draw(kernel(), 2000, 3, &Default::default()).unwrap_or_else(|e| panic!("{e}"));
    let native = Native.run(&program, &inputs.args).unwrap_or_else(|e| panic!("{e}"));
    let interp = Interp.run(&program, &inputs.args).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(native, interp);
    for target in [Target::Wgsl, Target::Hlsl] {
        let artifact = program.artifact(target).unwrap_or_else(|e| panic!("{e}"));
        let text = artifact.content.text().expect("text").to_owned();
        for name in ["patch_radiance(", "struct Patch", "struct Sg", "hsg_cosine_product_integral(", "albedo"]
        {
            assert!(text.contains(name), "{target}: no {name}");
        }
    }
}
