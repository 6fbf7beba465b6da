//! The package for three.js: built by three.js into shaders, run in a browser with WebGPU, judged as any route.

#[path = "../common/mod.rs"]
mod common;
mod pages;
mod replay;

use common::{plan, tool};
use lobe_backends::executor::Executor;
use lobe_backends::translate::web;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::kernels;
use lobe_codegen::package::{Package, PackageFile, package};
use lobe_codegen::prelude::Vec3;
use lobe_kernels::registry::KERNELS;
use lobe_kernels::sg::{Sg, sg_eval};
use lobe_tests::judge::judge;
use lobe_tests::question::{Question, Verdict};
use replay::Replay;
use std::process::Command;

fn files() -> Vec<PackageFile> {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<String> = KERNELS.iter().map(|k| k().name.to_owned()).collect();
    package(&module, &names, Package::Three, Package::Three.prefix()).unwrap_or_else(|e| panic!("{e}"))
}

/// three.js and a browser, or that one of them is not here.
#[track_caller]
fn three() -> Option<web::Package> {
    tool(web::browser())?;
    tool(web::three())
}

/// What is wrong with `kernels` as three.js builds them out of `files` and the browser's driver runs them: what the
/// page says, and what lies outside of its derived bound.
fn faults(three: &web::Package, files: &[PackageFile], kernels: &[FunctionRef]) -> Vec<String> {
    let plan = plan(64);
    let replay = Replay::default();
    let mut routes: Vec<Box<dyn Executor>> = vec![Box::new(replay.clone())];
    for kernel in kernels {
        judge(*kernel, &plan, &mut routes, &|_| {});
    }
    match pages::run(three, files, kernels, &replay.asked()) {
        Ok(results) => replay.answer_with(results),
        Err(said) => return said,
    }
    let mut faults = Vec::new();
    for kernel in kernels {
        let report = judge(*kernel, &plan, &mut routes, &|_| {});
        let answers: Vec<_> = report.answers.iter().filter(|a| a.question == Question::Conformant).collect();
        assert!(answers.len() == 1 && answers[0].cases >= 64, "{}: {answers:?}", report.name);
        if let Verdict::FallsShort(why) = &answers[0].verdict {
            faults.push(format!("{}: {why}; worst {:?}", report.name, answers[0].worst));
        }
    }
    faults
}

#[test]
fn every_kernel_runs_in_the_browser_inside_its_bound() {
    let Some(three) = three() else { return };
    let faults = faults(&three, &files(), KERNELS);
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// A test that cannot fail proves nothing: a wrong constant is found by its result, a name that nobody declares by
/// three.js, a fault of the module by the page.
#[test]
fn faults_of_the_module_are_found() {
    const EVAL: &str = "exp(-0.5f * sg.sharpness * dot(chord, chord))";
    let Some(three) = three() else { return };
    for (from, to, part) in [
        (EVAL, EVAL.replace("0.5", "0.51"), "lie outside the derived bound"),
        (EVAL, EVAL.replace("dot(", "lobe_dot("), "lobe_dot"),
        ("export const sg_eval =", "export const sg_eval_of =".to_owned(), "not a function"),
    ] {
        let mut files = files();
        let module = files.iter_mut().find(|file| file.path == "lobe.js").expect("the module");
        assert!(module.text.contains(from), "{from}");
        module.text = module.text.replacen(from, &to, 1);
        let faults = faults(&three, &files, &kernels![sg_eval]);
        assert!(faults.iter().any(|fault| fault.contains(part)), "{part}: {faults:?}");
    }
}

#[test]
fn all_kernels_stand_in_one_shader_beside_three_s_own_names() {
    let Some(three) = three() else { return };
    let said = pages::put_together(&three, &files());
    assert!(said.is_empty(), "{} faults:\n{}", said.len(), said.join("\n"));
}

#[test]
fn the_example_is_a_page_whose_picture_shows_the_kernel_s_values() {
    let Some(three) = three() else { return };
    let picture = pages::show_example(&three, &files());
    // Where the sphere faces the camera its normal is the axis z.
    let lobe = Sg { axis: Vec3::new(0.0, 0.6, 0.8), sharpness: 0.5, log_amplitude: 0.5 };
    let value = 0.5 * sg_eval(Vec3::Z, lobe);
    let wanted = 255.0 * (1.055 * value.powf(1.0 / 2.4) - 0.055);
    for channel in picture {
        assert!((f32::from(channel) - wanted).abs() <= 1.0, "{picture:?}, not {wanted}");
    }
}

/// A use of the module in TypeScript, and what its types refuse.
const USE: &str = "\
import { float, normalWorld, vec3, wgslFn } from 'three/tsl';
import { Sg, erf, rectangle_is_met, sg_eval, sg_product, using } from './lobe.js';
const lobe = Sg({ axis: vec3(0, 0, 1), sharpness: float(8), log_amplitude: float(0) });
const product = sg_product({ a: lobe, b: lobe });
const value = sg_eval({ dir: product.get('axis'), sg: product }).mul(erf({ x: 0.5 }));
rectangle_is_met({ meeting: normalWorld }).select(value, float(0));
wgslFn('fn twice(x: f32) -> f32 { return 2.0 * lobe_erf(x); }', using(erf));
// @ts-expect-error: an argument is missing
sg_eval({ dir: normalWorld });
// @ts-expect-error: a number is no structure
sg_eval({ dir: normalWorld, sg: 1 });
// @ts-expect-error: there is no such member
product.get('width');
// @ts-expect-error: three.js would take a number here for 0
Sg({ axis: vec3(0, 0, 1), sharpness: 8, log_amplitude: float(0) });
";

#[test]
fn its_declarations_are_typescript_s() {
    let (Some(three), Some(node)) = (tool(web::three()), tool(web::node())) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    for file in files() {
        std::fs::write(folder.path().join(&file.path), file.text).expect("writable");
    }
    std::fs::write(folder.path().join("use.ts"), USE).expect("writable");
    std::os::unix::fs::symlink(three.modules(), folder.path().join("node_modules")).expect("a link");
    let output = Command::new(node)
        .arg(three.modules().join("typescript/bin/tsc"))
        .args(["--noEmit", "--strict", "--skipLibCheck", "--target", "esnext", "--module", "esnext"])
        .args(["--moduleResolution", "bundler", "use.ts"])
        .current_dir(folder.path())
        .output()
        .expect("node runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}
