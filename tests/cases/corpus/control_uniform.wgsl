// Values that a whole workgroup shares, and decisions on them.
struct Settings {
    mode: u32,
    scale: u32,
    table: array<vec4u, 4>,
}

@group(0) @binding(0) var<uniform> settings: Settings;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;
var<workgroup> chosen: u32;

@compute @workgroup_size(32)
fn main(
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    if lane == 5u {
        chosen = group.x * 100u + settings.table[group.x % 4u][settings.mode % 4u] % 50u;
    }
    let agreed = workgroupUniformLoad(&chosen);
    var x = lane;
    if agreed % 2u == 0u {
        for (var k = 0u; k < agreed % 8u; k++) {
            x = x * 3u + settings.scale;
        }
    } else {
        x = x + groups.x;
    }
    let i = group.x * 32u + lane;
    if i < arrayLength(&out) {
        out[i] = x;
    }
}
