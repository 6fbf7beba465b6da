//! What throughput is measured on: three kernels as compute shaders, their data, and their native forms.

use crate::domain::Rng;
use lobe_codegen::emit::{Target, emit};
use lobe_codegen::prelude::{Vec3, exp, length};
use lobe_kernels::hsg::hsg_cosine_product_integral;
use lobe_kernels::sg::Sg;
use rayon::prelude::*;

/// Invocations of a workgroup.
pub(super) const SIZE: u32 = 64;

/// Items that a driver starts along one axis.
pub const MOST: usize = 65_535 * SIZE as usize;

/// Lights that an item of `lights` sums over.
const LIGHTS: usize = 64;

/// A kernel with its data; the last binding is the output, a float an item.
#[derive(Debug, Clone)]
pub struct Workload {
    /// Its name.
    pub name: &'static str,
    /// The compute shader `main`, in WGSL.
    pub text: String,
    /// Invocations.
    pub items: usize,
    /// Read-only buffers, at bindings 0, 1, ..
    pub inputs: Vec<Vec<f32>>,
    /// The same in Rust: the output of these items.
    pub native: fn(&[Vec<f32>], usize, &mut [f32]),
}

/// A workload by name, and the way to make it for a number of items.
pub struct Maker {
    /// Its name.
    pub name: &'static str,
    /// What it is, in a line.
    pub about: &'static str,
    /// Items, unless said otherwise.
    pub items: usize,
    make: fn(usize) -> Workload,
}

/// Every workload.
pub const WORKLOADS: [Maker; 3] = [
    Maker {
        name: "hsg",
        about: "integral of an SG, the clamped cosine and a hemisphere: branches, 5 elementary functions",
        items: 4_000_000,
        make: hsg,
    },
    Maker { name: "lights", about: "the sum over 64 SG lights", items: 1 << 17, make: lights },
    Maker { name: "triad", about: "a * 2 + b: bound by memory", items: 4_000_000, make: triad },
];

impl Maker {
    /// The workload for `items`, at most [`MOST`].
    #[must_use]
    pub fn make(&self, items: usize) -> Workload {
        (self.make)(items.clamp(1, MOST))
    }
}

impl Workload {
    /// The output, natively, on all threads.
    #[must_use]
    pub fn run_native(&self) -> Vec<f32> {
        const CHUNK: usize = 1 << 12;
        let mut out = vec![0.0; self.items];
        let chunks = out.par_chunks_mut(CHUNK).enumerate();
        chunks.for_each(|(index, chunk)| (self.native)(&self.inputs, index * CHUNK, chunk));
        out
    }
}

fn unit(rng: &mut Rng) -> f32 {
    rng.unit() as f32
}

fn direction(rng: &mut Rng) -> [f32; 3] {
    let (z, angle) = (2.0 * unit(rng) - 1.0, std::f32::consts::TAU * unit(rng));
    let r = (1.0 - z * z).max(0.0).sqrt();
    [r * angle.cos(), r * angle.sin(), z]
}

fn triad(items: usize) -> Workload {
    let text = "
        @group(0) @binding(0) var<storage, read> a: array<f32>;
        @group(0) @binding(1) var<storage, read> b: array<f32>;
        @group(0) @binding(2) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            out[id.x] = a[id.x] * 2.0 + b[id.x];
        }";
    let mut rng = Rng::new(1, "triad");
    let inputs = (0..2).map(|_| (0..items).map(|_| unit(&mut rng)).collect()).collect();
    Workload { name: "triad", text: text.to_owned(), items, inputs, native: native_triad }
}

fn native_triad(inputs: &[Vec<f32>], first: usize, out: &mut [f32]) {
    let (a, b) = (&inputs[0][first..], &inputs[1][first..]);
    out.iter_mut().zip(a).zip(b).for_each(|((out, a), b)| *out = a * 2.0 + b);
}

fn lights(items: usize) -> Workload {
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
    let mut rng = Rng::new(2, "lights");
    let light = |rng: &mut Rng| {
        let [x, y, z] = direction(rng);
        [x, y, z, 1.0 + 50.0 * unit(rng), unit(rng), 0.0, 0.0, 0.0]
    };
    let lights = (0..LIGHTS).flat_map(|_| light(&mut rng)).collect();
    let lobe = |rng: &mut Rng| {
        let [x, y, z] = direction(rng);
        [x, y, z, 1.0 + 100.0 * unit(rng)]
    };
    let lobes = (0..items).flat_map(|_| lobe(&mut rng)).collect();
    Workload {
        name: "lights",
        text: text.to_owned(),
        items,
        inputs: vec![lights, lobes],
        native: native_lights,
    }
}

fn native_lights(inputs: &[Vec<f32>], first: usize, out: &mut [f32]) {
    let (lights, lobes) = (inputs[0].as_chunks::<8>().0, &inputs[1].as_chunks::<4>().0[first..]);
    for (out, &[x, y, z, w]) in out.iter_mut().zip(lobes) {
        let mut sum = 0.0;
        for &[lx, ly, lz, light_sharpness, amplitude, ..] in lights {
            let axis = Vec3::new(x, y, z) * w + Vec3::new(lx, ly, lz) * light_sharpness;
            let sharpness = length(axis);
            let log_amplitude = sharpness - w - light_sharpness;
            let integral = std::f32::consts::TAU * (1.0 - exp(-2.0 * sharpness)) / sharpness;
            sum += amplitude * exp(log_amplitude) * integral;
        }
        *out = sum;
    }
}

fn hsg(items: usize) -> Workload {
    // Two arrays: a driver binds 128 MiB at once.
    let text = format!(
        "{}
        @group(0) @binding(0) var<storage, read> lobes: array<Sg>;
        @group(0) @binding(1) var<storage, read> normals: array<vec3<f32>>;
        @group(0) @binding(2) var<storage, read_write> out: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
            if id.x >= arrayLength(&normals) {{ return; }}
            out[id.x] = hsg_cosine_product_integral(lobes[id.x], normals[id.x]);
        }}",
        library()
    );
    let mut rng = Rng::new(3, "hsg");
    let (mut lobes, mut normals) = (Vec::with_capacity(8 * items), Vec::with_capacity(4 * items));
    for _ in 0..items {
        let ([x, y, z], [a, b, c]) = (direction(&mut rng), direction(&mut rng));
        lobes.extend([x, y, z, (unit(&mut rng) * 9.0).exp(), unit(&mut rng), 0.0, 0.0, 0.0]);
        normals.extend([a, b, c, 0.0]);
    }
    Workload { name: "hsg", text, items, inputs: vec![lobes, normals], native: native_hsg }
}

/// The kernel in WGSL, as a user gets it.
fn library() -> String {
    let module = lobe_codegen::lower(&lobe_codegen::kernels![hsg_cosine_product_integral]);
    let emitted = module.ok().and_then(|m| emit(&m, Target::Wgsl, &Default::default()).ok());
    emitted.and_then(|e| e.content.text().map(str::to_owned)).unwrap_or_default()
}

fn native_hsg(inputs: &[Vec<f32>], first: usize, out: &mut [f32]) {
    let (lobes, normals) = (&inputs[0].as_chunks::<8>().0[first..], &inputs[1].as_chunks::<4>().0[first..]);
    for ((out, &[x, y, z, sharpness, log_amplitude, ..]), &[a, b, c, _]) in
        out.iter_mut().zip(lobes).zip(normals)
    {
        let lobe = Sg { axis: Vec3::new(x, y, z), sharpness, log_amplitude };
        *out = hsg_cosine_product_integral(lobe, Vec3::new(a, b, c));
    }
}
