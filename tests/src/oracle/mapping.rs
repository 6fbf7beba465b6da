//! Which table speaks of which kernel, and how its columns become arguments.
//!
//! The standard mapping is `tests/cases/oracle-map/`, a file a family, compiled in.

use serde::Deserialize;
use std::collections::BTreeMap;

/// The files of the standard mapping.
const STANDARD: &[&str] = &[
    include_str!("../../cases/oracle-map/special.json"),
    include_str!("../../cases/oracle-map/sg.json"),
    include_str!("../../cases/oracle-map/hsg.json"),
    include_str!("../../cases/oracle-map/asg.json"),
    include_str!("../../cases/oracle-map/brdf.json"),
    include_str!("../../cases/oracle-map/filter.json"),
    include_str!("../../cases/oracle-map/rect_laplace.json"),
    include_str!("../../cases/oracle-map/rect.json"),
    include_str!("../../cases/oracle-map/vsgl.json"),
];

/// A mapping file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mapping {
    /// Of the format; 1.
    pub version: u32,
    /// In any order; a row of a table is judged by every entry that matches it.
    pub entries: Vec<Entry>,
}

/// One use of a table.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// `fn` of the rows.
    #[serde(rename = "fn")]
    pub function: String,
    /// `kind` of the rows.
    pub kind: String,
    /// `variant` of the rows; none matches rows without.
    #[serde(default)]
    pub variant: Option<String>,
    /// The kernel that the rows judge.
    pub kernel: String,
    /// What feeds each argument or part of one, by its path.
    pub args: BTreeMap<String, Source>,
    /// Which member of the value judges each part of the result, both by path; empty for the whole.
    pub result: BTreeMap<String, Member>,
    /// A column by which the kernel's result is multiplied before it is compared.
    #[serde(default)]
    pub times: Option<String>,
    /// Whether the value is to be matched, or an approximation error measured.
    pub rule: Rule,
    /// Parts of the result, by path, whose sign is free: the nearer of the two is compared.
    #[serde(default)]
    pub free_sign: Vec<String>,
    /// For the rule `distribution`: in which ranges quantiles of the ratio of result to value must lie.
    #[serde(default)]
    pub quantiles: Vec<Quantile>,
    /// Errors permitted beside those of the rule.
    #[serde(default)]
    pub slack: Vec<Slack>,
    /// Rows that are passed over.
    #[serde(default)]
    pub skip: Vec<Skip>,
}

/// Rows that an entry passes over: those that meet every condition it states.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Skip {
    /// A text in the row's tag.
    #[serde(default)]
    pub tag: Option<String>,
    /// Columns and the values that they have.
    #[serde(default)]
    pub args: BTreeMap<String, f64>,
    /// Quantities (see [`Scale`]) and the range that they lie in.
    #[serde(default)]
    pub between: BTreeMap<String, (f64, f64)>,
    /// The parts of the result that are passed over, by path; none stated: the whole row.
    #[serde(default)]
    pub parts: Vec<String>,
    /// Why.
    pub why: String,
}

/// Where the value of an argument comes from.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Source {
    /// A constant.
    Constant(f64),
    /// A column, or a member of a nested one by its path.
    Column(String),
    /// A column that is changed in f64 first.
    Transformed(Transform),
}

/// A change of a column's value.
#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Transform {
    /// A vector, normalised in f64: the tables' values are those of the normalised vectors.
    Unit(String),
    /// The natural logarithm.
    Ln(String),
    /// The cosine.
    Cos(String),
    /// The sine.
    Sin(String),
    /// The tangent.
    Tan(String),
    /// The square root.
    Sqrt(String),
    /// The opposite.
    Negated(String),
    /// Minus the vector, normalised.
    NegatedUnit(String),
    /// The first vector, made perpendicular to the second and normalised.
    NormalTo(String, String),
    /// The cross product of the second vector and of the first made perpendicular to it, normalised.
    Binormal(String, String),
    /// A list, flat, and filled up with zeros.
    Padded(String),
    /// A list of vectors, each normalised, flat, and filled up with zeros.
    PaddedUnit(String),
    /// How many items a list has.
    Count(String),
}

/// A member of a row's value, by its path; empty for the whole.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Member {
    /// As it is.
    Plain(String),
    /// Its natural logarithm, which is compared with what the kernel returns.
    Ln {
        /// The path.
        ln: String,
    },
}

impl Member {
    /// The path.
    #[must_use]
    pub fn path(&self) -> &str {
        match self {
            Self::Plain(path) | Self::Ln { ln: path } => path,
        }
    }
}

/// What is asked of the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rule {
    /// The formula is to be matched.
    Match,
    /// The value is that of an exact integral, which the kernel approximates within the slack.
    Approximate,
    /// Likewise, with ratios of result to value whose quantiles are stated.
    Distribution,
}

/// A share of the rows, and where the ratio lies that so many do not exceed.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Quantile {
    /// In 0 ..= 1.
    pub share: f64,
    /// The least permitted ratio.
    pub low: f64,
    /// The greatest.
    pub high: f64,
}

/// A permitted error: `factor · of`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Slack {
    /// In which lane.
    pub lane: Lane,
    /// The factor.
    pub factor: f64,
    /// What it multiplies.
    pub of: Scale,
    /// The parts of the result that it is for, by path; none stated: all.
    #[serde(default)]
    pub parts: Vec<String>,
    /// Why.
    pub why: String,
}

/// The arithmetic that a result was computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Lane {
    /// The f64 value.
    F64,
    /// A route's f32 result.
    F32,
    /// Either.
    Both,
}

/// What an error is proportional to: a quantity of the row, or the product of several.
///
/// Quantities are `one`; `value` (of the part that is compared); `value.PATH` (of another); `df32.PATH` (what rounding
/// the arguments does to it); an argument's
/// column (of a vector its length, of a list the sum of magnitudes); and `hemisphere_integral`,
/// Quantities are `one`; `value` (of the part that is compared); `value.PATH` (of another);
/// `df32.PATH` (what rounding the arguments does to it); an argument's column (of a vector its length, of a list
/// the sum of magnitudes); and `hemisphere_integral`,
/// `exp(log_amplitude) · 2π (1 - e^(-sharpness)) / sharpness` out of the columns of these names.
/// Quantities are `one`; `value` (of the part that is compared); `value.PATH` (of another); an argument's
/// column (of a vector its length, of a list the sum of magnitudes); `hemisphere_integral`,
/// `exp(log_amplitude) · 2π (1 - e^(-sharpness)) / sharpness` out of the columns of these names; and
/// `vsgl_unoccluded`, `R/π` times the integral of a VSGL's radiance over all directions.
/// All are taken without sign.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
pub enum Scale {
    /// One.
    Quantity(String),
    /// Several.
    Product(Vec<String>),
}

/// A mapping that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("the oracle mapping cannot be used: {0}")]
pub struct MappingError(String);

impl Mapping {
    /// One that maps no table.
    #[must_use]
    pub fn none() -> Self {
        Self { version: 1, entries: Vec::new() }
    }

    /// The mapping of Lobe's own kernels.
    ///
    /// # Errors
    /// When a file that was compiled in is malformed, which a test rules out.
    pub fn standard() -> Result<Self, MappingError> {
        let files = STANDARD.iter().map(|text| Self::parse(text)).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { version: 1, entries: files.into_iter().flat_map(|file| file.entries).collect() })
    }

    /// Reads a mapping.
    ///
    /// # Errors
    /// When it is no JSON of this format, or of another version.
    pub fn parse(text: &str) -> Result<Self, MappingError> {
        let mapping: Self = serde_json::from_str(text).map_err(|e| MappingError(e.to_string()))?;
        match mapping.version {
            1 => Ok(mapping),
            other => Err(MappingError(format!("its version is {other}, this Lobe reads 1"))),
        }
    }

    /// The entries that judge `kernel`.
    pub fn of_kernel<'a>(&'a self, kernel: &'a str) -> impl Iterator<Item = &'a Entry> {
        self.entries.iter().filter(move |e| e.kernel == kernel)
    }
}

impl Entry {
    /// `table`, or `table (kind)`, or `table (kind, variant)`: what an answer is about.
    #[must_use]
    pub fn label(&self) -> String {
        match &self.variant {
            None => format!("{} ({})", self.function, self.kind),
            Some(variant) => format!("{} ({}, {variant})", self.function, self.kind),
        }
    }
}
