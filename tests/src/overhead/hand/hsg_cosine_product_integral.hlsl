// A lobe as it lies in memory.
struct SgRow {
    float3 axis;
    float sharpness;
    float log_amplitude;
    float3 unused;
};

StructuredBuffer<SgRow> sg_values : register(t0);
StructuredBuffer<float4> normal_values : register(t1);
RWStructuredBuffer<float> results : register(u2);
cbuffer row_count : register(b3) { uint row_count; }

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x >= row_count)
        return;
    SgRow row = sg_values[thread.x];
    Sg sg;
    sg.axis = row.axis;
    sg.sharpness = row.sharpness;
    sg.log_amplitude = row.log_amplitude;
    results[thread.x] = hsg_cosine_product_integral(sg, normal_values[thread.x].xyz);
}
