//! How coordinates become texels.

/// Which texels a sample takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Filter {
    /// The nearest.
    Nearest,
    /// Those around, weighted by their nearness.
    Linear,
}

/// What lies beyond the edges, along one axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Address {
    /// The texel at the edge.
    ClampToEdge,
    /// The texture again.
    Repeat,
    /// The texture again, every other time reversed.
    MirrorRepeat,
}

/// A sampler; [`Sampler::default`] is WebGPU's: nearest, clamped to the edge, all levels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampler {
    /// Along each axis.
    pub address: [Address; 3],
    /// Where a texel is larger than what is sampled.
    pub magnify: Filter,
    /// Where it is smaller.
    pub minify: Filter,
    /// Between levels.
    pub mip: Filter,
    /// The lowest and highest level of detail; the first is not negative and not above the second.
    pub lod: [f32; 2],
    /// Of a comparison sampler: how a reference compares with a texel.
    pub compare: Option<Compare>,
}

/// A comparison of a reference with a texel's depth.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Compare {
    /// Never.
    Never,
    /// `reference < texel`
    Less,
    /// `reference == texel`
    Equal,
    /// `reference <= texel`
    LessEqual,
    /// `reference > texel`
    Greater,
    /// `reference != texel`
    NotEqual,
    /// `reference >= texel`
    GreaterEqual,
    /// Always.
    Always,
}

impl Compare {
    /// Whether it holds.
    pub(crate) fn holds(self, reference: f32, texel: f32) -> bool {
        match self {
            Self::Never => false,
            Self::Less => reference < texel,
            Self::Equal => reference == texel,
            Self::LessEqual => reference <= texel,
            Self::Greater => reference > texel,
            Self::NotEqual => reference != texel,
            Self::GreaterEqual => reference >= texel,
            Self::Always => true,
        }
    }
}

impl Default for Sampler {
    fn default() -> Self {
        Self {
            address: [Address::ClampToEdge; 3],
            magnify: Filter::Nearest,
            minify: Filter::Nearest,
            mip: Filter::Nearest,
            lod: [0.0, 32.0],
            compare: None,
        }
    }
}

impl Sampler {
    /// Linear along all axes and between levels.
    #[must_use]
    pub fn linear() -> Self {
        Self { magnify: Filter::Linear, minify: Filter::Linear, mip: Filter::Linear, ..Self::default() }
    }

    /// The same with this address mode along all axes.
    #[must_use]
    pub fn addressed(self, address: Address) -> Self {
        Self { address: [address; 3], ..self }
    }

    /// The same as a comparison sampler.
    #[must_use]
    pub fn comparing(self, compare: Compare) -> Self {
        Self { compare: Some(compare), ..self }
    }
}
