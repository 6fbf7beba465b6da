use super::{Accuracy, Model, Operation, Rounding, Subnormal};

#[test]
fn every_operation_has_its_row_in_every_model() {
    for model in Model::all() {
        for (row, operation) in model.rows().iter().zip(Operation::all()) {
            assert_eq!(row.operation, operation, "{}", model.name);
            assert!(
                model.row(operation).is_some_and(|r| std::ptr::eq(row, r)),
                "{}: {operation}",
                model.name
            );
            assert!(row.section != "not mentioned", "{}: {operation} has no row", model.name);
            assert!(!row.f32.is_empty() && !row.f16.is_empty(), "{}: {operation}", model.name);
        }
        assert_eq!(model.rows().len(), Operation::all().count());
    }
}

#[test]
fn what_does_not_compute_with_floats_has_no_row_and_is_exact() {
    use crate::intrinsics::{Intrinsic, TABLE};
    let known = |intrinsic: Intrinsic| Operation::all().any(|known| known == Operation::Builtin(intrinsic));
    let others = TABLE.iter().map(|row| row.intrinsic).filter(|intrinsic| !known(*intrinsic));
    let others = others.map(Operation::Builtin).chain([Operation::Infix(naga::BinaryOperator::ShiftLeft)]);
    for operation in others {
        assert!(Model::portable().row(operation).is_none(), "{operation}");
        assert_eq!(Model::portable().classes(operation), [Accuracy::Exact], "{operation}");
    }
}

#[test]
fn no_table_states_an_operation_twice_or_one_that_it_does_not_know() {
    for (name, rows) in
        [("wgsl", super::wgsl::ROWS), ("vulkan", super::vulkan::ROWS), ("hlsl", super::hlsl::ROWS)]
    {
        assert_eq!(rows.len(), Operation::all().count(), "{name}");
    }
}

/// The most that a class permits, where it is a number: at argument `x` and result `y`, in the units of `f32`.
fn permitted(class: Accuracy, x: f64, y: f64) -> f64 {
    let ulp = y.abs() / f64::from(1 << 23);
    match class {
        Accuracy::Exact | Accuracy::Inherited(_) => 0.0,
        Accuracy::Correct => ulp,
        Accuracy::Ulp(n) => n * ulp,
        Accuracy::UlpScaled { base, slope } => (base + slope * x.abs()) * ulp,
        Accuracy::UlpWhere { ulp: n, from, to } => {
            if (from..=to).contains(&x.abs()) {
                n * ulp
            } else {
                f64::INFINITY
            }
        }
        Accuracy::UlpOrAbsolute { ulp: n, absolute, from, to } => {
            if (from..=to).contains(&x) {
                absolute
            } else {
                n * ulp
            }
        }
        Accuracy::Absolute(error) => error,
        Accuracy::AbsoluteOn { absolute, from, to } => {
            if (from..=to).contains(&x) {
                absolute
            } else {
                f64::INFINITY
            }
        }
        Accuracy::Nothing => f64::INFINITY,
    }
}

/// Whether `loose` permits what `strict` does, number by number and formula by formula.
fn is_as_loose(loose: &[Accuracy], strict: &[Accuracy]) -> bool {
    const POINTS: [f64; 11] = [-1e39, -400.0, -3.0, -1.0, -1e-39, 0.0, 0.25, 0.75, 3.0, 300.0, 1e39];
    let worst =
        |classes: &[Accuracy], x, y| classes.iter().map(|class| permitted(*class, x, y)).fold(0.0, f64::max);
    let numbers = POINTS.iter().all(|x| POINTS.iter().all(|y| worst(loose, *x, *y) >= worst(strict, *x, *y)));
    let formulas = strict.iter().filter(|class| matches!(class, Accuracy::Inherited(_)));
    numbers
        && formulas.into_iter().all(|formula| loose.contains(formula) || loose.contains(&Accuracy::Nothing))
}

#[test]
fn portable_is_as_loose_as_each_model_that_it_is_made_of() {
    for name in ["wgsl", "vulkan"] {
        let model = Model::named(name).expect("a model");
        for (portable, row) in Model::portable().rows().iter().zip(model.rows()) {
            let place = format!("{name}: {}", row.operation);
            assert!(is_as_loose(portable.f32, row.f32), "{place}: {:?} < {:?}", portable.f32, row.f32);
            assert!(is_as_loose(portable.f16, row.f16), "{place}: {:?} < {:?}", portable.f16, row.f16);
        }
    }
    let rules = Model::portable().rules;
    assert!(rules.subnormal.0 == Subnormal::MayFlush && rules.rounding.0 == Rounding::Either);
    assert!(rules.contraction.0 && rules.reassociation.0 && rules.double.0);
}

#[test]
fn portable_is_no_looser_than_the_looser_one() {
    let of = |name: &str| Model::named(name).expect("a model").rows();
    for (portable, (a, b)) in Model::portable().rows().iter().zip(of("wgsl").iter().zip(of("vulkan"))) {
        let known = |class: &Accuracy| a.f32.contains(class) || b.f32.contains(class);
        assert!(portable.f32.iter().all(known), "{}", portable.operation);
    }
}

#[test]
fn the_loosest_of_all_three_promises_nothing_of_the_arc_tangent() {
    let [_, wgsl, vulkan, hlsl] = Model::all();
    let loosest = super::portable::of("loosest", "", &[wgsl, vulkan, hlsl]);
    for model in [wgsl, vulkan, hlsl] {
        for (loose, row) in loosest.rows().iter().zip(model.rows()) {
            assert!(is_as_loose(loose.f32, row.f32), "{}: {}", model.name, row.operation);
        }
    }
    assert_eq!(loosest.builtin(crate::intrinsics::Intrinsic::Atan), [Accuracy::Nothing]);
}

#[test]
fn one_class_covers_another_only_where_numbers_say_so() {
    let classes = || Model::all().iter().flat_map(Model::rows).flat_map(|row| row.f32).copied();
    for a in classes() {
        for b in classes().filter(|b| a.covers(*b)) {
            assert!(is_as_loose(&[a], &[b]), "{a} does not cover {b}");
        }
    }
}

#[test]
fn every_section_names_its_specification() {
    let begins = [
        ("wgsl", &["WGSL 15.7."][..]),
        ("vulkan", &["Vulkan, "]),
        ("hlsl", &["D3D11.3 ", "HLSL Reference", "no function of HLSL"]),
    ];
    for (name, known) in begins {
        let model = Model::named(name).expect("a model");
        let rules = model.rules;
        let told = [rules.subnormal.1, rules.rounding.1, rules.contraction.1];
        let rules = told.into_iter().chain([rules.reassociation.1, rules.double.1]);
        for section in model.rows().iter().map(|row| row.section).chain(rules) {
            assert!(known.iter().any(|begin| section.starts_with(begin)), "{name}: {section}");
        }
    }
}
