//! Memory that a dispatch is given.

use super::fast::pages;

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

impl Buffer {
    /// A buffer with a copy of `bytes`: a large one in large pages where the system has them, so that it is read and
    /// written as fast every time.
    #[must_use]
    pub fn copied(group: u32, binding: u32, bytes: &[u8]) -> Self {
        Self { group, binding, data: pages::copied(bytes) }
    }
}
