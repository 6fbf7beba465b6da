// A lobe as it lies in memory.
struct SgRow {
    float3 axis;
    float sharpness;
    float log_amplitude;
    float3 unused;
};

StructuredBuffer<SgRow> a_values : register(t0);
StructuredBuffer<SgRow> b_values : register(t1);
RWStructuredBuffer<SgRow> results : register(u2);
cbuffer row_count : register(b3) { uint row_count; }

Sg lobe(SgRow row)
{
    Sg sg;
    sg.axis = row.axis;
    sg.sharpness = row.sharpness;
    sg.log_amplitude = row.log_amplitude;
    return sg;
}

[numthreads(64, 1, 1)]
void main(uint3 thread : SV_DispatchThreadID)
{
    if (thread.x >= row_count)
        return;
    Sg product = sg_product(lobe(a_values[thread.x]), lobe(b_values[thread.x]));
    results[thread.x].axis = product.axis;
    results[thread.x].sharpness = product.sharpness;
    results[thread.x].log_amplitude = product.log_amplitude;
}
