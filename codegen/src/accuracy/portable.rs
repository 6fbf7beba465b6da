//! The loosest of several models, row by row.
//!
//! `portable` is that of WGSL and Vulkan: every text that Lobe emits or reads reaches its driver under the rules of one
//! of them, HLSL by way of DXC as SPIR-V.
//! Direct3D promises nothing of `atan`, `acos`, `tan` and `tanh`, so with it no kernel that calls them has a bound; who
//! runs HLSL on Direct3D asks for the model `hlsl`.
//!
//! No class is invented: an operation whose models disagree gets the classes of all of them, of which the worst counts,
//! less those that another one covers.

use super::{Accuracy, Model, Operation, Rounding, Row, Rules, Subnormal};

pub(super) const TITLE: &str = "the looser of WGSL and Vulkan";

/// The loosest of `models`, of which there is at least one.
pub(super) fn of(name: &'static str, title: &'static str, models: &[&Model]) -> Model {
    let rows: Vec<Row> = Operation::all().map(|operation| loosest(operation, models)).collect();
    Model::new(name, title, rules(models), &rows)
}

fn loosest(operation: Operation, models: &[&Model]) -> Row {
    let rows: Vec<&Row> = models.iter().filter_map(|model| model.row(operation)).collect();
    let of =
        |column: fn(&Row) -> &'static [Accuracy]| rows.iter().flat_map(|row| column(row)).copied().collect();
    let sections: Vec<&str> = rows.iter().map(|row| row.section).collect();
    Row {
        operation,
        f32: kept(without_covered(of(|row| row.f32))),
        f16: kept(without_covered(of(|row| row.f16))),
        section: String::leak(sections.join("; ")),
    }
}

/// Made once in the life of a program.
fn kept(classes: Vec<Accuracy>) -> &'static [Accuracy] {
    Vec::leak(classes)
}

fn without_covered(classes: Vec<Accuracy>) -> Vec<Accuracy> {
    let mut left: Vec<Accuracy> = Vec::new();
    for class in classes {
        if left.iter().any(|other| other.covers(class)) {
            continue;
        }
        left.retain(|other| !class.covers(*other));
        left.push(class);
    }
    left
}

fn rules(models: &[&Model]) -> Rules {
    let first = |is_loosest: fn(&Rules) -> bool| {
        models.iter().map(|model| model.rules).find(is_loosest).unwrap_or(models[0].rules)
    };
    Rules {
        subnormal: first(|rules| rules.subnormal.0 == Subnormal::MayFlush).subnormal,
        rounding: first(|rules| rules.rounding.0 == Rounding::Either).rounding,
        contraction: first(|rules| rules.contraction.0).contraction,
        reassociation: first(|rules| rules.reassociation.0).reassociation,
        // Where a language has no doubles, nothing speaks against what another says of them.
        double: first(|rules| rules.double.0).double,
    }
}
