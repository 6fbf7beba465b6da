//! Textures and subgroups of the interpreter alone: what is refused, and orders that must not show.

use lobe_backends::interp::{
    BoundSampler, BoundTexture, Buffer, Checks, Fault, InterpError, Interpreter, Resources,
};
use lobe_backends::texture::{Compare, Dimension, Format, Sampler, Texture, TextureShape};
use lobe_codegen::{ValidModule, validate};

/// A module that may have subgroups.
fn module(text: &str) -> ValidModule {
    validate::foreign_wgsl(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Zeros of a format and size.
fn texture(binding: u32, format: &str, size: [u32; 3], dimension: Dimension) -> BoundTexture {
    let shape = TextureShape::new(Format::named(format).unwrap(), dimension, size);
    BoundTexture { group: 0, binding, texture: Texture::zeros(shape).unwrap() }
}

fn flat(binding: u32, format: &str, [width, height]: [u32; 2]) -> BoundTexture {
    texture(binding, format, [width, height, 1], Dimension::D2)
}

fn run(
    text: &str,
    groups: [u32; 3],
    buffers: &mut [Buffer],
    textures: &mut [BoundTexture],
    samplers: &[BoundSampler],
) -> Result<(), InterpError> {
    let module = module(text);
    Interpreter::new(&module)?.run(0, groups, Resources { buffers, textures, samplers })
}

const SAMPLE: &str = "
    @group(0) @binding(0) var image: texture_2d<f32>;
    @group(0) @binding(1) var how: sampler;
    @group(0) @binding(2) var goal: texture_storage_2d<r32float, write>;
    @compute @workgroup_size(1)
    fn main() { textureStore(goal, vec2u(), textureSampleLevel(image, how, vec2f(0.5), 0.0)); }";

#[track_caller]
fn refused(textures: &mut [BoundTexture], samplers: &[BoundSampler], part: &str) {
    let message = run(SAMPLE, [1; 3], &mut [], textures, samplers).unwrap_err().to_string();
    assert!(message.contains(part), "{message}");
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let sampler = |sampler| [BoundSampler { group: 0, binding: 1, sampler }];
    let (plain, goal) = (sampler(Sampler::default()), || flat(2, "r32float", [1, 1]));
    refused(&mut [goal()], &plain, "no texture was given for `image` (group 0, binding 0)");
    refused(&mut [flat(0, "rgba8unorm", [2, 2]), goal()], &[], "no sampler was given for `how`");
    refused(
        &mut [flat(0, "rgba8uint", [2, 2]), goal()],
        &plain,
        "`image` is a 2d texture of floats, 1 sample a texel; it cannot be rgba8uint 2d 2x2x1",
    );
    let block = texture(0, "rgba8unorm", [2, 2, 2], Dimension::D3);
    refused(&mut [block, goal()], &plain, "it cannot be rgba8unorm 3d 2x2x2");
    let comparing = sampler(Sampler::default().comparing(Compare::Less));
    refused(&mut [flat(0, "r8unorm", [1, 1]), goal()], &comparing, "give it one without comparison");
    refused(
        &mut [flat(0, "r8unorm", [1, 1]), flat(2, "r32uint", [1, 1])],
        &plain,
        "`goal` is a 2d texture of r32float",
    );
    assert_eq!(run(SAMPLE, [1; 3], &mut [], &mut [flat(0, "r8unorm", [1, 1]), goal()], &plain), Ok(()));
}

fn words(texture: &BoundTexture) -> Vec<u32> {
    texture.texture.bytes().chunks(4).map(|c| u32::from_le_bytes(c.try_into().unwrap())).collect()
}

#[test]
fn texels_that_invocations_share_are_written_in_turn() {
    // Every 64th invocation shares a texel: the last one's number stays.
    let text = "
        @group(0) @binding(0) var goal: texture_storage_2d<r32uint, write>;
        @compute @workgroup_size(64)
        fn main(@builtin(global_invocation_id) id: vec3u) {
            textureStore(goal, vec2u(id.x % 8u, id.x / 8u % 8u), vec4u(id.x));
        }";
    let mut textures = [flat(0, "r32uint", [8, 8])];
    run(text, [2000, 1, 1], &mut [], &mut textures, &[]).unwrap();
    let last: Vec<u32> = (0..64).map(|i| 1999 * 64 + i).collect();
    assert_eq!(words(&textures[0]), last);
}

#[test]
fn texels_of_their_own_may_be_read_and_written_at_once() {
    let text = "
        @group(0) @binding(0) var goal: texture_storage_2d<r32uint, read_write>;
        @compute @workgroup_size(8, 8)
        fn main(@builtin(global_invocation_id) id: vec3u) {
            let old = textureLoad(goal, id.xy).x;
            textureStore(goal, id.xy, vec4u(old + id.y * 256u + id.x));
        }";
    let mut textures = [flat(0, "r32uint", [256, 200])];
    run(text, [32, 25, 1], &mut [], &mut textures, &[]).unwrap();
    run(text, [32, 25, 1], &mut [], &mut textures, &[]).unwrap();
    let twice: Vec<u32> = (0..256 * 200).map(|i| 2 * i).collect();
    assert_eq!(words(&textures[0]), twice);
}

#[test]
fn subgroups_are_consecutive_invocations_of_the_size_that_is_asked_for() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> out: array<vec4u, 40>;
        @compute @workgroup_size(40)
        fn main(@builtin(local_invocation_index) i: u32, @builtin(subgroup_size) size: u32,
                @builtin(subgroup_id) subgroup: u32, @builtin(num_subgroups) count: u32) {
            out[i] = vec4u(size, subgroup, count, subgroupAdd(1u));
        }";
    let module = module(text);
    for size in [4, 16, 64] {
        let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 640] }];
        let interpreter = Interpreter::new(&module).unwrap().with_subgroup_size(size);
        interpreter.run(0, [1; 3], &mut buffers).unwrap();
        let found: Vec<u32> =
            buffers[0].data.chunks(4).map(|c| u32::from_le_bytes(c.try_into().unwrap())).collect();
        // The last subgroup of a workgroup may not be full.
        let full = |subgroup: u32| size.min(40 - subgroup * size);
        let expected: Vec<u32> =
            (0..40).flat_map(|i| [size, i / size, 40u32.div_ceil(size), full(i / size)]).collect();
        assert_eq!(found, expected, "{size}");
    }
}

#[test]
fn a_value_of_a_lane_that_is_not_there_is_a_finding() {
    let findings = |value: &str| {
        let module = module(&format!(
            "@group(0) @binding(0) var<storage, read_write> out: array<u32, 8>;
            @compute @workgroup_size(8)
            fn main(@builtin(local_invocation_index) i: u32) {{ if i < 6u {{ out[i] = {value}; }} }}"
        ));
        let interpreter = Interpreter::new(&module).unwrap().with_subgroup_size(4);
        let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 32] }];
        let found = interpreter.sanitize(0, [1; 3], &mut buffers, Checks::default()).unwrap();
        found.into_iter().map(|f| f.kind).collect::<Vec<_>>()
    };
    for there in [
        "subgroupShuffleXor(i, 1u)",
        "subgroupBroadcastFirst(i)",
        "subgroupAdd(i)",
        "subgroupBroadcast(i, 1u)",
    ] {
        assert_eq!(findings(there), [], "{there}");
    }
    for absent in ["subgroupShuffleXor(i, 2u)", "subgroupShuffleDown(i, 1u)", "subgroupBroadcast(i, 2u)"] {
        assert_eq!(findings(absent), [Fault::AbsentLane], "{absent}");
    }
}

#[test]
fn a_texel_that_is_not_there_is_a_finding() {
    let findings = |texel: &str| {
        let module = module(&format!(
            "@group(0) @binding(0) var image: texture_2d_array<u32>;
            @group(0) @binding(1) var goal: texture_storage_2d<r32uint, write>;
            @compute @workgroup_size(1)
            fn main() {{ let at = textureDimensions(image).x; {texel}; }}"
        ));
        let shape = TextureShape::new(Format::named("r32uint").unwrap(), Dimension::D2Array, [4, 4, 1]);
        let image = Texture::zeros(shape.layered(2).levelled(2)).unwrap();
        let textures =
            &mut [BoundTexture { group: 0, binding: 0, texture: image }, flat(1, "r32uint", [4, 4])];
        let resources = Resources { buffers: &mut [], textures, samplers: &[] };
        let found = Interpreter::new(&module).unwrap().sanitize(0, [1; 3], resources, Checks::default());
        found.unwrap().into_iter().map(|f| (f.kind, f.message)).collect::<Vec<_>>()
    };
    let load = |texel: &str| format!("textureStore(goal, vec2u(), textureLoad(image, {texel}))");
    let store = |texel: &str| format!("textureStore(goal, {texel}, vec4u(1u))");
    let size = |level: &str| format!("textureStore(goal, vec2u(), textureDimensions(image, {level}).xyxy)");
    for there in [load("vec2u(at - 1), 1, 0"), load("vec2u(1), 1, 1"), store("vec2u(at - 1)"), size("1")] {
        assert_eq!(findings(&there), [], "{there}");
    }
    for (astray, what) in [
        (load("vec2u(at), 1, 0"), "texel 4,4,0 of layer 1, level 0, sample 0 of r32uint 2d_array"),
        (load("vec2u(), 2, 0"), "layer 2, level 0"),
        (load("vec2i(-1), 0, 1"), "texel -1,-1,0 of layer 0, level 1"),
        (load("vec2u(2), 0, 1"), "texel 2,2,0 of layer 0, level 1"),
        (store("vec2u(0, at)"), "texel 0,4,0"),
        (size("at"), "level 4"),
    ] {
        let found = findings(&astray);
        let [(Fault::OutOfBounds, message)] = &found[..] else { panic!("{astray}: {found:?}") };
        assert!(message.contains(what), "{message}");
    }
}
