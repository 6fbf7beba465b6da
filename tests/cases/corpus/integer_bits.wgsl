// Functions on the bits of integers.
@group(0) @binding(0) var<storage, read> a: array<vec2u>;
@group(0) @binding(1) var<storage, read_write> out: array<array<u32, 12>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    // The extremes come first.
    var u = a[i].x;
    switch i {
        case 0u: { u = 0u; }
        case 1u: { u = 0xffffffffu; }
        case 2u: { u = 0x80000000u; }
        case 3u: { u = 1u; }
        default: {}
    }
    let s = bitcast<i32>(u);
    let offset = a[i].y % 40u;
    let count = (a[i].y / 64u) % 40u;
    out[i] = array(
        countOneBits(u), countLeadingZeros(u), countTrailingZeros(u), reverseBits(u),
        firstLeadingBit(u), firstTrailingBit(u), bitcast<u32>(firstLeadingBit(s)), bitcast<u32>(firstTrailingBit(s)),
        extractBits(u, offset, count), bitcast<u32>(extractBits(s, offset, count)), insertBits(u, a[i].y, offset, count),
        bitcast<u32>(countLeadingZeros(s) + reverseBits(s)),
    );
}
