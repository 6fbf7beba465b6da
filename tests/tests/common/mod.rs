//! Executors and plans that several tests share.
#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod browser;
pub(crate) mod site;

use lobe_backends::executor::{ExecError, Executor, Interp, Native, Program};
use lobe_backends::route::Route;
use lobe_backends::translate::TranslateError;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_tests::cases::Cases;
use lobe_tests::judge::{Plan, judge};
use lobe_tests::oracle::Mapping;
use lobe_tests::question::{Answer, Question};
use lobe_tests::report::KernelReport;

/// A plan without files: nothing listed, no table mapped.
pub(crate) fn plan(inputs: usize) -> Plan {
    let mapping = Mapping::parse(r#"{"version": 1, "entries": []}"#).expect("a mapping");
    Plan {
        inputs,
        seed: 7,
        cases: Cases::at("no-such-folder"),
        mapping,
        sanitize: false,
        accuracy: Model::portable(),
        drivers: 0,
        search: None,
        expected: Vec::new(),
    }
}

/// The report on `kernel`, native and interpreted.
pub(crate) fn check(kernel: FunctionRef) -> KernelReport {
    check_on(kernel, &mut [Box::new(Native), Box::new(Interp)])
}

/// The report on `kernel`.
pub(crate) fn check_on(kernel: FunctionRef, routes: &mut [Box<dyn Executor>]) -> KernelReport {
    check_by(kernel, &plan(1000), routes)
}

/// The report on `kernel`, as planned.
pub(crate) fn check_by(kernel: FunctionRef, plan: &Plan, routes: &mut [Box<dyn Executor>]) -> KernelReport {
    judge(kernel, plan, routes, &|_| {})
}

/// The first answer to `question`.
#[track_caller]
pub(crate) fn answer(report: &KernelReport, question: Question) -> &Answer {
    let found = report.answers.iter().find(|a| a.question == question);
    found.unwrap_or_else(|| panic!("no answer to {}: {report:?}", question.name()))
}

/// Runs natively under another name, and lets `spoil` change the results.
pub(crate) struct Spoilt {
    pub(crate) route: Route,
    pub(crate) spoil: fn(&mut Columns),
    /// What its driver says of itself.
    pub(crate) driver: &'static str,
}

impl Executor for Spoilt {
    fn route(&self) -> &Route {
        &self.route
    }

    fn driver_info(&self) -> &str {
        self.driver
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        let mut output = Native.run(kernel, args)?;
        (self.spoil)(&mut output);
        Ok(output)
    }
}

/// A tool, or that it is not here.
#[track_caller]
pub(crate) fn tool<T>(found: Result<T, TranslateError>) -> Option<T> {
    match found {
        Ok(found) => Some(found),
        Err(TranslateError::NotFound { tool, mend, .. }) => {
            skip(tool, mend);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Says aloud, past libtest's capture, that something was left out; under `LOBE_REQUIRE_TOOLS` it fails.
#[track_caller]
pub(crate) fn skip(what: &str, mend: &str) {
    assert!(std::env::var_os("LOBE_REQUIRE_TOOLS").is_none(), "{what} is missing: {mend}");
    say(&format!("{what} is missing: {mend}"));
}

/// Says aloud, past libtest's capture, that something was left out.
pub(crate) fn say(what: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stderr(), "SKIPPED: {what}");
}
