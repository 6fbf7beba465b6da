//! The report as JUnit XML: a suite for each kernel, a case for each answer.

use super::{KernelReport, Report};
use crate::question::{Answer, Verdict};
use quick_junit::{NonSuccessKind, TestCase, TestCaseStatus, TestSuite};

/// The report as XML.
#[must_use]
pub fn render(report: &Report) -> String {
    let mut xml = quick_junit::Report::new("lobe");
    xml.add_test_suites(report.kernels.iter().map(suite));
    if !report.skipped.is_empty() {
        let mut suite = TestSuite::new("routes");
        for skipped in &report.skipped {
            let mut status = TestCaseStatus::skipped();
            status.set_message(format!("{}; {}", skipped.what, skipped.mend));
            suite.add_test_case(TestCase::new(skipped.route.as_str(), status));
        }
        xml.add_test_suite(suite);
    }
    if !report.missing.is_empty() {
        let mut suite = TestSuite::new("parts");
        for part in &report.missing {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
            status.set_message("no report of it is there");
            suite.add_test_case(TestCase::new(part.as_str(), status));
        }
        xml.add_test_suite(suite);
    }
    xml.to_string().unwrap_or_else(|e| format!("<!-- the report cannot be written as XML: {e} -->\n"))
}

fn suite(kernel: &KernelReport) -> TestSuite {
    let mut suite = TestSuite::new(kernel.name.as_str());
    suite.add_test_cases(kernel.answers.iter().map(|answer| case(kernel, answer)));
    suite
}

fn case(kernel: &KernelReport, answer: &Answer) -> TestCase {
    let status = match &answer.verdict {
        Verdict::Holds => TestCaseStatus::success(),
        Verdict::FallsShort(why) => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_message(why.clone());
            if let Some(worst) = &answer.worst {
                status.set_description(super::human::worst_line(&kernel.name, worst));
            }
            status
        }
        Verdict::ExpectedFailure(why) | Verdict::NotAsked(why) => {
            let mut status = TestCaseStatus::skipped();
            status.set_message(why.clone());
            status
        }
    };
    let name = format!("{} {}", answer.question.name(), answer.subject);
    let mut case = TestCase::new(name.trim_end(), status);
    case.set_classname(kernel.name.as_str());
    case
}
