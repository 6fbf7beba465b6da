// What GLSL has and WGSL lacks: inverse matrices, outer products, tests for NaN and infinity, logic without branches.
#version 450
layout(local_size_x = 64) in;

layout(std430, set = 0, binding = 0) readonly buffer A { vec4 a[]; };
layout(std430, set = 0, binding = 1) buffer Out { mat4 inverses[]; };
layout(std430, set = 0, binding = 2) buffer Flags { uvec4 flags[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= a.length() || i >= inverses.length() || i >= flags.length()) {
        return;
    }
    vec4 v = a[i];
    // Far from singular: every diagonal outweighs its column.
    mat4 m = outerProduct(v, v.wzyx) + mat4(6.0);
    inverses[i] = inverse(m);
    mat2 m2 = inverse(mat2(4.0 + v.x, v.y, v.z, 4.0 + v.w));
    mat3 m3 = inverse(outerProduct(v.xyz, v.yzw) + mat3(5.0));
    bool both = v.x > 0.0 && v.y > 0.0;
    bool either = v.x > 0.0 || v.y > 0.0;
    flags[i] = uvec4(uint(isnan(v.x)) + uint(isinf(v.y)), uint(both), uint(either), uint(m2[0][0] * m3[1][1] > 0.0));
}
