//! Binding arrays: the element that an index means, on every instruction set and by the judge, and beyond the last one.

use crate::dispatch::{buffer, words};
use crate::support::{Chance, foreign};
use lobe_backends::interp::{
    BoundSampler, BoundTexture, Buffer, Checks, Fault, InterpError, Interpreter, Isa, Resources, ShadowWord,
};
use lobe_backends::texture::{Address, Dimension, Format, Sampler, Texture, TextureShape};

/// What is bound to the places of a module.
#[derive(Clone, Default)]
struct Bound {
    buffers: Vec<Buffer>,
    textures: Vec<BoundTexture>,
    samplers: Vec<BoundSampler>,
}

impl Bound {
    fn lend(&mut self) -> Resources<'_> {
        Resources { buffers: &mut self.buffers, textures: &mut self.textures, samplers: &self.samplers }
    }

    /// The words of all buffers, then the texels of all textures.
    fn bytes(&self) -> Vec<Vec<u8>> {
        let buffers = self.buffers.iter().map(|b| b.data.clone());
        buffers.chain(self.textures.iter().map(|t| t.texture.bytes().to_vec())).collect()
    }
}

/// What `text` leaves of `bound`: the same on every instruction set, and by the judge.
fn run(text: &str, groups: u32, bound: &Bound) -> Bound {
    let text = format!("enable wgpu_binding_array;\n{text}");
    let module = foreign(&text);
    let interpreter = Interpreter::new(&module).unwrap();
    let mut judged = bound.clone();
    interpreter.run_judged(0, [groups, 1, 1], judged.lend()).unwrap();
    for isa in Isa::available() {
        let mut left = bound.clone();
        interpreter.clone().with_isa(isa).run(0, [groups, 1, 1], left.lend()).unwrap();
        assert!(left.bytes() == judged.bytes(), "{isa} and the judge\n{text}");
    }
    judged
}

/// The same of buffers alone; the words of each.
fn run_buffers(text: &str, groups: u32, buffers: &[Buffer]) -> Vec<Vec<u32>> {
    let bound = Bound { buffers: buffers.to_vec(), ..Bound::default() };
    run(text, groups, &bound).buffers.iter().map(words).collect()
}

/// A module of one array of buffers, and what each of 32 invocations does.
fn rows(length: &str, body: &str) -> String {
    format!(
        "struct Row {{ tag: u32, items: array<u32> }}
        @group(0) @binding(0) var<storage, read_write> rows: binding_array<Row{length}>;
        @group(0) @binding(1) var<storage, read> given: array<u32>;
        @group(0) @binding(2) var<storage, read_write> out: array<u32, 128>;
        @compute @workgroup_size(32) fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
            let i = id.x;
            {body}
        }}"
    )
}

/// Rows of 3, 9, 2 and 130 items, whose tags are 0 to 3 and whose items are 100 and 1 for each row and item.
const LENGTHS: [u32; 4] = [3, 9, 2, 130];

fn row(row: u32) -> Vec<u32> {
    std::iter::once(row).chain((0..LENGTHS[row as usize]).map(|item| 100 * row + item)).collect()
}

fn all(given: &[u32]) -> Vec<Buffer> {
    // Not in the order of their places: that of the elements counts.
    let mut buffers = vec![buffer(2, &[0; 128]), buffer(1, given)];
    buffers.extend((0..4).map(|n| buffer(0, &row(n))));
    buffers
}

/// What the rule says: the last element for an index beyond it, the last item for one beyond that.
fn loaded(which: u32, item: u32) -> u32 {
    let which = which.min(3);
    100 * which + item.min(LENGTHS[which as usize] - 1)
}

#[test]
fn an_index_means_its_element_and_one_beyond_the_last_means_that() {
    let mut chance = Chance(5);
    let mut number = |n: usize| if chance.below(9) == 0 { u32::MAX } else { chance.below(n) as u32 };
    let given: Vec<u32> = (0..256).map(|at| number(if at % 2 == 0 { 6 } else { 12 })).collect();
    let load = "out[i] = rows[given[2u * i]].items[given[2u * i + 1u]];";
    let expected: Vec<u32> = given.chunks(2).map(|c| loaded(c[0], c[1])).collect();
    for length in ["", ", 4"] {
        assert_eq!(run_buffers(&rows(length, load), 4, &all(&given))[0], expected, "{length}");
    }
    // The same for an index that all invocations share, or that is known.
    for which in [0, 2, 3, 4, 77] {
        let shared = format!("out[i] = rows[given[0]].items[i] + rows[{which}].items[i % 5u];");
        let expected: Vec<u32> = (0..128).map(|i| loaded(which, i) + loaded(which, i % 5)).collect();
        assert_eq!(run_buffers(&rows("", &shared), 4, &all(&[which]))[0], expected, "{which}");
    }
    let known = "out[i] = rows[1].items[7] + rows[2].items[40];";
    assert_eq!(run_buffers(&rows(", 4", known), 4, &all(&[0]))[0], [107 + 201; 128]);
}

#[test]
fn a_signed_index_below_zero_means_the_last_element() {
    let load = "out[i] = rows[i32(i) - 1].tag * 10u + rows[1].items[i32(i & 1u) - 1] - 100u;";
    let found = run_buffers(&rows("", load), 1, &all(&[0]));
    let expected: Vec<u32> = (0..32)
        .map(|i| if i == 0 { 30 } else { (i - 1).min(3) * 10 } + if i & 1 == 0 { 8 } else { 0 })
        .collect();
    assert_eq!(found[0][..32], expected);
}

#[test]
fn lengths_are_those_of_the_chosen_element() {
    let length = "out[i] = arrayLength(&rows[i].items) * 1000u + arrayLength(&rows[2].items);";
    let expected: Vec<u32> = (0..32).map(|i| LENGTHS[i.min(3)] * 1000 + 2).collect();
    for sized in ["", ", 4"] {
        assert_eq!(run_buffers(&rows(sized, length), 1, &all(&[0]))[0][..32], expected);
    }
}

#[test]
fn stores_and_atomics_reach_one_element_alone() {
    let store = "rows[i & 3u].items[i] = 7u; rows[i & 1u].tag = 40u + (i & 1u);";
    let left = run_buffers(&rows("", store), 1, &all(&[0]));
    for n in 0..4_u32 {
        let mut expected = row(n);
        // Each row is written at every fourth item, and beyond its end at the last one.
        let last = LENGTHS[n as usize] - 1;
        (0..32).filter(|i| i & 3 == n).for_each(|i| expected[1 + i.min(last) as usize] = 7);
        if n < 2 {
            expected[0] = 40 + n;
        }
        assert_eq!(left[2 + n as usize], expected, "row {n}");
    }
    let text = "
        struct Count { sum: atomic<u32>, most: atomic<i32> }
        @group(0) @binding(3) var<storage, read_write> counts: binding_array<Count, 3>;
        @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            atomicAdd(&counts[id.x % 3u].sum, id.x);
            let old = atomicMax(&counts[id.x % 5u].most, i32(id.x));
        }";
    let zeros = [buffer(3, &[0; 2]), buffer(3, &[0; 2]), buffer(3, &[0; 2])];
    let sum = |n| (0..128).filter(|i| i % 3 == n).sum::<u32>();
    assert_eq!(run_buffers(text, 2, &zeros), [[sum(0), 125], [sum(1), 126], [sum(2), 127]]);
}

#[test]
fn what_the_type_asks_for_has_to_be_there() {
    let text = format!("enable wgpu_binding_array;\n{}", rows(", 4", "out[i] = rows[i].tag;"));
    let module = foreign(&text);
    let run = |buffers: &mut [Buffer]| Interpreter::new(&module)?.run(0, [1; 3], buffers);
    assert_eq!(run(&mut all(&[0])), Ok(()));
    let mut more = all(&[0]);
    more.push(buffer(0, &[1]));
    assert_eq!(run(&mut more), Ok(()), "more than it uses does no harm");
    let missing = run(&mut all(&[0])[..5]).unwrap_err();
    assert!(matches!(missing, InterpError::MissingElements { expected: 4, found: 3, .. }), "{missing}");
    let mut short = all(&[0]);
    short[4] = buffer(0, &[1]);
    assert!(matches!(run(&mut short), Err(InterpError::BufferTooSmall { expected: 8, found: 4, .. })));
    let text = format!("enable wgpu_binding_array;\n{}", rows("", "out[i] = rows[i].tag;"));
    let module = foreign(&text);
    let none = Interpreter::new(&module).unwrap().run(0, [1; 3], &mut all(&[0])[..2]).unwrap_err();
    assert!(
        none.to_string().contains("`rows` (group 0, binding 0) is a binding array of 1 elements"),
        "{none}"
    );
}

/// Kinds, lines and messages of what a body does wrong; it stands in line 8.
fn findings(length: &str, body: &str) -> Vec<(Fault, u32, String)> {
    let text = format!("enable wgpu_binding_array;\n{}", rows(length, body));
    let module = foreign(&text);
    let interpreter = Interpreter::new(&module).unwrap();
    let mut bound = Bound { buffers: all(&[5; 64]), ..Bound::default() };
    let found = interpreter.sanitize(0, [1; 3], bound.lend(), Checks::default()).unwrap();
    let line = |f: &lobe_backends::interp::Finding| f.line(&text).map_or(0, |(line, _)| line);
    found.iter().map(|f| (f.kind, line(f), f.message.clone())).collect()
}

#[test]
fn an_index_beyond_the_last_element_is_found_at_its_line() {
    let out = |message: &str| vec![(Fault::OutOfBounds, 8, message.to_owned())];
    for length in ["", ", 4"] {
        assert_eq!(findings(length, "out[i] = rows[i & 3u].tag;"), []);
        assert_eq!(findings(length, "out[i] = rows[given[i]].tag;"), out("index 5 of 4 elements"));
        assert_eq!(findings(length, "out[i] = rows[4].tag;"), out("index 4 of 4 elements"));
        // Of an array within an element as many as that one has.
        let within = |at: &str| format!("out[i] = rows[i & 1u].items[{at}];");
        assert_eq!(findings(length, &within("2")), []);
        assert_eq!(findings(length, &within("3")), out("index 3 of 3 elements"));
        assert_eq!(findings(length, &within("9u - (i & 1u)")), out("index 9 of 3 elements"));
    }
}

#[test]
fn races_name_the_element() {
    let found = findings("", "rows[2u - (i >> 5u)].tag = i;");
    let [(Fault::Race, 8, message)] = &found[..] else { panic!("{found:?}") };
    assert!(message.contains("writes word 0 of `rows[2]`"), "{message}");
    assert_eq!(findings("", "if i < 4u { rows[i].tag = i; }"), []);
}

#[test]
fn bounds_are_told_by_element() {
    let text = "enable wgpu_binding_array;
        struct Floats { sum: f32, words: array<f32> }
        @group(0) @binding(0) var<storage, read_write> all: binding_array<Floats>;
        @compute @workgroup_size(4) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            all[id.x & 1u].words[id.x >> 1u] = sin(all[1u - (id.x & 1u)].sum);
        }";
    let floats = |x: f32| buffer(0, &[x.to_bits(), 0, 0]);
    let mut buffers = [floats(0.25), floats(0.75)];
    let module = foreign(text);
    let interpreter = Interpreter::new(&module).unwrap();
    let shadow = interpreter.shadow_run(0, [1; 3], &mut buffers).unwrap().buffers;
    assert_eq!(shadow.iter().map(|b| (b.binding, b.element)).collect::<Vec<_>>(), [(0, 0), (0, 1)]);
    for (buffer, argument) in shadow.iter().zip([0.75_f64, 0.25]) {
        let [ShadowWord::Word { known: true, .. }, rest @ ..] = &buffer.words[..] else {
            panic!("{buffer:?}")
        };
        for word in rest {
            let ShadowWord::Float { exact, bound, .. } = *word else { panic!("{word:?}") };
            assert!((exact - argument.sin()).abs() < 1e-12 && bound > 0.0 && bound < 1e-2, "{word:?}");
        }
    }
}

#[test]
fn nothing_is_known_of_an_array_that_drivers_write_at_different_elements() {
    // Whether the sine rounds below the literal is the driver's choice, and so is the element.
    let text = "enable wgpu_binding_array;
        struct Word { word: u32 }
        @group(0) @binding(0) var<storage, read_write> all: binding_array<Word>;
        @group(0) @binding(1) var<storage, read> x: f32;
        @group(0) @binding(2) var goals: binding_array<texture_storage_2d<r32uint, write>>;
        @compute @workgroup_size(1) fn main() {
            let which = u32(sin(x) * 1e6) & 1u;
            all[which].word = 5u;
            textureStore(goals[which], vec2<u32>(), vec4<u32>(5u));
        }";
    let module = foreign(text);
    let mut bound = Bound {
        buffers: vec![buffer(0, &[1]), buffer(0, &[2]), buffer(1, &[1.0_f32.to_bits()])],
        textures: (0..2).map(|_| texture(2, "r32uint", 2)).collect(),
        samplers: Vec::new(),
    };
    let left = Interpreter::new(&module).unwrap().shadow_run(0, [1; 3], bound.lend()).unwrap();
    let is_unknown = |word: &ShadowWord| matches!(word, ShadowWord::Word { known: false, .. });
    assert!(left.buffers.len() == 2 && left.buffers.iter().all(|b| is_unknown(&b.words[0])), "{left:?}");
    assert_eq!(
        left.textures.iter().map(|t| (t.element, t.is_known)).collect::<Vec<_>>(),
        [(0, false), (1, false)]
    );
}

/// A square texture whose texels are numbered from ten times its side on.
fn texture(binding: u32, format: &str, side: u32) -> BoundTexture {
    let shape = TextureShape::new(Format::named(format).unwrap(), Dimension::D2, [side, side, 1]);
    let texels = (0..side * side).flat_map(|n| (10 * side + n).to_le_bytes()).collect();
    BoundTexture { group: 0, binding, texture: Texture::new(shape, texels).unwrap() }
}

#[test]
fn textures_of_several_shapes_are_loaded_from_written_and_asked() {
    let text = "
        @group(0) @binding(0) var images: binding_array<texture_2d<u32>>;
        @group(0) @binding(1) var goals: binding_array<texture_storage_2d<r32uint, read_write>, 3>;
        @group(0) @binding(2) var<storage, read_write> out: array<vec2<u32>, 32>;
        @compute @workgroup_size(32) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            let which = id.x % 4u;
            let at = vec2<u32>(id.x / 4u % 2u, 1u);
            out[id.x] = vec2<u32>(textureLoad(images[which], at, 0).x, textureDimensions(images[which]).x);
            let goal = vec2<u32>(id.x / 3u % 2u, id.x / 6u);
            let old = textureLoad(goals[id.x % 3u], goal).x;
            textureStore(goals[id.x % 3u], goal, vec4<u32>(old + 1000u + id.x));
        }";
    let sides = [2, 5, 3];
    let textures = |binding| sides.map(|side| texture(binding, "r32uint", side));
    let bound = Bound {
        buffers: vec![buffer(2, &[0; 64])],
        textures: textures(0).into_iter().chain(textures(1)).collect(),
        samplers: Vec::new(),
    };
    let left = run(text, 1, &bound);
    let expected = (0..32).flat_map(|i: u32| {
        let side = sides[(i % 4).min(2) as usize];
        [10 * side + side + i / 4 % 2, side]
    });
    assert_eq!(words(&left.buffers[0]), expected.collect::<Vec<_>>());
    assert!(left.bytes()[1..4] == bound.bytes()[1..4], "what is only read stays");
    for (which, side) in (0..).zip(sides) {
        let mut expected: Vec<u32> = (0..side * side).map(|n| 10 * side + n).collect();
        for i in (0..32).filter(|i| i % 3 == which) {
            let [x, y] = [i / 3 % 2, i / 6];
            if y < side {
                expected[(y * side + x) as usize] += 1000 + i;
            }
        }
        let found = left.textures[3 + which as usize].texture.bytes().as_chunks().0.iter();
        assert_eq!(found.map(|c| u32::from_le_bytes(*c)).collect::<Vec<_>>(), expected, "{which}");
    }
}

#[test]
fn samplers_are_chosen_too_and_texels_outside_are_found_in_the_chosen_texture() {
    let text = "
        @group(0) @binding(0) var image: texture_2d<f32>;
        @group(0) @binding(1) var how: binding_array<sampler>;
        @group(0) @binding(2) var<storage, read_write> out: array<f32, 8>;
        @compute @workgroup_size(8) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            out[id.x] = textureSampleLevel(image, how[id.x & 3u], vec2<f32>(1.75, 0.25), 0.0).x;
        }";
    let samplers = [Address::ClampToEdge, Address::Repeat, Address::MirrorRepeat];
    let sampler = |address| Sampler { address: [address; 3], ..Sampler::default() };
    let shape = TextureShape::new(Format::named("r32float").unwrap(), Dimension::D2, [2, 1, 1]);
    let texels = [1.0_f32, 2.0].map(f32::to_le_bytes).concat();
    let bound = Bound {
        buffers: vec![buffer(2, &[0; 8])],
        textures: vec![BoundTexture { group: 0, binding: 0, texture: Texture::new(shape, texels).unwrap() }],
        samplers: samplers.map(|a| BoundSampler { group: 0, binding: 1, sampler: sampler(a) }).to_vec(),
    };
    let found: Vec<f32> = words(&run(text, 1, &bound).buffers[0]).into_iter().map(f32::from_bits).collect();
    // Clamped, repeated, mirrored; the last one again.
    assert_eq!(found, [2.0, 2.0, 1.0, 1.0, 2.0, 2.0, 1.0, 1.0]);

    let text = "enable wgpu_binding_array;
        @group(0) @binding(0) var images: binding_array<texture_2d<u32>>;
        @group(0) @binding(2) var<storage, read_write> out: array<u32, 8>;
        @compute @workgroup_size(8) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            out[id.x] = textureLoad(images[id.x & 1u], vec2<u32>(2u), 0).x;
        }";
    let module = foreign(text);
    let sanitized = |sides: [u32; 2]| {
        let textures = sides.map(|side| texture(0, "r32uint", side)).to_vec();
        let mut bound = Bound { buffers: vec![buffer(2, &[0; 8])], textures, samplers: Vec::new() };
        let interpreter = Interpreter::new(&module).unwrap();
        let found = interpreter.sanitize(0, [1; 3], bound.lend(), Checks::default()).unwrap();
        found.iter().map(|f| (f.kind, f.line(text).map(|(line, _)| line))).collect::<Vec<_>>()
    };
    assert_eq!(sanitized([3, 4]), []);
    assert_eq!(sanitized([3, 2]), [(Fault::OutOfBounds, Some(5))]);
}
