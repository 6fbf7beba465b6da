//! Ground truth by sampling: random numbers, one bounce over a glossy rectangle, means and their errors.
//!
//! Nothing here approximates beyond the noise that it states; what the lobe methods leave out (but occlusion) is in.

pub mod light;
pub mod one_bounce;
pub mod random;
pub mod rectangle;
pub mod running_mean;
