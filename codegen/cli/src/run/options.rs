//! Options of one shader, on the command line or in a list.

use crate::model;
use lobe_codegen::accuracy::Model;
use lobe_tests::shader::feed::Feed;
use lobe_tests::shader::job::{Entry, FUEL, Job, TIMEOUT, usual};
use lobe_tests::shader::texture::{SamplerWords, Sketch};
use std::path::PathBuf;

/// What is asked of one shader.
#[derive(Debug, Clone, Default, clap::Args)]
pub(super) struct JobArgs {
    /// The shader, by its extension: .wgsl, .spv, .glsl or .comp
    pub(super) file: Option<PathBuf>,
    /// Compute entry point; not needed where there is only one
    #[arg(long, value_name = "NAME")]
    entry: Option<String>,
    /// Workgroups along each axis [default: 1,1,1]
    #[arg(long, value_name = "X,Y,Z", value_parser = workgroups)]
    workgroups: Option<[u32; 3]>,
    /// What a buffer or texture holds: NAME (or GROUP:BINDING, or `immediate`; of an element of a binding array `NAME[INDEX]`) = FILE, zeros, random:SEED, edges:SEED or words:WORD,..
    #[arg(long = "input", value_name = "NAME=FILE|zeros|random:SEED|edges:SEED|words:WORD,..", value_parser = named::<Feed>)]
    inputs: Vec<(String, Feed)>,
    /// What every buffer and texture holds that --input does not name [default: random:0]
    #[arg(long, value_name = "zeros|random:SEED|edges:SEED", value_parser = drawn)]
    fill: Option<Feed>,
    /// Write what the interpreter leaves in a buffer to FILE, as bytes or as .json
    #[arg(long = "output", value_name = "NAME=FILE", value_parser = named::<PathBuf>)]
    outputs: Vec<(String, PathBuf)>,
    /// Length of a buffer
    #[arg(long = "size", value_name = "NAME=BYTES", value_parser = named::<usize>)]
    sizes: Vec<(String, usize)>,
    /// Elements of a binding array that does not say how many it has [default: those that are named, 4 at least]
    #[arg(long = "elements", value_name = "NAME=N", value_parser = named::<u32>)]
    elements: Vec<(String, u32)>,
    /// Shape of a texture [default: 16 texels along each side, all levels, 4 pictures in an array]
    #[arg(long = "texture", value_name = "NAME=FORMAT:WxHxD[:LAYERS[:LEVELS]]", value_parser = named::<Sketch>)]
    textures: Vec<(String, Sketch)>,
    /// Words for a sampler: linear, mip-linear, repeat, mirror, less, .., lod:LOW:HIGH [default: nearest]
    #[arg(long = "sampler", value_name = "NAME=WORD,..", value_parser = named::<SamplerWords>)]
    samplers: Vec<(String, SamplerWords)>,
    /// How far floats of NAME may be from the interpreter's where no bound is derived, as with textures
    #[arg(long = "within", value_name = "NAME=BOUND", value_parser = named::<f64>)]
    within: Vec<(String, f64)>,
    /// Look for mistakes of the program itself: out of bounds, races, division by zero, ..
    #[arg(long)]
    sanitize: bool,
    /// What drivers are permitted, by specification; see `lobe list --operations` [default: portable]
    #[arg(long, value_name = "MODEL", value_parser = model::parser())]
    model: Option<&'static Model>,
    /// Value of a pipeline-overridable constant, by name or @id
    #[arg(long = "override", value_name = "NAME=VALUE", value_parser = named::<f64>)]
    overrides: Vec<(String, f64)>,
    /// Compare only with these routes, as spirv@lavapipe; see below [default: ready]
    #[arg(long = "route", value_name = "ROUTE")]
    routes: Vec<String>,
    /// Rounds of loops that 128 invocations, or a workgroup, may run on the interpreter [default: 4194304]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    fuel: Option<u64>,
    /// Seconds that each step may take [default: 20]
    #[arg(long, value_name = "S", value_parser = clap::value_parser!(u64).range(1..=86_400))]
    timeout: Option<u64>,
}

impl JobArgs {
    /// The job for `file`; `entries` if no entry point is named.
    pub(super) fn job(&self, file: PathBuf, entries: Entry) -> Job {
        Job {
            workgroups: self.workgroups.unwrap_or([1; 3]),
            inputs: self.inputs.clone(),
            usual: self.fill.clone().unwrap_or_else(usual),
            outputs: self.outputs.clone(),
            sizes: self.sizes.clone(),
            elements: self.elements.clone(),
            textures: self.textures.clone(),
            samplers: self.samplers.clone(),
            within: self.within.clone(),
            sanitize: self.sanitize,
            model: self.model.map(|model| model.name.to_owned()),
            overrides: self.overrides.clone(),
            routes: self.routes.clone(),
            fuel: self.fuel.unwrap_or(FUEL),
            timeout: self.timeout.unwrap_or(TIMEOUT),
            ..Job::new(file, self.entry.clone().map_or(entries, Entry::Named))
        }
    }

    /// Whether these name files beside the shader, which the shader's own text must not do.
    pub(super) fn names_files(&self) -> bool {
        let reads = self.inputs.iter().any(|(_, feed)| matches!(feed, Feed::File(_)));
        reads || self.file.is_some() || !self.outputs.is_empty()
    }

    /// What these say, and else what `common` says; of values by name, both.
    pub(super) fn or(self, common: &Self) -> Self {
        Self {
            file: self.file,
            entry: self.entry.or_else(|| common.entry.clone()),
            workgroups: self.workgroups.or(common.workgroups),
            fill: self.fill.or_else(|| common.fill.clone()),
            inputs: [common.inputs.clone(), self.inputs].concat(),
            outputs: [common.outputs.clone(), self.outputs].concat(),
            sizes: [common.sizes.clone(), self.sizes].concat(),
            elements: [common.elements.clone(), self.elements].concat(),
            textures: [common.textures.clone(), self.textures].concat(),
            samplers: [common.samplers.clone(), self.samplers].concat(),
            within: [common.within.clone(), self.within].concat(),
            sanitize: self.sanitize || common.sanitize,
            model: self.model.or(common.model),
            overrides: [common.overrides.clone(), self.overrides].concat(),
            routes: if self.routes.is_empty() { common.routes.clone() } else { self.routes },
            fuel: self.fuel.or(common.fuel),
            timeout: self.timeout.or(common.timeout),
        }
    }
}

/// `NAME=VALUE`.
fn named<T>(text: &str) -> Result<(String, T), String>
where
    T: std::str::FromStr,
    T::Err: std::fmt::Display,
{
    let (name, value) = text.split_once('=').ok_or("it has no `=` between a name and a value")?;
    let value = value.parse().map_err(|e: T::Err| e.to_string())?;
    Ok((name.to_owned(), value))
}

/// What is drawn, and no file.
fn drawn(text: &str) -> Result<Feed, String> {
    match text.parse()? {
        Feed::File(_) => {
            Err("zeros, random:SEED or edges:SEED is wanted; --input NAME=FILE names files".to_owned())
        }
        feed => Ok(feed),
    }
}

fn workgroups(text: &str) -> Result<[u32; 3], String> {
    let sides = text.split(',').map(|side| side.trim().parse::<u32>().ok().filter(|n| *n > 0));
    let sides: Vec<u32> = sides.collect::<Option<_>>().ok_or("each number is an integer of at least 1")?;
    match sides[..] {
        [x] => Ok([x, 1, 1]),
        [x, y] => Ok([x, y, 1]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err("one to three numbers are wanted, with commas between".to_owned()),
    }
}
