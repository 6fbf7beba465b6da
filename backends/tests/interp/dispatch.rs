//! Entry points: workgroups, barriers, atomics, buffers.

use crate::support::module;
use lobe_backends::interp::{Buffer, InterpError, Interpreter, Isa};

pub(crate) fn buffer(binding: u32, words: &[u32]) -> Buffer {
    Buffer { group: 0, binding, data: words.iter().flat_map(|w| w.to_le_bytes()).collect() }
}

pub(crate) fn words(buffer: &Buffer) -> Vec<u32> {
    buffer.data.chunks(4).map(|c| u32::from_le_bytes(c.try_into().unwrap())).collect()
}

fn run(text: &str, groups: [u32; 3], buffers: &mut [Buffer]) -> Result<(), InterpError> {
    let module = module(text);
    Interpreter::new(&module)?.run(0, groups, buffers)
}

const REDUCE: &str = "
    @group(0) @binding(0) var<storage, read> input: array<u32>;
    @group(0) @binding(1) var<storage, read_write> sums: array<u32>;
    var<workgroup> part: array<u32, 64>;
    @compute @workgroup_size(64)
    fn reduce(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32,
              @builtin(workgroup_id) group: vec3<u32>) {
        part[i] = input[id.x];
        workgroupBarrier();
        for (var step = 32u; step > 0u; step /= 2u) {
            if i < step { part[i] += part[i + step]; }
            workgroupBarrier();
        }
        if i == 0u { sums[group.x] = part[0]; }
    }";

#[test]
fn a_tree_reduction_sums_each_workgroup() {
    let input: Vec<u32> = (0..192).collect();
    let mut buffers = [buffer(0, &input), buffer(1, &[0; 3])];
    run(REDUCE, [3, 1, 1], &mut buffers).unwrap();
    let sums: Vec<u32> = input.chunks(64).map(|c| c.iter().sum()).collect();
    assert_eq!(words(&buffers[1]), sums);
    assert_eq!(words(&buffers[0]), input);
}

#[test]
fn atomics_serve_lane_after_lane() {
    let text = "
        struct Counters { n: atomic<u32>, low: atomic<i32>, high: atomic<i32>, bits: atomic<u32>, last: atomic<u32> }
        @group(0) @binding(0) var<storage, read_write> c: Counters;
        @group(0) @binding(1) var<storage, read_write> order: array<u32>;
        var<workgroup> shared_count: atomic<u32>;
        @compute @workgroup_size(8, 2)
        fn count(@builtin(local_invocation_index) i: u32, @builtin(local_invocation_id) at: vec3<u32>) {
            let ticket = atomicAdd(&c.n, 2u);
            order[ticket / 2u] = at.y * 8u + at.x;
            atomicMin(&c.low, 3 - i32(i));
            atomicMax(&c.high, i32(i));
            atomicOr(&c.bits, 1u << i);
            if i % 2u == 0u { atomicAdd(&shared_count, 1u); atomicSub(&c.n, 1u); }
            workgroupBarrier();
            if i == 3u { atomicStore(&c.last, atomicLoad(&shared_count)); }
            let swapped = atomicCompareExchangeWeak(&c.bits, 0xffffu, 7u);
            if swapped.exchanged { atomicXor(&c.bits, 8u); }
        }";
    let mut buffers = [buffer(0, &[0; 5]), buffer(1, &[99; 16])];
    run(text, [1, 1, 1], &mut buffers).unwrap();
    assert_eq!(words(&buffers[0]), [24, -12_i32 as u32, 15, 15, 8]);
    assert_eq!(words(&buffers[1]), (0..16).collect::<Vec<_>>());
}

#[test]
fn buffers_have_the_layout_of_wgsl() {
    let text = "
        struct Item { v: vec3<f32>, w: u32, m: mat2x2<f32>, n: mat3x3<f32> }
        struct Head { count: u32, items: array<Item> }
        struct Scale { by: f32, at: vec3<f32> }
        @group(0) @binding(0) var<storage, read_write> head: Head;
        @group(0) @binding(1) var<uniform> scale: Scale;
        @compute @workgroup_size(4)
        fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
            if id.x >= arrayLength(&head.items) { return; }
            let item = &head.items[id.x];
            (*item).v *= scale.by;
            (*item).w = id.x + 10u * groups.x + 100u * arrayLength(&head.items);
            (*item).m[1].x = scale.at.z;
            (*item).n[2][1] = (*item).v.z;
            if id.x == 1u { head.count = head.items[0].w; }
        }";
    // Item: v at 0, w at 12, m at 16, n at 32, 80 bytes; items begin at 16.
    let mut data = vec![0; 4 + 3 * 20];
    for (i, value) in [1.0_f32, 2.0, 3.0].into_iter().enumerate() {
        data[4 + 20 + i] = value.to_bits();
    }
    let scale = [2.0_f32, 0.0, 0.0, 0.0, 5.0, 6.0, 7.0, 0.0].map(f32::to_bits);
    let mut buffers = [buffer(0, &data), buffer(1, &scale)];
    run(text, [1, 1, 1], &mut buffers).unwrap();
    let got = words(&buffers[0]);
    assert_eq!(got[0], 310);
    assert_eq!(got[24..27], [2.0_f32, 4.0, 6.0].map(f32::to_bits));
    assert_eq!(got[27], 311);
    assert_eq!(got[24 + 4 + 2], 7.0_f32.to_bits());
    assert_eq!(got[24 + 8 + 8 + 1], 6.0_f32.to_bits());
}

#[test]
fn accesses_past_a_buffer_mean_its_last_element() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> data: array<u32>;
        @compute @workgroup_size(1)
        fn main() { var i = 100u; data[i] = data[i + 7u] + 1u; }";
    let mut buffers = [buffer(0, &[1, 2, 3])];
    run(text, [1, 1, 1], &mut buffers).unwrap();
    assert_eq!(words(&buffers[0]), [1, 2, 4]);
}

#[test]
fn a_barrier_that_some_invocations_miss_is_an_error() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> data: array<u32>;
        fn wait() { workgroupBarrier(); }
        @compute @workgroup_size(2)
        fn main(@builtin(local_invocation_index) i: u32) { if i + data[0] == 0u { wait(); } data[i] = 1u; }";
    let result = run(text, [1, 1, 1], &mut [buffer(0, &[0, 0])]);
    assert_eq!(result, Err(InterpError::NonUniformBarrier { function: "wait".to_owned() }));
}

#[test]
fn a_missing_or_short_buffer_is_named() {
    let mut short = [buffer(0, &[1; 64]), Buffer { group: 0, binding: 1, data: vec![0; 2] }];
    let error = run(REDUCE, [1, 1, 1], &mut short).unwrap_err();
    assert_eq!(error, InterpError::BufferTooSmall { name: "sums".to_owned(), expected: 4, found: 2 });
    let error = run(REDUCE, [1, 1, 1], &mut short[..1]).unwrap_err();
    assert_eq!(error, InterpError::MissingBuffer { name: "sums".to_owned(), group: 0, binding: 1 });
    assert_eq!(
        Interpreter::new(&module(REDUCE)).unwrap().run(3, [1, 1, 1], &mut []),
        Err(InterpError::NoEntryPoint(3))
    );
}

/// What a dispatch leaves is the same each time and on each instruction set.
fn settled(text: &str, groups: [u32; 3], buffers: &[Buffer]) -> Vec<Vec<u32>> {
    let module = module(text);
    let mut left: Option<Vec<Vec<u32>>> = None;
    for isa in Isa::available() {
        for _ in 0..20 {
            let mut ran = buffers.to_vec();
            Interpreter::new(&module).unwrap().with_isa(isa).run(0, groups, &mut ran).unwrap();
            let ran: Vec<_> = ran.iter().map(words).collect();
            assert!(left.as_ref().is_none_or(|left| *left == ran), "{isa} left something else\n{text}");
            left = Some(ran);
        }
    }
    left.unwrap()
}

#[test]
fn the_last_writer_of_a_place_is_the_last_invocation() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        @compute @workgroup_size(64) fn f(@builtin(global_invocation_id) id: vec3<u32>) {
            out[id.x % 64u] = id.x;
        }";
    let left = settled(text, [1000, 1, 1], &[buffer(0, &[0; 64])]);
    assert_eq!(left[0], (63_936..64_000).collect::<Vec<_>>());
    let mut judged = [buffer(0, &[0; 64])];
    Interpreter::new(&module(text)).unwrap().run_judged(0, [1000, 1, 1], &mut judged).unwrap();
    assert_eq!(words(&judged[0]), left[0]);
}

/// Indices are clamped: invocations beyond the array write its last element, the last one last.
#[test]
fn invocations_beyond_an_array_share_its_last_element_in_order() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        @compute @workgroup_size(64) fn f(@builtin(global_invocation_id) id: vec3<u32>) { out[id.x] = id.x; }";
    for (groups, length) in [(1000, 6000), (1000, 64_000), (3, 5)] {
        let left = settled(text, [groups, 1, 1], &[buffer(0, &vec![0; length])]);
        let mut expected: Vec<u32> = (0..length as u32).collect();
        expected[length - 1] = (groups * 64 - 1).max(length as u32 - 1);
        assert_eq!(left[0], expected);
    }
}

#[test]
fn workgroups_beyond_an_array_come_last() {
    let text = "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        var<workgroup> sum: atomic<u32>;
        @compute @workgroup_size(64) fn f(@builtin(global_invocation_id) id: vec3<u32>) {
            atomicAdd(&sum, id.x);
            workgroupBarrier();
            out[id.x] = out[id.x] * 3u + atomicLoad(&sum);
        }";
    settled(text, [300, 1, 1], &[buffer(0, &[1; 5000])]);
}

/// Like the judge's, whose invocations run in turn.
fn check_in_turn(text: &str, groups: [u32; 3], buffers: &[Buffer]) {
    let left = settled(text, groups, buffers);
    let mut judged = buffers.to_vec();
    Interpreter::new(&module(text)).unwrap().run_judged(0, groups, &mut judged).unwrap();
    assert_eq!(judged.iter().map(words).collect::<Vec<_>>(), left, "{text}");
}

/// An element for each workgroup, written by any of its invocations; in the second, an invocation has the element of
/// another workgroup; at last more workgroups than elements.
#[test]
fn an_element_is_a_workgroups() {
    let text = |index: &str| {
        format!(
            "@group(0) @binding(0) var<storage, read_write> sums: array<u32>;
            var<workgroup> part: atomic<u32>;
            @compute @workgroup_size(8)
            fn f(@builtin(global_invocation_id) id: vec3<u32>, @builtin(workgroup_id) group: vec3<u32>) {{
                atomicAdd(&part, id.x);
                workgroupBarrier();
                sums[group.x] = sums[{index}] * 3u + atomicLoad(&part);
            }}"
        )
    };
    for (index, length) in [("group.x", 300), ("id.x", 300), ("group.x", 50)] {
        check_in_turn(&text(index), [200, 1, 1], &[buffer(0, &vec![1; length])]);
    }
}

/// Rows of a width that is known, stated by a buffer or the number of workgroups. Those that are narrower than a dispatch
/// overlap, and those beyond the array share its end: the last to write there is the last invocation.
#[test]
fn places_in_rows_are_an_invocations() {
    let text = |width: &str, value: &str| {
        format!(
            "@group(0) @binding(0) var<storage, read_write> out: array<u32>;
            @group(0) @binding(1) var<storage, read> size: array<u32, 1>;
            @compute @workgroup_size(8, 4)
            fn f(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {{
                let i = id.y * {width} + id.x;
                out[i] = {value} + id.x * 1000u + id.y;
            }}"
        )
    };
    // So many that all threads take part.
    const ALL: usize = 80 * 1600;
    for width in ["80u", "64u", "size[0]", "(groups.x * 8u)"] {
        for (size, length) in [(80, ALL), (72, ALL), (80, 500)] {
            let buffers = [buffer(0, &vec![1; length]), buffer(1, &[size])];
            check_in_turn(&text(width, "7u"), [10, 400, 1], &buffers);
        }
        // Nobody else's place is read where each has one.
        let buffers = [buffer(0, &vec![1; ALL]), buffer(1, &[80])];
        if width != "64u" {
            check_in_turn(&text(width, "out[i] * 3u"), [10, 400, 1], &buffers);
        }
    }
}

/// Variables that take each other's values, or their own changed in place, over the rounds of a loop that lanes leave together, or
/// not.
#[test]
fn variables_change_in_place() {
    let text = |rounds: &str| {
        "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        @compute @workgroup_size(64) fn f(@builtin(global_invocation_id) id: vec3<u32>) {
            var a = f32(id.x) * 0.01;
            var b = 1.0;
            var c = 0.5;
            var most = -10.0;
            var least = 10.0;
            var far = 0.0;
            var slow = f32(id.x);
            var n = 1u;
            for (var i = 0u; i < ROUNDS; i++) {
                let before = a;
                a = exp(a * -0.5);
                b = b - a * before;
                c = before * 0.25 + c;
                most = max(most, b);
                least = min(least, c);
                far = sqrt(far * far + a);
                let swapped = b;
                b = c;
                c = swapped;
                b = b * 0.9;
                let next = slow * 0.75 + 1.0;
                most = most + slow;
                slow = next;
                c = a - c;
                if id.x % 3u == i { a = exp2(-a); c = c + b; }
                n = n * 3u + i;
            }
            out[id.x] = bitcast<u32>(a) ^ bitcast<u32>(b) * 3u ^ bitcast<u32>(c) * 5u ^ bitcast<u32>(most) * 7u
                ^ bitcast<u32>(least) * 11u ^ bitcast<u32>(far) * 13u ^ n;
        }"
    .replace("ROUNDS", rounds)
    };
    for rounds in ["7u", "3u + id.x % 5u"] {
        check_in_turn(&text(rounds), [4, 1, 1], &[buffer(0, &[0; 256])]);
    }
}
