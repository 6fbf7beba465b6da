//! The CPU executor: strict results against the native functions, shadow bounds against chance drivers.

#[path = "interp/support.rs"]
mod support;

#[path = "interp/bindings.rs"]
mod bindings;
#[path = "interp/chance.rs"]
mod chance;
#[path = "interp/conformance.rs"]
mod conformance;
#[path = "interp/control.rs"]
mod control;
#[path = "interp/dispatch.rs"]
mod dispatch;
#[path = "interp/elements.rs"]
mod elements;
#[path = "interp/integers.rs"]
mod integers;
#[path = "interp/memory.rs"]
mod memory;
#[path = "interp/overrides.rs"]
mod overrides;
#[path = "interp/sanitize.rs"]
mod sanitize;
#[path = "interp/shadow.rs"]
mod shadow;
#[path = "interp/shadow_runs.rs"]
mod shadow_runs;
#[path = "interp/soundness.rs"]
mod soundness;
#[path = "interp/sums.rs"]
mod sums;
#[path = "interp/texels.rs"]
mod texels;
#[path = "interp/textures.rs"]
mod textures;
#[path = "interp/truths.rs"]
mod truths;
#[path = "interp/widths.rs"]
mod widths;
