//! Reports with a case of every kind, and pictures that they are true of.

use lobe_golden::Golden;
use lobe_golden::image::{Picture, write_golden, write_picture};
use lobe_golden::page::Evidence;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// What a name or a text may do at worst.
pub(crate) const HOSTILE: &str = "\"'><script>window.harmed = 1</script><img src=x onerror=\"window.harmed = 1\">${1}\\\u{2028}</textarea>";

pub(crate) const ROUTES: [&str; 4] =
    ["native", "spirv@lavapipe", "wgsl+naga@lavapipe", "hlsl+dxc@swiftshader"];

/// Files by the name that a report has for them.
#[derive(Default)]
pub(crate) struct Pictures(pub(crate) BTreeMap<String, Vec<u8>>);

impl Evidence for Pictures {
    fn bytes(&self, file: &str) -> Result<Vec<u8>, String> {
        self.0.get(file).cloned().ok_or_else(|| format!("{file} is not there"))
    }

    /// Something to look at in the place of FLIP.
    fn flip(&self, truth: &Picture, found: &Picture) -> Option<Vec<f32>> {
        let pairs = truth.values.chunks(3).zip(found.values.chunks(3));
        let far = |(t, f): (&[f32], &[f32])| t.iter().zip(f).map(|(t, f)| (f - t).abs()).fold(0.0, f32::max);
        Some(pairs.map(|pair| (far(pair) * 1e5).min(1.0)).collect())
    }
}

/// A case in the making.
pub(crate) struct Case {
    scene: String,
    method: String,
    size: [u32; 2],
    item: Value,
    truth: Vec<f32>,
    permitted: Vec<f32>,
    pictures: Pictures,
}

/// A hash; others begin later in it.
const HASH: &str = "00112233445566778899aabbccddeeff00112233445566778899aabbccddeeff";

fn chain(last: &str) -> Value {
    let module = |name: &str, ending: &str, is_judged: bool| json!({ "name": name, "module": format!("{}{ending}", &HASH[2..]), "is_judged": is_judged });
    json!({
        "hash": format!("{}{last}", &HASH[2..]), "scene": HASH, "settings": HASH,
        "kernels": [module("sg_shade", last, true), module("trace_primary", "00", false)],
    })
}

impl Case {
    /// A case whose golden was accepted and holds, without routes.
    pub(crate) fn new(scene: &str, method: &str, size: [u32; 2]) -> Self {
        let (truth, permitted) = sphere(size, 0.0);
        let file = format!("{scene}/{method}/accepted.exr");
        let accepted =
            |route: &str| json!({ "route": route, "driver": driver(route), "emitted": HASH, "output": HASH });
        let item = json!({
            "scene": scene, "method": method, "kind": "render", "size": size,
            "settings": { "width": size[0].to_string(), "samples": "64" }, "verdict": "holds", "why": "",
            "chain": chain("01"),
            "accepted": {
                "chain": chain("01"), "by": "Ada", "at": "2026-11-01T09:00:00Z", "why": "first picture of this scene",
                "environment": "linux x86_64", "exr": HASH, "routes": (ROUTES.map(accepted)),
            },
            "rendered": false, "proof": "the scene, the settings and the kernels are those of the accepted golden", "truth": null,
            "files": { "accepted": file, "fresh": null }, "routes": [],
        });
        let mut pictures = Pictures::default();
        pictures.0.insert(file, golden(size, &truth, &permitted));
        Self { scene: scene.into(), method: method.into(), size, item, truth, permitted, pictures }
    }

    /// Sets a member of the report's item.
    pub(crate) fn with(mut self, member: &str, value: Value) -> Self {
        self.item[member] = value;
        self
    }

    /// As of a run that wrote no pictures.
    pub(crate) fn without_pictures(mut self) -> Self {
        self.pictures.0.clear();
        self.item["files"] = json!({ "accepted": null, "fresh": null });
        for route in self.item["routes"].as_array_mut().into_iter().flatten() {
            route["picture"] = Value::Null;
        }
        self
    }

    /// The report's item.
    pub(crate) fn item_mut(&mut self) -> &mut Value {
        &mut self.item
    }

    /// A new golden whose truth is shifted, in place of or beside the accepted one.
    pub(crate) fn with_fresh(mut self, shift: f32, verdict: &str) -> Self {
        let (truth, permitted) = sphere(self.size, shift);
        let file = format!("{}/{}/fresh.exr", self.scene, self.method);
        let differing = truth.iter().zip(&self.truth).filter(|(a, b)| a != b).count();
        let beyond =
            truth.iter().zip(&self.truth).zip(&self.permitted).filter(|((a, b), p)| (*a - *b).abs() > **p);
        self.item["truth"] =
            json!({ "differing": differing, "furthest_ulp": 51_234, "beyond_permitted": beyond.count() });
        self.item["files"]["fresh"] = json!(file);
        (self.item["rendered"], self.item["proof"]) = (json!(true), Value::Null);
        self.item["chain"] = chain("02");
        self.item["verdict"] = json!(verdict);
        if ["missing", "damaged"].contains(&verdict) {
            (self.item["accepted"], self.item["truth"], self.item["files"]["accepted"]) =
                (Value::Null, Value::Null, Value::Null);
        }
        self.pictures.0.insert(file, golden(self.size, &truth, &permitted));
        // Routes are judged by it.
        (self.truth, self.permitted) = (truth, permitted);
        self
    }

    /// Changes what is permitted of the accepted golden.
    pub(crate) fn permitting(mut self, of: impl Fn(usize, f32) -> f32) -> Self {
        self.permitted =
            self.permitted.iter().enumerate().map(|(at, permitted)| of(at, *permitted)).collect();
        let file = self.item["files"]["accepted"].as_str().unwrap_or_default().to_owned();
        self.pictures.0.insert(file, golden(self.size, &self.truth, &self.permitted));
        self
    }

    /// A route whose value at a place is `found` of the place, the true one and what is permitted.
    pub(crate) fn route(mut self, name: &str, change: &str, found: impl Fn(usize, f32, f32) -> f32) -> Self {
        let pairs = self.truth.iter().zip(&self.permitted).enumerate();
        let values: Vec<f32> = pairs.map(|(at, (truth, permitted))| found(at, *truth, *permitted)).collect();
        let file = format!("{}/{}/{}.exr", self.scene, self.method, name.replace(['@', '+'], "-"));
        let verdict = self.judge(name, change, &values, &file);
        self.item["routes"].as_array_mut().expect("routes").push(verdict);
        self.pictures.0.insert(file, write_picture(&Picture { size: self.size, values }).expect("a picture"));
        self
    }

    fn judge(&self, name: &str, change: &str, values: &[f32], file: &str) -> Value {
        let share = |at: usize| {
            let distance = (f64::from(values[at]) - f64::from(self.truth[at])).abs();
            let share = distance / f64::from(self.permitted[at]);
            if distance == 0.0 {
                0.0
            } else if share.is_nan() {
                f64::INFINITY
            } else {
                share
            }
        };
        let bounded: Vec<usize> =
            (0..values.len()).filter(|at| self.permitted[*at] < f32::INFINITY).collect();
        let worst = bounded.iter().copied().fold(None, |worst: Option<usize>, at| match worst {
            Some(most) if share(most) >= share(at) => Some(most),
            _ => Some(at),
        });
        let pixels = values.len() / 3;
        let most = |at: usize| {
            (3 * at..3 * at + 3)
                .filter(|at| self.permitted[*at] < f32::INFINITY)
                .map(share)
                .fold(0.0, f64::max)
        };
        let is_bounded = |at: usize| (3 * at..3 * at + 3).all(|at| self.permitted[at] < f32::INFINITY);
        let outside = (0..pixels).filter(|at| most(*at) > 1.0).count();
        let inside = (0..pixels).filter(|at| most(*at) <= 1.0 && is_bounded(*at)).count();
        let equal = (0..pixels)
            .filter(|at| (3 * at..3 * at + 3).all(|at| values[at].to_bits() == self.truth[at].to_bits()));
        let mut shares: Vec<f64> = (0..pixels).filter(|at| is_bounded(*at)).map(most).collect();
        shares.sort_by(f64::total_cmp);
        let quantile = |share: f64| {
            shares.get(((shares.len().max(1) - 1) as f64 * share) as usize).copied().unwrap_or(0.0)
        };
        let width = self.size[0] as usize;
        let worst = worst.map(|at| json!({
            "x": at / 3 % width, "y": at / 3 / width, "channel": (["R", "G", "B"][at % 3]), "found": number(f64::from(values[at])),
            "truth": self.truth[at], "permitted": self.permitted[at], "share": number(share(at)),
        }));
        let flip = json!({ "mean": 0.0125, "first_quartile": 0.1, "weighted_median": 0.2, "third_quartile": 0.3, "max": 0.5 });
        json!({
            "route": name, "driver": driver(name), "verdict": if outside > 0 { "outside" } else { "inside" },
            "why": if outside > 0 { format!("{outside} pixels are outside") } else { String::new() },
            "change": change, "emitted": if change == "emission" { Value::Null } else { json!(HASH) }, "output": HASH,
            "pixels": { "inside": inside, "outside": outside, "indeterminate": pixels - inside - outside, "equal": equal.count() },
            "worst": worst, "shares": ([0.5, 0.99, 0.999, 1.0].map(|share| number(quantile(share)))),
            "metrics": { "mean_ratio": 1.0002, "relative_rmse": 3.1e-7, "flip_hdr": flip, "flip_ldr": flip,
                "furthest": { "x": 0, "y": 0, "picture": [0, 0, 0], "truth": [0, 0, 0] } },
            "picture": file,
        })
    }
}

fn number(value: f64) -> Value {
    if value.is_nan() {
        json!("nan")
    } else if value.is_infinite() {
        json!("inf")
    } else {
        json!(value)
    }
}

fn driver(route: &str) -> &'static str {
    match route.split_once('@') {
        Some((_, "lavapipe")) => "llvmpipe, Mesa 25.0.7, LLVM 19, 256 bits",
        Some(_) => "SwiftShader 5.0.0",
        None => "",
    }
}

fn golden(size: [u32; 2], truth: &[f32], permitted: &[f32]) -> Vec<u8> {
    let golden = Golden::of_floats(size, truth.to_vec(), permitted.to_vec());
    golden.map_err(Into::into).and_then(|golden| write_golden(&golden)).expect("a golden")
}

/// A ball in light, on a floor, and what is permitted of it.
fn sphere([width, height]: [u32; 2], shift: f32) -> (Vec<f32>, Vec<f32>) {
    let mut truth = Vec::new();
    for y in 0..height {
        for x in 0..width {
            let [u, v] =
                [(x as f32 + 0.5) / width as f32 * 2.0 - 1.0, (y as f32 + 0.5) / height as f32 * 2.0 - 1.0];
            let r = (u * u + v * v) / 0.6;
            let light = if r < 1.0 {
                let z = (1.0 - r).sqrt();
                (0.5 * z - 0.45 * u - 0.6 * v + shift).max(0.0)
                    + 3.0 * (z * 0.8 - 0.4 * u - 0.4 * v).max(0.0).powi(40)
            } else {
                0.18 + 0.12 * (v + 1.0) + 0.03 * ((u * 12.0).floor() + (v * 12.0).floor()).rem_euclid(2.0)
            };
            truth.extend([0.9, 0.62, 0.35].map(|tint| light * if r < 1.0 { tint } else { 0.8 }));
        }
    }
    let permitted = truth.iter().map(|value| value.abs() * 4e-6 + 1e-7).collect();
    (truth, permitted)
}

/// Something for every value that is neither regular nor the same twice.
pub(crate) fn noise(at: usize) -> f32 {
    let mixed = (at as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5bd1_e995;
    ((mixed >> 33) & 0xffff) as f32 / 32_768.0 - 1.0
}

/// All cases as a report.
pub(crate) fn report(cases: Vec<Case>) -> (Value, Pictures) {
    let mut pictures = Pictures::default();
    let mut items = Vec::new();
    for case in cases {
        items.push(case.item);
        pictures.0.extend(case.pictures.0);
    }
    let verdicts = ["holds", "restated", "changed", "missing", "damaged", "falls_short", "failed"];
    let of = |verdict: &str| items.iter().filter(|item| item["verdict"] == verdict).count();
    let tally: serde_json::Map<String, Value> =
        verdicts.iter().map(|v| ((*v).to_owned(), json!(of(v)))).collect();
    let report = json!({
        "schema": 1, "report": "golden", "lobe": "0.1.0", "environment": "linux x86_64, naga 30.0, wgpu 30.0", "golden": "golden", "evidence": "report",
        "routes": (ROUTES.map(|route| json!({ "route": route, "driver": driver(route) }))),
        "skipped": [{ "route": "wgsl+tint@dawn", "what": "Dawn is not here", "mend": "run tests/setup.sh" }],
        "items": items, "dead": ["cornell/old-method"], "interrupted": false, "pending": "golden/pending", "bytes": 1_234_567, "tally": tally,
    });
    (report, pictures)
}
