//! The ground truth by sampling: its random numbers, its mean and error, and its radiance against independent values.
//!
//! Seeds are fixed where noise is judged by its own standard error, so that a run can be repeated.

mod one_bounce;
mod random;
mod rows;

use lobe_kernels::reference::running_mean::RunningMean;

pub(super) const NOTHING: RunningMean = RunningMean { count: 0, mean: 0.0, squares: 0.0 };
