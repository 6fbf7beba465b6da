//! `lobe run --check`: a shader on many inputs, by every route and by drivers drawn by chance, as one report.
//!
//! Each input is a [`Job`] of its own, so that one on which a driver crashes costs no other; [`gather`] makes the reports
//! of all inputs the answers to the questions that kernels are asked.

mod answers;

use super::entry::READY;
use super::feed::Feed;
use super::job::Job;
use super::report::Report;
use crate::question::expected::Expected;
use crate::report::KernelReport;
use answers::Answers;

/// How much is checked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// Inputs: drawn, on the edges of their types, zeros, and so on in turns.
    pub inputs: u64,
    /// Drivers drawn by chance, for each input.
    pub drivers: u64,
    /// Where the drawing begins.
    pub seed: u64,
}

/// The runs that a check of `job` takes: what the user says of a resource stays, all else is drawn.
#[must_use]
pub fn runs(job: &Job, extent: Extent) -> Vec<Job> {
    let run = |n: u64| {
        let seed = extent.seed.wrapping_add(n);
        let usual = match n {
            2 => Feed::Zeros,
            n if n % 2 == 1 => Feed::Edges(seed),
            _ => Feed::Random(seed),
        };
        let mut routes = if job.routes.is_empty() { vec![READY.to_owned()] } else { job.routes.clone() };
        let first = seed.wrapping_mul(extent.drivers);
        routes.extend((0..extent.drivers).map(|n| format!("perturbed:{}", first.wrapping_add(n))));
        // One input may show a fault that another does not, so what is expected is asked of all together.
        Job { usual, routes, sanitize: true, check: true, expected: Vec::new(), ..job.clone() }
    };
    (0..extent.inputs).map(run).collect()
}

/// What the `runs` of `job` came to, an entry point each.
#[must_use]
pub fn gather(job: &Job, runs: &[(&Job, &[Report])]) -> Vec<KernelReport> {
    let reports = || runs.iter().flat_map(|(run, reports)| reports.iter().map(move |report| (*run, report)));
    let mut subjects: Vec<String> = Vec::new();
    for (_, report) in reports() {
        let name = report.subject();
        if !subjects.contains(&name) {
            subjects.push(name);
        }
    }
    let one = |name: String| {
        let of_it: Vec<(&Job, &Report)> = reports().filter(|(_, report)| report.subject() == name).collect();
        let drivers = of_it.iter().flat_map(|(_, report)| &report.routes);
        let drivers = drivers.map(|route| (route.route.clone(), route.driver.clone())).collect();
        let expected = Expected::new(&job.stem(), &job.expected, drivers);
        let mut answers = Answers::default();
        of_it.iter().for_each(|(run, report)| answers.take(run, report));
        let answers = answers.finish(&expected);
        KernelReport { inputs: of_it.len(), answers, ..KernelReport::unknown(&name) }
    };
    subjects.into_iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expectation::{Expectation, Fault};
    use crate::question::{Answer, Question, Verdict};
    use crate::report::human::worst_line;
    use crate::shader::compare::{Compared, Difference, Standing};
    use crate::shader::job::Entry;
    use crate::shader::report::{Agreement, Mistake, Outputs, RouteReport, RouteStatus, Status};

    const ROUTE: &str = "spirv@card";

    fn job() -> Job {
        Job {
            workgroups: [4, 1, 1],
            inputs: vec![("scale".to_owned(), Feed::File("scale.bin".into()))],
            ..Job::new("a dir/blur.wgsl".into(), Entry::Only)
        }
    }

    fn compared(standing: Standing, share: f64) -> Compared {
        let first = Difference {
            path: "out[3]".to_owned(),
            interp: "0x1p0".to_owned(),
            found: "0x1.8p0".to_owned(),
            ulp: Some(4_194_304),
            bound: Some(0.25),
        };
        let buffer = "out".to_owned();
        Compared {
            buffer,
            standing,
            scalars: 64,
            differing: 1,
            max_ulp: 4_194_304,
            share,
            first: Some(first),
        }
    }

    /// It is known of such a driver.
    fn fault(driver: &str) -> Expectation {
        Expectation {
            subject: "blur".to_owned(),
            route: ROUTE.to_owned(),
            driver: Some(driver.to_owned()),
            fails: Fault::Beyond,
            reason: "it blurs".to_owned(),
            link: None,
        }
    }

    /// A report in which one route left this.
    fn report(route: RouteReport) -> Report {
        let mut report =
            Report::of("a dir/blur.wgsl".to_owned(), Some("main".to_owned()), Status::Ok, String::new());
        report.message = None;
        report.outputs = Some(Outputs { scalars: 64, indeterminate: 2 });
        report.add(RouteReport { driver: "Card 25.0".to_owned(), ..route });
        report
    }

    fn left(standing: Standing, share: f64) -> Report {
        report(RouteReport::compared(ROUTE, vec![compared(standing, share)]))
    }

    fn gathered(job: &Job, reports: Vec<Report>) -> KernelReport {
        let runs = runs(job, Extent { inputs: reports.len() as u64, drivers: 1, seed: 5 });
        let reports: Vec<[Report; 1]> = reports.into_iter().map(|report| [report]).collect();
        let pairs: Vec<(&Job, &[Report])> = runs.iter().zip(&reports).map(|(run, r)| (run, &r[..])).collect();
        let [of_entry] = &gather(job, &pairs)[..] else { panic!("one entry point") };
        of_entry.clone()
    }

    #[track_caller]
    fn answer<'r>(report: &'r KernelReport, question: Question, subject: &str) -> &'r Answer {
        let found = report.answers.iter().find(|a| a.question == question && a.subject == subject);
        found.unwrap_or_else(|| panic!("no answer of {subject}: {report:#?}"))
    }

    #[test]
    fn inputs_take_turns_and_keep_what_the_user_says() {
        let job = Job { expected: vec![fault("")], ..job() };
        let runs = runs(&job, Extent { inputs: 5, drivers: 2, seed: 7 });
        let usual: Vec<String> = runs.iter().map(|run| run.usual.to_string()).collect();
        assert_eq!(usual, ["random:7", "edges:8", "zeros", "edges:10", "random:11"]);
        assert_eq!(runs[1].routes, ["ready", "perturbed:16", "perturbed:17"]);
        assert!(runs.iter().all(|run| run.inputs == job.inputs && run.sanitize && run.check));
        assert!(runs.iter().all(|run| run.expected.is_empty()), "it is asked of all together");
    }

    #[test]
    fn the_worst_input_is_kept_with_its_command() {
        let reports =
            [left(Standing::Within, 0.5), left(Standing::Beyond, 2.0), left(Standing::Within, 0.75)];
        let report = gathered(&job(), reports.to_vec());
        assert_eq!((report.name.as_str(), report.inputs), ("a dir/blur.wgsl main", 3));
        let conformant = answer(&report, Question::Conformant, ROUTE);
        let why = "beyond the bound on 1 of 3 inputs".to_owned();
        assert_eq!((&conformant.verdict, conformant.cases), (&Verdict::FallsShort(why), 192));
        assert_eq!((conformant.share, conformant.absolute), (2.0, 0.5));
        let line = worst_line(&report.name, conformant.worst.as_ref().expect("an input"));
        let command = "lobe run 'a dir/blur.wgsl' --workgroups 4,1,1 --input scale=scale.bin --fill edges:6 \
                       --route spirv@card";
        assert!(line.starts_with("out[3] is 1.5") && line.ends_with(command), "{line}");
        let robust = answer(&report, Question::Robust, "");
        assert_eq!((robust.cases, robust.indeterminate), (192, 6));
    }

    #[test]
    fn what_is_expected_is_asked_of_all_inputs_together() {
        let verdict = |driver: &str, share: f64| {
            let standing = if share > 1.0 { Standing::Beyond } else { Standing::Within };
            let job = Job { expected: vec![fault(driver)], ..job() };
            let report = gathered(&job, vec![left(Standing::Within, 0.5), left(standing, share)]);
            answer(&report, Question::Conformant, ROUTE).verdict.clone()
        };
        assert_eq!(verdict("25.0", 2.0), Verdict::ExpectedFailure("it blurs".to_owned()));
        assert!(matches!(verdict("25.0", 0.5), Verdict::FallsShort(why) if why.contains("has to go")));
        assert!(matches!(verdict("25.1", 2.0), Verdict::FallsShort(why) if why.contains("1 of 2 inputs")));
    }

    #[test]
    fn what_has_no_results_says_why() {
        let without = |status| report(RouteReport::without(ROUTE, status, "the driver is gone".to_owned()));
        let verdict = |status| {
            let report = gathered(&job(), vec![left(Standing::Equal, 0.0), without(status)]);
            answer(&report, Question::Conformant, ROUTE).verdict.clone()
        };
        let crashed = verdict(RouteStatus::Crashed);
        let Verdict::FallsShort(why) = &crashed else { panic!("{crashed:?}") };
        assert!(
            why.contains("crashed on 1 of 2 inputs: the driver is gone; lobe run ")
                && why.contains("edges:6")
        );
        assert!(matches!(verdict(RouteStatus::Timeout), Verdict::FallsShort(_)));
        assert!(matches!(verdict(RouteStatus::Refused), Verdict::NotAsked(_)));
        let late = Report::of("blur.wgsl".to_owned(), None, Status::Timeout, "interp: not done".to_owned());
        let report = gathered(&job(), vec![late]);
        let interp = answer(&report, Question::Conformant, "interp");
        assert!(
            matches!(&interp.verdict, Verdict::FallsShort(why) if why.contains("timeout on 1 of 1 inputs"))
        );
    }

    #[test]
    fn findings_and_disagreements_are_answers() {
        let mut found = left(Standing::Equal, 0.0);
        let mistake = Mistake { kind: "Race".to_owned(), at: Some((3, 5)), message: "two write".to_owned() };
        found.findings = vec![mistake.clone(), mistake];
        let differing = vec![("wgsl+naga@card".to_owned(), compared(Standing::Beyond, 0.0))];
        let routes = vec![ROUTE.to_owned(), "wgsl+naga@card".to_owned()];
        found.agreements = vec![Agreement { driver: "card".to_owned(), routes, differing }];
        let report = gathered(&job(), vec![found.clone()]);
        let sanitized = &answer(&report, Question::Robust, "sanitized").verdict;
        let Verdict::FallsShort(why) = sanitized else { panic!("{sanitized:?}") };
        assert!(why.starts_with("Race at 3:5: two write; lobe run ") && why.contains("--sanitize"), "{why}");
        let agree = &answer(&report, Question::Agree, "2 routes @card").verdict;
        assert!(
            matches!(agree, Verdict::FallsShort(why) if why.contains("differs from spirv@card")),
            "{agree:?}"
        );
        // Routes that are within the bound may differ.
        found.add(RouteReport::compared("wgsl+naga@card", vec![compared(Standing::Within, 0.5)]));
        let report = gathered(&job(), vec![found]);
        let agree = &answer(&report, Question::Agree, "2 routes @card").verdict;
        assert!(
            matches!(agree, Verdict::NotAsked(why) if why.ends_with("both within the bound")),
            "{agree:?}"
        );
    }
}
