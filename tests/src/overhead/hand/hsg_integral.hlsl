StructuredBuffer<float> cosine_values : register(t0);
StructuredBuffer<float> sharpness_values : register(t1);
RWStructuredBuffer<float> results : register(u2);
cbuffer row_count : register(b3) { uint row_count; }

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x >= row_count)
        return;
    results[thread.x] = hsg_integral(cosine_values[thread.x], sharpness_values[thread.x]);
}
