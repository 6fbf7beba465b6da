//! Entry points with everything that functions have not: bindings, built-in inputs, workgroup memory,
//! barriers and atomics, on the interpreter and on every driver by every road.

mod common;

use lobe_backends::gpu::{Binding, BindingKind, Gpu, Job, Shader, drivers};
use lobe_backends::interp::{Buffer, Interpreter};
use lobe_backends::translate::dxc::{Dxc, DxcOutput};
use lobe_backends::translate::{TranslateError, spirv_words};
use lobe_codegen::ValidModule;
use lobe_codegen::def::KernelValue;
use lobe_codegen::emit::{Content, Options, Target, emit};
use lobe_codegen::intrinsics::{Intrinsic, Op, Shape, TABLE};
use lobe_codegen::prelude::*;
use lobe_kernels::rect::disk::rect_disk_radius;
use lobe_kernels::rect::reflection::{DistantLight, Reflection, rect_reflection};
use lobe_kernels::rect::shade::rect_shade;
use lobe_kernels::rect::{GlossyReceiver, Rectangle};

const GROUPS: u32 = 3;
const SIZE: usize = 64;

/// Adds the values of each workgroup in a tree, between barriers.
#[kernel(workgroup_size(64))]
pub fn group_sums(
    #[builtin(global_invocation_id)] id: UVec3,
    #[builtin(local_invocation_index)] lane: u32,
    #[builtin(workgroup_id)] group: UVec3,
    #[storage(0, 0)] values: &[u32],
    #[storage(0, 1)] sums: &mut [u32],
    #[workgroup] partial: &mut [u32; 64],
) {
    partial[lane as usize] = values[id.x as usize];
    workgroup_barrier();
    let mut stride = 32_u32;
    while stride > 0 {
        if lane < stride {
            partial[lane as usize] += partial[(lane + stride) as usize];
        }
        workgroup_barrier();
        stride /= 2;
    }
    if lane == 0 {
        sums[group.x as usize] = partial[0];
    }
}

/// Every atomic, on its own word; the order of invocations does not show in the outcome.
#[kernel(workgroup_size(64))]
pub fn all_atomics(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] values: &[u32],
    #[storage(0, 1)] words: &[AtomicU32; 8],
    #[storage(0, 2)] seen: &mut [u32],
) {
    let value = values[id.x as usize];
    atomic_add(&words[0], value);
    atomic_sub(&words[1], value);
    atomic_min(&words[2], value);
    atomic_max(&words[3], value);
    atomic_and(&words[4], value | 0xff00);
    atomic_or(&words[5], value);
    atomic_xor(&words[6], value);
    if id.x == 0 {
        atomic_store(&words[7], 40);
        let former = atomic_exchange(&words[7], 7);
        seen[0] = former + atomic_load(&words[7]);
    }
    storage_barrier();
}

/// Gathers the light of all rectangles at each receiver: the reflections are made once a rectangle and light.
#[kernel(workgroup_size(64))]
pub fn gather_rectangles(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] rectangles: &[Rectangle],
    #[storage(0, 1)] reflections: &[Reflection],
    #[storage(0, 2)] receivers: &[GlossyReceiver],
    #[storage(0, 3)] alphas: &[f32],
    #[storage(0, 4)] radiances: &mut [f32],
) {
    let receiver = receivers[id.x as usize];
    let mut sum = 0.0;
    for i in 0..rectangles.len() {
        let rectangle = rectangles[i];
        let offset = receiver.position - rectangle.position;
        let dist = max(dot(offset, rectangle.normal), 0.0) / max(reflections[i].cos_sigma, 1e-3);
        let radius = rect_disk_radius(3.0, alphas[i], dist, rectangle.half_x, rectangle.half_y);
        sum += rect_shade(rectangle, reflections[i], receiver, max(radius, 1e-3)).radiance;
    }
    radiances[id.x as usize] = sum;
}

/// The intrinsics that the entry points above call.
const CALLED: &[Intrinsic] = &[
    Intrinsic::AtomicLoad,
    Intrinsic::AtomicStore,
    Intrinsic::AtomicAdd,
    Intrinsic::AtomicSub,
    Intrinsic::AtomicMin,
    Intrinsic::AtomicMax,
    Intrinsic::AtomicAnd,
    Intrinsic::AtomicOr,
    Intrinsic::AtomicXor,
    Intrinsic::AtomicExchange,
    Intrinsic::WorkgroupBarrier,
    Intrinsic::StorageBarrier,
];

/// Notes the number of workgroups, which HLSL cannot read.
#[kernel(workgroup_size(64))]
pub fn group_count(
    #[builtin(num_workgroups)] groups: UVec3,
    #[builtin(local_invocation_id)] local: UVec3,
    #[storage(0, 0)] count: &mut [u32],
) {
    if local.x == 0 {
        count[0] = groups.x;
    }
}

#[test]
fn hlsl_is_refused_where_it_would_read_nothing() {
    let module = lobe_codegen::lower(&lobe_codegen::kernels![group_count]).unwrap_or_else(|e| panic!("{e}"));
    let error = emit(&module, Target::Hlsl, &Options::default()).expect_err("HLSL has no such input");
    assert!(error.to_string().contains("pass it in a uniform"), "{error}");
    let bound = [Bound(BindingKind::StorageReadWrite, vec![0])];
    assert_eq!(interpreted(&module, &bound), [[GROUPS]]);
}

#[test]
fn every_operation_on_memory_is_called() {
    for row in TABLE {
        let on_memory = matches!(row.shape, Shape::AtomicLoad | Shape::AtomicStore | Shape::AtomicUpdate)
            || matches!(row.op, Op::Barrier(_));
        assert_eq!(on_memory, CALLED.contains(&row.intrinsic), "{}", row.name);
    }
}

/// A buffer and how it is bound.
struct Bound(BindingKind, Vec<u32>);

fn bytes(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|w| w.to_le_bytes()).collect()
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect()
}

/// The writable buffers after the interpreter ran the entry point.
fn interpreted(module: &ValidModule, bound: &[Bound]) -> Vec<Vec<u32>> {
    let mut buffers: Vec<Buffer> =
        (0_u32..).zip(bound).map(|(binding, b)| Buffer { group: 0, binding, data: bytes(&b.1) }).collect();
    let interpreter = Interpreter::new(module).unwrap_or_else(|e| panic!("{e}"));
    interpreter.run(0, [GROUPS, 1, 1], &mut buffers).unwrap_or_else(|e| panic!("{e}"));
    let written = bound.iter().zip(&buffers).filter(|(b, _)| b.0 == BindingKind::StorageReadWrite);
    written.map(|(_, buffer)| words(&buffer.data)).collect()
}

/// The same on a driver.
fn run(gpu: &mut Gpu, entry: &str, shader: Shader<'_>, bound: &[Bound]) -> Vec<Vec<u32>> {
    let data: Vec<Vec<u8>> = bound.iter().map(|b| bytes(&b.1)).collect();
    let bindings: Vec<Binding<'_>> = (0_u32..)
        .zip(bound.iter().zip(&data))
        .map(|(binding, (b, data))| Binding { group: 0, binding, element: None, kind: b.0, data })
        .collect();
    let job = Job {
        shader,
        entry,
        workgroup_size: [SIZE as u32, 1, 1],
        groups: [GROUPS, 1, 1],
        bindings: &bindings,
        immediates: &[],
    };
    gpu.run(&job).unwrap_or_else(|e| panic!("{entry}: {e}")).iter().map(|b| words(b)).collect()
}

fn content(module: &ValidModule, target: Target) -> Content {
    emit(module, target, &Options::default()).unwrap_or_else(|e| panic!("{e}")).content
}

/// Compares the interpreter and every driver, by WGSL, SPIR-V and HLSL, with what is expected, word by word.
fn check(kernel: lobe_codegen::def::FunctionRef, bound: &[Bound], expected: &[Vec<u32>]) {
    check_by(kernel, bound, |found, way| assert_eq!(found, expected, "{way}"));
}

/// Lets `judge` see the writable buffers of the interpreter and of every driver, by WGSL, SPIR-V and HLSL.
fn check_by(kernel: lobe_codegen::def::FunctionRef, bound: &[Bound], judge: impl Fn(&[Vec<u32>], &str)) {
    let module = lobe_codegen::lower(&[kernel]).unwrap_or_else(|e| panic!("{e}"));
    let entry = kernel().name;
    for target in Target::ALL {
        emit(&module, target, &Options::default()).unwrap_or_else(|e| panic!("{entry}, {target}: {e}"));
    }
    judge(&interpreted(&module, bound), &format!("{entry} on interp"));
    let found = drivers();
    if found.is_empty() {
        common::skip("a Vulkan driver", "run tests/setup.sh");
    }
    for driver in &found {
        let mut gpu = Gpu::open(driver).unwrap_or_else(|e| panic!("{e}"));
        let wgsl = content(&module, Target::Wgsl);
        let text = wgsl.text().expect("text");
        judge(&run(&mut gpu, entry, Shader::Wgsl(text), bound), &format!("{entry} by WGSL @{}", driver.name));
        let Content::Words(spirv) = content(&module, Target::Spirv) else { panic!("not words") };
        judge(
            &run(&mut gpu, entry, Shader::Spirv(&spirv), bound),
            &format!("{entry} by SPIR-V @{}", driver.name),
        );
        let dxc = match Dxc::find() {
            Ok(dxc) => dxc,
            Err(TranslateError::NotFound { .. }) => {
                common::skip("DXC", "run tests/setup.sh");
                continue;
            }
            Err(error) => panic!("{error}"),
        };
        let hlsl = content(&module, Target::Hlsl);
        let object = dxc.compile(hlsl.text().expect("text"), "cs_6_0", Some(entry), DxcOutput::Spirv);
        let spirv = spirv_words(&object.unwrap_or_else(|e| panic!("{e}"))).unwrap_or_else(|e| panic!("{e}"));
        judge(
            &run(&mut gpu, entry, Shader::Spirv(&spirv), bound),
            &format!("{entry} by HLSL @{}", driver.name),
        );
    }
}

fn values() -> Vec<u32> {
    (0..GROUPS * SIZE as u32).map(|i| i.wrapping_mul(2654435761) >> 7).collect()
}

#[test]
fn workgroup_memory_and_barriers() {
    let values = values();
    let sums = values.chunks(SIZE).map(|c| c.iter().copied().fold(0, u32::wrapping_add)).collect::<Vec<_>>();
    let bound = [
        Bound(BindingKind::StorageRead, values),
        Bound(BindingKind::StorageReadWrite, vec![0; GROUPS as usize]),
    ];
    check(lobe_codegen::kernels![group_sums][0], &bound, &[sums]);
}

#[test]
fn atomics() {
    let values = values();
    let start = [5, 6, u32::MAX, 0, u32::MAX, 1, 9, 0];
    let fold = |i: usize, f: fn(u32, u32) -> u32| values.iter().copied().fold(start[i], f);
    let outcome = vec![
        fold(0, u32::wrapping_add),
        fold(1, u32::wrapping_sub),
        fold(2, u32::min),
        fold(3, u32::max),
        fold(4, |a, b| a & (b | 0xff00)),
        fold(5, |a, b| a | b),
        fold(6, |a, b| a ^ b),
        7,
    ];
    let bound = [
        Bound(BindingKind::StorageRead, values.clone()),
        Bound(BindingKind::StorageReadWrite, start.to_vec()),
        Bound(BindingKind::StorageReadWrite, vec![0]),
    ];
    check(lobe_codegen::kernels![all_atomics][0], &bound, &[outcome, vec![47]]);
}

/// `values` as an array in a buffer: words of each in order, three-component vectors on 16 bytes.
fn array<T: KernelValue>(values: &[T], slots: &[usize], stride: usize) -> Vec<u32> {
    let element = |value: &T| {
        let (mut packed, mut laid) = (Vec::new(), vec![0; stride]);
        value.write(&mut packed);
        assert_eq!(packed.len(), slots.len(), "a slot for each word");
        slots.iter().zip(packed).for_each(|(slot, word)| laid[*slot] = word);
        laid
    };
    values.iter().flat_map(element).collect()
}

/// Two rectangles before a row of receivers, with the light that each reflects.
fn lit_rectangles() -> ([Rectangle; 2], [f32; 2], [Reflection; 2]) {
    let low = Rectangle { position: Vec3::ZERO, normal: Vec3::Z, tangent: Vec3::X, half_x: 1.0, half_y: 0.5 };
    let leaning = Rectangle {
        position: Vec3::new(-0.3, 0.0, -0.5),
        normal: Vec3::new(0.28, 0.0, 0.96),
        tangent: Vec3::Y,
        half_x: 0.7,
        half_y: 1.2,
    };
    let light = DistantLight { direction: Vec3::new(0.6, 0.0, 0.8), irradiance: 3.0 };
    let alphas = [0.2, 0.4];
    let reflect = |rectangle: Rectangle, alpha| rect_reflection(rectangle.normal, alpha, 0.5, light);
    ([low, leaning], alphas, [reflect(low, 0.2), reflect(leaning, 0.4)])
}

/// A row of receivers above both rectangles that face their reflections.
fn receivers() -> Vec<GlossyReceiver> {
    let receiver = |i: usize| {
        let x = i as f32 / 96.0 - 0.5;
        GlossyReceiver {
            position: Vec3::new(x, 0.1, 1.0),
            normal: Vec3::new(0.28, 0.0, -0.96),
            view: Vec3::new(0.28, 0.0, -0.96),
            alpha: 0.4,
            reflectance: 0.5,
        }
    };
    (0..GROUPS as usize * SIZE).map(receiver).collect()
}

#[test]
fn rectangles_are_gathered_as_by_a_loop() {
    let (rectangles, alphas, reflections) = lit_rectangles();
    let receivers = receivers();
    let shaded = |receiver: &GlossyReceiver, i: usize| {
        let (rectangle, reflection) = (rectangles[i], reflections[i]);
        let height = (receiver.position - rectangle.position).dot(rectangle.normal).max(0.0);
        let dist = height / reflection.cos_sigma.max(1e-3);
        let radius = rect_disk_radius(3.0, alphas[i], dist, rectangle.half_x, rectangle.half_y);
        rect_shade(rectangle, reflection, *receiver, radius.max(1e-3)).radiance
    };
    let brightest = |i: usize| receivers.iter().map(|r| shaded(r, i)).fold(0.0, f32::max);
    let scale = brightest(0).min(brightest(1));
    assert!(scale > 1e-3, "a rectangle is dark");
    let expected: Vec<f32> = receivers.iter().map(|r| shaded(r, 0) + shaded(r, 1)).collect();
    let with_three_vectors = [0, 1, 2, 4, 5, 6, 8, 9, 10, 11, 12];
    let bound = [
        Bound(BindingKind::StorageRead, array(&rectangles, &with_three_vectors, 16)),
        Bound(BindingKind::StorageRead, array(&reflections, &[0, 1, 2, 4, 5, 6, 7, 8, 9], 12)),
        Bound(BindingKind::StorageRead, array(&receivers, &with_three_vectors, 16)),
        Bound(BindingKind::StorageRead, array(&alphas, &[0], 1)),
        Bound(BindingKind::StorageReadWrite, vec![0; receivers.len()]),
    ];
    check_by(lobe_codegen::kernels![gather_rectangles][0], &bound, |found, way| {
        for (index, (word, wanted)) in found[0].iter().zip(&expected).enumerate() {
            let value = f32::from_bits(*word);
            let gap = (value - wanted).abs();
            assert!(gap <= 1e-4 * scale, "{way}, receiver {index}: {value} instead of {wanted}");
        }
    });
}
