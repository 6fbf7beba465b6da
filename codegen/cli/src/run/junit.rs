//! Reports of runs for CI servers: a suite for each entry point, a case for the program and for each route.

use super::text;
use lobe_tests::shader::report::{Report, RouteReport, RouteStatus, Status};
use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

/// All reports as XML.
pub(super) fn render(reports: &[Report]) -> String {
    let mut xml = quick_junit::Report::new("lobe run");
    xml.add_test_suites(reports.iter().map(suite));
    xml.to_string().unwrap_or_else(|e| format!("<!-- the report cannot be written as XML: {e} -->\n"))
}

fn suite(report: &Report) -> TestSuite {
    let subject = report.subject();
    let mut suite = TestSuite::new(subject.as_str());
    let cases = std::iter::once(("interp", program(report)));
    let cases = cases.chain(report.routes.iter().map(|route| (route.route.as_str(), of_route(route))));
    for (name, status) in cases {
        let mut case = TestCase::new(name, status);
        case.set_classname(subject.as_str());
        suite.add_test_case(case);
    }
    suite
}

/// The program itself: whether it ran on the interpreter, and made no mistake.
fn program(report: &Report) -> TestCaseStatus {
    let mistakes: Vec<String> = report.findings.iter().map(text::mistake).collect();
    let is_fine = report.message.is_none() && (mistakes.is_empty() || report.status != Status::Findings);
    if is_fine {
        return TestCaseStatus::success();
    }
    let message = report.message.iter().cloned().chain(mistakes).collect::<Vec<_>>().join("; ");
    failure(format!("{}: {message}", report.status.name()))
}

fn of_route(route: &RouteReport) -> TestCaseStatus {
    let buffers: Vec<String> = route.buffers.iter().map(text::buffer).collect();
    let found =
        || route.message.iter().cloned().chain(buffers.iter().cloned()).collect::<Vec<_>>().join("; ");
    match (&route.expected, route.status) {
        (Some(reason), status) => skipped(format!("{}, as expected: {reason}", status.name())),
        (None, RouteStatus::Equal | RouteStatus::Within) => TestCaseStatus::success(),
        (None, RouteStatus::Refused) => skipped(format!("refused: {}", found())),
        (None, status) => failure(format!("{}: {}", status.name(), found())),
    }
}

fn skipped(message: String) -> TestCaseStatus {
    let mut status = TestCaseStatus::skipped();
    status.set_message(message);
    status
}

fn failure(message: String) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(message);
    status
}
