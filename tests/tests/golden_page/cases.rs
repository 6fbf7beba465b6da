//! The reports that pages are looked at with.

use crate::synthetic::{Case, HOSTILE, Pictures, ROUTES, noise, report};
use serde_json::{Value, json};

const SIZE: [u32; 2] = [128, 128];

/// A case of every verdict, and of everything that evidence may lack.
pub(crate) fn every_kind() -> (Value, Pictures) {
    report(vec![
        changed(),
        falls_short(),
        Case::new("spheres", "new-method", SIZE).with_fresh(0.01, "missing").route(ROUTES[1], "new", near),
        Case::new("spheres", "torn", SIZE)
            .with_fresh(0.0, "damaged")
            .with("why", json!("the golden cannot be read: it is damaged"))
            .route(ROUTES[1], "new", near),
        Case::new("spheres", "restated", SIZE).with_fresh(0.0, "restated").route(ROUTES[1], "same", near),
        Case::new("spheres", "sg-specular", SIZE)
            .route(ROUTES[0], "same", |_, t, _| t)
            .route(ROUTES[1], "same", near)
            .route(ROUTES[3], "driver", near),
        Case::new("spheres", "undefined-edge", SIZE)
            .permitting(|at, p| if at / 3 % 128 > 100 { f32::INFINITY } else { p })
            .route(ROUTES[1], "emission", near),
        failed(),
        lacking("lost-picture", |item| item["routes"][0]["picture"] = json!("nowhere.exr")),
        lacking("swapped-picture", |item| item["routes"][0]["worst"]["found"] = json!(0.125)),
        lacking("no-picture", |item| {
            item["files"]["accepted"] = Value::Null;
            item["routes"][0]["picture"] = Value::Null;
        }),
        plot(),
    ])
}

/// As a driver: off by less than is permitted.
fn near(at: usize, truth: f32, permitted: f32) -> f32 {
    if permitted == f32::INFINITY { truth + 0.01 * noise(at) } else { truth + 0.8 * permitted * noise(at) }
}

fn changed() -> Case {
    let before = "fn sg_shade(n: vec3<f32>) -> f32 {\n    let k = 0.5;\n    let a = dot(n, vec3(0.0, 1.0, 0.0));\n    return k * max(a, 0.0);\n}\n";
    let after = before.replace("0.5;", "0.51;").replace("max(a, 0.0)", "max(a, 0.0) + 0.01");
    let long = |middle: &str| {
        let line = |at: u32| format!("%{at} = OpFAdd %float %{} %{}", at - 1, at - 2);
        let all: Vec<String> =
            (10..210).map(|at| if at == 100 { middle.to_owned() } else { line(at) }).collect();
        all.join("\n")
    };
    let text = |target: &str, before: &str, after: &str| json!({ "kernel": "sg_shade", "target": target, "before": before, "after": after });
    let law = |route: &str, name: &str, residual: f64, permitted: f64| json!({ "route": route, "name": name, "residual": residual, "permitted": permitted });
    let physics: Vec<Value> = ROUTES
        .iter()
        .flat_map(|route| {
            [
                law(route, "white_furnace", 0.0021, 0.005),
                law(route, "reciprocity", 3.1e-7, 1e-6),
                law(route, "energy", 0.0, 1e-6),
                law(route, "rotation", 2.4e-6, 1e-6),
            ]
        })
        .collect();
    Case::new("cornell", "sg-diffuse", SIZE)
        .with_fresh(0.02, "changed")
        .with("why", json!("the truth is another: 30,183 values differ"))
        .with(
            "texts",
            json!([
                text("kernel", before, &after),
                text("WGSL", before, &after),
                text("HLSL", before, before),
                text("SPIR-V", &long("%100 = OpFMul %float %1 %2"), &long("%100 = OpFMul %float %1 %3")),
            ]),
        )
        .with("physics", json!(physics))
        .route(ROUTES[0], "mathematics", |at, t, p| t + 0.3 * p * noise(at))
        .route(ROUTES[1], "mathematics", near)
        .route(ROUTES[2], "mathematics", near)
        .route(ROUTES[3], "mathematics", |at, t, p| if at % 997 == 0 { f32::NAN } else { near(at, t, p) })
}

fn falls_short() -> Case {
    let is_far = |at: usize| at / 3 % 128 > 60 && at / 3 % 128 < 70 && at / 384 > 60 && at / 384 < 66;
    Case::new("cornell", "ltc-rectangle", SIZE)
        .with("verdict", json!("falls_short"))
        .with("why", json!("hlsl+dxc@swiftshader is outside"))
        .route(ROUTES[0], "same", |_, t, _| t)
        .route(ROUTES[1], "same", near)
        .route(
            ROUTES[3],
            "driver",
            move |at, t, p| if is_far(at) { t + p * (2.0 + 3.0 * noise(at)) } else { near(at, t, p) },
        )
}

fn failed() -> Case {
    let route = json!({
        "route": ROUTES[1], "driver": "", "verdict": "failed", "why": "the device was lost", "change": "same", "emitted": null, "output": null,
        "pixels": { "inside": 0, "outside": 0, "indeterminate": 0, "equal": 0 }, "worst": null, "shares": [0, 0, 0, 0], "metrics": null, "picture": null,
    });
    Case::new("spheres", "lost-device", SIZE)
        .with("verdict", json!("failed"))
        .with("why", json!("no route could render it"))
        .with("routes", json!([route]))
}

/// A case that the report says holds, though something of its evidence is not there.
fn lacking(method: &str, lack: impl Fn(&mut Value)) -> Case {
    let mut case = Case::new("lacking", method, SIZE).route(ROUTES[1], "same", near);
    lack(case.item_mut());
    case
}

fn plot() -> Case {
    let grey = |at: usize, t: f32, p: f32| near(at / 3, t, p);
    Case::new("plots", "ggx_distribution", [64, 48])
        .with("kind", json!("plot"))
        .route(ROUTES[0], "same", |_, t, _| t)
        .route(ROUTES[2], "emission", grey)
}

/// Names and texts that mean harm, wherever a report has any.
pub(crate) fn hostile() -> (Value, Pictures) {
    let mut case = Case::new("hostile", HOSTILE, [8, 8])
        .with_fresh(0.1, "changed")
        .route(ROUTES[1], "mathematics", near)
        .route(HOSTILE, "new", near);
    let item = case.item_mut();
    (item["scene"], item["why"], item["kind"]) = (json!(HOSTILE), json!(HOSTILE), json!(HOSTILE));
    item["settings"] = json!({ HOSTILE: HOSTILE, "__proto__": HOSTILE });
    item["texts"] =
        json!([{ "kernel": HOSTILE, "target": HOSTILE, "before": HOSTILE, "after": format!("{HOSTILE} ") }]);
    item["physics"] = json!([{ "route": HOSTILE, "name": HOSTILE, "residual": 1, "permitted": 2 }]);
    for name in ["by", "at", "why"] {
        item["accepted"][name] = json!(HOSTILE);
    }
    let lost = Case::new("../../up", "x", [8, 8])
        .with("files", json!({ "accepted": HOSTILE, "fresh": null }))
        .with("why", json!(HOSTILE));
    let (mut report, pictures) = report(vec![case, lost]);
    for name in ["lobe", "environment", "golden", "pending"] {
        report[name] = json!(HOSTILE);
    }
    report["skipped"] = json!([{ "route": HOSTILE, "what": HOSTILE, "mend": HOSTILE }]);
    report["dead"] = json!([HOSTILE]);
    (report, pictures)
}

/// Many cases, small ones, a few of which change, and only these have pictures.
pub(crate) fn many(n: usize) -> (Value, Pictures) {
    let case = |at: usize| {
        let is_changed = at % 100 == 7;
        let case = Case::new(&format!("scene-{}", at / 40), &format!("method-{}", at % 40), [8, 8]);
        let case = if is_changed { case.with_fresh(0.01, "changed") } else { case };
        let change = if is_changed { "mathematics" } else { "same" };
        let case = ROUTES.iter().fold(case, |case, route| case.route(route, change, near));
        if is_changed { case } else { case.without_pictures() }
    };
    report((0..n).map(case).collect())
}

/// One case of the largest size.
pub(crate) fn large() -> (Value, Pictures) {
    let case = Case::new("large", "sg-diffuse", [1024, 1024]).with_fresh(0.001, "changed");
    report(vec![case.route(ROUTES[1], "mathematics", near)])
}
