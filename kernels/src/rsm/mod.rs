//! Reflective shadow maps: what a light sees, texel by texel, and the virtual lights that are drawn out of it.
//!
//! | file | what |
//! |---|---|
//! | [`view`] | rays through the texels of a map |
//! | [`point`] | what is seen in a texel: a virtual point light |
//! | [`mean`] | what is kept of several texels |
//! | [`chain`] | means of ever larger squares: a mip chain |
//! | [`density`] | how much each texel matters to what the camera sees |
//! | [`curve`] | the order of the texels in these |
//! | [`scan`] | sums of all texels before each |
//! | [`draw`] | texels by their density, read at the level that it asks for: virtual lights |
//! | [`stratum`] | lights of all texels between two that are drawn |
//! | [`light`] | a virtual light, and what it sends by way of a surface |
//! | [`shade`] | all virtual lights on each pixel |
//! | [`shadow`] | rays between pixels and virtual lights |
//! | [`imperfect`] | small maps of what hides each virtual light |
//! | [`wide`] | virtual lights whose lobes are GGX |
//! | [`two`] | the whole map as two lights |
//!
//! A map of the camera is made in the same way: a pixel is a texel whose light is the camera. Importance is light that
//! goes the other way, so what the texels of a light's map mean to it is what they would receive of virtual lights drawn
//! out of the camera's.
//!
//! A map's passes call their buffers `map_points`, `levels` and `map_means`, whatever the map is of.

pub mod chain;
pub mod curve;
pub mod density;
pub mod draw;
pub mod imperfect;
pub mod light;
pub mod mean;
pub mod point;
pub mod scan;
pub mod shade;
pub mod shadow;
pub mod stratum;
pub mod two;
pub mod view;
pub mod wide;
