// Shared memory with a barrier, and the size of a workgroup as a built-in value.
#version 450
layout(local_size_x = 16, local_size_y = 2) in;

layout(std430, set = 0, binding = 0) buffer Out { uvec4 result[]; };

shared uint values[32];

void main() {
    uint lane = gl_LocalInvocationIndex;
    values[lane] = lane * gl_WorkGroupSize.x + gl_WorkGroupID.x;
    barrier();
    uint i = gl_WorkGroupID.x * 32u + lane;
    if (i < result.length()) {
        result[i] = uvec4(values[31u - lane], gl_WorkGroupSize.y, gl_NumWorkGroups.x, gl_LocalInvocationID.y);
    }
}
