// Functions that call functions, with structures in and out.
struct Ray {
    origin: vec3f,
    direction: vec3f,
}
struct Hit {
    distance: f32,
    normal: vec3f,
    found: bool,
}

@group(0) @binding(0) var<storage, read> rays: array<Ray>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;

fn at(ray: Ray, t: f32) -> vec3f {
    return ray.origin + t * ray.direction;
}

fn plane(ray: Ray, height: f32) -> Hit {
    let t = (height - ray.origin.y) / ray.direction.y;
    return Hit(t, vec3f(0.0, 1.0, 0.0), t > 0.0);
}

fn nearer(a: Hit, b: Hit) -> Hit {
    if a.found && (!b.found || a.distance < b.distance) {
        return a;
    }
    return b;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&rays) {
        return;
    }
    var ray = rays[i];
    ray.direction.y = 1.5 + ray.direction.y;
    let hit = nearer(plane(ray, 2.5), plane(ray, 3.0 + ray.origin.x));
    out[i] = vec4f(at(ray, hit.distance), hit.normal.y);
}
