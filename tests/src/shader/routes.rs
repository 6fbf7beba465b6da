//! The routes of a shader beside the interpreter: what each is given, and what it leaves.

use super::given::{Given, Owned};
use super::machine::{MachineError, uses_subgroups};
use super::report::RouteStatus;
use lobe_backends::gpu::{AnyGpu, Binding, BindingKind, GpuError, Job, Shader};
use lobe_backends::interp::InterpError;
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::{Machine, State};
use lobe_backends::translate::{DxcOutput, spirv_val, spirv_words};
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Content, EmitError, Plain, Target, check_calls, immediates_in_hlsl, plain};
use lobe_codegen::foreign::{self, Language, Source};
use lobe_codegen::validate;
use std::collections::{BTreeMap, HashMap};
use std::time::Duration;

/// The road of a SPIR-V file's own words.
pub(super) const ORIGINAL: &str = "original";

/// The interpreter's own second opinion.
const JUDGE: &str = "judge";

/// A driver drawn by chance; a seed follows.
const PERTURBED: &str = "perturbed:";

/// A way to results that are compared with the interpreter's.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ShaderRoute {
    /// The interpreter's judge, which runs the same program in another way: its results are the same.
    Judge,
    /// A driver that takes liberties, each of them permitted, as its seed says.
    Perturbed(u64),
    /// A driver of this machine.
    Gpu {
        /// The way there; `None`: the words of the file, unchanged.
        road: Option<Road>,
        /// The driver's name.
        driver: String,
    },
}

impl ShaderRoute {
    /// The resources as the route's shader has them, and its immediates: HLSL has neither uniform buffers nor those.
    fn lend<'g>(&self, subject: &Subject<'g>) -> (Vec<Binding<'g>>, &'g [u8]) {
        let is_hlsl = matches!(self, Self::Gpu { road: Some(Road::HlslDxc | Road::HlslSlang), .. });
        let lend = |given: &'g Given| match given.lend() {
            binding if is_hlsl && given.is_immediate() => {
                let (group, binding_in_hlsl) = immediates_in_hlsl(subject.module.module());
                Binding {
                    group,
                    binding: binding_in_hlsl,
                    element: None,
                    kind: BindingKind::StorageRead,
                    ..binding
                }
            }
            binding if is_hlsl && binding.kind == BindingKind::Uniform => {
                Binding { kind: BindingKind::StorageRead, ..binding }
            }
            binding => binding,
        };
        let bound = subject.given.iter().filter(|given| is_hlsl || !given.is_immediate());
        let immediates = subject.given.iter().find(|given| !is_hlsl && given.is_immediate());
        (bound.map(lend).collect(), immediates.map_or(&[], |given| &given.data))
    }
}

impl std::fmt::Display for ShaderRoute {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Judge => f.write_str(JUDGE),
            Self::Perturbed(seed) => write!(f, "{PERTURBED}{seed}"),
            Self::Gpu { road, driver } => write!(f, "{}@{driver}", road.map_or(ORIGINAL, Road::name)),
        }
    }
}

impl std::str::FromStr for ShaderRoute {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == JUDGE {
            return Ok(Self::Judge);
        }
        if let Some(seed) = text.strip_prefix(PERTURBED) {
            let seed = seed.parse().map_err(|_| format!("`{seed}` is no seed; it is an integer"))?;
            return Ok(Self::Perturbed(seed));
        }
        if let Some((ORIGINAL, driver)) = text.split_once('@') {
            return Ok(Self::Gpu { road: None, driver: driver.to_owned() });
        }
        match text.parse::<Route>() {
            Ok(Route::Gpu { road, driver }) => Ok(Self::Gpu { road: Some(road), driver }),
            Ok(Route::Native | Route::Interp) => Err(format!("`{text}` is no route of a shader")),
            Err(error) => Err(error.to_string()),
        }
    }
}

/// One entry point, ready to run.
#[derive(Debug)]
pub struct Subject<'s> {
    /// The file.
    pub source: &'s Source,
    /// The entry point's module.
    pub module: &'s ValidModule,
    /// The entry point's name.
    pub entry: &'s str,
    /// Whether the file's text means the same as `module`: no constant was overridden.
    pub is_as_written: bool,
    /// Invocations of a workgroup.
    pub workgroup_size: [u32; 3],
    /// Workgroups.
    pub workgroups: [u32; 3],
    /// What it uses.
    pub given: &'s [Given],
    /// The same on the interpreter.
    pub interp: super::machine::Machine<'s>,
}

impl Subject<'_> {
    /// Whether `road` has all kinds of resources that the shader uses.
    fn may_take(&self, road: Road) -> bool {
        match road {
            Road::Spirv | Road::WgslNaga | Road::HlslDxc => true,
            // They have faults of their own with shaders of others: only where they are asked for.
            Road::HlslSlang | Road::GlslGlslang => false,
            // WebGPU has neither immediates nor binding arrays, and Dawn's device here no textures.
            Road::WgslTint => self
                .given
                .iter()
                .all(|given| !given.is_immediate() && given.is_buffer() && given.element.is_none()),
            Road::Glsl => false,
        }
    }

    fn is_own_wgsl(&self) -> bool {
        self.is_as_written && self.source.language == Language::Wgsl
    }

    /// WGSL with the directive that WebGPU asks for before subgroups, which naga neither writes nor asks for. It is
    /// on the first line, so that the others keep their numbers.
    fn for_tint(&self, wgsl: &str, entry: &str) -> Plain {
        let directive = if uses_subgroups(self.module) { "enable subgroups; " } else { "" };
        Plain { content: Content::Text(format!("{directive}{wgsl}")), entry: entry.to_owned() }
    }
}

/// Why a route has no results.
#[derive(Debug)]
pub struct Failure {
    /// How it ended.
    pub status: RouteStatus,
    /// Why.
    pub message: String,
}

/// The drivers of this machine, each opened at its first use.
#[derive(Debug)]
pub struct Routes {
    machine: Machine,
    opened: HashMap<(String, Way), AnyGpu>,
    subgroups: HashMap<String, Option<u32>>,
}

/// How a driver is reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Way {
    Wgpu,
    Dawn,
}

impl Way {
    fn of(road: Option<Road>) -> Self {
        match road {
            Some(Road::WgslTint) => Self::Dawn,
            None
            | Some(
                Road::Spirv
                | Road::WgslNaga
                | Road::HlslDxc
                | Road::HlslSlang
                | Road::GlslGlslang
                | Road::Glsl,
            ) => Self::Wgpu,
        }
    }

    /// A road that goes this way.
    fn road(self) -> Road {
        match self {
            Self::Wgpu => Road::Spirv,
            Self::Dawn => Road::WgslTint,
        }
    }
}

/// Tells the size of a subgroup.
const PROBE: &str = "
    @group(0) @binding(0) var<storage, read_write> size: u32;
    @compute @workgroup_size(64) fn main(@builtin(subgroup_size) n: u32) { size = n; }";

impl Routes {
    /// Looks for drivers and translators.
    #[must_use]
    pub fn look() -> Self {
        Self { machine: Machine::look(), opened: HashMap::new(), subgroups: HashMap::new() }
    }

    /// The routes to drivers that `subject` can take here.
    #[must_use]
    pub fn ready(&self, subject: &Subject<'_>) -> Vec<ShaderRoute> {
        let original = self.machine.drivers().iter().filter(|d| d.has_passthrough);
        let original = original.map(|d| ShaderRoute::Gpu { road: None, driver: d.name.clone() });
        let ready = self.machine.routes().into_iter().filter(|(_, state)| *state == State::Ready);
        let roads = ready.filter_map(|(route, _)| match route {
            Route::Gpu { road, driver } if subject.may_take(road) => {
                Some(ShaderRoute::Gpu { road: Some(road), driver })
            }
            Route::Gpu { .. } | Route::Native | Route::Interp => None,
        });
        let is_spirv = subject.source.language == Language::Spirv;
        original.filter(|_| is_spirv).chain(roads).collect()
    }

    /// What `route` lacks on this machine, and how to get it.
    #[must_use]
    pub fn missing(&self, route: &ShaderRoute) -> Option<String> {
        let ShaderRoute::Gpu { road, driver } = route else { return None };
        let road = road.unwrap_or(Road::Spirv);
        match self.machine.state(&Route::Gpu { road, driver: driver.clone() }) {
            State::Ready => None,
            State::Missing { what, mend } => Some(format!("{what}; {mend}")),
        }
    }

    /// What the route's driver says of itself, its version with it; nothing if there is none.
    #[must_use]
    pub fn driver_info(&self, route: &ShaderRoute) -> &str {
        let ShaderRoute::Gpu { driver, .. } = route else { return "" };
        let known = self.machine.drivers().iter().find(|d| d.name == *driver);
        known.map_or("", |d| &d.driver_info)
    }

    /// Runs `subject` by `route` and gives back what then lies in those resources that it may write.
    ///
    /// # Errors
    /// When the route does not take the shader, or does not survive it.
    pub fn run(
        &mut self,
        route: &ShaderRoute,
        subject: &Subject<'_>,
        timeout: Duration,
    ) -> Result<Vec<Vec<u8>>, Failure> {
        let (road, driver) = match route {
            ShaderRoute::Judge => return left(subject, |machine| machine.judged()),
            ShaderRoute::Perturbed(seed) => return left(subject, |machine| machine.perturbed(*seed)),
            ShaderRoute::Gpu { road, driver } => (*road, driver.as_str()),
        };
        self.check_capabilities(driver, subject)?;
        let plain = self.written(road, subject)?;
        let shader = match &plain.content {
            Content::Text(text) => Shader::Wgsl(text),
            Content::Words(words) => Shader::Spirv(words),
        };
        let (bindings, immediates) = route.lend(subject);
        let gpu = self.open(driver, Way::of(road))?;
        gpu.set_timeout(timeout);
        let job = Job {
            shader,
            entry: &plain.entry,
            workgroup_size: subject.workgroup_size,
            groups: subject.workgroups,
            bindings: &bindings,
            immediates,
        };
        gpu.run(&job).map_err(|e| Failure::of_gpu(&e))
    }

    /// A driver may crash on what it does not know.
    fn check_capabilities(&self, name: &str, subject: &Subject<'_>) -> Result<(), Failure> {
        let driver = self.machine.drivers().iter().find(|d| d.name == name);
        let lacking = driver.and_then(|d| validate::lacking(subject.module, d.capabilities));
        match lacking {
            Some(why) => Err(Failure::refused(format!("{name} does not take the shader: {why}"))),
            None => Ok(()),
        }
    }

    /// Invocations of a subgroup on the route's driver; `None` if it has no subgroups of its own.
    pub fn subgroup(&mut self, route: &ShaderRoute) -> Option<u32> {
        let ShaderRoute::Gpu { driver, .. } = route else { return None };
        if let Some(known) = self.subgroups.get(driver) {
            return *known;
        }
        let size = self.open(driver, Way::Wgpu).ok().and_then(|gpu| {
            let kind = BindingKind::StorageReadWrite;
            let bindings = [Binding { group: 0, binding: 0, element: None, kind, data: &[0; 4] }];
            let shader = Shader::Wgsl(PROBE);
            let job = Job {
                shader,
                entry: "main",
                workgroup_size: [64, 1, 1],
                groups: [1; 3],
                bindings: &bindings,
                immediates: &[],
            };
            let found = gpu.run(&job).ok()?;
            found.first()?.first_chunk().map(|bytes| u32::from_le_bytes(*bytes))
        });
        self.subgroups.insert(driver.clone(), size);
        size
    }

    fn open(&mut self, name: &str, way: Way) -> Result<&mut AnyGpu, Failure> {
        let place = (name.to_owned(), way);
        if !self.opened.contains_key(&place) {
            let driver = self.machine.drivers().iter().find(|d| d.name == name);
            let Some(driver) = driver else {
                return Err(Failure::refused(format!("there is no driver {name} here")));
            };
            let gpu = self.machine.device(way.road(), driver).map_err(|e| Failure::of_gpu(&e))?;
            self.opened.insert(place.clone(), gpu);
        }
        self.opened.get_mut(&place).ok_or_else(|| Failure::refused(format!("{name} was lost")))
    }

    /// What the driver is given.
    fn written(&self, road: Option<Road>, subject: &Subject<'_>) -> Result<Plain, Failure> {
        let of = |module: &ValidModule, target| {
            plain(module, target, subject.entry, subject.workgroups).map_err(|e| Failure::of_emit(&e))
        };
        let write = |target| of(subject.module, target);
        // A driver gets the lengths of binding arrays with the words, but WGSL has wgpu for that.
        let sized = |target| {
            let sized = foreign::with_elements(subject.module, &elements(subject.given));
            let sized = sized.map_err(|e| Failure::refused(e.to_string()))?;
            of(sized.as_ref().unwrap_or(subject.module), target)
        };
        match road {
            Some(Road::Spirv) => sized(Target::Spirv),
            Some(Road::WgslNaga) => match subject.source.wgsl().filter(|_| subject.is_as_written) {
                Some(text) => {
                    check_calls(subject.module.module()).map_err(|e| Failure::of_emit(&e))?;
                    Ok(Plain { content: Content::Text(text.into_owned()), entry: subject.entry.to_owned() })
                }
                None => write(Target::Wgsl),
            },
            Some(road @ (Road::HlslDxc | Road::HlslSlang)) => self.translated(road, &sized(road.target())?),
            Some(road @ Road::GlslGlslang) => {
                check_samplers(subject.module)?;
                self.translated(road, &sized(road.target())?)
            }
            Some(Road::WgslTint) => match subject.source.text().filter(|_| subject.is_own_wgsl()) {
                Some(text) => Ok(subject.for_tint(text, subject.entry)),
                None => {
                    let written = write(Target::Wgsl)?;
                    Ok(subject.for_tint(written.content.text().unwrap_or_default(), &written.entry))
                }
            },
            Some(Road::Glsl) => Err(Failure::refused(
                "glsl is a road of kernels alone: OpenGL has no groups of resources; take another road"
                    .to_owned(),
            )),
            None => {
                let words =
                    spirv_words(&subject.source.bytes).map_err(|e| Failure::refused(e.to_string()))?;
                spirv_val::validate(&words).map_err(|e| Failure::refused(e.to_string()))?;
                Ok(Plain { content: Content::Words(words), entry: subject.entry.to_owned() })
            }
        }
    }

    /// What a translator makes of it.
    fn translated(&self, road: Road, plain: &Plain) -> Result<Plain, Failure> {
        let translators = self.machine.translators();
        let text = plain.content.text().unwrap_or_default();
        let words = match (road, translators.dxc()) {
            // naga's writer has HLSL 2018 in mind, and foreign shaders use what kernels do not.
            (Road::HlslDxc, Ok(dxc)) => dxc
                .compile(text, "cs_6_6", Some(&plain.entry), DxcOutput::Spirv2018)
                .and_then(|object| spirv_words(&object)),
            _ => translators.spirv(road, text, &plain.entry),
        };
        let words = words.map_err(|e| Failure::refused(e.to_string()))?;
        Ok(Plain { content: Content::Words(words), entry: plain.entry.clone() })
    }
}

/// naga's GLSL joins a texture with a sampler, and no binding of the module is both.
fn check_samplers(module: &ValidModule) -> Result<(), Failure> {
    let module = module.module();
    let is_sampler = |ty| matches!(module.types[ty].inner, naga::TypeInner::Sampler { .. });
    match module.global_variables.iter().any(|(_, variable)| is_sampler(variable.ty)) {
        true => Err(Failure::refused("GLSL as naga writes it has no samplers of their own".to_owned())),
        false => Ok(()),
    }
}

/// How many elements the binding arrays have, by group and binding.
fn elements(given: &[Given]) -> Vec<((u32, u32), u32)> {
    let mut counts: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for given in given.iter().filter(|given| given.element.is_some()) {
        *counts.entry((given.group, given.binding)).or_default() += 1;
    }
    counts.into_iter().collect()
}

/// What a run of the interpreter leaves where the shader may write.
fn left(
    subject: &Subject<'_>,
    run: impl FnOnce(&super::machine::Machine<'_>) -> Result<Owned, MachineError>,
) -> Result<Vec<Vec<u8>>, Failure> {
    let owned = run(&subject.interp).map_err(|e| Failure::of_machine(&e))?;
    Ok(subject.given.iter().filter(|g| g.is_written()).map(|g| owned.bytes(g).to_vec()).collect())
}

impl Failure {
    fn refused(message: String) -> Self {
        Self { status: RouteStatus::Refused, message }
    }

    fn of_gpu(error: &GpuError) -> Self {
        let status = match error {
            GpuError::Timeout { .. } => RouteStatus::Timeout,
            GpuError::DeviceLost { .. } => RouteStatus::Crashed,
            _ => RouteStatus::Refused,
        };
        Self { status, message: error.to_string() }
    }

    fn of_machine(error: &MachineError) -> Self {
        let status = match error {
            MachineError::Interp(InterpError::OutOfFuel { .. }) => RouteStatus::Timeout,
            MachineError::Interp(_) | MachineError::Texture(_) => RouteStatus::Refused,
            MachineError::Panicked(_) => RouteStatus::Crashed,
        };
        Self { status, message: error.to_string() }
    }

    fn of_emit(error: &EmitError) -> Self {
        let is_panic = matches!(error, EmitError::Panicked { .. });
        let status = if is_panic { RouteStatus::Crashed } else { RouteStatus::Refused };
        Self { status, message: error.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn routes_are_spelt_as_they_print() {
        let drivers = [
            "original@lavapipe",
            "spirv@lavapipe",
            "wgsl+naga@a-card-2",
            "wgsl+tint@swiftshader",
            "hlsl+dxc@swiftshader",
            "hlsl+slang@x",
            "glsl+glslang@x",
        ];
        for name in drivers.into_iter().chain(["judge", "perturbed:7"]) {
            assert_eq!(name.parse::<ShaderRoute>().map(|r| r.to_string()), Ok(name.to_owned()));
        }
        for name in ["interp", "native", "metal@x", "lavapipe", "perturbed:x"] {
            assert!(name.parse::<ShaderRoute>().is_err(), "{name}");
        }
    }
}
