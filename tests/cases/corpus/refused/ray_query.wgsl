// Ray queries.
enable wgpu_ray_query;
enable wgpu_ray_query_vertex_return;

@group(0) @binding(0) var scene: acceleration_structure<vertex_return>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;

@compute @workgroup_size(1)
fn main() {
    var query: ray_query<vertex_return>;
    rayQueryInitialize(&query, scene, RayDesc(0u, 0xffu, 0.1, 100.0, vec3f(0.0), vec3f(0.0, 1.0, 0.0)));
    while rayQueryProceed(&query) {}
    let hit = rayQueryGetCommittedIntersection(&query);
    let corners = getCommittedHitVertexPositions(&query);
    out[0] = vec4f(corners[0], hit.t);
}
