//! `lobe compare`: how far a picture is from another.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use lobe_tests::metrics::flip::{PIXELS_PER_DEGREE, ToneMap};
use lobe_tests::metrics::{self, Comparison, Opened, Pair, Range, Viewing};
use serde::Serialize;
use std::borrow::Cow;
use std::path::PathBuf;

/// Version of the format.
const SCHEMA: u32 = 1;

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    /// The picture that is judged: `.exr` or `.png`
    picture: PathBuf,
    /// What it should be, in the same form and size
    truth: PathBuf,
    /// Layer of both EXR files, as `indirect_specular_vis` of the channels `indirect_specular_vis.R`, ..
    #[arg(long, value_name = "NAME")]
    layer: Option<String>,
    /// File to write FLIP of each pixel to, as PNG: black where nothing is seen, yellow where all is
    #[arg(long, value_name = "FILE")]
    map: Option<PathBuf>,
    /// Of EXR files, what makes them pictures for a screen
    #[arg(long, value_enum, default_value_t = Curve::Aces)]
    tone_map: Curve,
    /// Pixels in a degree of the angle under which the screen is seen
    #[arg(long, value_name = "PIXELS", default_value_t = PIXELS_PER_DEGREE, value_parser = pixels_per_degree)]
    pixels_per_degree: f32,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

const HELP: &str = "\
The mean ratio and the relative RMSE are of the luminance of linear values. FLIP is what somebody sees who is shown one \
picture and then the other in its place, 0 to 1: HDR-FLIP of EXR files, over exposures that the truth asks for, LDR-FLIP of PNG \
files, which are read as sRGB. The default of --pixels-per-degree is a screen 0.7 m wide of 3840 columns, seen from 0.7 m.

Exit codes: 0 they are compared, 2 a file or an option is refused.";

/// A curve from radiance to what a screen shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Curve {
    /// Narkowicz' fit to that of ACES
    Aces,
    /// Hable's filmic curve
    Hable,
    /// Reinhard's
    Reinhard,
}

impl From<Curve> for ToneMap {
    fn from(curve: Curve) -> Self {
        match curve {
            Curve::Aces => Self::Aces,
            Curve::Hable => Self::Hable,
            Curve::Reinhard => Self::Reinhard,
        }
    }
}

/// The report as an object.
#[derive(Serialize)]
struct Report<'a> {
    report: &'static str,
    picture: Cow<'a, str>,
    truth: Cow<'a, str>,
    layer: Option<&'a str>,
    #[serde(flatten)]
    comparison: &'a Comparison,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let layer = args.layer.as_deref();
    let (picture, truth) = (metrics::open(&args.picture, layer)?, metrics::open(&args.truth, layer)?);
    let range = common_range(args, &picture, &truth)?;
    let pair = Pair::new(&picture.image, &truth.image)
        .map_err(|cause| Fail::Usage(format!("{}: {cause}", args.picture.display())))?;
    let viewing = Viewing { pixels_per_degree: args.pixels_per_degree, tone_map: args.tone_map.into() };
    let found = metrics::compare(&pair, range, &viewing);
    if let Some(path) = &args.map {
        output::write_file(path, &found.map.png()?)?;
    }
    let [picture, truth] = [&args.picture, &args.truth].map(|path| path.to_string_lossy());
    let report = Report { report: "compare", picture, truth, layer, comparison: &found };
    output::print(&match args.format {
        ListFormat::Human => found.to_string(),
        ListFormat::Json => output::json_line(SCHEMA, &report),
    })?;
    Ok(Outcome::Holds)
}

/// What the values of both mean.
fn common_range(args: &Args, picture: &Opened, truth: &Opened) -> Result<Range, Fail> {
    if picture.range == truth.range {
        return Ok(picture.range);
    }
    let (radiance, screen) = match picture.range {
        Range::High => (&args.picture, &args.truth),
        Range::Low => (&args.truth, &args.picture),
    };
    let message = format!(
        "{} holds radiance, {} what a screen shows: compare two EXR or two PNG files",
        radiance.display(),
        screen.display()
    );
    Err(Fail::Usage(message))
}

fn pixels_per_degree(text: &str) -> Result<f32, String> {
    let value = text.parse().ok().filter(|v| (1.0..=1000.0).contains(v));
    value.ok_or_else(|| format!("`{text}` is no number of pixels in a degree; take one from 1 to 1000"))
}
