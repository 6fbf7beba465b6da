//! Properties that the mathematics must have, on random arguments, and readers on spoilt texts; a file or a folder a family.
//!
//! Each test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run, `LOBE_CASES=n` draws so many.

mod asg;
mod brdf;
mod curve;
mod filter;
mod gltf;
mod imperfect;
mod meshes;
mod rect;
mod reference;
mod scene;
mod sg;
mod support;
mod texels;
mod textured;
mod textures;
mod vsgl;
