//! What a check of golden images found, for programs: `tests/schema/golden-1.json`.

use crate::metrics::{Pooled, Worst as Furthest};
use crate::report::Skipped;
use lobe_golden::{Acceptance, CHANNELS, Chain, Hash, Kernel, Record};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the format.
pub const SCHEMA: u32 = 1;

/// What a check found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Version of the format.
    pub schema: u32,
    /// `golden`.
    pub report: String,
    /// Version of Lobe.
    pub lobe: String,
    /// Where it ran.
    pub environment: String,
    /// The folder of goldens.
    pub golden: String,
    /// The folder of pictures.
    pub evidence: Option<String>,
    /// Routes that pictures were rendered on.
    pub routes: Vec<RouteName>,
    /// Routes that this machine lacks.
    pub skipped: Vec<Skipped>,
    /// The cases.
    pub items: Vec<Item>,
    /// Goldens that no case names.
    pub dead: Vec<String>,
    /// Whether a decision was broken off and is not completed.
    pub interrupted: bool,
    /// The folder of pending goldens, if any were written.
    pub pending: Option<String>,
    /// Bytes of all goldens.
    pub bytes: u64,
    /// Items by verdict.
    pub tally: Tally,
}

/// A route and what decides its results.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RouteName {
    /// The route.
    pub route: String,
    /// Driver, version, device, processor.
    pub driver: String,
}

/// How many items have which verdict.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Tally {
    /// [`Verdict::Holds`].
    pub holds: usize,
    /// [`Verdict::Restated`].
    pub restated: usize,
    /// [`Verdict::Changed`].
    pub changed: usize,
    /// [`Verdict::Missing`].
    pub missing: usize,
    /// [`Verdict::Damaged`].
    pub damaged: usize,
    /// [`Verdict::FallsShort`].
    pub falls_short: usize,
    /// [`Verdict::Failed`].
    pub failed: usize,
}

/// How a case came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Every route is inside what the golden permits.
    Holds,
    /// The same, and the truth is the accepted one to the last bit, but hashes are others.
    Restated,
    /// The truth is another.
    Changed,
    /// There is no golden.
    Missing,
    /// It cannot be used.
    Damaged,
    /// A route is outside.
    FallsShort,
    /// It could not be rendered.
    Failed,
}

/// A case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Item {
    /// The scene.
    pub scene: String,
    /// The method.
    pub method: String,
    /// `render` or `plot`.
    pub kind: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Parameters.
    pub settings: BTreeMap<String, String>,
    /// How it came out.
    pub verdict: Verdict,
    /// In words.
    pub why: String,
    /// What it depends on.
    pub chain: ChainReport,
    /// What was accepted.
    pub accepted: Option<Accepted>,
    /// Whether the truth was computed.
    pub rendered: bool,
    /// Why it need not be.
    pub proof: Option<String>,
    /// The new truth against the accepted one.
    pub truth: Option<TruthReport>,
    /// Pictures.
    pub files: Files,
    /// Each route.
    pub routes: Vec<RouteReport>,
    /// What was written, then and now.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub texts: Vec<Text>,
    /// Laws that the method keeps.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub physics: Vec<Law>,
}

/// A kernel in a language, when its golden was accepted and now.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Text {
    /// The kernel.
    pub kernel: String,
    /// `kernel` for its own source, else what it was emitted as.
    pub target: String,
    /// The text of the acceptance, if it was kept.
    pub before: Option<String>,
    /// The text of now.
    pub after: Option<String>,
}

/// How far a route is from a law of physics.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Law {
    /// The route.
    pub route: String,
    /// The law, as `white_furnace`.
    pub name: String,
    /// The distance from it.
    pub residual: Share,
    /// How large it may be.
    pub permitted: Share,
}

/// What a case depends on, in hashes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ChainReport {
    /// Of everything.
    pub hash: Option<Hash>,
    /// Of the scene.
    pub scene: Option<Hash>,
    /// Of the parameters.
    pub settings: Hash,
    /// Of the kernels.
    pub kernels: Vec<Kernel>,
}

/// What was accepted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Accepted {
    /// What it depended on.
    pub chain: ChainReport,
    /// Who accepted it.
    pub by: String,
    /// When.
    pub at: String,
    /// Why.
    pub why: String,
    /// Where it was made.
    pub environment: String,
    /// Of the EXR file.
    pub exr: Hash,
    /// What routes returned.
    pub routes: Vec<RouteBefore>,
}

/// What a route returned when the golden was accepted.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct RouteBefore {
    /// The route.
    pub route: String,
    /// Its driver.
    pub driver: String,
    /// Hash of what its target was given.
    pub emitted: Option<Hash>,
    /// Hash of the picture.
    pub output: Hash,
}

/// The new truth against the accepted one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct TruthReport {
    /// Values that are other f32 numbers.
    pub differing: usize,
    /// How many f32 numbers the furthest one is off.
    pub furthest_ulp: u32,
    /// Values that are further off than a driver may be.
    pub beyond_permitted: usize,
}

/// Pictures, within the folder of evidence.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Files {
    /// The accepted golden.
    pub accepted: Option<String>,
    /// The new one.
    pub fresh: Option<String>,
}

/// A route, judged.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RouteReport {
    /// The route.
    pub route: String,
    /// Its driver.
    pub driver: String,
    /// How it came out.
    pub verdict: RouteVerdict,
    /// In words.
    pub why: String,
    /// Against what it returned when the golden was accepted.
    pub change: Change,
    /// Hash of what its target is given.
    pub emitted: Option<Hash>,
    /// Hash of the picture.
    pub output: Option<Hash>,
    /// Pixels.
    pub pixels: PixelCount,
    /// The value that uses most of what is permitted.
    pub worst: Option<WorstValue>,
    /// Shares that half, 99 %, 99.9 % and all pixels stay within.
    pub shares: [Share; 4],
    /// How far it is from the truth.
    pub metrics: Option<Metrics>,
    /// The picture, within the folder of evidence.
    pub picture: Option<String>,
}

/// How a route came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RouteVerdict {
    /// No pixel is outside.
    Inside,
    /// One is.
    Outside,
    /// None is, but of too many nothing is promised.
    Indeterminate,
    /// It did not run.
    Failed,
}

/// A route against what it returned when the golden was accepted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// The same bits.
    Same,
    /// The truth is another.
    Mathematics,
    /// The truth is the same, what is emitted is another text.
    Emission,
    /// The text is the same, the driver another.
    Driver,
    /// Neither, but other bits.
    Unexplained,
    /// Nothing was noted of the route.
    New,
}

/// Pixels by what was found of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct PixelCount {
    /// Within what is permitted.
    pub inside: usize,
    /// Not.
    pub outside: usize,
    /// Nothing is promised.
    pub indeterminate: usize,
    /// The nearest floats to the truth.
    pub equal: usize,
}

/// A number that may be infinite, which JSON has no word for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Share(#[serde(with = "crate::question::float")] pub f64);

/// A value and how it stands.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WorstValue {
    /// Column, from the left.
    pub x: usize,
    /// Row, from the top.
    pub y: usize,
    /// `R`, `G` or `B`.
    pub channel: String,
    /// What the route has.
    pub found: Share,
    /// What is true.
    pub truth: Share,
    /// The permitted distance.
    pub permitted: Share,
    /// The distance over it.
    pub share: Share,
}

/// How far a picture is from the truth, for people.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Metrics {
    /// Mean luminance over the truth's.
    pub mean_ratio: Option<Share>,
    /// Root of the mean squared difference over the truth's mean.
    pub relative_rmse: Option<Share>,
    /// The pixel that is furthest off.
    pub furthest: FurthestPixel,
    /// HDR-FLIP.
    pub flip_hdr: Pooled,
    /// LDR-FLIP.
    pub flip_ldr: Pooled,
}

/// The pixel that is furthest off.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FurthestPixel {
    /// Column.
    pub x: u32,
    /// Row.
    pub y: u32,
    /// What the route has.
    pub picture: [Share; 3],
    /// What is true.
    pub truth: [Share; 3],
}

impl From<Furthest> for FurthestPixel {
    fn from(Furthest { x, y, picture, truth }: Furthest) -> Self {
        let shares = |values: [f32; 3]| values.map(|value| Share(value.into()));
        Self { x, y, picture: shares(picture), truth: shares(truth) }
    }
}

impl From<lobe_golden::Worst> for WorstValue {
    fn from(worst: lobe_golden::Worst) -> Self {
        Self {
            x: worst.x,
            y: worst.y,
            channel: CHANNELS[worst.channel].to_owned(),
            found: Share(worst.found.into()),
            truth: Share(worst.truth.into()),
            permitted: Share(worst.permitted.into()),
            share: Share(worst.share),
        }
    }
}

impl From<lobe_golden::Pixels> for PixelCount {
    fn from(pixels: lobe_golden::Pixels) -> Self {
        let lobe_golden::Pixels { inside, outside, indeterminate, equal } = pixels;
        Self { inside, outside, indeterminate, equal }
    }
}

impl From<&Chain> for ChainReport {
    fn from(chain: &Chain) -> Self {
        let Chain { hash, scene, settings, kernels } = chain.clone();
        Self { hash: Some(hash), scene, settings, kernels }
    }
}

impl From<&Record> for Accepted {
    fn from(record: &Record) -> Self {
        let Acceptance { by, at, why } = record.accepted.clone().unwrap_or_else(|| Acceptance {
            by: String::new(),
            at: String::new(),
            why: String::new(),
        });
        let routes = record.routes.iter().map(|route| RouteBefore {
            route: route.route.clone(),
            driver: route.driver.clone(),
            emitted: route.emitted.clone(),
            output: route.output.clone(),
        });
        Self {
            chain: (&record.chain).into(),
            by,
            at,
            why,
            environment: record.environment.clone(),
            exr: record.exr.clone(),
            routes: routes.collect(),
        }
    }
}

impl Verdict {
    /// Whether the case is as it was accepted.
    #[must_use]
    pub fn holds(self) -> bool {
        matches!(self, Self::Holds | Self::Restated)
    }

    /// Its name in reports for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Restated => "restated",
            Self::Changed => "changed",
            Self::Missing => "missing",
            Self::Damaged => "damaged",
            Self::FallsShort => "falls short",
            Self::Failed => "failed",
        }
    }
}

impl Item {
    /// Scene and method.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}/{}", self.scene, self.method)
    }
}

impl Report {
    /// Whether everything is as it was accepted: no case at all is not.
    #[must_use]
    pub fn holds(&self) -> bool {
        !self.items.is_empty()
            && self.items.iter().all(|item| item.verdict.holds())
            && self.dead.is_empty()
            && !self.interrupted
    }

    /// Counts the items.
    #[must_use]
    pub fn tallied(mut self) -> Self {
        let count = |verdict| self.items.iter().filter(|item| item.verdict == verdict).count();
        self.tally = Tally {
            holds: count(Verdict::Holds),
            restated: count(Verdict::Restated),
            changed: count(Verdict::Changed),
            missing: count(Verdict::Missing),
            damaged: count(Verdict::Damaged),
            falls_short: count(Verdict::FallsShort),
            failed: count(Verdict::Failed),
        };
        self
    }

    /// The report as JSON, indented.
    #[must_use]
    pub fn json(&self) -> String {
        // Maps with string keys and finite numbers only: this cannot fail, and if it did the text would say so.
        serde_json::to_string_pretty(self).unwrap_or_else(|error| format!("{:?}", error.to_string())) + "\n"
    }

    /// The report that [`Report::json`] wrote.
    ///
    /// # Errors
    /// When the text is none, with the line and what is wrong there.
    pub fn parse(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}
