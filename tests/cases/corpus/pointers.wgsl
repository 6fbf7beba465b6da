// Pointers as arguments, into function and private memory.
struct State {
    position: vec3f,
    energy: f32,
    history: array<f32, 4>,
}

var<private> total: f32 = 0.25;
var<private> log: array<vec2f, 3>;

@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4f, 3>>;

fn add(p: ptr<private, f32>, x: f32) {
    *p += x;
}

fn advance(s: ptr<function, State>, step: vec3f, slot: u32) -> bool {
    (*s).position += step;
    (*s).history[slot % 4u] = (*s).energy;
    (*s).energy *= 0.5;
    if (*s).energy < 0.1 {
        return false;
    }
    (*s).position.y = 1.0;
    return true;
}

fn swap(x: ptr<function, f32>, y: ptr<function, f32>) {
    let kept = *x;
    *x = *y;
    *y = kept;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    var state = State(a[i].xyz, 0.9, array(0.0, 1.0, 2.0, 3.0));
    var rounds = 0u;
    for (var k = 0u; k < 6u; k++) {
        if !advance(&state, a[i].yzw, i + k) {
            break;
        }
        rounds += 1u;
    }
    var p = a[i].x;
    var q = a[i].y;
    swap(&p, &q);
    add(&total, p);
    log[i % 3u] = vec2f(q, total);
    out[i] = array(vec4f(state.position, state.energy), vec4f(state.history[0], state.history[1], state.history[2], f32(rounds)), vec4f(log[0] + log[1], log[2]));
}
