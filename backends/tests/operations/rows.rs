//! One row for each operation of naga's IR, with its state on the interpreter.
//!
//! Each section is an exhaustive `match`: a variant that a new naga brings does not compile until it has its row.

use State::{Outside, Refused, Runs};
use naga::{
    AddressSpace, ArraySize, AtomicFunction, BinaryOperator, Binding, BuiltIn, CollectiveOperation,
    Direction, Expression, GatherMode, ImageClass, ImageDimension, ImageQuery, Literal, MathFunction,
    RelationalFunction, SampleLevel, ScalarKind, Statement, StorageFormat, SubgroupOperation, SwitchValue,
    TypeInner, UnaryOperator,
};

/// What becomes of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    /// It runs: a module of the corpus has it.
    Runs,
    /// It is valid in a compute entry point, and refused with a message, for this reason: a module under `refused/` has it.
    Refused(&'static str),
    /// No compute entry point that naga accepts has it, for this reason.
    Outside(&'static str),
}

/// An operation: its section and its name.
pub(crate) type Key = (&'static str, &'static str);

/// The rows of one kind of operation.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    pub(crate) rows: &'static [(&'static str, State)],
}

macro_rules! sections {
    ($($function:ident: $title:literal, $ty:ident { $($variant:ident $state:expr),* $(,)? })*) => {
        $(
            pub(crate) fn $function(value: &$ty) -> Key {
                match value {
                    $($ty::$variant { .. } => ($title, stringify!($variant)),)*
                }
            }
        )*

        pub(crate) const TABLE: &[Section] = &[
            $(Section { title: $title, rows: &[$((stringify!($variant), $state)),*] }),*
        ];
    };
}

const FRAGMENT: State = Outside("it needs the neighbouring pixels of a fragment shader");
const OTHER_STAGE: State = Outside("it belongs to another stage");
const RAYS: State = Refused("ray queries need a scene");
const COOPERATIVE: State = Refused("cooperative matrices are hardware's own");

/// Scalar types by kind and width.
#[derive(Clone, Copy)]
pub(crate) enum ScalarType {
    Bool,
    I16,
    I32,
    I64,
    U16,
    U32,
    U64,
    F16,
    F32,
    F64,
    Abstract,
}

impl ScalarType {
    pub(crate) fn of(scalar: naga::Scalar) -> Self {
        match (scalar.kind, scalar.width) {
            (ScalarKind::Bool, _) => Self::Bool,
            (ScalarKind::Sint, 2) => Self::I16,
            (ScalarKind::Sint, 4) => Self::I32,
            (ScalarKind::Sint, 8) => Self::I64,
            (ScalarKind::Uint, 2) => Self::U16,
            (ScalarKind::Uint, 4) => Self::U32,
            (ScalarKind::Uint, 8) => Self::U64,
            (ScalarKind::Float, 2) => Self::F16,
            (ScalarKind::Float, 4) => Self::F32,
            (ScalarKind::Float, 8) => Self::F64,
            (ScalarKind::AbstractInt | ScalarKind::AbstractFloat, _) => Self::Abstract,
            (kind, width) => panic!("no row for a {kind:?} of {width} bytes"),
        }
    }
}

/// Barriers by what they order.
#[derive(Clone, Copy)]
pub(crate) enum BarrierKind {
    Storage,
    WorkGroup,
    SubGroup,
    Texture,
}

impl BarrierKind {
    pub(crate) fn all_of(flags: naga::Barrier) -> impl Iterator<Item = Self> {
        let kinds = [
            (naga::Barrier::STORAGE, Self::Storage),
            (naga::Barrier::WORK_GROUP, Self::WorkGroup),
            (naga::Barrier::SUB_GROUP, Self::SubGroup),
            (naga::Barrier::TEXTURE, Self::Texture),
        ];
        kinds.into_iter().filter(move |(flag, _)| flags.contains(*flag)).map(|(_, kind)| kind)
    }
}

sections! {
    scalar: "Scalar types", ScalarType {
        Bool Runs, I16 Runs, I32 Runs, I64 Runs, U16 Runs, U32 Runs, U64 Runs, F16 Runs, F32 Runs, F64 Runs,
        Abstract Outside("constants are made concrete before a module is valid"),
    }
    type_inner: "Types", TypeInner {
        Scalar Runs, Vector Runs, Matrix Runs, CooperativeMatrix COOPERATIVE, Atomic Runs, Pointer Runs,
        ValuePointer Outside("only the types of expressions are such"),
        Array Runs, Struct Runs, Image Runs, Sampler Runs, AccelerationStructure RAYS, RayQuery RAYS,
        BindingArray Runs,
    }
    array_size: "Lengths of arrays", ArraySize { Constant Runs, Pending Runs, Dynamic Runs }
    space: "Address spaces", AddressSpace {
        Function Runs, Private Runs, WorkGroup Runs, Uniform Runs, Storage Runs, Handle Runs, Immediate Runs,
        TaskPayload OTHER_STAGE, RayPayload OTHER_STAGE, IncomingRayPayload OTHER_STAGE,
    }
    image_dimension: "Dimensions of textures", ImageDimension { D1 Runs, D2 Runs, D3 Runs, Cube Runs }
    image_class: "Classes of textures", ImageClass {
        Sampled Runs, Depth Runs, Storage Runs,
        External Refused("external textures come out of a browser's video"),
    }
    storage_format: "Formats of storage textures", StorageFormat {
        R8Unorm Runs, R8Snorm Runs, R8Uint Runs, R8Sint Runs, R16Uint Runs, R16Sint Runs, R16Float Runs,
        Rg8Unorm Runs, Rg8Snorm Runs, Rg8Uint Runs, Rg8Sint Runs, R32Uint Runs, R32Sint Runs, R32Float Runs,
        Rg16Uint Runs, Rg16Sint Runs, Rg16Float Runs, Rgba8Unorm Runs, Rgba8Snorm Runs, Rgba8Uint Runs,
        Rgba8Sint Runs, Bgra8Unorm Runs, Rgb10a2Uint Runs, Rgb10a2Unorm Runs, Rg11b10Ufloat Runs, R64Uint Runs,
        Rg32Uint Runs, Rg32Sint Runs, Rg32Float Runs, Rgba16Uint Runs, Rgba16Sint Runs, Rgba16Float Runs,
        Rgba32Uint Runs, Rgba32Sint Runs, Rgba32Float Runs, R16Unorm Runs, R16Snorm Runs, Rg16Unorm Runs,
        Rg16Snorm Runs, Rgba16Unorm Runs, Rgba16Snorm Runs,
    }
    binding: "Parameters of entry points", Binding { BuiltIn Runs, Location OTHER_STAGE }
    builtin: "Built-in values", BuiltIn {
        GlobalInvocationId Runs, LocalInvocationId Runs, LocalInvocationIndex Runs, WorkGroupId Runs,
        WorkGroupSize Runs, NumWorkGroups Runs, NumSubgroups Runs, SubgroupId Runs, SubgroupSize Runs,
        SubgroupInvocationId Runs,
        PrimitiveIndex OTHER_STAGE, Position OTHER_STAGE, ViewIndex OTHER_STAGE, BaseInstance OTHER_STAGE,
        BaseVertex OTHER_STAGE, ClipDistances OTHER_STAGE, CullDistance OTHER_STAGE, InstanceIndex OTHER_STAGE,
        PointSize OTHER_STAGE, VertexIndex OTHER_STAGE, DrawIndex OTHER_STAGE, FragDepth OTHER_STAGE,
        PointCoord OTHER_STAGE, FrontFacing OTHER_STAGE, Barycentric OTHER_STAGE, SampleIndex OTHER_STAGE,
        SampleMask OTHER_STAGE, MeshTaskSize OTHER_STAGE, CullPrimitive OTHER_STAGE, PointIndex OTHER_STAGE,
        LineIndices OTHER_STAGE, TriangleIndices OTHER_STAGE, VertexCount OTHER_STAGE, Vertices OTHER_STAGE,
        PrimitiveCount OTHER_STAGE, Primitives OTHER_STAGE, RayInvocationId OTHER_STAGE,
        NumRayInvocations OTHER_STAGE, InstanceCustomData OTHER_STAGE, GeometryIndex OTHER_STAGE,
        WorldRayOrigin OTHER_STAGE, WorldRayDirection OTHER_STAGE, ObjectRayOrigin OTHER_STAGE,
        ObjectRayDirection OTHER_STAGE, RayTmin OTHER_STAGE, RayTCurrentMax OTHER_STAGE, ObjectToWorld OTHER_STAGE,
        WorldToObject OTHER_STAGE, HitKind OTHER_STAGE,
    }
    expression: "Expressions", Expression {
        Literal Runs, Constant Runs, Override Runs, ZeroValue Runs, Compose Runs, Access Runs, AccessIndex Runs,
        Splat Runs, Swizzle Runs, FunctionArgument Runs, GlobalVariable Runs, LocalVariable Runs, Load Runs,
        ImageSample Runs, ImageLoad Runs, ImageQuery Runs, Unary Runs, Binary Runs, Select Runs,
        Derivative FRAGMENT, Relational Runs, Math Runs, As Runs, CallResult Runs, AtomicResult Runs,
        WorkGroupUniformLoadResult Runs, ArrayLength Runs, RayQueryVertexPositions RAYS, RayQueryProceedResult RAYS,
        RayQueryGetIntersection RAYS, SubgroupBallotResult Runs, SubgroupOperationResult Runs,
        CooperativeLoad COOPERATIVE, CooperativeMultiplyAdd COOPERATIVE,
    }
    literal: "Literals", Literal {
        F64 Runs, F32 Runs, F16 Runs, U16 Runs, I16 Runs, U32 Runs, I32 Runs, U64 Runs, I64 Runs, Bool Runs,
        AbstractInt Outside("constants are made concrete before a module is valid"),
        AbstractFloat Outside("constants are made concrete before a module is valid"),
    }
    unary: "Unary operators", UnaryOperator { Negate Runs, LogicalNot Runs, BitwiseNot Runs }
    binary: "Binary operators", BinaryOperator {
        Add Runs, Subtract Runs, Multiply Runs, Divide Runs, Modulo Runs, Equal Runs, NotEqual Runs, Less Runs,
        LessEqual Runs, Greater Runs, GreaterEqual Runs, And Runs, ExclusiveOr Runs, InclusiveOr Runs,
        LogicalAnd Runs, LogicalOr Runs, ShiftLeft Runs, ShiftRight Runs,
    }
    relational: "Relational functions", RelationalFunction { All Runs, Any Runs, IsNan Runs, IsInf Runs }
    math: "Built-in functions", MathFunction {
        Abs Runs, Min Runs, Max Runs, Clamp Runs, Saturate Runs, Cos Runs, Cosh Runs, Sin Runs, Sinh Runs, Tan Runs,
        Tanh Runs, Acos Runs, Asin Runs, Atan Runs, Atan2 Runs, Asinh Runs, Acosh Runs, Atanh Runs, Radians Runs,
        Degrees Runs, Ceil Runs, Floor Runs, Round Runs, Fract Runs, Trunc Runs, Modf Runs, Frexp Runs, Ldexp Runs,
        Exp Runs, Exp2 Runs, Log Runs, Log2 Runs, Pow Runs, Dot Runs, Dot4I8Packed Runs, Dot4U8Packed Runs,
        Outer Runs, Cross Runs, Distance Runs, Length Runs, Normalize Runs, FaceForward Runs, Reflect Runs,
        Refract Runs, Sign Runs, Fma Runs, Mix Runs, Step Runs, SmoothStep Runs, Sqrt Runs, InverseSqrt Runs,
        Inverse Runs, Transpose Runs, Determinant Runs, QuantizeToF16 Runs, CountTrailingZeros Runs,
        CountLeadingZeros Runs, CountOneBits Runs, ReverseBits Runs, ExtractBits Runs, InsertBits Runs,
        FirstTrailingBit Runs, FirstLeadingBit Runs, Pack4x8snorm Runs, Pack4x8unorm Runs, Pack2x16snorm Runs,
        Pack2x16unorm Runs, Pack2x16float Runs, Pack4xI8 Runs, Pack4xU8 Runs, Pack4xI8Clamp Runs,
        Pack4xU8Clamp Runs, Unpack4x8snorm Runs, Unpack4x8unorm Runs, Unpack2x16snorm Runs, Unpack2x16unorm Runs,
        Unpack2x16float Runs, Unpack4xI8 Runs, Unpack4xU8 Runs,
    }
    sample_level: "Levels of sampling", SampleLevel {
        Auto FRAGMENT, Zero Runs, Exact Runs, Bias FRAGMENT, Gradient Runs,
    }
    image_query: "Queries of textures", ImageQuery { Size Runs, NumLevels Runs, NumLayers Runs, NumSamples Runs }
    statement: "Statements", Statement {
        Emit Runs, Block Runs, If Runs, Switch Runs, Loop Runs, Break Runs, Continue Runs, Return Runs,
        Kill Outside("only a fragment can be discarded"),
        ControlBarrier Runs, MemoryBarrier Runs, Store Runs, ImageStore Runs, Atomic Runs, ImageAtomic Runs,
        WorkGroupUniformLoad Runs, Call Runs, RayQuery RAYS, RayPipelineFunction OTHER_STAGE, SubgroupBallot Runs,
        SubgroupGather Runs, SubgroupCollectiveOperation Runs, CooperativeStore COOPERATIVE,
    }
    switch_value: "Values of switches", SwitchValue { I32 Runs, U32 Runs, Default Runs }
    barrier: "Barriers", BarrierKind { Storage Runs, WorkGroup Runs, SubGroup Runs, Texture Runs }
    atomic: "Atomic functions", AtomicFunction {
        Add Runs, Subtract Runs, And Runs, ExclusiveOr Runs, InclusiveOr Runs, Min Runs, Max Runs, Exchange Runs,
    }
    subgroup: "Subgroup operations", SubgroupOperation {
        All Runs, Any Runs, Add Runs, Mul Runs, Min Runs, Max Runs, And Runs, Or Runs, Xor Runs,
    }
    collective: "Subgroup reductions", CollectiveOperation { Reduce Runs, InclusiveScan Runs, ExclusiveScan Runs }
    gather: "Subgroup gathers", GatherMode {
        BroadcastFirst Runs, Broadcast Runs, Shuffle Runs, ShuffleDown Runs, ShuffleUp Runs, ShuffleXor Runs,
        QuadBroadcast Runs, QuadSwap Runs,
    }
    direction: "Directions of quad swaps", Direction { X Runs, Y Runs, Diagonal Runs }
}
