//! What the shadow lane tells of results, buffers and textures.

/// Results of the shadow lane.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShadowColumns {
    /// One for each scalar of the result.
    pub columns: Vec<ShadowColumn>,
    /// Number of rows.
    pub rows: usize,
    /// Rows that met a decision which drivers may take either way; both ways were followed and joined.
    pub ambiguous: Vec<bool>,
    /// Rows without bound for a reason other than arithmetic: an ambiguous exit of a loop, the bits of an
    /// inexact number, an index that is not known.
    pub indeterminate: Vec<bool>,
}

/// One scalar of the result in all rows.
#[derive(Debug, Clone, PartialEq)]
pub enum ShadowColumn {
    /// Floats.
    Float {
        /// In strict f32.
        value: Vec<f32>,
        /// Of the formula in real numbers, along the decisions that these take.
        exact: Vec<f64>,
        /// Largest distance from `exact` of any permitted driver's result; infinite when there is none.
        bound: Vec<f64>,
    },
    /// Integers and booleans.
    Word {
        /// In strict f32.
        value: Vec<u32>,
        /// Whether every permitted driver returns `value`.
        known: Vec<bool>,
    },
}

/// What a dispatch leaves, in the shadow lane.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowRun {
    /// Buffers that the program may write.
    pub buffers: Vec<ShadowBuffer>,
    /// Textures that it may write.
    pub textures: Vec<ShadowTexture>,
}

/// What a dispatch leaves in a storage texture, in the shadow lane.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowTexture {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// Which element, of a binding array; else 0.
    pub element: u32,
    /// Texels that were written, in order.
    pub texels: Vec<ShadowTexel>,
    /// Whether it is known which ones these are.
    pub is_known: bool,
}

/// A texel that was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowTexel {
    /// The byte where it begins.
    pub at: usize,
    /// The least and the largest number that permitted drivers store in each channel, infinite where nothing is
    /// promised; those of integers mean nothing. `None` if drivers may leave anything.
    pub ranges: Option<[[f64; 2]; 4]>,
}

/// What a dispatch leaves in a storage buffer, in the shadow lane.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowBuffer {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// Which element, of a binding array; else 0.
    pub element: u32,
    /// One for each 32-bit word.
    pub words: Vec<ShadowWord>,
    /// Floats of 16 and 64 bits that were written there, in order.
    pub floats: Vec<ShadowFloat>,
}

/// A float of 16 or 64 bits in a buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowFloat {
    /// The byte where it begins.
    pub at: usize,
    /// How many it has.
    pub bytes: u32,
    /// In strict arithmetic.
    pub value: f64,
    /// Of the formula in real numbers.
    pub exact: f64,
    /// Largest distance from `exact` of any permitted driver's result; infinite when there is none.
    pub bound: f64,
}

/// One word of a buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShadowWord {
    /// Written as a float.
    Float {
        /// In strict f32.
        value: f32,
        /// Of the formula in real numbers.
        exact: f64,
        /// Largest distance from `exact` of any permitted driver's result; infinite when there is none.
        bound: f64,
    },
    /// Never written, or written as anything else.
    Word {
        /// In strict f32.
        value: u32,
        /// Whether every permitted driver leaves `value`.
        known: bool,
    },
}
