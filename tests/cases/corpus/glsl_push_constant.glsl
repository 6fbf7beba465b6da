// Push constants, which are immediate data.
#version 450

layout(local_size_x = 4) in;

layout(push_constant, std430) uniform Push {
    uint factor;
    vec2 shift;
    uint list[3];
} push;

layout(set = 0, binding = 0) buffer Numbers {
    uint numbers[];
};

layout(set = 0, binding = 1) buffer Moved {
    float moved[];
};

void main() {
    uint lane = gl_LocalInvocationIndex;
    numbers[lane] = lane * push.factor + push.list[lane % 3u];
    moved[lane] = push.shift[lane % 2u];
}
