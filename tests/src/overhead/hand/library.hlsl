// The functions of [Tokuyoshi22]'s supplement as a careful author writes them, for what Lobe emits to be measured
// against: they compute the same values as the kernels of these names.

static const float PI = 3.14159265358979;

struct Sg {
    float3 axis;
    float sharpness;
    float log_amplitude;
};

// Listing 5.
float erf(float x)
{
    float a = abs(x);
    if (a >= 4.0)
        return x > 0.0 ? 1.0 : -1.0;
    if (a > 1.0) {
        float p = 2.58907676e-5;
        p = p * a - 5.64874616e-4;
        p = p * a + 5.66795561e-3;
        p = p * a - 3.51759829e-2;
        p = p * a + 1.54329389e-1;
        p = p * a + 9.15674746e-1;
        p = p * a + 1.628459513;
        float y = 1.0 - exp2(-(p * a));
        return x > 0.0 ? y : -y;
    }
    float x2 = x * x;
    float p = -5.58853149e-4;
    p = p * x2 + 4.90735564e-3;
    p = p * x2 - 2.67030653e-2;
    p = p * x2 + 1.12799220e-1;
    p = p * x2 - 3.76123011e-1;
    p = p * x2 + 1.128379121;
    return p * x;
}

// (exp(x) - 1) / x, by its series near 0.
float expm1_over_x(float x)
{
    if (abs(x) < 1.0) {
        float p = 1.0 / 3628800.0;
        p = 1.0 / 362880.0 + x * p;
        p = 1.0 / 40320.0 + x * p;
        p = 1.0 / 5040.0 + x * p;
        p = 1.0 / 720.0 + x * p;
        p = 1.0 / 120.0 + x * p;
        p = 1.0 / 24.0 + x * p;
        p = 1.0 / 6.0 + x * p;
        p = 1.0 / 2.0 + x * p;
        return 1.0 + x * p;
    }
    return abs(exp(x) - 1.0) / max(abs(x), 1.0);
}

// Its derivative.
float expm1_over_x_slope(float x)
{
    if (abs(x) < 1.0) {
        float p = 10.0 / 39916800.0;
        p = 9.0 / 3628800.0 + x * p;
        p = 8.0 / 362880.0 + x * p;
        p = 7.0 / 40320.0 + x * p;
        p = 6.0 / 5040.0 + x * p;
        p = 5.0 / 720.0 + x * p;
        p = 4.0 / 120.0 + x * p;
        p = 3.0 / 24.0 + x * p;
        p = 2.0 / 6.0 + x * p;
        return 1.0 / 2.0 + x * p;
    }
    return abs(exp(x) - expm1_over_x(x)) / max(abs(x), 1.0);
}

// Listing 2, with a norm that neither overflows nor cancels.
Sg sg_product(Sg a, Sg b)
{
    float largest = max(max(a.sharpness, b.sharpness), 1e-30);
    float ra = a.sharpness / largest;
    float rb = b.sharpness / largest;
    float3 difference = a.axis - b.axis;
    float3 sum = a.axis + b.axis;
    float gap = ra - rb;
    float norm = sqrt(gap * gap + ra * rb * dot(sum, sum));
    float shift = -largest * (ra * rb * dot(difference, difference) / max(norm + ra + rb, 1.0));

    Sg product;
    product.axis = (ra * a.axis + rb * b.axis) / max(norm, 1e-6);
    product.sharpness = largest * norm;
    product.log_amplitude = a.log_amplitude + b.log_amplitude + shift;
    return product;
}

// Eq. 6, over the sharpness.
float hsg_steepness(float sharpness)
{
    float k = min(sharpness, 1e9);
    return sqrt((0.5 * k + 0.65173288269070562) / ((k + 1.3418280033141288) * k + 7.2216687798956709));
}

// Listing 3.
float hsg_integral(float cosine, float sharpness)
{
    float c = clamp(cosine, -1.0, 1.0);
    float t = max(sharpness * hsg_steepness(sharpness), 1e-4);
    float ratio = clamp(erf(t * c) / erf(t), -1.0, 1.0);
    float e = expm1_over_x(-sharpness);
    return 2.0 * PI * e * (exp(-sharpness) + (0.5 + 0.5 * ratio) * (sharpness * e));
}

// Eq. 3.
float clamped_cosine(float cosine)
{
    const float LAMBDA = 0.00084560872241480124;
    const float ALPHA = 1182.2467339678153;
    float c = max(cosine, 0.0);
    return ALPHA * LAMBDA * c * expm1_over_x(LAMBDA * c);
}

// Listing 1, as the gradient of listing 3.
float hsg_cosine_product_integral(Sg sg, float3 normal)
{
    const float A = 0.65173288269070562;
    const float B = 1.3418280033141288;
    const float C = 7.2216687798956709;
    const float ERF_SLOPE = 1.1283791670955126;

    float amplitude = exp(sg.log_amplitude);
    float k = sg.sharpness;
    float c = clamp(dot(sg.axis, normal), -1.0, 1.0);
    if (k < 1e-4)
        return amplitude * max(PI + k * (2.0 * PI / 3.0 * c - PI), 0.0);

    float width = hsg_steepness(k);
    float t = k * width;
    float scale = 1.0 / erf(t);
    float ratio = clamp(erf(t * c) * scale, -1.0, 1.0);
    float slope = ERF_SLOPE * scale * exp(-(t * c) * (t * c));
    float s = 0.5 + 0.5 * ratio;
    float ds_dc = 0.5 * t * slope;
    float ds_dt = 0.5 * (c * slope - ERF_SLOPE * scale * exp(-t * t) * ratio);
    float dt_dk = width * (1.0 + 0.5 * k * (0.5 / (0.5 * k + A) - (2.0 * k + B) / ((k + B) * k + C)));

    float e = exp(-k);
    float upper = expm1_over_x(-k);
    float upper_slope = -expm1_over_x_slope(-k);
    float weight = e + k * upper * s;
    float along = weight * (upper + upper_slope) + upper * (k * upper * ds_dt * dt_dk - e * (1.0 - s));
    float across = max(1.0 - c * c, 0.0) * (upper * upper) * ds_dc;
    return amplitude * max(2.0 * PI * (c * along + across), 0.0);
}
