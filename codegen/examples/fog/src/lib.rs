//! A pass that puts fog before a picture: its shader, and the structures that its buffers hold.
//!
//! ```
//! let fog = fog::host::Fog {
//!     albedo: [0.9, 0.95, 1.0],
//!     extinction: 0.002,
//!     falloff: 0.01,
//!     phase_sharpness: 8.0,
//!     ..bytemuck::Zeroable::zeroed()
//! };
//! // The bytes of the uniform buffer at group 0, binding 0.
//! assert_eq!(bytemuck::bytes_of(&fog).len(), 32);
//! assert!(fog::WGSL.contains("fn fog_pass("));
//! ```

/// The pass in WGSL; its entry point is `fog_pass`.
pub const WGSL: &str = include_str!(concat!(env!("OUT_DIR"), "/fog.wgsl"));

/// The pass in HLSL, for shader model 6.
pub const HLSL: &str = include_str!(concat!(env!("OUT_DIR"), "/fog.hlsl"));

/// Functions, structures with their offsets, and bindings, as JSON.
pub const REFLECTION: &str = include_str!(concat!(env!("OUT_DIR"), "/fog.json"));

/// Invocations in a workgroup.
pub const WORKGROUP: usize = 64;

/// Structures as the shader lays them out.
pub mod host {
    include!(concat!(env!("OUT_DIR"), "/fog.rs"));
}
