//! Memory that a dispatch is given.

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
