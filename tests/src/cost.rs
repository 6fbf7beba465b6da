//! What a kernel costs: its scalar operations, counted in the lowered module.
//!
//! Calls count as often as they are written, as if they were inlined; of a branch, both sides count.
//! A vector operation counts once for each component, a dot product of n components as n multiplications and
//! n - 1 additions. Negations, components, conversions and constants are free.

use lobe_backends::executor::Program;
use naga::proc::TypeResolution;
use naga::{BinaryOperator, Expression, Function, Handle, MathFunction, Module, Statement, TypeInner};
use std::fmt;
use std::ops::AddAssign;

/// Scalar operations by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions and multiplications.
    pub add_mul: usize,
    /// Divisions.
    pub div: usize,
    /// Roots and their inverses.
    pub sqrt: usize,
    /// Exponentials, logarithms, powers, trigonometric functions.
    pub elementary: usize,
    /// Minima, maxima, clamps, magnitudes, signs, roundings.
    pub min_max: usize,
    /// Comparisons, choices, and what combines truths.
    pub choice: usize,
}

impl Cost {
    /// All of them.
    #[must_use]
    pub fn total(&self) -> usize {
        self.add_mul + self.div + self.sqrt + self.elementary + self.min_max + self.choice
    }
}

impl AddAssign for Cost {
    fn add_assign(&mut self, other: Self) {
        self.add_mul += other.add_mul;
        self.div += other.div;
        self.sqrt += other.sqrt;
        self.elementary += other.elementary;
        self.min_max += other.min_max;
        self.choice += other.choice;
    }
}

impl fmt::Display for Cost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { add_mul, div, sqrt, elementary, min_max, choice } = self;
        let total = self.total();
        write!(
            f,
            "{add_mul} +-*, {div} /, {sqrt} sqrt, {elementary} exp, {min_max} min/max, {choice} choices: {total}"
        )
    }
}

/// The cost of a kernel, callees included.
///
/// # Panics
/// Where it uses an operation that has no count here.
#[must_use]
pub fn of(program: &Program) -> Cost {
    let valid = program.module();
    let counter = Counter { module: valid.module(), info: valid.info() };
    counter.function(program.handle())
}

/// The cost of the function `name` that a kernel calls, its callees included; `None` when it calls none.
#[must_use]
pub fn of_callee(program: &Program, name: &str) -> Option<Cost> {
    let valid = program.module();
    let counter = Counter { module: valid.module(), info: valid.info() };
    valid.function(name).map(|handle| counter.function(handle))
}

struct Counter<'a> {
    module: &'a Module,
    info: &'a naga::valid::ModuleInfo,
}

impl Counter<'_> {
    fn function(&self, handle: Handle<Function>) -> Cost {
        let function = &self.module.functions[handle];
        let info = &self.info[handle];
        let width = |e: Handle<Expression>| self.width(&info[e].ty);
        let mut cost = Cost::default();
        for (at, expression) in function.expressions.iter() {
            match expression {
                Expression::Binary { op, .. } => cost += operator(*op, width(at)),
                Expression::Math { fun, arg, .. } => cost += math(*fun, width(*arg)),
                Expression::Select { .. } => cost.choice += width(at),
                Expression::Relational { argument, .. } => cost.choice += width(*argument),
                other => assert!(is_free(other), "{other:?} has no count"),
            }
        }
        self.calls(&function.body, &mut cost);
        cost
    }

    fn calls(&self, block: &naga::Block, cost: &mut Cost) {
        for statement in block {
            match statement {
                Statement::Call { function, .. } => *cost += self.function(*function),
                Statement::Block(inner) => self.calls(inner, cost),
                Statement::If { accept, reject, .. } => {
                    self.calls(accept, cost);
                    self.calls(reject, cost);
                }
                Statement::Switch { cases, .. } => cases.iter().for_each(|c| self.calls(&c.body, cost)),
                Statement::Emit(_)
                | Statement::Store { .. }
                | Statement::Return { .. }
                | Statement::Break
                | Statement::Continue => {}
                Statement::Loop { .. }
                | Statement::Kill
                | Statement::ControlBarrier(_)
                | Statement::MemoryBarrier(_)
                | Statement::ImageStore { .. }
                | Statement::Atomic { .. }
                | Statement::ImageAtomic { .. }
                | Statement::WorkGroupUniformLoad { .. }
                | Statement::RayQuery { .. }
                | Statement::RayPipelineFunction(_)
                | Statement::SubgroupBallot { .. }
                | Statement::SubgroupGather { .. }
                | Statement::SubgroupCollectiveOperation { .. }
                | Statement::CooperativeStore { .. } => panic!("{statement:?} has no count"),
            }
        }
    }

    fn width(&self, ty: &TypeResolution) -> usize {
        match ty.inner_with(&self.module.types) {
            TypeInner::Scalar(_) => 1,
            TypeInner::Vector { size, .. } => *size as usize,
            other => panic!("an operation on {other:?} has no count"),
        }
    }
}

fn operator(op: BinaryOperator, width: usize) -> Cost {
    match op {
        BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply => {
            Cost { add_mul: width, ..Cost::default() }
        }
        BinaryOperator::Divide | BinaryOperator::Modulo => Cost { div: width, ..Cost::default() },
        BinaryOperator::Equal
        | BinaryOperator::NotEqual
        | BinaryOperator::Less
        | BinaryOperator::LessEqual
        | BinaryOperator::Greater
        | BinaryOperator::GreaterEqual
        | BinaryOperator::And
        | BinaryOperator::ExclusiveOr
        | BinaryOperator::InclusiveOr
        | BinaryOperator::LogicalAnd
        | BinaryOperator::LogicalOr
        | BinaryOperator::ShiftLeft
        | BinaryOperator::ShiftRight => Cost { choice: width, ..Cost::default() },
    }
}

/// What moves values, or names them.
fn is_free(expression: &Expression) -> bool {
    matches!(
        expression,
        Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::Override(_)
            | Expression::ZeroValue(_)
            | Expression::Compose { .. }
            | Expression::Access { .. }
            | Expression::AccessIndex { .. }
            | Expression::Splat { .. }
            | Expression::Swizzle { .. }
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_)
            | Expression::Load { .. }
            | Expression::Unary { .. }
            | Expression::As { .. }
            | Expression::CallResult(_)
    )
}

fn math(function: MathFunction, width: usize) -> Cost {
    let none = Cost::default();
    match function {
        MathFunction::Min
        | MathFunction::Max
        | MathFunction::Clamp
        | MathFunction::Saturate
        | MathFunction::Abs
        | MathFunction::Sign
        | MathFunction::Floor
        | MathFunction::Ceil
        | MathFunction::Round
        | MathFunction::Trunc
        | MathFunction::Fract => Cost { min_max: width, ..none },
        MathFunction::Sqrt | MathFunction::InverseSqrt => Cost { sqrt: width, ..none },
        MathFunction::Exp
        | MathFunction::Exp2
        | MathFunction::Log
        | MathFunction::Log2
        | MathFunction::Pow
        | MathFunction::Sin
        | MathFunction::Cos => Cost { elementary: width, ..none },
        MathFunction::Fma => Cost { add_mul: 2 * width, ..none },
        MathFunction::Dot => Cost { add_mul: 2 * width - 1, ..none },
        MathFunction::Length => Cost { add_mul: 2 * width - 1, sqrt: 1, ..none },
        MathFunction::Distance => Cost { add_mul: 3 * width - 1, sqrt: 1, ..none },
        MathFunction::Normalize => Cost { add_mul: 2 * width - 1, div: width, sqrt: 1, ..none },
        MathFunction::Cross => Cost { add_mul: 9, ..none },
        MathFunction::Mix => Cost { add_mul: 4 * width, ..none },
        other => panic!("{other:?} has no count"),
    }
}
