// Branches in branches, early returns, switches with several selectors and a default between cases.
@group(0) @binding(0) var<storage, read> a: array<i32>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4i>;

fn kind(x: i32) -> i32 {
    if x < 0 {
        if x % 2 == 0 {
            return 1;
        }
        return 2;
    } else if x == 0 {
        return 3;
    }
    return 4;
}

fn chosen(x: i32) -> i32 {
    var result = 0;
    switch x {
        case 0, 1: {
            result = 10;
        }
        default: {
            result = 20;
        }
        case 2: {
            if result == 0 {
                result = 30;
                break;
            }
            result = 31;
        }
        case -3, 7: {
            return 40;
        }
    }
    return result + 1;
}

fn chosen_unsigned(x: u32) -> i32 {
    switch x & 3u {
        case 0u: {
            return 5;
        }
        case 2u, 3u: {
            return 6;
        }
        default {
            return 7;
        }
    }
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i] % 9;
    out[i] = vec4i(kind(x), chosen(x), chosen_unsigned(u32(x + 9)), select(kind(-x), chosen(x + 1), x > 2));
}
