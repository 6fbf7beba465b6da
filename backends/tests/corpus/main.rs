//! Modules of our own with textures and subgroups, each run by the interpreter and by lavapipe: what they leave in their
//! buffers and textures is the same, bit for bit or within the bound that the module states.
//!
//! The judge of the interpreter leaves the same too, and chance drivers stay within its bounds.
//!
//! They are those in `tests/cases/corpus` that say how they are run; `options` tells what their first lines mean.

#[path = "../common/mod.rs"]
mod common;
mod compare;
mod judged;
mod options;
mod resources;

use lobe_backends::gpu::{Binding, BindingKind, Gpu, Job, Shader};
use lobe_backends::interp::Interpreter;
use lobe_codegen::ValidModule;
use options::Options;
use resources::{Given, Owned, given};
use std::path::PathBuf;

/// Fewer modules than this would not cover textures and subgroups.
const FEWEST: usize = 33;

/// A module, ready to run.
struct Case {
    name: String,
    text: String,
    module: ValidModule,
    options: Options,
    given: Vec<Given>,
}

impl Case {
    fn new(name: String, text: String) -> Result<Self, String> {
        let module = lobe_codegen::validate::foreign_wgsl(&text).map_err(|error| error.to_string())?;
        let options = Options::of(&text)?;
        let given = given(module.module(), &options)?;
        Ok(Self { name, text, module, options, given })
    }

    fn size(&self) -> [u32; 3] {
        self.module.module().entry_points[0].workgroup_size
    }

    /// What the interpreter leaves in each written variable.
    fn interpret(&self, subgroup: u32) -> Result<Vec<Vec<u8>>, String> {
        let mut owned = Owned::of(&self.given)?;
        let interpreter = Interpreter::new(&self.module).map_err(|error| error.to_string())?;
        let interpreter = interpreter.with_subgroup_size(subgroup);
        interpreter.run(0, self.options.groups, owned.lend()).map_err(|error| error.to_string())?;
        Ok(self.given.iter().filter(|g| g.written()).map(|g| owned.bytes(g).to_vec()).collect())
    }

    /// What a driver leaves there.
    fn drive(&self, gpu: &mut Gpu, shader: Shader<'_>) -> Result<Vec<Vec<u8>>, String> {
        let bindings: Vec<_> = self.given.iter().map(Given::lend).collect();
        let entry = &self.module.module().entry_points[0].name;
        let (workgroup_size, groups) = (self.size(), self.options.groups);
        let job = Job { shader, entry, workgroup_size, groups, bindings: &bindings };
        gpu.run(&job).map_err(|error| error.to_string())
    }

    /// What keeps the executors from agreeing.
    fn fault(&self, gpu: &mut Gpu, subgroup: u32) -> Result<(), String> {
        let interpreted = self.interpret(subgroup)?;
        let wgsl = self.drive(gpu, Shader::Wgsl(&self.text)).map_err(|error| format!("WGSL: {error}"))?;
        self.compare("WGSL", &interpreted, &wgsl)?;
        let words = self.spirv()?;
        let spirv = self.drive(gpu, Shader::Spirv(&words)).map_err(|error| format!("SPIR-V: {error}"))?;
        self.compare("SPIR-V", &interpreted, &spirv)
    }

    fn compare(&self, route: &str, interpreted: &[Vec<u8>], driven: &[Vec<u8>]) -> Result<(), String> {
        let written = self.given.iter().filter(|g| g.written());
        for (given, (ours, theirs)) in written.zip(interpreted.iter().zip(driven)) {
            let within = self.options.within.get(&given.name).copied();
            compare::agree(given.kind, ours, theirs, within)
                .map_err(|difference| format!("{route}: `{}`: {difference}", given.name))?;
        }
        Ok(())
    }

    fn spirv(&self) -> Result<Vec<u32>, String> {
        let policy = naga::proc::BoundsCheckPolicy::Restrict;
        let options = naga::back::spv::Options {
            lang_version: (1, 3),
            flags: naga::back::spv::WriterFlags::empty(),
            bounds_check_policies: naga::proc::BoundsCheckPolicies {
                index: policy,
                buffer: policy,
                image_load: naga::proc::BoundsCheckPolicy::Unchecked,
                binding_array: policy,
            },
            ..Default::default()
        };
        let (module, info) = (self.module.module(), self.module.info());
        naga::back::spv::write_vec(module, info, &options, None).map_err(|error| format!("SPIR-V: {error}"))
    }
}

fn modules() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/cases/corpus");
    let entries =
        std::fs::read_dir(&folder).expect("the folder of modules").map(|e| e.expect("an entry").path());
    let mut files: Vec<_> = entries.filter(|path| path.extension().is_some_and(|e| e == "wgsl")).collect();
    files.sort();
    let read = |path: PathBuf| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        (name, std::fs::read_to_string(&path).expect("a module's text"))
    };
    files.into_iter().map(read).filter(|(_, text)| options::are_in(text)).collect()
}

/// Invocations of a subgroup on a driver; a driver without subgroups cannot run this.
fn subgroup_size(gpu: &mut Gpu) -> Option<u32> {
    let text = "@group(0) @binding(0) var<storage, read_write> size: u32;
        @compute @workgroup_size(64) fn main(@builtin(subgroup_size) n: u32) { size = n; }";
    let bindings = [Binding { group: 0, binding: 0, kind: BindingKind::StorageReadWrite, data: &[0; 4] }];
    let [workgroup_size, groups] = [[64, 1, 1], [1; 3]];
    let job = Job { shader: Shader::Wgsl(text), entry: "main", workgroup_size, groups, bindings: &bindings };
    let outputs = gpu.run(&job).ok()?;
    Some(u32::from_le_bytes(outputs.first()?.as_slice().try_into().ok()?))
}

#[test]
fn the_interpreter_and_lavapipe_agree_on_every_module() {
    let Some(driver) = common::driver("lavapipe") else {
        return;
    };
    let mut gpu = Gpu::open(&driver).expect("lavapipe opens");
    let subgroup = subgroup_size(&mut gpu).expect("lavapipe has subgroups");
    // One module alone, for those who look for what went wrong.
    let only = std::env::var("LOBE_CORPUS").ok();
    let modules = modules();
    assert!(modules.len() >= FEWEST, "{} modules, there should be {FEWEST}", modules.len());
    let wanted = modules.into_iter().filter(|(name, _)| only.as_ref().is_none_or(|only| name.contains(only)));
    let faults: Vec<String> = wanted
        .filter_map(|(name, text)| {
            let fault = Case::new(name.clone(), text).and_then(|case| case.fault(&mut gpu, subgroup));
            fault.err().map(|fault| format!("{name}: {fault}"))
        })
        .collect();
    assert!(faults.is_empty(), "{} modules differ:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn a_wrong_number_would_be_found() {
    let text = "@group(0) @binding(0) var<storage, read_write> x: array<f32, 4>;
        @compute @workgroup_size(4) fn main(@builtin(local_invocation_index) i: u32) { x[i] = f32(i); }";
    let case = Case::new("ramp".to_owned(), text.to_owned()).expect("a module");
    assert_eq!(case.name, "ramp");
    let right = case.interpret(32).expect("results");
    assert_eq!(case.compare("itself", &right, &right), Ok(()));
    let mut wrong = right.clone();
    wrong[0][4] ^= 1;
    let fault = case.compare("itself", &right, &wrong).expect_err("a difference");
    assert!(fault.contains("`x`") && fault.contains("word 1"), "{fault}");
}
