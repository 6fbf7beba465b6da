//! The oracle catches a wrong kernel, a wrong mapping and a wrong table.

use lobe_backends::executor::{Executor, Native};
use lobe_codegen::def::FunctionRef;
use lobe_codegen::prelude::*;
use lobe_tests::oracle::{Mapping, Row, TableReport, judge_table, table};
use lobe_tests::question::Verdict;

/// Squares.
#[kernel]
fn square(x: f32) -> f32 {
    x * x
}

/// Squares, nearly.
#[kernel]
fn nearly_square(x: f32) -> f32 {
    x * x * 1.0001
}

/// Cancels in f32.
#[kernel(variant_of = square, not_robust = "a difference of near values")]
fn square_the_long_way(x: f32) -> f32 {
    (x * x + 1e8) - 1e8
}

/// Cancels in f32, and is nobody's variant.
#[kernel(not_robust = "a difference of near values")]
fn the_only_square(x: f32) -> f32 {
    (x * x + 1e8) - 1e8
}

/// The cosine between directions.
#[kernel]
fn cosine(a: Vec3, b: Vec3) -> f32 {
    dot(a, b)
}

/// The sum of a list's first numbers.
#[kernel]
fn sum_of(list: [f32; 4], count: u32) -> f32 {
    let mut sum = 0.0;
    for i in 0..count {
        sum += list[i as usize];
    }
    sum
}

/// The third axis of a frame.
#[kernel]
fn third(z: Vec3, x: Vec3) -> Vec3 {
    cross(z, x)
}

fn kernel(name: &str) -> Option<FunctionRef> {
    lobe_codegen::kernels![square, nearly_square, square_the_long_way, the_only_square, cosine, sum_of, third]
        .into_iter()
        .find(|k| k().name == name)
}

fn mapping(kernel: &str, args: &str, more: &str) -> Mapping {
    let text = format!(
        r#"{{"version": 1, "entries": [{{"fn": "f", "kind": "formula-f64", "kernel": "{kernel}",
            "args": {args}, "result": {{"": ""}}, "rule": "match"{more}}}]}}"#
    );
    Mapping::parse(&text).unwrap_or_else(|e| panic!("{e}"))
}

fn rows(lines: &[&str]) -> Vec<Row> {
    lines.iter().map(|line| serde_json::from_str(line).expect("a row")).collect()
}

const SQUARES: [&str; 3] = [
    r#"{"fn": "f", "args": {"x": 3}, "kind": "formula-f64", "value": 9, "df32": 1e-6}"#,
    r#"{"fn": "f", "args": {"x": 0}, "kind": "formula-f64", "value": 0}"#,
    r#"{"fn": "f", "args": {"x": 0.5}, "kind": "formula-f64", "value": 0.25, "tag": "a half"}"#,
];

fn judged(mapping: &Mapping, lines: &[&str]) -> TableReport {
    let mut routes: [Box<dyn Executor>; 1] = [Box::new(Native)];
    judge_table(&rows(lines), mapping, &kernel, &mut routes)
}

#[track_caller]
fn assert_short(report: &TableReport, part: &str) {
    let short = report.answers.iter().find_map(|(_, a)| match &a.verdict {
        Verdict::FallsShort(why) => Some(why.clone()),
        Verdict::Holds | Verdict::ExpectedFailure(_) | Verdict::NotAsked(_) => None,
    });
    let why = short.unwrap_or_else(|| panic!("all holds instead of {part}"));
    assert!(why.contains(part), "{why}");
}

#[test]
fn a_right_kernel_holds_in_f64_and_on_the_route() {
    let report = judged(&mapping("square", r#"{"x": "x"}"#, ""), &SQUARES);
    let verdicts: Vec<_> =
        report.answers.iter().map(|(_, a)| (a.subject.as_str(), &a.verdict, a.cases)).collect();
    let holds = &Verdict::Holds;
    assert_eq!(verdicts, [("f (formula-f64), f64", holds, 3), ("f (formula-f64), native", holds, 3)]);
}

#[test]
fn a_wrong_kernel_falls_short_in_both_lanes() {
    let report = judged(&mapping("nearly_square", r#"{"x": "x"}"#, ""), &SQUARES);
    for (_, answer) in &report.answers {
        let Verdict::FallsShort(why) = &answer.verdict else { panic!("{answer:?}") };
        assert!(why.contains("2 of 3 rows"), "{why}");
        assert!(answer.worst.is_some());
    }
}

#[test]
fn a_form_that_is_not_robust_must_be_right_in_f64_only() {
    let line = r#"{"fn": "f", "args": {"x": 3}, "kind": "formula-f64", "value": 9, "df32": 1e-3}"#;
    let report = judged(&mapping("square_the_long_way", r#"{"x": "x"}"#, ""), &[line]);
    let verdicts: Vec<&Verdict> = report.answers.iter().map(|(_, a)| &a.verdict).collect();
    let expected = Verdict::ExpectedFailure("a difference of near values".to_owned());
    assert_eq!(verdicts, [&Verdict::Holds, &expected]);
    assert_short(&judged(&mapping("the_only_square", r#"{"x": "x"}"#, ""), &[line]), "1 of 1 rows");
    let wrong = r#"{"fn": "f", "args": {"x": 3}, "kind": "formula-f64", "value": 10}"#;
    assert_short(&judged(&mapping("square_the_long_way", r#"{"x": "x"}"#, ""), &[wrong]), "1 of 1 rows");
}

#[test]
fn vectors_are_normalised_before_they_are_exact() {
    let line = r#"{"fn": "f", "args": {"a": [0.6, 0.0, 0.80000001], "b": [0, 0, 2]}, "kind": "formula-f64",
        "value": 0.800000003599999967}"#;
    let report = judged(&mapping("cosine", r#"{"a": {"unit": "a"}, "b": {"unit": "b"}}"#, ""), &[line]);
    assert!(report.answers.iter().all(|(_, a)| a.verdict == Verdict::Holds), "{report:?}");
    let report = judged(&mapping("cosine", r#"{"a": "a", "b": {"unit": "b"}}"#, ""), &[line]);
    assert_short(&report, "farther off than permitted");
}

#[test]
fn slack_belongs_to_its_lane() {
    let more = r#", "slack": [{"lane": "f32", "factor": 1e-3, "of": "value", "why": "a test"}]"#;
    let report = judged(&mapping("nearly_square", r#"{"x": "x"}"#, more), &SQUARES);
    let verdicts: Vec<bool> = report.answers.iter().map(|(_, a)| a.falls_short()).collect();
    assert_eq!(verdicts, [true, false]);
}

#[test]
fn a_mapping_that_does_not_fit_says_where() {
    for (kernel, args, part) in [
        ("square", r#"{}"#, "feeds `x` of square 0 times"),
        ("square", r#"{"x": "y"}"#, "it has no `y`"),
        ("square", r#"{"x": "x", "z": 1}"#, "`z`, which square does not take"),
        ("cosine", r#"{"a": "x", "b": {"unit": "x"}}"#, "`a` has 3 scalars, 1 are given"),
        ("missing", r#"{"x": "x"}"#, "there is no kernel `missing`"),
    ] {
        assert_short(&judged(&mapping(kernel, args, ""), &SQUARES), part);
    }
}

#[test]
fn rows_that_no_entry_speaks_of_are_counted() {
    let more = r#"{"fn": "g", "args": {}, "kind": "exact-integral", "variant": "v", "value": 1}"#;
    let mut lines = SQUARES.to_vec();
    lines.extend([more, more]);
    let report = judged(&mapping("square", r#"{"x": "x"}"#, ""), &lines);
    assert_eq!(report.unmapped.into_iter().collect::<Vec<_>>(), [("g (exact-integral, v)".to_owned(), 2)]);
}

#[test]
fn rows_are_passed_over_as_stated_and_none_left_is_no_success() {
    let more = r#", "skip": [{"tag": "half", "why": "a test"}]"#;
    let report = judged(&mapping("square", r#"{"x": "x"}"#, more), &SQUARES);
    assert!(report.answers.iter().all(|(_, a)| a.cases == 2));
    assert_short(&judged(&mapping("square", r#"{"x": "x"}"#, more), &SQUARES[2..]), "holds no row");
    let more = r#", "skip": [{"args": {"x": 3}, "why": "a test"}, {"args": {"x": 0}, "tag": "half", "why": "both"}]"#;
    let report = judged(&mapping("square", r#"{"x": "x"}"#, more), &SQUARES);
    assert!(report.answers.iter().all(|(_, a)| a.cases == 2));
    let null = r#"{"fn": "f", "args": {"x": 3}, "kind": "formula-f64", "value": null}"#;
    assert_short(&judged(&mapping("square", r#"{"x": "x"}"#, ""), &[null]), "no row has a value");
}

#[test]
fn lists_are_filled_up_and_counted() {
    let args = r#"{"list": {"padded": "items"}, "count": {"count": "items"}}"#;
    let line = |items: &str, value: f32| {
        format!(r#"{{"fn": "f", "args": {{"items": {items}}}, "kind": "formula-f64", "value": {value}}}"#)
    };
    let holds = |items, value| {
        let report = judged(&mapping("sum_of", args, ""), &[&line(items, value)]);
        report.answers.iter().all(|(_, a)| a.verdict == Verdict::Holds)
    };
    assert!(holds("[1, 2]", 3.0) && holds("[1, 2, 3, 4]", 10.0) && holds("[]", 0.0) && !holds("[1, 2]", 4.0));
    assert_short(
        &judged(&mapping("sum_of", args, ""), &[&line("[1, 2, 3, 4, 5]", 0.0)]),
        "does not fit into 4",
    );
    assert_short(&judged(&mapping("sum_of", args, ""), &[&line("7", 0.0)]), "`items` is no list");
}

#[test]
fn frames_are_made_orthonormal_and_a_free_sign_is_free() {
    let args = r#"{"z": {"unit": "z"}, "x": {"normal_to": ["x", "z"]}}"#;
    let line = |y: &str| {
        let frame = r#""z": [0, 0, 2], "x": [1, 0, 0.5]"#;
        format!(r#"{{"fn": "f", "args": {{{frame}}}, "kind": "formula-f64", "value": {y}}}"#)
    };
    let falls_short = |y: &str, more: &str| {
        judged(&mapping("third", args, more), &[&line(y)]).answers.iter().any(|(_, a)| a.falls_short())
    };
    let free = r#", "free_sign": [""]"#;
    assert!(!falls_short("[0, 1, 0]", "") && falls_short("[0, -1, 0]", ""));
    assert!(!falls_short("[0, -1, 0]", free) && falls_short("[1, 0, 0]", free));
}

#[test]
fn a_row_may_leave_out_what_it_has_no_value_for() {
    let text = |member: &str| {
        format!(
            r#"{{"version": 1, "entries": [{{"fn": "f", "kind": "formula-f64", "kernel": "square",
            "args": {{"x": "x"}}, "result": {{"": "{member}"}}, "rule": "match"}}]}}"#
        )
    };
    let parsed = |member| Mapping::parse(&text(member)).unwrap_or_else(|e| panic!("{e}"));
    let lines = [
        r#"{"fn": "f", "args": {"x": 3}, "kind": "formula-f64", "value": {"all": 9, "some": 9}}"#,
        r#"{"fn": "f", "args": {"x": 2}, "kind": "formula-f64", "value": {"all": 4}}"#,
    ];
    let cases =
        |member| judged(&parsed(member), &lines).answers.iter().map(|(_, a)| a.cases).collect::<Vec<_>>();
    assert_eq!((cases("all"), cases("some")), (vec![2, 2], vec![1, 1]));
    assert_short(&judged(&parsed("none"), &lines), "no row has a value for `none`");
}

#[test]
fn parts_of_the_result_are_passed_over_as_stated() {
    let skip = r#", "skip": [{"between": {"x": [2, 3]}, "parts": [""], "why": "a test"}]"#;
    let report = judged(&mapping("nearly_square", r#"{"x": "x"}"#, skip), &SQUARES);
    assert!(report.answers.iter().all(|(_, a)| a.cases == 2), "the row of 3 has no other part");
    let slack = r#", "slack": [{"lane": "both", "factor": 1e-3, "of": ["x", "x"], "why": "a test"}]"#;
    let report = judged(&mapping("nearly_square", r#"{"x": "x"}"#, slack), &SQUARES);
    assert!(report.answers.iter().all(|(_, a)| !a.falls_short()));
}

#[test]
fn ratios_lie_in_the_stated_quantiles() {
    let text = |low: f64, high: f64| {
        format!(
            r#"{{"version": 1, "entries": [{{"fn": "f", "kind": "formula-f64", "kernel": "nearly_square",
            "args": {{"x": "x"}}, "result": {{"": ""}}, "rule": "distribution",
            "quantiles": [{{"share": 0.5, "low": {low}, "high": {high}}}]}}]}}"#
        )
    };
    let parsed = |low, high| Mapping::parse(&text(low, high)).unwrap_or_else(|e| panic!("{e}"));
    let report = judged(&parsed(1.00005, 1.00015), &SQUARES);
    assert!(report.answers.iter().all(|(_, a)| !a.falls_short() && a.subject.contains("50 % 1.0001")));
    assert_short(&judged(&parsed(0.9, 1.0), &SQUARES), "are up to 1.0001");
}

#[test]
fn a_table_that_cannot_be_used_names_file_line_and_column() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("f.jsonl");
    std::fs::write(&path, format!("{}\n{{\"fn\": \"f\", oops\n", SQUARES[0])).expect("writable");
    let message = table::read(&path).expect_err("malformed").to_string();
    assert!(message.contains("f.jsonl:2:13"), "{message}");
    std::fs::write(&path, "\n").expect("writable");
    assert!(table::read(&path).expect_err("empty").to_string().contains("holds no rows"));
    let nowhere = folder.path().join("nowhere");
    assert!(table::list(&nowhere).expect_err("missing").to_string().contains("cannot be read"));
    assert!(table::list(folder.path()).is_ok());
}

#[test]
fn a_mapping_of_another_version_is_refused() {
    let message =
        Mapping::parse(r#"{"version": 2, "entries": []}"#).expect_err("another version").to_string();
    assert!(message.contains("version is 2"), "{message}");
    assert!(Mapping::parse("{").is_err());
}
