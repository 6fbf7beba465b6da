//! Bounds of what entry points store in textures and load from them: drivers drawn by chance stay within them.

use crate::support::foreign;
use lobe_backends::interp::{
    BoundTexture, Buffer, Interpreter, Resources, ShadowRun, ShadowTexture, ShadowWord,
};
use lobe_backends::texture::{Dimension, Format, Texture, TextureShape};

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
