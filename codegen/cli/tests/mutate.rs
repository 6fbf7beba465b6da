//! `lobe mutate` as its users meet it.

mod common;

use common::{assert_fails, assert_holds, lobe, text};
use serde_json::Value;

#[test]
fn faults_are_told_with_their_places_and_counted() {
    let said = assert_holds(&lobe(&["mutate", "hsg_integral", "--equivalence", "0"]));
    assert!(said.starts_with("hsg_integral   ") && said.contains("by the bound"), "{said}");
    let said = assert_holds(&lobe(&["mutate", "hsg_integral", "--equivalence", "0", "--format", "json"]));
    let report: Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!((&report["schema"], &report["report"]), (&1.into(), &"mutate".into()));
    let faults = report["kernels"][0]["faults"].as_array().expect("faults");
    let of_bound = faults.iter().filter(|f| f["outcome"] == "outside-bound").count();
    assert_eq!(report["kernels"][0]["count"]["by_bound"], of_bound);
    for fault in faults {
        let place = fault["place"].as_str();
        let is_text = fault["kind"].as_str().is_some_and(|k| k == "last-digit" || k == "text-operator");
        assert!(is_text || place.is_some_and(|p| p.contains(".rs:")), "{fault}");
    }
}

#[test]
fn time_that_is_over_is_said() {
    let output = lobe(&["mutate", "hsg_integral", "--limit", "0"]);
    assert!(text(&output.stdout).contains("not tried"), "{}", text(&output.stdout));
}

#[test]
fn an_unknown_kernel_is_refused() {
    assert_fails(&lobe(&["mutate", "hsg_integrals"]), 2, &["hsg_integral"]);
}
