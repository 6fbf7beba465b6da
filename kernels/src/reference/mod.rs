//! Ground truth by sampling: random numbers, one bounce over a glossy rectangle, means and their errors.
//!
//! Nothing here approximates beyond the noise that it states; what the lobe methods leave out (but occlusion)
//! is in. For each pixel, sample by sample:
//!
//! 1. two random numbers of pixel, sample and decision: [`random_pair`](random::random_pair). No state is
//!    kept, and every route gives the same bits;
//! 2. what it is of, in scenes of many surfaces and lights: [`Reflector`](reflector::Reflector);
//! 3. a direction by one of four techniques, drawn uniformly:
//!    [`one_bounce_sample`](one_bounce::one_bounce_sample);
//! 4. where it meets the rectangle: [`rectangle_intersect`](rectangle::rectangle_intersect),
//!    [`rectangle_is_met`](rectangle::rectangle_is_met);
//! 5. its contribution, 0 where it meets nothing: [`one_bounce_estimate`](one_bounce::one_bounce_estimate),
//!    times the light's irradiance across its direction ([`spot_irradiance`](light::spot_irradiance) for a
//!    spotlight);
//! 6. into the mean: [`running_mean_add`](running_mean::running_mean_add); at the end
//!    [`running_mean_standard_error`](running_mean::running_mean_standard_error), and
//!    [`running_mean_merge`](running_mean::running_mean_merge) for parts.
//!
//! For quadrature in place of chance, [`one_bounce_area_integrand`](one_bounce::one_bounce_area_integrand)
//! over the rectangle is the same integral.
//!
//! Conventions: the integrals are over directions of incidence at the viewed point. The functions are of one rectangle and
//! one light; the passes are of all.

pub mod budget;
pub mod light;
pub mod one_bounce;
pub mod pass;
pub mod random;
pub mod rectangle;
pub mod reflector;
pub mod running_mean;
pub mod textured;
