//! Memory that a dispatch is given.

/// Group and binding by which a module's immediates are given, which have neither.
pub const IMMEDIATES: (u32, u32) = (u32::MAX, u32::MAX);

/// Bytes bound to a resource, laid out as WGSL lays out its type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Buffer {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// The bytes.
    pub data: Vec<u8>,
}
