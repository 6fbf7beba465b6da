//! Bounds of what entry points store in textures and load from them: drivers drawn by chance stay within them.

use crate::support::foreign;
use lobe_backends::interp::{
    BoundSampler, BoundTexture, Buffer, Interpreter, Resources, ShadowRun, ShadowTexture, ShadowWord,
};
use lobe_backends::texture::{Compare, Dimension, Format, Sampler, Texture, TextureShape};

const DRIVERS: u64 = 24;
const SIDE: u32 = 8;

/// A texture whose texels are the bytes of a sequence that looks drawn.
fn picture(binding: u32, format: &str) -> BoundTexture {
    let format = Format::named(format).unwrap();
    let shape = TextureShape::new(format, Dimension::D2, [SIDE, SIDE, 1]);
    let texels = (0..SIDE * SIDE).flat_map(|i| {
        let number = |k: u32| (f64::from(i * 7 + k * 5) / 90.0 % 1.0) as f32;
        let texel = format.encode([0, 1, 2, 3].map(|k| number(k).to_bits().into()));
        texel.to_le_bytes().into_iter().take(format.bytes())
    });
    BoundTexture { group: 0, binding, texture: Texture::new(shape, texels.collect()).unwrap() }
}

/// The texel at a byte.
fn texel(texture: &Texture, at: usize) -> u128 {
    let bytes = &texture.bytes()[at..at + texture.shape().format.bytes()];
    bytes.iter().rev().fold(0, |texel, byte| texel << 8 | u128::from(*byte))
}

fn is_left(shadow: &ShadowTexture, texture: &Texture, interp: &Texture) -> Result<(), String> {
    if !shadow.is_known {
        return Ok(());
    }
    for at in (0..texture.bytes().len()).step_by(texture.shape().format.bytes()) {
        let found = texel(texture, at);
        let is_fine = match shadow.texels.iter().find(|t| t.at == at) {
            Some(stored) => stored.ranges.is_none_or(|ranges| texture.shape().format.admits(found, ranges)),
            None => found == texel(interp, at),
        };
        if !is_fine {
            return Err(format!("texel {at}: {found:#x}, the interpreter has {:#x}", texel(interp, at)));
        }
    }
    Ok(())
}

/// Runs `text` on buffer 0 of floats, buffer 1 of results, and textures 2 and 3; what chance drivers leave is permitted.
fn check(text: &str, formats: [&str; 2]) -> ShadowRun {
    let module = foreign(text);
    let interpreter = Interpreter::new(&module).unwrap();
    let floats: Vec<u8> = (0..64).flat_map(|i| (i as f32 / 50.0 - 0.3).to_le_bytes()).collect();
    let run = |driver: Option<u64>| {
        let mut buffers = [(0, floats.clone()), (1, vec![0; 1024])].map(|(binding, data)| Buffer {
            group: 0,
            binding,
            data,
        });
        let mut textures = [picture(2, formats[0]), picture(3, formats[1])];
        let resources = Resources { buffers: &mut buffers, textures: &mut textures, samplers: &[] };
        match driver {
            None => return (Some(interpreter.shadow_run(0, [1; 3], resources).unwrap()), buffers, textures),
            Some(0) => interpreter.run(0, [1; 3], resources).unwrap(),
            Some(seed) => interpreter.perturbed_run(0, [1; 3], resources, seed).unwrap(),
        }
        (None, buffers, textures)
    };
    let shadow = run(None).0.unwrap();
    let (_, _, interp) = run(Some(0));
    for driver in 0..DRIVERS {
        let (_, buffers, textures) = run(Some(driver));
        for left in &shadow.textures {
            let of = |textures: &[BoundTexture; 2]| textures[left.binding as usize - 2].texture.clone();
            let outcome = is_left(left, &of(&textures), &of(&interp));
            assert_eq!(outcome, Ok(()), "driver {driver}\n{text}");
        }
        for (word, bytes) in shadow.buffers[0].words.iter().zip(buffers[1].data.chunks(4)) {
            let found = f32::from_le_bytes(bytes.try_into().unwrap());
            let is_fine = match *word {
                ShadowWord::Float { exact, bound, .. } => {
                    bound.is_infinite() || (f64::from(found) - exact).abs() <= bound
                }
                ShadowWord::Word { value, known } => !known || value == found.to_bits(),
            };
            assert!(is_fine, "driver {driver}: {found:e} is not {word:?}\n{text}");
        }
    }
    shadow
}

fn entry(formats: [&str; 2], body: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read> a: array<f32, 64>;
        @group(0) @binding(1) var<storage, read_write> out: array<vec4<f32>, 64>;
        @group(0) @binding(2) var goal: texture_storage_2d<{}, read_write>;
        @group(0) @binding(3) var source: texture_storage_2d<{}, read>;
        @compute @workgroup_size(8, 8)
        fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {{
            let x = a[i] * 1.1 - 0.1;
            {body}
            if i == 0u {{ out[63] = textureLoad(source, vec2(0, 0)); }}
        }}",
        formats[0], formats[1]
    )
}

const FORMATS: [&str; 12] = [
    "rgba8unorm",
    "rgba8snorm",
    "rgba16float",
    "r32float",
    "rg32float",
    "rgba32float",
    "r16unorm",
    "rg16snorm",
    "rgb10a2unorm",
    "rg11b10ufloat",
    "r8unorm",
    "bgra8unorm",
];

#[test]
fn chance_drivers_leave_what_may_be_stored() {
    for format in FORMATS {
        let body = "textureStore(goal, id.xy, vec4(x, x * x * 3.0, sin(x), 1.0 / (x + 3.0)));
            if a[i] * 50.0 + 15.0 > f32(i) { textureStore(goal, id.xy, vec4(x, 0.5, x, 0.5)); }";
        let text = entry([format, "rgba8unorm"], body);
        let shadow = check(&text, [format, "rgba8unorm"]);
        let [goal] = &shadow.textures[..] else { panic!("one texture is written") };
        assert!(goal.is_known && goal.texels.len() == 64 && goal.texels.iter().all(|t| t.ranges.is_some()));
    }
}

#[test]
fn chance_drivers_read_what_texels_may_hold() {
    for format in FORMATS {
        let body = "let t = textureLoad(source, id.xy);
            out[i] = t * x + sqrt(abs(t));
            textureStore(goal, id.xy, vec4(x));
            out[i] += textureLoad(goal, id.xy) + textureLoad(goal, vec2(9, 9));";
        let shadow = check(&entry([format, format], body), [format; 2]);
        let bounded = shadow.buffers[0].words.iter().filter(|word| match word {
            ShadowWord::Float { bound, .. } => bound.is_finite(),
            ShadowWord::Word { .. } => false,
        });
        assert_eq!(bounded.count(), 256, "{format}");
    }
}

#[test]
fn texels_at_places_that_are_not_known_spoil_the_texture() {
    let formats = ["rgba8unorm", "rgba8unorm"];
    let spoilt = check(
        &entry(formats, "textureStore(goal, vec2(u32(a[i] * 50.0 + 15.0) % 8u, 0u), vec4(0.5));"),
        formats,
    );
    assert!(!spoilt.textures[0].is_known);
    let counted = check(&entry(formats, "textureStore(goal, vec2(i % 3u, 0u), vec4(0.5));"), formats);
    assert!(counted.textures[0].is_known && counted.textures[0].texels.len() == 3);
}

#[test]
fn a_code_further_away_is_not_admitted() {
    let format = Format::named("rgba8unorm").unwrap();
    let ranges = [[0.5, 0.5], [0.0, 0.1], [1.0, 1.0], [f64::NEG_INFINITY, f64::INFINITY]];
    for (texel, is_admitted) in [
        (0x00ff_1a7f_u128, true),
        (0x77ff_0080, true),
        (0x00ff_1b80, false),
        (0x00ff_0081, false),
        (0x00fe_0080, false),
    ] {
        assert_eq!(format.admits(texel, ranges), is_admitted, "{texel:#x}");
    }
}

/// Numbers that `sample` leaves in `out`, on a texture of `format`, as the shadow lane has them.
fn sampled(format: &str, sampler: Sampler, kind: &str, sample: &str) -> Vec<(f64, f64)> {
    let how = if sampler.compare.is_some() { "sampler_comparison" } else { "sampler" };
    let text = format!(
        "@group(0) @binding(0) var<storage, read_write> out: array<vec4<f32>, 64>;
        @group(0) @binding(2) var image: {kind};
        @group(0) @binding(3) var how: {how};
        @compute @workgroup_size(8, 8)
        fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {{
            let at = (vec2<f32>(id.xy) + 0.5) / 8.0;
            let edge = vec2<f32>(id.xy) / 8.0;
            out[i] = vec4<f32>({sample});
        }}"
    );
    let module = foreign(&text);
    let interpreter = Interpreter::new(&module).unwrap();
    let samplers = [BoundSampler { group: 0, binding: 3, sampler }];
    let mut textures = [picture(2, format)];
    let mut run = |driver: Option<u64>| {
        let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 1024] }];
        let resources = Resources { buffers: &mut buffers, textures: &mut textures, samplers: &samplers };
        match driver {
            None => return (Some(interpreter.shadow_run(0, [1; 3], resources).unwrap()), buffers),
            Some(seed) => interpreter.perturbed_run(0, [1; 3], resources, seed).unwrap(),
        }
        (None, buffers)
    };
    let shadow = run(None).0.unwrap();
    let told = |word: &ShadowWord| match *word {
        ShadowWord::Float { exact, bound, .. } => (exact, bound),
        ShadowWord::Word { .. } => panic!("a float was written"),
    };
    let told: Vec<(f64, f64)> = shadow.buffers[0].words.iter().map(told).collect();
    for driver in 0..DRIVERS {
        let (_, [buffer]) = run(Some(driver));
        for ((exact, bound), bytes) in told.iter().zip(buffer.data.chunks(4)) {
            let found = f64::from(f32::from_le_bytes(bytes.try_into().unwrap()));
            assert!(
                bound.is_infinite() || (found - exact).abs() <= *bound,
                "{found} {exact} {bound}: {text}"
            );
        }
    }
    told
}

/// The same number in the texel at a place that `picture` gives it.
fn number(x: u32, y: u32, channel: u32) -> f64 {
    f64::from(((f64::from((y * SIDE + x) * 7 + channel * 5) / 90.0) % 1.0) as f32)
}

#[test]
fn a_sample_in_the_middle_of_a_texel_is_that_texel() {
    let told = sampled(
        "rgba32float",
        Sampler::default(),
        "texture_2d<f32>",
        "textureSampleLevel(image, how, at, 0.0)",
    );
    for (i, (exact, bound)) in told.iter().enumerate() {
        let (texel, channel) = (i as u32 / 4, i as u32 % 4);
        assert_eq!((*exact, *bound), (number(texel % SIDE, texel / SIDE, channel), 0.0), "{i}");
    }
}

#[test]
fn a_sample_at_the_edge_of_texels_is_either() {
    let told = sampled(
        "rgba32float",
        Sampler::default(),
        "texture_2d<f32>",
        "textureSampleLevel(image, how, edge, 0.0)",
    );
    let (exact, bound) = told[4 * (3 * SIDE as usize + 3)];
    let around = [number(2, 2, 0), number(3, 2, 0), number(2, 3, 0), number(3, 3, 0)];
    let furthest = around.map(|x| (x - exact).abs()).into_iter().fold(0.0, f64::max);
    assert!(exact == number(3, 3, 0) && (bound - furthest).abs() < 1e-6, "{exact} {bound} {around:?}");
}

#[test]
fn a_sample_a_division_from_the_edge_is_either() {
    let bound = |shift| {
        let sample = format!("textureSampleLevel(image, how, at + {shift}, 0.0)");
        sampled("rgba32float", Sampler::default(), "texture_2d<f32>", &sample)[4 * (3 * SIDE as usize + 3)].1
    };
    // 0.4 and 0.45 texels from the middle: 0.1 and 0.05 from the edge, where divisions are 0.0625 apart. An edge is the
    // first division of the texel that begins there.
    assert_eq!((bound("0.05"), bound("0.05625") > 0.0, bound("-0.05625")), (0.0, true, 0.0));
}

#[test]
fn gathered_and_compared_texels_are_told_and_blends_are_not() {
    let is_told = |told: &[(f64, f64)]| told.iter().filter(|(_, bound)| bound.is_finite()).count();
    let color = "texture_2d<f32>";
    let gathered =
        sampled("rgba32float", Sampler::default(), color, "textureGather(1, image, how, at + 0.03)");
    assert_eq!(is_told(&gathered), 256);
    let blend =
        sampled("rgba32float", Sampler::linear(), color, "textureSampleLevel(image, how, at + 0.03, 0.0)");
    assert_eq!(is_told(&blend), 0);
    let moved =
        sampled("rgba32float", Sampler::default(), color, "textureSampleLevel(image, how, at * 1e9, 0.0)");
    assert!(is_told(&moved) < 256);
    let compare = |format, compare| {
        let sample = "textureSampleCompareLevel(image, how, at, 0.51)";
        sampled(format, Sampler::default().comparing(compare), "texture_depth_2d", sample)
    };
    for format in ["depth32float", "depth16unorm"] {
        for (i, (exact, bound)) in compare(format, Compare::Less).iter().enumerate() {
            let texel = i as u32 / 4;
            let depth = number(texel % SIDE, texel / SIDE, 0);
            assert_eq!((*exact, *bound), (f64::from(u8::from(0.51 < depth)), 0.0), "{format}: {depth}");
        }
    }
}

#[test]
fn integers_that_a_coordinate_may_miss_are_not_known() {
    let known = |shift: &str| {
        let text = format!(
            "@group(0) @binding(0) var<storage, read_write> out: array<vec4<i32>, 64>;
            @group(0) @binding(2) var image: texture_2d<i32>;
            @group(0) @binding(3) var how: sampler;
            @compute @workgroup_size(8, 8)
            fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {{
                out[i] = textureGather(0, image, how, (vec2<f32>(id.xy) + {shift}) / 8.0);
            }}"
        );
        let module = foreign(&text);
        let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 1024] }];
        let mut textures = [picture(2, "r8sint")];
        textures[0].texture.bytes_mut().iter_mut().zip(100..).for_each(|(byte, n)| *byte = n);
        let samplers = [BoundSampler { group: 0, binding: 3, sampler: Sampler::default() }];
        let resources = Resources { buffers: &mut buffers, textures: &mut textures, samplers: &samplers };
        let shadow = Interpreter::new(&module).unwrap().shadow_run(0, [1; 3], resources).unwrap();
        let words = shadow.buffers[0].words.iter();
        words.filter(|word| matches!(word, ShadowWord::Word { known: true, .. })).count()
    };
    // In the middle of four texels they are sure; past edges the same texel is all there is.
    assert!(known("0.0") == 256 && known("0.5") < 64);
}
