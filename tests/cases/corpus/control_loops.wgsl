// Loops: nested, left early from within, with a continuing block that leaves, and none at all.
@group(0) @binding(0) var<storage, read> a: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4u>;

fn collatz(start: u32) -> u32 {
    var x = start;
    var steps = 0u;
    loop {
        if x <= 1u {
            break;
        }
        if x % 2u == 0u {
            x = x / 2u;
            steps += 1u;
            continue;
        }
        x = 3u * x + 1u;
        continuing {
            steps += 1u;
            break if steps > 200u;
        }
    }
    return steps;
}

fn first_divisor(x: u32) -> u32 {
    for (var d = 2u; d * d <= x; d++) {
        if x % d == 0u {
            return d;
        }
    }
    return x;
}

fn pairs(n: u32) -> u32 {
    var count = 0u;
    for (var i = 0u; i < n; i++) {
        var j = 0u;
        while j < n {
            j++;
            if (i + j) % 3u == 0u {
                continue;
            }
            if j > i + 2u {
                break;
            }
            count += j;
        }
    }
    return count;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        let x = a[i] % 1000u;
        out[i] = vec4u(collatz(x), first_divisor(x), pairs(x % 12u), x);
    }
}
