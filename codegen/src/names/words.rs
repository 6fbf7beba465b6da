//! The words themselves, sorted within each list.
//!
//! The lists of HLSL, GLSL and MSL were taken from those that naga 30 (MIT OR Apache-2.0) keeps for its
//! writers, which are not public, and sorted by meaning.
//! Added to them: functions of the Metal standard library, and some types of MSL and functions of HLSL.
//! None was compared with the languages' own documents word by word.
//!
//! WGSL's words are naga's public lists; names with a leading or double underscore are left out here
//! since a rule refuses them all.

/// Keywords and reserved words of HLSL.
pub(super) const HLSL_KEYWORDS: &str = "\
    BlendState CompileShader ComputeShader DepthStencilState DepthStencilView DomainShader GeometryShader \
    Hullshader NULL PixelShader RasterizerState RenderTargetView Technique VertexShader asm asm_fragment \
    auto break case catch cbuffer center centroid char class column_major compile compile_fragment const \
    const_cast continue default delete discard do dynamic_cast else enum explicit export extern false for \
    friend fxgroup globallycoherent goto groupshared if in indices inline inout interface line lineadj \
    linear long mutable namespace new nointerpolation noperspective operator out packoffset pass payload \
    pixelfragment point precise primitives private protected public register reinterpret_cast return \
    row_major sample sampler sampler_state shared short signed sizeof snorm stateblock stateblock_state \
    static static_cast string struct switch tbuffer technique technique10 technique11 template texture this \
    throw triangle triangleadj true try typedef typeid typename uniform union unorm unsigned using \
    vertexfragment vertices virtual void volatile wchar_t while";

/// Scalar types of HLSL; each also makes vectors (`float3`) and matrices (`float3x4`).
pub(super) const HLSL_SCALARS: &str = "\
    bool double dword float float16_t float32_t float64_t half int int16_t int32_t int64_t int8_t4_packed \
    min10float min12int min16float min16int min16uint uint uint16_t uint32_t uint64_t uint8_t4_packed";

/// Other types of HLSL.
pub(super) const HLSL_TYPES: &str = "\
    AppendStructuredBuffer Buffer ByteAddressBuffer ConstantBuffer ConsumeStructuredBuffer FeedbackTexture2D \
    FeedbackTexture2DArray InputPatch LineStream OutputPatch PointStream RWBuffer RWByteAddressBuffer \
    RWStructuredBuffer RWTexture1D RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture2DMS \
    RWTexture2DMSArray RWTexture3D RWTextureCube RWTextureCubeArray RasterizerOrderedBuffer \
    RasterizerOrderedByteAddressBuffer RasterizerOrderedStructuredBuffer RasterizerOrderedTexture1D \
    RasterizerOrderedTexture1DArray RasterizerOrderedTexture2D RasterizerOrderedTexture2DArray \
    RasterizerOrderedTexture3D RayDesc RayQuery RaytracingAccelerationStructure SamplerComparisonState \
    SamplerState StructuredBuffer SubpassInput SubpassInputMS Texture1D Texture1DArray Texture2D Texture2DArray Texture2DMS \
    Texture2DMSArray Texture3D TextureBuffer TextureCube TextureCubeArray TriangleStream matrix vector";

/// Intrinsic functions of HLSL.
pub(super) const HLSL_FUNCTIONS: &str = "\
    AcceptHitAndEndSearch AddUint64 AllMemoryBarrier AllMemoryBarrierWithGroupSync AllocateRayQuery \
    CallShader CheckAccessFullyMapped CreateResourceFromHeap D3DCOLORtoUBYTE4 DeviceMemoryBarrier \
    DeviceMemoryBarrierWithGroupSync DispatchMesh DispatchRaysDimensions DispatchRaysIndex \
    EvaluateAttributeAtSample EvaluateAttributeCentroid EvaluateAttributeSnapped GeometryIndex \
    GetAttributeAtVertex GetRenderTargetSampleCount GetRenderTargetSamplePosition GroupMemoryBarrier \
    GroupMemoryBarrierWithGroupSync HitKind IgnoreHit InstanceID InstanceIndex InterlockedAdd InterlockedAnd \
    InterlockedCompareExchange InterlockedCompareExchangeFloatBitwise InterlockedCompareStore \
    InterlockedCompareStoreFloatBitwise InterlockedExchange InterlockedMax InterlockedMin InterlockedOr \
    InterlockedXor IsHelperLane NonUniformResourceIndex ObjectRayDirection ObjectRayOrigin ObjectToWorld \
    ObjectToWorld3x4 ObjectToWorld4x3 PrimitiveIndex Process2DQuadTessFactorsAvg Process2DQuadTessFactorsMax \
    Process2DQuadTessFactorsMin ProcessIsolineTessFactors ProcessQuadTessFactorsAvg \
    ProcessQuadTessFactorsMax ProcessQuadTessFactorsMin ProcessTriTessFactorsAvg ProcessTriTessFactorsMax \
    ProcessTriTessFactorsMin QuadAll QuadAny QuadReadAcrossDiagonal QuadReadAcrossX QuadReadAcrossY \
    QuadReadLaneAt RayFlags RayTCurrent RayTMin ReportHit SetMeshOutputCounts TraceRay WaveActiveAllEqual \
    WaveActiveAllTrue WaveActiveAnyTrue WaveActiveBallot WaveActiveBitAnd WaveActiveBitOr WaveActiveBitXor \
    WaveActiveCountBits WaveActiveMax WaveActiveMin WaveActiveProduct WaveActiveSum WaveGetLaneCount \
    WaveGetLaneIndex WaveIsFirstLane WaveMatch WaveMultiPrefixBitAnd WaveMultiPrefixBitOr \
    WaveMultiPrefixBitXor WaveMultiPrefixCountBits WaveMultiPrefixProduct WaveMultiPrefixSum \
    WavePrefixCountBits WavePrefixProduct WavePrefixSum WaveReadLaneAt WaveReadLaneFirst WorldRayDirection \
    WorldRayOrigin WorldToObject WorldToObject3x4 WorldToObject4x3 abort abs acos all and any asdouble \
    asfloat asfloat16 asin asint asint16 asuint asuint16 atan atan2 ceil clamp clip cos cosh countbits cross \
    ddx ddx_coarse ddx_fine ddy ddy_coarse ddy_fine degrees determinant distance dot dot2add \
    dot4add_i8packed dot4add_u8packed dst errorf exp exp2 f16tof32 f32tof16 faceforward firstbithigh \
    firstbitlow floor fma fmod frac frexp fwidth isfinite isinf isnan ldexp length lerp lit log log10 log2 \
    mad max min modf msad4 mul noise normalize or pack_clamp_s8 pack_clamp_u8 pack_s8 pack_u8 pow printf \
    radians rcp reflect refract reversebits round rsqrt saturate select sign sin sincos sinh smoothstep \
    source_mark sqrt step tan tanh tex1D tex1Dbias tex1Dgrad tex1Dlod tex1Dproj tex2D tex2Dbias tex2Dgrad \
    tex2Dlod tex2Dproj tex3D tex3Dbias tex3Dgrad tex3Dlod tex3Dproj texCUBE texCUBEbias texCUBEgrad \
    texCUBElod texCUBEproj transpose trunc unpack_s8s16 unpack_s8s32 unpack_u8u16 unpack_u8u32";

/// Words that HLSL reserves in every spelling of upper and lower case.
pub(super) const HLSL_ANY_CASE: [&str; 8] =
    ["Texture1D", "Texture2D", "Texture3D", "TextureCube", "asm", "decl", "pass", "technique"];

/// Keywords and reserved words of GLSL.
pub(super) const GLSL_KEYWORDS: &str = "\
    active asm attribute break buffer case cast centroid class coherent common const continue default \
    discard do else enum extern external false filter fixed flat for goto half highp if in inline inout \
    input interface invariant layout long lowp main mediump namespace noinline noperspective out output \
    packed partition patch precise precision public readonly resource restrict return row_major sample \
    shared short sizeof smooth static struct subroutine superp switch template this true typedef uniform \
    union unsigned using varying volatile while writeonly";

/// Types of GLSL.
pub(super) const GLSL_TYPES: &str = "\
    atomic_uint bool bvec2 bvec3 bvec4 dmat2 dmat2x2 dmat2x3 dmat2x4 dmat3 dmat3x2 dmat3x3 dmat3x4 dmat4 \
    dmat4x2 dmat4x3 dmat4x4 double dvec2 dvec3 dvec4 float fvec2 fvec3 fvec4 hvec2 hvec3 hvec4 iimage1D \
    iimage1DArray iimage2D iimage2DArray iimage2DMS iimage2DMSArray iimage2DRect iimage3D iimageBuffer \
    iimageCube iimageCubeArray image1D image1DArray image1DArrayShadow image1DShadow image2D image2DArray \
    image2DArrayShadow image2DMS image2DMSArray image2DRect image2DShadow image3D imageBuffer imageCube \
    imageCubeArray int isampler1D isampler1DArray isampler2D isampler2DArray isampler2DMS isampler2DMSArray \
    isampler2DRect isampler3D isamplerBuffer isamplerCube isamplerCubeArray isubpassInput isubpassInputMS \
    itexture1D itexture1DArray itexture2D itexture2DArray itexture2DMS itexture2DMSArray itexture2DRect \
    itexture3D itextureBuffer itextureCube itextureCubeArray ivec2 ivec3 ivec4 mat2 mat2x2 mat2x3 mat2x4 \
    mat3 mat3x2 mat3x3 mat3x4 mat4 mat4x2 mat4x3 mat4x4 sampler sampler1D sampler1DArray \
    sampler1DArrayShadow sampler1DShadow sampler2D sampler2DArray sampler2DArrayShadow sampler2DMS \
    sampler2DMSArray sampler2DRect sampler2DRectShadow sampler2DShadow sampler3D sampler3DRect samplerBuffer \
    samplerCube samplerCubeArray samplerCubeArrayShadow samplerCubeShadow samplerShadow subpassInput \
    subpassInputMS texture1D texture1DArray texture2D texture2DArray texture2DMS texture2DMSArray \
    texture2DRect texture3D textureBuffer textureCube textureCubeArray uimage1D uimage1DArray uimage2D \
    uimage2DArray uimage2DMS uimage2DMSArray uimage2DRect uimage3D uimageBuffer uimageCube uimageCubeArray \
    uint usampler1D usampler1DArray usampler2D usampler2DArray usampler2DMS usampler2DMSArray usampler2DRect \
    usampler3D usamplerBuffer usamplerCube usamplerCubeArray usubpassInput usubpassInputMS utexture1D \
    utexture1DArray utexture2D utexture2DArray utexture2DMS utexture2DMSArray utexture2DRect utexture3D \
    utextureBuffer utextureCube utextureCubeArray uvec2 uvec3 uvec4 vec2 vec3 vec4 void";

/// Built-in functions of GLSL.
pub(super) const GLSL_FUNCTIONS: &str = "\
    EmitStreamVertex EmitVertex EndPrimitive EndStreamPrimitive abs acos acosh all allInvocations \
    allInvocationsEqual any anyInvocation asin asinh atan atanh atomicAdd atomicAnd atomicCompSwap \
    atomicCounter atomicCounterAdd atomicCounterAnd atomicCounterCompSwap atomicCounterDecrement \
    atomicCounterExchange atomicCounterIncrement atomicCounterMax atomicCounterMin atomicCounterOr \
    atomicCounterSubtract atomicCounterXor atomicExchange atomicMax atomicMin atomicOr atomicXor barrier \
    bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp cos cosh cross dFdx dFdxCoarse \
    dFdxFine dFdy dFdyCoarse dFdyFine degrees determinant distance dot equal exp exp2 faceforward findLSB \
    findMSB floatBitsToInt floatBitsToUint floor fma fract frexp ftransform fwidth fwidthCoarse fwidthFine \
    greaterThan greaterThanEqual groupMemoryBarrier imageAtomicAdd imageAtomicAnd imageAtomicCompSwap \
    imageAtomicExchange imageAtomicMax imageAtomicMin imageAtomicOr imageAtomicXor imageLoad imageSamples \
    imageSize imageStore imulExtended intBitsToFloat interpolateAtCentroid interpolateAtOffset \
    interpolateAtSample inverse inversesqrt isinf isnan ldexp length lessThan lessThanEqual log log2 \
    matrixCompMult max memoryBarrier memoryBarrierAtomicCounter memoryBarrierBuffer memoryBarrierImage \
    memoryBarrierShared min mix mod modf noise1 noise2 noise3 noise4 normalize not notEqual outerProduct \
    packDouble2x32 packHalf2x16 packSnorm2x16 packSnorm4x8 packUnorm2x16 packUnorm4x8 pow radians reflect \
    refract round roundEven shadow1D shadow1DLod shadow1DProj shadow1DProjLod shadow2D shadow2DLod \
    shadow2DProj shadow2DProjLod sign sin sinh smoothstep sqrt step subpassLoad tan tanh texelFetch \
    texelFetchOffset texture texture1DLod texture1DProj texture1DProjLod texture2DLod texture2DProj \
    texture2DProjLod texture3DLod texture3DProj texture3DProjLod textureCubeLod textureGather \
    textureGatherOffset textureGatherOffsets textureGrad textureGradOffset textureLod textureLodOffset \
    textureOffset textureProj textureProjGrad textureProjGradOffset textureProjLod textureProjLodOffset \
    textureProjOffset textureQueryLevels textureQueryLod textureSamples textureSize transpose trunc \
    uaddCarry uintBitsToFloat umulExtended unpackDouble2x32 unpackHalf2x16 unpackSnorm2x16 unpackSnorm4x8 \
    unpackUnorm2x16 unpackUnorm4x8 usubBorrow";

/// Keywords of MSL, which has those of C++.
pub(super) const MSL_KEYWORDS: &str = "\
    alignas alignof and and_eq asm assert bitand bitor break case catch class compl const const_cast \
    constant constexpr continue decltype default delete device do dynamic_cast else enum explicit export \
    extern false for fragment friend goto if inline kernel metal mutable namespace new noexcept not not_eq \
    nullptr object_data operator or or_eq private protected public ray_data register reinterpret_cast \
    restrict return sizeof static static_assert static_cast struct switch template this thread thread_local \
    threadgroup threadgroup_imageblock throw true try typedef typeid typename union using vertex virtual \
    volatile while xor xor_eq";

/// Types of MSL.
pub(super) const MSL_TYPES: &str = "\
    as_type atomic atomic_bool atomic_float atomic_int atomic_uint atomic_ulong auto bfloat bfloat2 bfloat3 \
    bfloat4 bool bool2 bool3 bool4 char char16_t char2 char3 char32_t char4 complex double float float2 \
    float2x2 float2x3 float2x4 float3 float3x2 float3x3 float3x4 float4 float4x2 float4x3 float4x4 half \
    half2 half2x2 half2x3 half2x4 half3 half3x2 half3x3 half3x4 half4 half4x2 half4x3 half4x4 imaginary int \
    int16_t int2 int3 int32_t int4 int64_t int8_t llong long long2 long3 long4 main matrix packed_bfloat2 \
    packed_bfloat3 packed_bfloat4 packed_bool2 packed_bool3 packed_bool4 packed_char2 packed_char3 \
    packed_char4 packed_float2 packed_float3 packed_float4 packed_half2 packed_half3 packed_half4 \
    packed_int2 packed_int3 packed_int4 packed_long2 packed_long3 packed_long4 packed_short2 packed_short3 \
    packed_short4 packed_uchar2 packed_uchar3 packed_uchar4 packed_uint2 packed_uint3 packed_uint4 \
    packed_ushort2 packed_ushort3 packed_ushort4 packed_vec ptrdiff_t quad short short2 short3 short4 signed \
    simdgroup_bfloat8x8 simdgroup_float8x8 simdgroup_half8x8 simdgroup_matrix size_t uchar uchar2 uchar3 \
    uchar4 uint uint16_t uint2 uint3 uint32_t uint4 uint64_t uint8_t ullong ulong ulong2 ulong3 ulong4 \
    unsigned ushort ushort2 ushort3 ushort4 vec void wchar_t";

/// Macros that the Metal standard library defines.
pub(super) const MSL_MACROS: &str = "\
    CHAR_BIT CHAR_MAX CHAR_MIN DBL_DECIMAL_DIG DBL_DIG DBL_EPSILON DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP \
    DBL_MAX_EXP DBL_MIN DBL_MIN_10_EXP DBL_MIN_EXP DBL_RADIX FLT_DECIMAL_DIG FLT_DIG FLT_EPSILON \
    FLT_MANT_DIG FLT_MAX FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN FLT_MIN_10_EXP FLT_MIN_EXP FLT_RADIX FP_ILOGB0 \
    FP_ILOGBNAN HALF_DECIMAL_DIG HALF_DIG HALF_EPSILON HALF_MANT_DIG HALF_MAX HALF_MAX_10_EXP HALF_MAX_EXP \
    HALF_MIN HALF_MIN_10_EXP HALF_MIN_EXP HALF_RADIX HUGE_VAL HUGE_VALF HUGE_VALH INFINITY INT_MAX INT_MIN \
    LLONG_MAX LLONG_MIN LONG_MAX LONG_MIN MAXDOUBLE MAXFLOAT MAXHALF M_1_PI M_1_PI_F M_1_PI_H M_2_PI \
    M_2_PI_F M_2_PI_H M_2_SQRTPI M_2_SQRTPI_F M_2_SQRTPI_H M_E M_E_F M_E_H M_LN10 M_LN10_F M_LN10_H M_LN2 \
    M_LN2_F M_LN2_H M_LOG10E M_LOG10E_F M_LOG10E_H M_LOG2E M_LOG2E_F M_LOG2E_H M_PI M_PI_2 M_PI_2_F M_PI_2_H \
    M_PI_4 M_PI_4_F M_PI_4_H M_PI_F M_PI_H M_SQRT1_2 M_SQRT1_2_F M_SQRT1_2_H M_SQRT2 M_SQRT2_F M_SQRT2_H NAN \
    SCHAR_MAX SCHAR_MIN SHRT_MAX SHRT_MIN UCHAR_MAX UINT_MAX ULLONG_MAX ULONG_MAX USHRT_MAX";

/// Functions of the Metal standard library.
pub(super) const MSL_FUNCTIONS: &str = "\
    abs absdiff acos acosh addsat all any as_type asin asinh atan atan2 atanh atomic_exchange_explicit \
    atomic_fetch_add_explicit atomic_fetch_and_explicit atomic_fetch_max_explicit atomic_fetch_min_explicit \
    atomic_fetch_or_explicit atomic_fetch_sub_explicit atomic_fetch_xor_explicit atomic_load_explicit \
    atomic_store_explicit atomic_thread_fence ceil clamp clz copysign cos cosh cospi cross ctz determinant \
    dfdx dfdy discard_fragment distance distance_squared divide dot exp exp10 exp2 extract_bits fabs \
    faceforward fast fdim floor fma fmax fmax3 fmedian3 fmin fmin3 fmod fract frexp fwidth get_num_samples \
    get_sample_position hadd ilogb insert_bits is_function_constant_defined isfinite isinf isnan isnormal \
    isordered isunordered ldexp length length_squared log log10 log2 mad24 madhi madsat max max3 median3 min \
    min3 mix modf mul24 mulhi nan nextafter normalize pack_float_to_snorm4x8 pack_float_to_unorm4x8 popcount \
    pow powr precise quad_broadcast quad_shuffle reflect refract remainder reverse_bits rhadd rint rotate \
    round rsqrt saturate select sign signbit simd_all simd_any simd_ballot simd_broadcast simd_max simd_min \
    simd_product simd_shuffle simd_sum simdgroup_barrier sin sincos sinh sinpi smoothstep sqrt step subsat \
    tan tanh tanpi threadgroup_barrier transpose trunc unpack_snorm4x8_to_float unpack_unorm4x8_to_float";
