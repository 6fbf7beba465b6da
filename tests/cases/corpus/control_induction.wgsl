// A float that halves each round ends the loop. Mesa 25.0 counts the rounds of this loop wrongly when it compiles.
@group(0) @binding(0) var<storage, read_write> out: array<vec2f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&out) { return; }
    var energy = 0.9;
    var rounds = 0.0;
    for (var k = 0u; k < 6u; k++) {
        energy *= 0.5;
        if energy < 0.1 { break; }
        rounds += 1.0;
    }
    out[i] = vec2f(rounds, energy);
}
