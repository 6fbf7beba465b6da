//! Throughput of the interpreter against lavapipe: the same kernels, side by side, round after round.
//!
//! `cargo bench -p lobe-tests --bench throughput [-- KERNEL ...]`; `RAYON_NUM_THREADS=1 LP_NUM_THREADS=1` for one
//! thread. Prints the median of each executor's time and of the ratios of the rounds.

use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, Job, Shader};
use lobe_backends::interp::{Buffer, Interpreter, Isa};
use lobe_codegen::{ValidModule, validate};
use std::time::{Duration, Instant};

/// Invocations of a workgroup.
const SIZE: u32 = 64;

/// A kernel, its inputs and the size of its output.
struct Case {
    name: &'static str,
    text: String,
    items: usize,
    inputs: Vec<Vec<f32>>,
}

fn unit(seed: &mut u64) -> f32 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 40) as f32 / (1 << 24) as f32
}

fn direction(seed: &mut u64) -> [f32; 3] {
    let (z, angle) = (2.0 * unit(seed) - 1.0, std::f32::consts::TAU * unit(seed));
    let r = (1.0 - z * z).max(0.0).sqrt();
    [r * angle.cos(), r * angle.sin(), z]
}

fn triad() -> Case {
    let items = 4_000_000;
    let text = "
        @group(0) @binding(0) var<storage, read> a: array<f32>;
        @group(0) @binding(1) var<storage, read> b: array<f32>;
        @group(0) @binding(2) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            out[id.x] = a[id.x] * 2.0 + b[id.x];
        }";
    let mut seed = 1;
    let inputs = (0..2).map(|_| (0..items).map(|_| unit(&mut seed)).collect()).collect();
    Case { name: "triad", text: text.to_owned(), items, inputs }
}

fn lights() -> Case {
    let items = 1 << 17;
    let text = "
        struct Light { axis: vec3<f32>, sharpness: f32, amplitude: f32, a: f32, b: f32, c: f32 }
        @group(0) @binding(0) var<storage, read> lights: array<Light, 64>;
        @group(0) @binding(1) var<storage, read> lobes: array<vec4<f32>>;
        @group(0) @binding(2) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            let lobe = lobes[id.x];
            var sum = 0.0;
            for (var i = 0u; i < 64u; i++) {
                let light = lights[i];
                let axis = lobe.xyz * lobe.w + light.axis * light.sharpness;
                let sharpness = length(axis);
                let log_amplitude = sharpness - lobe.w - light.sharpness;
                let integral = 6.2831855 * (1.0 - exp(-2.0 * sharpness)) / sharpness;
                sum += light.amplitude * exp(log_amplitude) * integral;
            }
            out[id.x] = sum;
        }";
    let mut seed = 2;
    let light = |seed: &mut u64| {
        let [x, y, z] = direction(seed);
        [x, y, z, 1.0 + 50.0 * unit(seed), unit(seed), 0.0, 0.0, 0.0]
    };
    let lights = (0..64).flat_map(|_| light(&mut seed)).collect();
    let lobe = |seed: &mut u64| {
        let [x, y, z] = direction(seed);
        [x, y, z, 1.0 + 100.0 * unit(seed)]
    };
    let lobes = (0..items).flat_map(|_| lobe(&mut seed)).collect();
    Case { name: "lights", text: text.to_owned(), items, inputs: vec![lights, lobes] }
}

fn hsg() -> Case {
    let items = 2_500_000; // 48 bytes each: what a driver binds at once
    let module = lobe_codegen::lower(&lobe_codegen::kernels![lobe_kernels::hsg::hsg_cosine_product_integral]);
    let module = module.unwrap_or_else(|e| panic!("{e}"));
    let target = lobe_codegen::emit::Target::Wgsl;
    let emitted = lobe_codegen::emit::emit(&module, target, &Default::default()).expect("WGSL");
    let text = format!(
        "{}
        struct Item {{ sg: Sg, normal: vec3<f32> }}
        @group(0) @binding(0) var<storage, read> items: array<Item>;
        @group(0) @binding(1) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
            if id.x >= arrayLength(&items) {{ return; }}
            let item = items[id.x];
            out[id.x] = hsg_cosine_product_integral(item.sg, item.normal);
        }}",
        emitted.content.text().expect("text")
    );
    let mut seed = 3;
    let item = |seed: &mut u64| {
        let [x, y, z] = direction(seed);
        let [a, b, c] = direction(seed);
        [x, y, z, (unit(seed) * 9.0).exp(), unit(seed), 0.0, 0.0, 0.0, a, b, c, 0.0]
    };
    let data = (0..items).flat_map(|_| item(&mut seed)).collect();
    Case { name: "hsg", text, items, inputs: vec![data] }
}

fn bytes(floats: &[f32]) -> Vec<u8> {
    floats.iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// One run on the interpreter.
fn interpret(module: &ValidModule, isa: Isa, case: &Case, buffers: &mut [Buffer]) -> Duration {
    let interpreter = Interpreter::new(module).expect("an interpreter").with_isa(isa);
    let begin = Instant::now();
    let groups = (case.items as u32).div_ceil(SIZE);
    interpreter.run(0, [groups, 1, 1], buffers).unwrap_or_else(|e| panic!("{e}"));
    begin.elapsed()
}

fn measure(case: &Case, rounds: usize) {
    let module = validate::from_wgsl(&case.text).unwrap_or_else(|e| panic!("{e}"));
    let data: Vec<Vec<u8>> = case.inputs.iter().map(|i| bytes(i)).chain([vec![0; case.items * 4]]).collect();
    let mut buffers: Vec<Buffer> =
        (0..).zip(&data).map(|(binding, data)| Buffer { group: 0, binding, data: data.clone() }).collect();
    let last = data.len() - 1;
    let kind = |at| if at == last { BindingKind::StorageReadWrite } else { BindingKind::StorageRead };
    let bindings: Vec<Binding<'_>> = (0_u32..)
        .zip(&data)
        .map(|(binding, data)| Binding { group: 0, binding, kind: kind(binding as usize), data })
        .collect();
    let job = Job {
        shader: Shader::Wgsl(&case.text),
        entry: "main",
        workgroup_size: [SIZE, 1, 1],
        groups: [(case.items as u32).div_ceil(SIZE), 1, 1],
        bindings: &bindings,
    };
    let driver =
        gpu::drivers().into_iter().find(|d| d.name.contains("llvmpipe") || d.name.contains("lavapipe"));
    let mut gpu = driver.map(|d| Gpu::open(&d).unwrap_or_else(|e| panic!("{e}")));
    let isas = Isa::available();
    let mut ratios = vec![Vec::new(); isas.len()];
    let mut times = vec![Vec::new(); isas.len()];
    let mut theirs = Vec::new();
    for _ in 0..rounds {
        let lavapipe = gpu.as_mut().map(|gpu| {
            let times = gpu.time(&job, 3).unwrap_or_else(|e| panic!("{e}"));
            median(times.iter().map(Duration::as_secs_f64).collect())
        });
        theirs.extend(lavapipe);
        for (at, isa) in isas.iter().enumerate() {
            let ours = interpret(&module, *isa, case, &mut buffers).as_secs_f64();
            times[at].push(ours);
            ratios[at].extend(lavapipe.map(|t| t / ours));
        }
    }
    let show = |what: &str, times: &[f64]| {
        let seconds = median(times.to_vec());
        println!(
            "{:8} {what:10} {:8.2} ms {:9.2} M/s",
            case.name,
            seconds * 1e3,
            case.items as f64 / seconds / 1e6
        );
    };
    if !theirs.is_empty() {
        show("lavapipe", &theirs);
    }
    for (at, isa) in isas.iter().enumerate() {
        show(&isa.to_string(), &times[at]);
        if !ratios[at].is_empty() {
            println!("{:8} {:10} {:8.2} x lavapipe", case.name, isa.to_string(), median(ratios[at].clone()));
        }
    }
}

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    for case in [triad(), lights(), hsg()] {
        if wanted.is_empty() || wanted.iter().any(|w| w == case.name) {
            measure(&case, 9);
        }
    }
}
