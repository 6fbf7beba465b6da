//! `lobe bench` as its users meet it. What it measures is no matter here, only what it says of it.

mod common;

use common::{assert_fails, assert_holds, lobe};
use serde_json::Value;

const SCENE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases/scenes/plates_a010.json");
const QUICK: [&str; 9] =
    ["bench", "--items", "1000", "--rounds", "3", "--route", "native", "--route", "interp"];

fn measured(rest: &[&str]) -> Vec<Value> {
    let said = assert_holds(&lobe(&[&QUICK[..], &["--format", "json"], rest].concat()));
    said.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

#[test]
fn each_measurement_is_an_object_with_the_ratios_to_the_others() {
    let all = measured(&["triad", "lights"]);
    let kernels: Vec<_> = all.iter().map(|m| m["kernel"].as_str().unwrap_or_default()).collect();
    let half = kernels.len() / 2;
    assert!(kernels[..half].iter().all(|k| *k == "lights") && kernels[half..].iter().all(|k| *k == "triad"));
    for measurement in &all {
        assert_eq!(
            (&measurement["items"], &measurement["rounds"]),
            (&1000.into(), &3.into()),
            "{measurement}"
        );
        assert!(measurement["seconds"].as_f64().is_some_and(|s| s > 0.0), "{measurement}");
        assert!(measurement["threads"].as_u64().is_some_and(|n| n > 0), "{measurement}");
        let others = measurement["ratio_to"].as_object().expect("ratios");
        assert_eq!(others.len(), half - 1, "{measurement}");
        let is_interp = measurement["executor"] == "interp";
        assert_eq!(measurement["isa"].is_string(), is_interp, "{measurement}");
        assert_eq!(others.contains_key("native"), is_interp, "{measurement}");
    }
}

#[test]
fn threads_are_those_asked_for() {
    let all = measured(&["triad", "--threads", "1"]);
    assert!(all.iter().all(|m| m["threads"] == 1), "{all:?}");
}

#[test]
fn what_is_not_there_is_refused() {
    assert_fails(&lobe(&["bench", "nix"]), 2, &["nix", "triad"]);
    assert_fails(&lobe(&["bench", "--items", "0"]), 2, &["0"]);
    assert_fails(&lobe(&["bench", "--route", "spirv@nix"]), 3, &["no Vulkan driver `nix`"]);
    let floor = lobe(&[&QUICK[..], &["triad", "--floor"]].concat());
    let has_goal = lobe_backends::interp::Isa::available().len() > 1;
    if has_goal {
        assert_fails(&floor, 2, &["--floor needs interp and wgsl+naga@lavapipe"]);
    }
}

#[test]
fn methods_are_measured_beside_sampling() {
    let folder = tempfile::tempdir().expect("a folder");
    let plot = folder.path().join("cost.svg");
    let plot_name = plot.display().to_string();
    let small =
        ["--size", "16x16", "--truth", "1024", "--rounds", "1", "--route", "interp", "--format", "json"];
    let said =
        assert_holds(&lobe(&[&["bench", "--render", SCENE, "--plot", &plot_name], &small[..]].concat()));
    let all: Vec<Value> = said.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let (sampling, methods): (Vec<_>, Vec<_>) = all.iter().partition(|e| e["method"] == "reference");
    let numbers = |key: &str| sampling.iter().map(|e| e[key].as_f64().expect("a number")).collect::<Vec<_>>();
    assert_eq!(numbers("samples"), [4.0, 16.0, 64.0, 256.0]);
    assert!(numbers("relative_rmse").is_sorted_by(|a, b| a > b), "{:?}", numbers("relative_rmse"));
    assert!(methods.iter().all(|e| e["sampling_ratio"].as_f64().is_some_and(|r| r > 0.0)), "{said}");
    let error = |name: &str| {
        methods.iter().find(|e| e["method"] == name).and_then(|e| e["relative_rmse"].as_f64()).expect(name)
    };
    assert!(error("rect-laplace") < error("rect") && error("rect") < error("rect-paper"), "{said}");
    assert!(std::fs::read_to_string(&plot).expect("the plot").contains("relative RMSE"));
    assert_fails(&lobe(&["bench", "--render", "nix.json"]), 2, &["nix.json"]);
    let name = folder.path().join("cost.gif").display().to_string();
    assert_fails(&lobe(&["bench", "--render", SCENE, "--plot", &name]), 2, &["cost.gif", ".png or .svg"]);
}
