//! Elements of arrays: fields that are loaded together, strides, indices in any order and beyond the end.

use crate::support::module;
use lobe_backends::interp::{Buffer, Interpreter, Isa};

/// What WGSL computes of an invocation's number, and the same in Rust.
type Index = (&'static str, fn(u32) -> u32);

fn buffer(binding: u32, words: impl Iterator<Item = u32>) -> Buffer {
    Buffer { group: 0, binding, data: words.flat_map(u32::to_le_bytes).collect() }
}

/// Invocation `i` sums fields of element `index(i)`, each times its rank, on every instruction set; the words of the array
/// are their numbers. `fields`: their offsets in words, of `stride`.
fn check(fields: &[u32], stride: u32, length: u32, index: Index) {
    let members: String = (0..stride).map(|word| format!("w{word}: u32, ")).collect();
    let terms: Vec<String> =
        fields.iter().enumerate().map(|(rank, word)| format!("{}u * e.w{word}", rank + 1)).collect();
    let text = format!(
        "struct Element {{ {members} }}
        @group(0) @binding(0) var<storage, read> elements: array<Element>;
        @group(0) @binding(1) var<storage, read_write> out: array<u32>;
        @compute @workgroup_size(32) fn f(@builtin(global_invocation_id) id: vec3<u32>) {{
            let i = id.x;
            let e = elements[{}];
            out[i] = {};
        }}",
        index.0,
        terms.join(" + ")
    );
    let module = module(&text);
    let invocations = 32 * 9;
    let expected: Vec<u32> = (0..invocations)
        .map(|i| {
            let element = index.1(i).min(length - 1);
            (1..).zip(fields).fold(0, |sum: u32, (rank, word)| sum + rank * (element * stride + word))
        })
        .collect();
    for isa in Isa::available() {
        let mut buffers =
            [buffer(0, 0..length * stride), buffer(1, std::iter::repeat_n(0, invocations as usize))];
        Interpreter::new(&module).unwrap().with_isa(isa).run(0, [9, 1, 1], &mut buffers).unwrap();
        let found: Vec<u32> =
            buffers[1].data.chunks(4).map(|c| u32::from_le_bytes(c.try_into().unwrap())).collect();
        assert_eq!(found, expected, "{isa}, {length} elements\n{text}");
    }
}

#[test]
fn fields_that_are_loaded_together_are_each_its_own() {
    let indices: [Index; 4] =
        [("i", |i| i), ("i * 7u % 61u", |i| i * 7 % 61), ("i + 3u", |i| i + 3), ("300u - i", |i| 300 - i)];
    let layouts: [(&[u32], u32); 7] = [
        (&[0], 1),
        (&[1, 0], 2),
        (&[0, 1, 2], 3),
        (&[0, 2], 3),
        (&[0, 1, 2, 3], 4),
        (&[4, 0, 3, 1], 5),
        (&[0, 1, 2, 3, 4, 8, 9, 10], 12),
    ];
    for index in indices {
        for (fields, stride) in layouts {
            for length in [1, 2, 5, 127, 128, 200, 400] {
                check(fields, stride, length, index);
            }
        }
    }
}

/// Loads on both sides of a store: the later one sees what was stored.
#[test]
fn loads_do_not_move_over_stores() {
    let text = "
        struct Pair { a: u32, b: u32 }
        @group(0) @binding(0) var<storage, read_write> pairs: array<Pair>;
        @compute @workgroup_size(32) fn f(@builtin(global_invocation_id) id: vec3<u32>) {
            let a = pairs[id.x].a;
            pairs[id.x].b = a + 1u;
            pairs[id.x].a = pairs[id.x].b * 2u;
        }";
    let module = module(text);
    for isa in Isa::available() {
        let mut buffers = [buffer(0, 0..400)];
        Interpreter::new(&module).unwrap().with_isa(isa).run(0, [5, 1, 1], &mut buffers).unwrap();
        for (i, pair) in buffers[0].data.chunks(8).enumerate().take(160) {
            let word = |at: usize| u32::from_le_bytes(pair[at..at + 4].try_into().unwrap());
            let i = i as u32;
            assert_eq!((word(0), word(4)), ((2 * i + 1) * 2, 2 * i + 1), "{isa}, {i}");
        }
    }
}

/// Elements of a buffer that is too large for caches, stored once each, or not: what is stored is there in the end.
#[test]
fn stores_of_large_buffers_arrive() {
    const WORDS: u32 = (2 << 20) + 37;
    let whole = |i: u32| 3 * i + 1;
    let programs: [Index; 5] = [
        ("out[id.x] = 3u * id.x + 1u;", whole),
        ("out[id.x] = 7u;", |_| 7),
        ("if id.x % 5u != 0u { out[id.x] = id.x; }", |i| if i % 5 == 0 { 0 } else { i }),
        ("out[id.x] = 3u * id.x; out[id.x] += 1u;", whole),
        ("for (var k = 0u; k < 2u; k++) { out[id.x] = 3u * id.x + k; }", whole),
    ];
    for (body, expected) in programs {
        let module = module(&format!(
            "@group(0) @binding(0) var<storage, read_write> out: array<u32>;
            @compute @workgroup_size(64) fn f(@builtin(global_invocation_id) id: vec3<u32>) {{
                if id.x < arrayLength(&out) {{ {body} }}
            }}"
        ));
        for isa in Isa::available() {
            let mut buffers = [buffer(0, std::iter::repeat_n(0, WORDS as usize))];
            let groups = [WORDS.div_ceil(64), 1, 1];
            Interpreter::new(&module).unwrap().with_isa(isa).run(0, groups, &mut buffers).unwrap();
            let mut words = buffers[0].data.as_chunks().0.iter().map(|c| u32::from_le_bytes(*c));
            let wrong = (0..WORDS).zip(&mut words).find(|(i, word)| *word != expected(*i));
            assert_eq!((wrong, words.next()), (None, None), "{isa}, {body}");
        }
    }
}
