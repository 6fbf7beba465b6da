//! The declared name is the emitted one; two definitions of one name are refused.

use crate::check::{lowered, wgsl};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

mod other {
    use lobe_codegen::prelude::*;

    /// Another lobe.
    #[kernel]
    pub(crate) struct Lobe {
        /// Power.
        pub(crate) power: f32,
    }

    #[kernel]
    pub(crate) const SCALE: f32 = 2.0;

    #[kernel]
    pub(crate) fn width(x: f32) -> f32 {
        x * SCALE
    }

    #[kernel]
    pub(crate) fn power(lobe: Lobe) -> f32 {
        lobe.power
    }
}

/// A lobe.
#[kernel]
struct Lobe {
    /// Sharpness.
    sharpness: f32,
}

#[kernel]
const SCALE: f32 = 3.0;

#[kernel]
fn width(lobe: Lobe) -> f32 {
    lobe.sharpness * SCALE
}

#[track_caller]
fn clash(kernels: &[lobe_codegen::def::FunctionRef], name: &str) {
    let message = lobe_codegen::lower(kernels).unwrap_err().to_string();
    assert!(message.contains(&format!("two items of one module are called `{name}`")), "{message}");
    assert!(message.contains("names.rs"), "{message}");
}

#[kernel]
fn area(x: f32) -> f32 {
    x * SCALE
}

#[test]
fn two_items_of_one_name_are_refused() {
    clash(&kernels![width, other::width], "width");
    clash(&kernels![width, other::power], "Lobe");
    clash(&kernels![area, other::width], "SCALE");
}

#[test]
fn declared_names_are_emitted() {
    let text = wgsl(&lowered(&kernels![width]));
    for name in ["fn width(lobe: Lobe)", "struct Lobe", "sharpness: f32", "const SCALE"] {
        assert!(text.contains(name), "{name} is missing in\n{text}");
    }
}

macro_rules! twins {
    ($($module:ident)*) => {
        $(mod $module {
            use lobe_codegen::prelude::*;

            #[kernel]
            pub(crate) fn twin(x: f32) -> f32 {
                x
            }
        })*
    };
}
twins! { first second }

/// They share their line, and are two all the same.
#[test]
fn items_of_one_macro_are_told_apart() {
    clash(&kernels![first::twin, second::twin], "twin");
}
