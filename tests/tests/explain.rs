//! Explanations: the operation that is at fault is named, and none where none is.

mod common;

use common::skip;
use lobe_backends::executor::trace::{self, Trace, buffers, finish};
use lobe_backends::executor::{ExecError, Executor, Interp, Program};
use lobe_backends::interp::Interpreter;
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, State};
use lobe_codegen::data::Columns;
use lobe_codegen::def::{FunctionRef, Scalar};
use lobe_codegen::emit::{Options, Target, emit};
use lobe_codegen::prelude::*;
use lobe_codegen::trace::Traced;
use lobe_codegen::validate::foreign_wgsl;
use lobe_kernels::registry::KERNELS;
use lobe_kernels::special::expm1_over_x_higham;
use lobe_tests::domain::Inputs;
use lobe_tests::explain::{ExplainError, Explanation, explain};
use lobe_tests::subject::Subject;
use lobe_tests::value::parse_rows;

/// A permitted driver that errs by chance.
struct Perturbed(u64);

impl Executor for Perturbed {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        kernel.perturbed(args, self.0)
    }

    fn trace(&mut self, _: &Program, traced: &Traced, args: &Columns) -> Result<Trace, ExecError> {
        Ok(trace::perturbed(traced, args, self.0).expect("it runs"))
    }
}

/// The interpreter, given the emitted WGSL with `from` in place of `to`.
struct Altered {
    from: &'static str,
    to: &'static str,
}

impl Executor for Altered {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        Interp.run(kernel, args)
    }

    fn trace(&mut self, _: &Program, traced: &Traced, args: &Columns) -> Result<Trace, ExecError> {
        let artifact = emit(&traced.module, Target::Wgsl, &Options::default()).expect("WGSL");
        let text = artifact.content.text().expect("text");
        assert_eq!(text.matches(self.from).count(), 1, "`{}` is not there once:\n{text}", self.from);
        let module = foreign_wgsl(&text.replace(self.from, self.to)).expect("a module");
        let mut buffers = buffers(traced, args);
        Interpreter::new(&module).and_then(|i| i.run(0, [1, 1, 1], &mut buffers)).expect("it runs");
        Ok(finish(traced, &buffers))
    }
}

fn explained(kernel: FunctionRef, route: &mut dyn Executor, row: &str) -> Explanation {
    let row = parse_rows(kernel(), row).expect("a row");
    explain(&Subject::new(kernel).expect("a kernel"), route, &row).expect("an explanation")
}

/// The Rust text of the operation that does most to the result.
fn culprit(found: &Explanation) -> &str {
    found.shares.first().and_then(|step| step.rust.as_deref()).unwrap_or_default()
}

/// Where `log(u)` is far from its own rule's best and `u - 1` is exact.
const NEAR_ZERO: [&str; 3] = [r#"{"x": 0.0012}"#, r#"{"x": 0.00031}"#, r#"{"x": -0.0007}"#];

#[test]
fn higham_s_logarithm_is_named_on_a_driver_that_errs_by_chance() {
    let [kernel] = lobe_codegen::kernels![expm1_over_x_higham];
    let mut over = 0;
    for seed in 0..20 {
        for row in NEAR_ZERO {
            let found = explained(kernel, &mut Perturbed(seed), row);
            assert!(found.broken.is_none() && found.outside.is_none(), "seed {seed}: {found:#?}");
            // Chance may make a good logarithm, too.
            if found.results[0].budget.is_some_and(|budget| found.results[0].error.abs() <= budget) {
                continue;
            }
            over += 1;
            assert_eq!(culprit(&found), "log(u)", "seed {seed}: {found:#?}");
            let step = &found.shares[0];
            assert!(step.place.as_ref().is_some_and(|p| p.contains("special.rs")));
            assert!(step.rule.starts_with("absolute 4.76837158203125e-7"), "{}", step.rule);
            assert!(
                step.lines.len() == 4 && step.lines.iter().all(|l| l.text.to_lowercase().contains("log"))
            );
        }
    }
    assert!(over > 20, "only {over} of 60 results are over their budget");
}

#[test]
fn higham_s_logarithm_is_named_on_every_driver() {
    let [kernel] = lobe_codegen::kernels![expm1_over_x_higham];
    let machine = Machine::look();
    for (route, state) in machine.routes() {
        let Route::Gpu { .. } = route else { continue };
        if let State::Missing { what, mend } = state {
            skip(&format!("{route} ({what})"), &mend);
            continue;
        }
        let mut executor = machine.open(&route).expect("a route");
        for row in NEAR_ZERO {
            let found = explained(kernel, executor.as_mut(), row);
            assert_eq!(culprit(&found), "log(u)", "{route}: {found:#?}");
            assert!(found.holds(), "{route}: {found:#?}");
        }
    }
}

/// A call, a loop, a vector and a decision.
#[kernel(domain(v = 0.5..=2.0, n = 1.0..=4.0))]
fn medley(v: Vec3, n: u32) -> f32 {
    let mut sum = halved(v.x) - 0.25;
    let mut i = 0u32;
    while i < n {
        sum += sin(v.y) * 0.37;
        i += 1;
    }
    if v.z > 1.0 {
        sum /= v.z;
    }
    sum
}

#[kernel]
fn halved(x: f32) -> f32 {
    x * 0.5
}

const ROW: &str = r#"{"v": [0.75, 1.25, 1.5], "n": 3}"#;

#[track_caller]
fn names(from: &'static str, to: &'static str, operation: &str) {
    let [kernel] = lobe_codegen::kernels![medley];
    let found = explained(kernel, &mut Altered { from, to }, ROW);
    let step = found.broken.as_ref().unwrap_or_else(|| panic!("nothing breaks its rule: {found:#?}"));
    assert_eq!((step.rust.as_deref(), step.execution), (Some(operation), 1), "{found:#?}");
    assert!(!found.holds());
}

#[test]
fn an_altered_operation_is_named() {
    names("x * 0.5f;", "x * 0.50001f;", "x * 0.5");
    names("sin(", "cos(", "sin(v.y)");
    names("- 0.25f;", "+ 0.25f;", "halved(v.x) - 0.25");
    names("* 0.37f;", "* 0.3700001f;", "sin(v.y) * 0.37");
    names("> 1f;", "< 1f;", "v.z > 1.0");
}

#[test]
fn what_is_not_altered_breaks_nothing() {
    let [kernel] = lobe_codegen::kernels![medley];
    let found = explained(kernel, &mut Altered { from: "0.37", to: "0.37" }, ROW);
    assert!(found.holds() && found.same_bits, "{found:#?}");
    assert_eq!(found.results[0].error.abs() < 1e-6, found.holds());
}

/// Every kernel keeps the rules on the interpreter, and on drivers that err by chance within them.
#[test]
fn nothing_is_named_where_the_rules_are_kept() {
    for &kernel in KERNELS {
        let subject = Subject::new(kernel).expect("a kernel");
        let inputs = Inputs::draw(kernel(), 2, 11, &Columns::zeros(subject.program().params().len(), 0));
        let args = inputs.expect("inputs").args;
        for row in 0..args.rows {
            let row = args.slice(row..row + 1);
            let mut routes: [Box<dyn Executor>; 2] = [Box::new(Interp), Box::new(Perturbed(3))];
            for route in &mut routes {
                match explain(&subject, route.as_mut(), &row) {
                    Ok(found) => {
                        let fault = (&found.broken, &found.outside);
                        assert!(fault == (&None, &None), "{}: {:#?}", kernel().name, fault);
                    }
                    Err(ExplainError::NoFloat { .. }) => {
                        let mut results = subject.program().results().iter();
                        assert!(results.all(|leaf| leaf.scalar != Scalar::F32), "{}", kernel().name);
                    }
                    Err(error) => panic!("{}: {error}", kernel().name),
                }
            }
        }
    }
}
