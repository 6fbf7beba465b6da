//! One fault: what it is, where it is, and the kernel with it.

use lobe_codegen::source::RustPlace;
use naga::{Expression, Function, Handle, Module};

/// What is done to a kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// `a - b` becomes `b - a`.
    SwappedOperands,
    /// `clamp(x, a, b)`, `max(x, a)`, `abs(x)` or `-x` becomes `x`.
    Dropped,
    /// An integer literal is one more or less.
    OffByOne,
    /// A float literal is multiplied by 1 + 1e-4.
    LiteralBy1e4,
    /// A float literal is multiplied by 1 + 1e-6.
    LiteralBy1e6,
    /// `sin` becomes `cos`.
    WrongBuiltin,
    /// `a + b` becomes `a - b`.
    WrongOperator,
    /// `v.x` becomes `v.y`.
    WrongComponent,
    /// `a < b` becomes `a > b`, a choice takes the other side.
    FlippedComparison,
    /// A store or a branch is gone.
    RemovedStatement,
    /// A comparison of integers takes in its bound, or leaves it out.
    LoopBound,
    /// The last digit of a literal in the text is one more.
    LastDigit,
    /// An operator in the text is another one.
    TextOperator,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 13] = [
        Self::SwappedOperands,
        Self::Dropped,
        Self::OffByOne,
        Self::LiteralBy1e4,
        Self::LiteralBy1e6,
        Self::WrongBuiltin,
        Self::WrongOperator,
        Self::WrongComponent,
        Self::FlippedComparison,
        Self::RemovedStatement,
        Self::LoopBound,
        Self::LastDigit,
        Self::TextOperator,
    ];

    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SwappedOperands => "swapped operands",
            Self::Dropped => "dropped operation",
            Self::OffByOne => "integer off by one",
            Self::LiteralBy1e4 => "literal x (1 + 1e-4)",
            Self::LiteralBy1e6 => "literal x (1 + 1e-6)",
            Self::WrongBuiltin => "wrong builtin",
            Self::WrongOperator => "wrong operator",
            Self::WrongComponent => "wrong component",
            Self::FlippedComparison => "flipped comparison",
            Self::RemovedStatement => "removed statement",
            Self::LoopBound => "loop bound",
            Self::LastDigit => "text: last digit",
            Self::TextOperator => "text: operator",
        }
    }

    /// Whether the change itself is smaller than one part in ten thousand.
    #[must_use]
    pub fn is_small(self) -> bool {
        matches!(self, Self::LiteralBy1e6 | Self::LastDigit)
    }
}

/// How a kernel is changed.
#[derive(Debug, Clone)]
pub enum Edit {
    /// An expression becomes another one of the same type.
    Expression {
        /// Where.
        function: Handle<Function>,
        /// Which.
        at: Handle<Expression>,
        /// What it becomes.
        to: Expression,
    },
    /// A statement is gone.
    Statement {
        /// Where.
        function: Handle<Function>,
        /// The way to it: its place in its block, after the places of the blocks around it.
        path: Vec<usize>,
    },
    /// A whole text of WGSL.
    Text(String),
}

/// A fault.
#[derive(Debug, Clone)]
pub struct Mutant {
    /// What kind it is.
    pub kind: Kind,
    /// The function in which it is.
    pub function: String,
    /// Its Rust line.
    pub place: Option<RustPlace>,
    /// What is there, and what it becomes.
    pub change: String,
    /// How to make it.
    pub edit: Edit,
}

impl Edit {
    /// `module` with the fault; `None` if there is no such place, or the text is none.
    #[must_use]
    pub fn apply(&self, module: &Module) -> Option<Module> {
        match self {
            Self::Expression { function, at, to } => {
                let mut changed = module.clone();
                *changed.functions.get_mut(*function).expressions.get_mut(*at) = to.clone();
                Some(changed)
            }
            Self::Statement { function, path } => {
                let mut changed = module.clone();
                remove(&mut changed.functions.get_mut(*function).body, path)?;
                Some(changed)
            }
            Self::Text(text) => naga::front::wgsl::parse_str(text).ok(),
        }
    }
}

/// Takes a statement out of a block; a branch loses what it does where its condition holds.
fn remove(block: &mut naga::Block, path: &[usize]) -> Option<()> {
    let (at, rest) = path.split_first()?;
    let statement = block.get_mut(*at)?;
    if let Some((inner, rest)) = rest.split_first() {
        return remove(super::sites::blocks_mut(statement).into_iter().nth(*inner)?, rest);
    }
    match statement {
        naga::Statement::If { accept, .. } => *accept = naga::Block::new(),
        other => *other = naga::Statement::Block(naga::Block::new()),
    }
    Some(())
}
