StructuredBuffer<float> x_values : register(t0);
RWStructuredBuffer<float> results : register(u1);
cbuffer row_count : register(b2) { uint row_count; }

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x >= row_count)
        return;
    results[thread.x] = erf(x_values[thread.x]);
}
