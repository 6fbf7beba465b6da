//! What `#[kernel]` writes down: a function, structure or constant as plain, constant data.
//!
//! The macro parses Rust and expands each item to itself (the native form) and to one of the
//! definitions here.
//! They hold syntax and source positions, no types of expressions: [`lower`](mod@crate::lower) infers those,
//! builds the naga module from them and reports every mistake at its Rust line.
//!
//! Everything is `'static` and built in constants, so that a definition costs nothing until used.
//! References between items are function pointers ([`FunctionRef`] and its siblings): a kernel can
//! name another in any module or crate, and address equality identifies a definition.

use crate::intrinsics::Intrinsic;

/// The text that an item was written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Path of the file as rustc was given it.
    pub file: &'static str,
    /// Line of the file (from 1) at which [`Source::text`] begins.
    pub line: u32,
    /// The whole lines that the item covers; empty when the file could not be read.
    pub text: &'static str,
}

/// A stretch of source: `(line, column)` of its first character and past its last one.
/// Lines count from 1, columns (characters) from 0, as rustc's procedural macro spans do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Span {
    /// First character.
    pub start: (u32, u32),
    /// Past the last character.
    pub end: (u32, u32),
}

/// Kind of a scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Scalar {
    /// 32-bit IEEE float.
    F32,
    /// 32-bit signed integer.
    I32,
    /// 32-bit unsigned integer.
    U32,
    /// Boolean; it has no layout in buffers.
    Bool,
}

impl Scalar {
    /// The Rust (and WGSL) spelling.
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::Bool => "bool",
        }
    }
}

/// A type of the kernel language.
#[derive(Debug, Clone, Copy)]
pub enum TypeDef {
    /// `f32`, `i32`, `u32`, `bool`.
    Scalar(Scalar),
    /// glam's `Vec2`..`Vec4`, `IVec*`, `UVec*`, `BVec*`: component count and kind.
    Vector(u8, Scalar),
    /// glam's `Mat2`..`Mat4`, column-major: `(columns, rows)`.
    Matrix(u8, u8),
    /// `[T; N]`.
    Array(&'static TypeDef, u32),
    /// `[T]`, only as the target of a storage binding.
    Slice(&'static TypeDef),
    /// `AtomicU32` / `AtomicI32`, only inside storage and workgroup bindings.
    Atomic(Scalar),
    /// A structure marked `#[kernel]`.
    Struct(StructRef),
}

impl PartialEq for TypeDef {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Scalar(a), Self::Scalar(b)) | (Self::Atomic(a), Self::Atomic(b)) => a == b,
            (Self::Vector(n, a), Self::Vector(m, b)) => n == m && a == b,
            (Self::Matrix(c, r), Self::Matrix(d, s)) => c == d && r == s,
            (Self::Array(a, n), Self::Array(b, m)) => a == b && n == m,
            (Self::Slice(a), Self::Slice(b)) => a == b,
            (Self::Struct(a), Self::Struct(b)) => std::ptr::eq(a(), b()),
            (
                Self::Scalar(_)
                | Self::Vector(..)
                | Self::Matrix(..)
                | Self::Array(..)
                | Self::Slice(_)
                | Self::Atomic(_)
                | Self::Struct(_),
                _,
            ) => false,
        }
    }
}

impl std::fmt::Display for TypeDef {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match *self {
            Self::Scalar(s) => f.write_str(s.name()),
            Self::Vector(n, Scalar::F32) => write!(f, "Vec{n}"),
            Self::Vector(n, Scalar::I32) => write!(f, "IVec{n}"),
            Self::Vector(n, Scalar::U32) => write!(f, "UVec{n}"),
            Self::Vector(n, Scalar::Bool) => write!(f, "BVec{n}"),
            Self::Matrix(c, r) if c == r => write!(f, "Mat{c}"),
            Self::Matrix(c, r) => write!(f, "Mat{c}x{r}"),
            Self::Array(t, n) => write!(f, "[{t}; {n}]"),
            Self::Slice(t) => write!(f, "[{t}]"),
            Self::Atomic(s) => write!(f, "Atomic{}", s.name().to_uppercase()),
            Self::Struct(s) => f.write_str(s().name),
        }
    }
}

/// Names a function's definition.
pub type FunctionRef = fn() -> &'static FunctionDef;
/// Names a structure's definition.
pub type StructRef = fn() -> &'static StructDef;
/// Names a constant's definition.
pub type ConstantRef = fn() -> &'static ConstantDef;

/// A structure: fields in declaration order, laid out as WGSL lays them out.
#[derive(Debug)]
pub struct StructDef {
    /// Declared and emitted name.
    pub name: &'static str,
    /// Doc comment, a line an item, without its leading space.
    pub docs: &'static [&'static str],
    /// Where it was written.
    pub source: Source,
    /// The whole item.
    pub span: Span,
    /// The fields.
    pub fields: &'static [FieldDef],
}

/// A field of a [`StructDef`].
#[derive(Debug)]
pub struct FieldDef {
    /// Declared and emitted name.
    pub name: &'static str,
    /// Its type.
    pub ty: TypeDef,
    /// Doc comment lines.
    pub docs: &'static [&'static str],
    /// The values it may have, when the field states them.
    pub domain: Option<Domain>,
    /// The declaration.
    pub span: Span,
}

/// A named constant.
#[derive(Debug)]
pub struct ConstantDef {
    /// Declared and emitted name.
    pub name: &'static str,
    /// Doc comment lines.
    pub docs: &'static [&'static str],
    /// Where it was written.
    pub source: Source,
    /// The whole item.
    pub span: Span,
    /// Its type.
    pub ty: TypeDef,
    /// Its value, evaluated by rustc.
    pub value: ConstantValue,
    /// The value that the source text states, when that is a single float literal.
    pub exact: Option<f64>,
}

/// The value of a constant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ConstantValue {
    /// A float.
    F32(f32),
    /// A signed integer.
    I32(i32),
    /// An unsigned integer.
    U32(u32),
    /// A boolean.
    Bool(bool),
    /// Components of a vector, columns of a matrix, elements of an array.
    Composite(&'static [ConstantValue]),
}

/// A function or an entry point.
#[derive(Debug)]
pub struct FunctionDef {
    /// Declared and emitted name.
    pub name: &'static str,
    /// `module_path!()` of the definition.
    pub module: &'static str,
    /// Doc comment, a line an item, without its leading space; a text that it includes is one item.
    pub docs: &'static [&'static str],
    /// Where it was written.
    pub source: Source,
    /// The signature, from `fn` to the return type.
    pub span: Span,
    /// Workgroup size of an entry point; `None` for an ordinary function.
    pub entry: Option<[u32; 3]>,
    /// Parameters; they are the locals `0..params.len()`.
    pub params: &'static [Param],
    /// Return type; `None` for a function that returns nothing.
    pub ret: Option<TypeDef>,
    /// Names of all locals, parameters first, indexed by [`ExprKind::Local`] and [`StmtKind::Let`].
    pub locals: &'static [LocalDef],
    /// The body.
    pub body: Block,
    /// What the function promises.
    pub contract: Contract,
    /// Calls the Rust function: reads the arguments' words in order, appends the result's.
    /// `None` for entry points.
    pub native: Option<fn(&mut crate::data::WordReader<'_>, &mut Vec<u32>)>,
}

/// A parameter.
#[derive(Debug)]
pub struct Param {
    /// Declared and emitted name.
    pub name: &'static str,
    /// Its type; for bindings, the type behind the reference.
    pub ty: TypeDef,
    /// How the value arrives.
    pub binding: Binding,
    /// The declaration.
    pub span: Span,
}

/// How a parameter's value arrives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Binding {
    /// By value, the only way for ordinary functions.
    Value,
    /// A built-in input of an entry point.
    Builtin(Builtin),
    /// `&T` or `&mut T` (`writable`) in storage memory.
    Storage {
        /// Bind group.
        group: u32,
        /// Binding within the group.
        binding: u32,
        /// Whether the shader writes it.
        writable: bool,
    },
    /// `&T` in uniform memory.
    Uniform {
        /// Bind group.
        group: u32,
        /// Binding within the group.
        binding: u32,
    },
    /// `&mut T` shared by a workgroup, zero at its start.
    Workgroup,
}

/// Built-in inputs of a compute entry point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Builtin {
    /// `UVec3`
    GlobalInvocationId,
    /// `UVec3`
    LocalInvocationId,
    /// `u32`
    LocalInvocationIndex,
    /// `UVec3`
    WorkgroupId,
    /// `UVec3`
    NumWorkgroups,
}

/// A local variable or parameter.
#[derive(Debug)]
pub struct LocalDef {
    /// Name as written.
    pub name: &'static str,
    /// Declared `mut`.
    pub mutable: bool,
    /// Where the name stands.
    pub span: Span,
}

/// Statements and, when it is an expression, a final value.
#[derive(Debug, Clone, Copy)]
pub struct Block {
    /// In order.
    pub stmts: &'static [Stmt],
    /// The value without semicolon at the end.
    pub value: Option<&'static Expr>,
}

/// A statement.
#[derive(Debug)]
pub struct Stmt {
    /// What it does.
    pub kind: StmtKind,
    /// Where it stands.
    pub span: Span,
}

/// What a statement does.
#[derive(Debug)]
pub enum StmtKind {
    /// `let local: ty = init;`
    Let {
        /// Index into [`FunctionDef::locals`].
        local: u32,
        /// The annotation.
        ty: Option<TypeDef>,
        /// The value; a declaration without one must be assigned before use.
        init: Option<Expr>,
    },
    /// `place = value;` or `place op= value;`
    Assign {
        /// A local, a binding, or a field or element of one.
        place: Expr,
        /// The operator of a compound assignment.
        op: Option<BinaryOp>,
        /// Right-hand side.
        value: Expr,
    },
    /// An expression for its effect: a call, `if`, `match` or block that has no value.
    Expr(Expr),
    /// `while condition { body }`
    While {
        /// Tested before each round.
        condition: Expr,
        /// The body.
        body: Block,
    },
    /// `loop { body }`
    Loop(Block),
    /// `for local in start..end { body }` (`..=` when inclusive).
    For {
        /// Index into [`FunctionDef::locals`].
        local: u32,
        /// First value.
        start: Expr,
        /// Bound, evaluated once.
        end: Expr,
        /// `..=`
        inclusive: bool,
        /// The body.
        body: Block,
    },
    /// `break;`
    Break,
    /// `continue;`
    Continue,
    /// `return value;`
    Return(Option<Expr>),
}

/// An expression.
#[derive(Debug)]
pub struct Expr {
    /// What it computes.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// What an expression computes.
#[derive(Debug)]
pub enum ExprKind {
    /// A float literal: the `f32` that rustc makes of it, and the value that its decimals state.
    Float(f32, f64),
    /// An integer literal and its suffix.
    Int(u64, Option<Scalar>),
    /// `true` or `false`.
    Bool(bool),
    /// Index into [`FunctionDef::locals`].
    Local(u32),
    /// A constant marked `#[kernel]`.
    Constant(ConstantRef),
    /// `Type::NAME`, as `Vec3::ZERO` or `f32::MAX`.
    TypeConstant(TypeDef, &'static str),
    /// `-x` or `!x`.
    Unary(UnaryOp, &'static Expr),
    /// `left op right`.
    Binary(BinaryOp, &'static Expr, &'static Expr),
    /// `function(arguments)`.
    Call(Callee, &'static [Expr]),
    /// `Type::function(arguments)`, as `Vec3::new(x, y, z)`.
    TypeCall(TypeDef, &'static str, &'static [Expr]),
    /// `receiver.method(arguments)`.
    Method(&'static Expr, &'static str, &'static [Expr]),
    /// `base.field`, of a structure or a vector.
    Field(&'static Expr, &'static str),
    /// `base[index]`.
    Index(&'static Expr, &'static Expr),
    /// `Type { field: value, ..rest }`.
    Struct {
        /// The structure.
        ty: TypeDef,
        /// Fields as written.
        fields: &'static [(&'static str, Expr)],
        /// `..rest`
        rest: Option<&'static Expr>,
    },
    /// `[a, b, c]`.
    Array(&'static [Expr]),
    /// `[value; count]`.
    Repeat(&'static Expr, u32),
    /// `value as ty`.
    Cast(&'static Expr, TypeDef),
    /// `if condition { .. } else { .. }`.
    If {
        /// The condition.
        condition: &'static Expr,
        /// Taken when it holds.
        accept: Block,
        /// Taken when it does not; `else if` is a block whose value or statement is an `If`.
        reject: Option<Block>,
    },
    /// `match selector { 1 | 2 => .., _ => .. }` on integers.
    Match {
        /// An integer.
        selector: &'static Expr,
        /// In order; the arm without patterns is `_`.
        arms: &'static [Arm],
    },
    /// `{ .. }`.
    Block(Block),
}

/// An arm of a `match`.
#[derive(Debug)]
pub struct Arm {
    /// Values it stands for; empty for `_`.
    pub patterns: &'static [i64],
    /// Its value or effect.
    pub body: Block,
    /// The pattern.
    pub span: Span,
}

/// What a call names.
#[derive(Debug, Clone, Copy)]
pub enum Callee {
    /// Another kernel.
    Function(FunctionRef),
    /// A built-in operation.
    Intrinsic(Intrinsic),
}

/// Prefix operators.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Negate,
    /// `!`: logical on `bool`, bitwise on integers.
    Not,
}

/// Infix operators.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BinaryOp {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `%`
    Remainder,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `&&`
    LogicalAnd,
    /// `||`
    LogicalOr,
    /// `&`
    And,
    /// `|`
    Or,
    /// `^`
    Xor,
    /// `<<`
    ShiftLeft,
    /// `>>`
    ShiftRight,
}

/// What a kernel promises, as its attribute states it.
#[derive(Debug)]
pub struct Contract {
    /// Subject it belongs to, as `sg`; empty when none is stated.
    pub family: &'static str,
    /// Where the equation stands, as `[Tokuyoshi22] listing 3`.
    pub cite: &'static str,
    /// Values of the arguments for which the promises hold.
    pub domain: &'static [DomainDef],
    /// Permitted rounding error, a row for each stated part of the result.
    pub budget: &'static [BudgetDef],
    /// The kernel that this one is another form of.
    pub variant_of: Option<FunctionRef>,
    /// Why question 2 (robust) is expected to be answered "no".
    pub not_robust: Option<&'static str>,
    /// The exact function that the body approximates.
    pub truth: Option<Truth>,
    /// The text of the file of measured errors; its first paragraph goes into emitted comments.
    pub measured: Option<&'static str>,
}

/// The domain of one argument, or of a part of it.
#[derive(Debug)]
pub struct DomainDef {
    /// `x`, or `lobe.sharpness`.
    pub path: &'static str,
    /// Permitted values.
    pub domain: Domain,
    /// Where it is stated.
    pub span: Span,
}

/// Permitted values of an argument or field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Domain {
    /// Every value in the closed range (each component, for a vector).
    Range(f64, f64),
    /// Vectors of length one.
    Unit,
    /// Vectors of length one, perpendicular to that of the named sibling, which is declared before.
    NormalTo(&'static str),
    /// The cross product of the two named siblings, which are declared before.
    Cross(&'static str, &'static str),
    /// Just these.
    Values(&'static [f64]),
}

/// The permitted absolute error of the result, or of one of its fields.
#[derive(Debug)]
pub struct BudgetDef {
    /// Field of the result; empty for the whole.
    pub path: &'static str,
    /// The expression as written.
    pub text: &'static str,
    /// A function of the kernel's parameters and then its result, that returns the permitted error.
    pub function: FunctionRef,
}

/// The exact function that a kernel approximates, in f64.
#[derive(Clone, Copy)]
pub enum Truth {
    /// Of one `f32` argument.
    Unary(fn(f64) -> f64),
    /// Of two `f32` arguments.
    Binary(fn(f64, f64) -> f64),
}

impl std::fmt::Debug for Truth {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Unary(_) => "Truth::Unary",
            Self::Binary(_) => "Truth::Binary",
        })
    }
}

/// A type that kernels can use.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no type of the kernel language",
    label = "not marked `#[kernel]`; use f32, i32, u32, bool, glam's vectors and matrices, arrays, or a structure under `#[kernel]`"
)]
pub trait KernelType {
    /// Its description.
    const TYPE: TypeDef;
}

/// A [`KernelType`] that travels as 32-bit words: one for each scalar, in declaration order.
#[diagnostic::on_unimplemented(
    message = "values of type `{Self}` do not travel to kernels",
    label = "use f32, i32, u32, bool, glam's vectors and matrices, arrays, or a structure under `#[kernel]`"
)]
pub trait KernelValue: KernelType + Sized {
    /// Takes the words of one value.
    fn read(words: &mut crate::data::WordReader<'_>) -> Self;
    /// Appends the words of the value.
    fn write(&self, words: &mut Vec<u32>);
}

/// Implemented, beside every kernel and intrinsic, by a type of the same name.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no kernel function",
    label = "only functions under `#[kernel]` and those of the prelude can be called"
)]
pub trait Callable {
    /// What a call of this name is.
    const CALLEE: Callee;
}

/// Implemented, beside every kernel constant, by a type of the same name.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no kernel constant",
    label = "put `#[kernel]` on the `const`"
)]
pub trait Constant {
    /// Its definition.
    const DEF: ConstantRef;
}
