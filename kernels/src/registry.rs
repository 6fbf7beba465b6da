//! The list of all kernels. What is not here is not emitted, checked or documented by the tools, and a
//! test says so.

use crate::rect::laplace;
use crate::{hsg, sg, special};
use lobe_codegen::def::FunctionRef;
use lobe_codegen::kernels;

/// All kernels, callees before callers.
pub const KERNELS: &[FunctionRef] = &kernels![
    special::expm1_over_x,
    special::expm1_over_x_slope,
    special::expm1_over_x_higham,
    special::erf,
    sg::sg_eval,
    sg::sg_eval_paper,
    sg::sg_integral,
    sg::sg_product,
    sg::sg_product_paper,
    sg::sg_sg_product_integral,
    sg::sg_sg_product_integral_iwasaki,
    hsg::hsg_steepness,
    hsg::hsg_upper_integral,
    hsg::hsg_ratio,
    hsg::hsg_integral,
    hsg::hsg_integral_paper,
    hsg::clamped_cosine,
    hsg::clamped_cosine_paper,
    hsg::hsg_cosine_product_integral,
    hsg::hsg_cosine_product_integral_paper,
    laplace::rect_laplace,
    laplace::rect_laplace_sg,
    laplace::rect_laplace_fast,
    laplace::rect_laplace_fast_sg,
];
