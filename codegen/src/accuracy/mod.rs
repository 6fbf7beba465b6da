//! How far drivers may be from the exact result: one table a specification, one row an operation.
//!
//! [`Model::all`] lists the tables; [`Model::portable`], the default, is computed from those of the languages that
//! drivers are given here ([`portable`](mod@portable)).
//! The interpreter's shadow lane and its perturbed drivers keep to the table they are told to.

mod class;
mod hlsl;
mod operation;
mod portable;
mod vulkan;
mod wgsl;

pub use class::{Accuracy, LERP};
pub use operation::Operation;

use crate::intrinsics::Intrinsic;
use std::sync::LazyLock;

/// What one specification promises of one operation.
#[derive(Debug, Clone)]
pub struct Row {
    /// The operation.
    pub operation: Operation,
    /// Of `f32`: the worst of these.
    pub f32: &'static [Accuracy],
    /// Of `f16`: the worst of these.
    pub f16: &'static [Accuracy],
    /// Where the specification says so.
    pub section: &'static str,
}

impl Row {
    /// A row that has the same classes for both widths.
    const fn of(operation: Operation, classes: &'static [Accuracy], section: &'static str) -> Self {
        Self { operation, f32: classes, f16: classes, section }
    }

    /// A row with a column for each width.
    const fn each(
        operation: Operation,
        f32: &'static [Accuracy],
        f16: &'static [Accuracy],
        section: &'static str,
    ) -> Self {
        Self { operation, f32, f16, section }
    }
}

/// What becomes of subnormal operands and results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Subnormal {
    /// A driver may take them for zero.
    MayFlush,
    /// A driver takes them for zero.
    Flushed,
}

/// Which neighbour a correctly rounded result is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rounding {
    /// Either.
    Either,
    /// The nearest one.
    Nearest,
}

/// Bits of a float.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Width {
    /// `f16`
    Half,
    /// `f32`
    Single,
    /// `f64`
    Double,
}

/// What holds for all operations of a model.
#[derive(Debug, Clone, Copy)]
pub struct Rules {
    /// Of subnormal numbers, and where the specification says so.
    pub subnormal: (Subnormal, &'static str),
    /// Of correctly rounded results, likewise.
    pub rounding: (Rounding, &'static str),
    /// Whether a product may go into a sum without having been rounded, likewise.
    pub contraction: (bool, &'static str),
    /// Whether the terms of a sum may be added in another order, likewise.
    pub reassociation: (bool, &'static str),
    /// Whether operations on `f64` keep the classes of `f32`, with its ULP, likewise; else nothing is known of them.
    pub double: (bool, &'static str),
}

/// One table.
#[derive(Debug)]
pub struct Model {
    /// By which it is asked for.
    pub name: &'static str,
    /// The specification.
    pub title: &'static str,
    /// What holds for all operations.
    pub rules: Rules,
    /// In the order of [`Operation::all`].
    rows: Vec<Row>,
}

static MODELS: LazyLock<[Model; 4]> = LazyLock::new(|| {
    let (wgsl, vulkan, hlsl) = (wgsl::model(), vulkan::model(), hlsl::model());
    let portable = portable::of("portable", portable::TITLE, &[&wgsl, &vulkan]);
    [portable, wgsl, vulkan, hlsl]
});

impl Model {
    fn new(name: &'static str, title: &'static str, rules: Rules, rows: &[Row]) -> Self {
        let row = |operation: Operation| {
            let found = rows.iter().find(|row| row.operation == operation).cloned();
            found.unwrap_or(Row::of(operation, &[Accuracy::Nothing], "not mentioned"))
        };
        Self { name, title, rules, rows: Operation::all().map(row).collect() }
    }

    /// All models, the default first.
    pub fn all() -> &'static [Self; 4] {
        &MODELS
    }

    /// The default: what may be relied on in every language that drivers are given here.
    pub fn portable() -> &'static Self {
        &MODELS[0]
    }

    /// Its name, unless it is the default.
    pub fn unusual_name(&self) -> Option<&'static str> {
        (self.name != Self::portable().name).then_some(self.name)
    }

    /// The model of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        Self::all().iter().find(|model| model.name == name)
    }

    /// All rows, in the order of [`Operation::all`].
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The row of an operation; one that does not compute with floats has none.
    pub fn row(&self, operation: Operation) -> Option<&Row> {
        self.rows.get(operation.index()?)
    }

    /// The classes of an operation on `f32`, whose error is the worst of them; what has no row is exact.
    pub fn classes(&self, operation: Operation) -> &'static [Accuracy] {
        self.row(operation).map_or(&[Accuracy::Exact], |row| row.f32)
    }

    /// The same of a built-in function.
    pub fn builtin(&self, intrinsic: Intrinsic) -> &'static [Accuracy] {
        self.classes(Operation::Builtin(intrinsic))
    }

    /// The same of an operation on floats of any width.
    pub fn classes_of(&self, operation: Operation, width: Width) -> &'static [Accuracy] {
        match width {
            Width::Half => self.row(operation).map_or(&[Accuracy::Exact], |row| row.f16),
            Width::Single => self.classes(operation),
            Width::Double if self.rules.double.0 && operation.takes_doubles() => self.classes(operation),
            Width::Double => &[Accuracy::Nothing],
        }
    }
}

#[cfg(test)]
mod tests;
