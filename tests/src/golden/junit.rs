//! A check of golden images for CI servers: a suite for each golden, a case for it and for each route.

use super::report::{Item, Report, RouteVerdict};
use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

/// The report as XML.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut xml = quick_junit::Report::new("lobe golden");
    xml.add_test_suites(report.items.iter().map(suite));
    let mut store = TestSuite::new("store");
    for skipped in &report.skipped {
        let mut status = TestCaseStatus::skipped();
        status.set_message(format!("{}; {}", skipped.what, skipped.mend));
        store.add_test_case(TestCase::new(skipped.route.as_str(), status));
    }
    for dead in &report.dead {
        store.add_test_case(TestCase::new(dead.as_str(), failure("no case names this golden")));
    }
    if report.interrupted {
        store.add_test_case(TestCase::new("decisions", failure("a decision was broken off")));
    }
    xml.add_test_suite(store);
    xml.to_string().unwrap_or_else(|e| format!("<!-- the report cannot be written as XML: {e} -->\n"))
}

fn suite(item: &Item) -> TestSuite {
    let mut suite = TestSuite::new(item.name());
    let golden = match item.verdict.holds() {
        true => TestCaseStatus::success(),
        false => failure(&format!("{}: {}", item.verdict.name(), item.why)),
    };
    let routes = item.routes.iter().map(|route| match route.verdict {
        RouteVerdict::Inside => (route.route.as_str(), TestCaseStatus::success()),
        RouteVerdict::Outside | RouteVerdict::Failed => (route.route.as_str(), failure(&route.why)),
        RouteVerdict::Indeterminate => (route.route.as_str(), failure("too many pixels without bound")),
    });
    for (name, status) in std::iter::once(("golden", golden)).chain(routes) {
        let mut case = TestCase::new(name, status);
        case.set_classname(item.name());
        suite.add_test_case(case);
    }
    suite
}

fn failure(why: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message(why.to_owned());
    status
}
