//! What emitted code costs beside hand-written code: the functions of the accurate-diffuse listings in HLSL by
//! hand and as emitted, through DXC with full optimisation.
//!
//! Each is measured three times: all by hand; the emitted functions, called by the hand's entry point; and the emitted
//! entry point as a whole.

pub mod count;
mod emission;

pub use emission::{Emission, GOAL, emission};

use crate::domain::{DomainError, Inputs, Rng};
use lobe_backends::executor::{ExecError, Program};
use lobe_backends::gpu::{Binding, BindingKind, Gpu, GpuError, Job, Shader};
use lobe_backends::translate::{Dxc, DxcOutput, TranslateError, spirv_words};
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::emit::{EmitError, Options, Target, emit};
use lobe_kernels::registry::KERNELS;

/// The functions by hand.
const LIBRARY: &str = include_str!("hand/library.hlsl");

/// A kernel, and the entry point that calls it, by hand.
#[derive(Debug, Clone, Copy)]
pub struct Listing {
    /// The kernel's name.
    pub kernel: &'static str,
    entry: &'static str,
}

/// What is measured.
pub const LISTINGS: [Listing; 6] = [
    Listing {
        kernel: "hsg_cosine_product_integral",
        entry: include_str!("hand/hsg_cosine_product_integral.hlsl"),
    },
    Listing { kernel: "hsg_integral", entry: include_str!("hand/hsg_integral.hlsl") },
    Listing { kernel: "clamped_cosine", entry: include_str!("hand/clamped_cosine.hlsl") },
    Listing { kernel: "sg_product", entry: include_str!("hand/sg_product.hlsl") },
    Listing { kernel: "expm1_over_x", entry: include_str!("hand/expm1_over_x.hlsl") },
    Listing { kernel: "erf", entry: include_str!("hand/erf.hlsl") },
];

/// How much of it is emitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// Nothing.
    Hand,
    /// The functions.
    Library,
    /// Everything.
    Entry,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Hand, Self::Library, Self::Entry];

    /// Its name: `hand`, `library`, `entry`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Hand => "hand",
            Self::Library => "library",
            Self::Entry => "entry",
        }
    }

    /// How many times the instructions that the hand needs are permitted.
    #[must_use]
    pub fn most_instructions(self) -> f64 {
        match self {
            Self::Hand | Self::Library => 1.0,
            Self::Entry => 1.05,
        }
    }

    /// How many times the time that the hand needs is permitted.
    #[must_use]
    pub fn most_time(self) -> f64 {
        match self {
            Self::Hand => 1.0,
            Self::Library => 1.01,
            Self::Entry => 1.05,
        }
    }
}

/// What a compiler made of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Counts {
    /// Instructions in SPIR-V.
    pub spirv: usize,
    /// Instructions in DXIL.
    pub dxil: usize,
}

/// A part, compiled.
#[derive(Debug, Clone)]
pub struct Compiled {
    /// Which.
    pub part: Part,
    /// Its instructions.
    pub counts: Counts,
    words: Vec<u32>,
    entry: String,
}

/// Why there is no measurement.
#[derive(Debug, thiserror::Error)]
pub enum OverheadError {
    /// The kernel cannot be run.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// The kernel cannot be emitted.
    #[error("{kernel} cannot be emitted: {cause}")]
    Emit {
        /// The kernel.
        kernel: &'static str,
        /// Why.
        cause: EmitError,
    },
    /// A compiler says no.
    #[error("{kernel}, {part}: {cause}", part = part.name())]
    Translate {
        /// The kernel.
        kernel: &'static str,
        /// What of it.
        part: Part,
        /// Why.
        cause: TranslateError,
    },
    /// There are no inputs.
    #[error("{kernel}: {cause}")]
    Domain {
        /// The kernel.
        kernel: &'static str,
        /// Why.
        cause: DomainError,
    },
    /// The driver gave up.
    #[error("{kernel}, {part}: {cause}", part = part.name())]
    Gpu {
        /// The kernel.
        kernel: &'static str,
        /// What of it.
        part: Part,
        /// Why.
        cause: GpuError,
    },
}

impl Listing {
    /// The kernel, lowered.
    ///
    /// # Errors
    /// When it is not written in the kernel language.
    pub fn program(&self) -> Result<Program, OverheadError> {
        let is_meant = |kernel: &&FunctionRef| kernel().name == self.kernel;
        let kernel = KERNELS.iter().find(is_meant).expect("a listing is of a kernel of the registry");
        Ok(Program::new(*kernel)?)
    }

    /// All parts through DXC, optimised.
    ///
    /// # Errors
    /// When DXC refuses one.
    pub fn compile(&self, program: &Program, dxc: &Dxc) -> Result<[Compiled; 3], OverheadError> {
        let emitted = |cause| OverheadError::Emit { kernel: self.kernel, cause };
        let options = Options { docs: false, header: false, ..Options::default() };
        let text = |module| {
            let artifact = emit(module, Target::Hlsl, &options).map_err(emitted)?;
            Ok::<_, OverheadError>(artifact.content.text().unwrap_or_default().to_owned())
        };
        let (module, layout) = program.entry()?;
        let hand = LIBRARY.to_owned() + self.entry;
        let library = text(program.module())? + self.entry;
        Ok([
            self.compile_part(Part::Hand, &hand, "main", dxc)?,
            self.compile_part(Part::Library, &library, "main", dxc)?,
            self.compile_part(Part::Entry, &text(module)?, &layout.entry_name, dxc)?,
        ])
    }

    fn compile_part(
        &self,
        part: Part,
        text: &str,
        entry: &str,
        dxc: &Dxc,
    ) -> Result<Compiled, OverheadError> {
        let kernel = self.kernel;
        let went_wrong = |cause| OverheadError::Translate { kernel, part, cause };
        let compile = |output| dxc.compile(text, "cs_6_0", Some(entry), output);
        let words =
            compile(DxcOutput::SpirvOptimized).and_then(|spirv| spirv_words(&spirv)).map_err(went_wrong)?;
        let dxil = compile(DxcOutput::Dxil).and_then(|dxil| dxc.disassemble(&dxil)).map_err(went_wrong)?;
        let counts = Counts { spirv: count::spirv(&words), dxil: count::dxil(&dxil) };
        Ok(Compiled { part, counts, words, entry: entry.to_owned() })
    }
}

/// What one part of a kernel costs.
#[derive(Debug, Clone, serde::Serialize)]
pub struct Cost {
    /// The kernel.
    pub kernel: &'static str,
    /// What of it is emitted.
    pub part: Part,
    /// Its instructions.
    pub instructions: Counts,
    /// Its instructions over those by hand: the larger of SPIR-V and DXIL.
    pub instructions_to_hand: f64,
    /// Median time of a dispatch.
    pub seconds: f64,
    /// Its time over that by hand, the median of the rounds.
    pub time_to_hand: f64,
    /// Rows.
    pub rows: usize,
    /// Rows whose results have other bits than those by hand.
    pub differing_rows: usize,
}

impl Cost {
    /// Whether it takes no more instructions than its part is permitted, and returns what the hand returns.
    #[must_use]
    pub fn is_lean(&self) -> bool {
        self.instructions_to_hand <= self.part.most_instructions() && self.differing_rows == 0
    }

    /// Whether it takes no more time than its part is permitted.
    #[must_use]
    pub fn is_fast(&self) -> bool {
        self.time_to_hand <= self.part.most_time()
    }
}

/// The larger of both ratios.
#[must_use]
pub fn ratio(part: Counts, hand: Counts) -> f64 {
    let ratio = |part: usize, hand: usize| part as f64 / hand as f64;
    ratio(part.spirv, hand.spirv).max(ratio(part.dxil, hand.dxil))
}

/// Dispatches of a part in a round, of which the fastest counts: what disturbs a driver only delays it.
const DISPATCHES: usize = 5;

/// Measures the parts of `listing` on `rows` rows of its kernel's domain, `rounds` times after one that is not counted.
///
/// # Errors
/// When a compiler or the driver gives up.
pub fn measure(
    listing: &Listing,
    dxc: &Dxc,
    gpu: &mut Gpu,
    rows: usize,
    rounds: usize,
) -> Result<Vec<Cost>, OverheadError> {
    let kernel = listing.kernel;
    let program = listing.program()?;
    let parts = listing.compile(&program, dxc)?;
    let inputs = Inputs::draw(program.def(), rows, 7, &Columns::default())
        .map_err(|cause| OverheadError::Domain { kernel, cause })?;
    let mut bench = Bench { kernel, data: data(&program, &inputs.args)?, rows: inputs.args.rows, gpu };
    let results = parts.iter().map(|part| bench.run(part)).collect::<Result<Vec<_>, _>>()?;
    let mut times = [Vec::new(), Vec::new(), Vec::new()];
    for round in 0..=rounds {
        for at in turn(round) {
            let time = bench.time(&parts[at])?;
            if round > 0 {
                times[at].push(time);
            }
        }
    }
    let hand = parts[0].counts;
    let cost = |(at, part): (usize, &Compiled)| {
        let ratios = times[at].iter().zip(&times[0]).map(|(ours, hand)| ours / hand).collect();
        Cost {
            kernel,
            part: part.part,
            instructions: part.counts,
            instructions_to_hand: ratio(part.counts, hand),
            seconds: super::throughput::median(times[at].clone()),
            time_to_hand: super::throughput::median(ratios),
            rows: bench.rows,
            differing_rows: differing(&results[at], &results[0], bench.rows),
        }
    };
    Ok(parts.iter().enumerate().map(cost).collect())
}

/// Who runs when in a round: each comes first, second and last in turn, in either direction.
fn turn(round: usize) -> [usize; 3] {
    let first = round % 3;
    let mut turn = [first, (first + 1) % 3, (first + 2) % 3];
    if Rng::new(round as u64, "turn").below(2) == 1 {
        turn.swap(1, 2);
    }
    turn
}

/// The buffers: arguments, results, and the number of rows.
fn data(program: &Program, args: &Columns) -> Result<Vec<Vec<u8>>, OverheadError> {
    let (_, layout) = program.entry()?;
    let mut data = program.argument_buffers(args)?;
    data.push(vec![0; layout.result.stride as usize * args.rows]);
    data.push((args.rows as u32).to_le_bytes().to_vec());
    Ok(data)
}

/// Rows that differ in any bit.
fn differing(ours: &[u8], hand: &[u8], rows: usize) -> usize {
    let stride = (hand.len() / rows.max(1)).max(1);
    ours.chunks(stride).zip(hand.chunks(stride)).filter(|(ours, hand)| ours != hand).count()
}

struct Bench<'g> {
    kernel: &'static str,
    data: Vec<Vec<u8>>,
    rows: usize,
    gpu: &'g mut Gpu,
}

impl Bench<'_> {
    /// What `part` returns.
    fn run(&mut self, part: &Compiled) -> Result<Vec<u8>, OverheadError> {
        let outputs = self.with_job(part, |gpu, job| gpu.run(job))?;
        Ok(outputs.into_iter().next().unwrap_or_default())
    }

    /// The seconds of a dispatch.
    fn time(&mut self, part: &Compiled) -> Result<f64, OverheadError> {
        let times = self.with_job(part, |gpu, job| gpu.time(job, DISPATCHES))?;
        Ok(times.iter().map(std::time::Duration::as_secs_f64).fold(f64::INFINITY, f64::min))
    }

    fn with_job<T>(
        &mut self,
        part: &Compiled,
        work: impl FnOnce(&mut Gpu, &Job<'_>) -> Result<T, GpuError>,
    ) -> Result<T, OverheadError> {
        let results = self.data.len() - 2;
        let kind = |at| match at {
            at if at < results => BindingKind::StorageRead,
            at if at == results => BindingKind::StorageReadWrite,
            _ => BindingKind::Uniform,
        };
        let bind = |(at, data)| Binding { group: 0, binding: at as u32, element: None, kind: kind(at), data };
        let bindings: Vec<Binding<'_>> = self.data.iter().map(Vec::as_slice).enumerate().map(bind).collect();
        let size = 64;
        let job = Job {
            shader: Shader::Spirv(&part.words),
            entry: &part.entry,
            workgroup_size: [size, 1, 1],
            groups: [(self.rows as u32).div_ceil(size), 1, 1],
            bindings: &bindings,
            immediates: &[],
        };
        work(self.gpu, &job).map_err(|cause| OverheadError::Gpu {
            kernel: self.kernel,
            part: part.part,
            cause,
        })
    }
}
