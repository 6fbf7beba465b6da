//! The pictures of a case: which there should be, which there are, and why others are not.

use crate::hash::Hash;
use crate::image::{Picture, read_golden, read_picture};
use serde_json::{Map, Value, json};

/// Where the pictures of a report come from.
pub trait Evidence {
    /// The bytes of a file that the report names.
    ///
    /// # Errors
    /// In words, when they cannot be read.
    fn bytes(&self, file: &str) -> Result<Vec<u8>, String>;

    /// The FLIP map of a picture against the truth, a number in 0 ..= 1 for each pixel; `None` where nobody computes it.
    fn flip(&self, _truth: &Picture, _found: &Picture) -> Option<Vec<f32>> {
        None
    }
}

/// A picture that is there.
pub(super) struct Slot {
    pub(super) name: String,
    pub(super) picture: Picture,
    /// Values a pixel.
    pub(super) channels: usize,
    /// The slot that it is written as a difference from.
    pub(super) base: Option<String>,
}

/// The pictures of a case.
#[derive(Default)]
pub(super) struct Slots {
    found: Vec<Slot>,
    /// What is not there though it should be, and why.
    missing: Vec<(String, String)>,
    /// What is there, but is not what the report speaks of.
    doubts: Vec<(String, String)>,
    /// Of the new golden's file.
    fresh: Option<Hash>,
}

impl Slots {
    pub(super) fn of(item: &Value, evidence: &dyn Evidence) -> Self {
        let mut slots = Self::default();
        let size = size_of(item);
        for side in ["accepted", "fresh"] {
            slots.golden(side, item, size, evidence);
        }
        // Routes were judged by the new truth where there is one.
        let truth = ["fresh.truth", "accepted.truth"].into_iter().find(|name| slots.get(name).is_some());
        for (at, route) in item["routes"].as_array().into_iter().flatten().enumerate() {
            slots.route(at, route, size, truth, evidence);
        }
        slots.flip("flip.fresh", "accepted.truth", "fresh.truth", evidence);
        slots
    }

    fn golden(&mut self, side: &str, item: &Value, size: Option<[u32; 2]>, evidence: &dyn Evidence) {
        let names = ["truth", "permitted"].map(|part| format!("{side}.{part}"));
        let read = match item["files"][side].as_str() {
            Some(file) => self.read_golden(side, file, size, evidence),
            // Without a file there is nothing to miss, unless it has been accepted.
            None if side == "accepted" && !item["accepted"].is_null() => {
                Err("the report names no file of it".to_owned())
            }
            None => return,
        };
        match read {
            Ok(pictures) => {
                // The new truth is nearly the accepted one, if that is there.
                let bases = ["accepted.truth", "accepted.permitted"]
                    .map(|base| self.get(base).map(|_| base.to_owned()));
                for ((name, picture), base) in names.into_iter().zip(pictures).zip(bases) {
                    self.found.push(Slot { name, picture, channels: 3, base });
                }
            }
            Err(why) => self.missing.extend(names.map(|name| (name, why.clone()))),
        }
    }

    fn read_golden(
        &mut self,
        side: &str,
        file: &str,
        size: Option<[u32; 2]>,
        evidence: &dyn Evidence,
    ) -> Result<[Picture; 2], String> {
        let bytes = evidence.bytes(file)?;
        let golden = read_golden(&bytes).map_err(|error| format!("{file}: {error}"))?;
        if side == "fresh" {
            self.fresh = Some(Hash::of(&bytes));
        }
        let part =
            |values: &[f32]| fitting(Picture { size: golden.size(), values: values.to_vec() }, size, file);
        Ok([part(golden.truth())?, part(golden.permitted())?])
    }

    fn route(
        &mut self,
        at: usize,
        route: &Value,
        size: Option<[u32; 2]>,
        truth: Option<&str>,
        evidence: &dyn Evidence,
    ) {
        let name = format!("route.{at}");
        let read = match route["picture"].as_str() {
            Some(file) => evidence.bytes(file).and_then(|bytes| {
                let picture = read_picture(&bytes).map_err(|error| format!("{file}: {error}"))?;
                fitting(picture, size, file)
            }),
            None if route["verdict"] == "failed" => return,
            None => Err("the report names no file of it".to_owned()),
        };
        match read {
            Ok(picture) => {
                if !is_judged(&picture, &route["worst"]) {
                    let why = "this is not the picture that was judged, since its worst value is not in it: write the report again";
                    self.doubts.push((name.clone(), why.to_owned()));
                }
                let base = truth.map(str::to_owned);
                self.found.push(Slot { name: name.clone(), picture, channels: 3, base });
                if let Some(truth) = truth {
                    self.flip(&format!("flip.{at}"), truth, &name, evidence);
                }
            }
            Err(why) => self.missing.push((name, why)),
        }
    }

    fn flip(&mut self, name: &str, truth: &str, found: &str, evidence: &dyn Evidence) {
        let (Some(truth), Some(found)) = (self.get(truth), self.get(found)) else { return };
        let size = truth.size;
        let Some(values) = evidence.flip(truth, found) else { return };
        let slot = Slot { name: name.to_owned(), picture: Picture { size, values }, channels: 1, base: None };
        self.found.push(slot);
    }

    fn get(&self, name: &str) -> Option<&Picture> {
        self.found.iter().find(|slot| slot.name == name).map(|slot| &slot.picture)
    }

    pub(super) fn found(&self) -> &[Slot] {
        &self.found
    }

    /// The numbers that a slot is written as a difference from.
    pub(super) fn base(&self, slot: &Slot) -> Option<&[f32]> {
        slot.base.as_deref().and_then(|base| self.get(base)).map(|picture| picture.values.as_slice())
    }

    /// Whether something is not there that should be, or is something else, or there is nothing to look at.
    pub(super) fn is_lacking(&self) -> bool {
        !self.missing.is_empty() || !self.doubts.is_empty() || self.found.is_empty()
    }

    /// By name: why it is not believed.
    pub(super) fn doubts(&self) -> Value {
        Value::Object(self.doubts.iter().map(|(name, why)| (name.clone(), json!(why))).collect())
    }

    /// The SHA-256 of the new golden's file.
    pub(super) fn fresh(&self) -> Option<&Hash> {
        self.fresh.as_ref()
    }

    /// By name: null for what is there, else why it is not.
    pub(super) fn describe(&self) -> Value {
        let found = self.found.iter().map(|slot| (slot.name.clone(), Value::Null));
        let missing = self.missing.iter().map(|(name, why)| (name.clone(), json!(why)));
        Value::Object(found.chain(missing).collect::<Map<_, _>>())
    }
}

/// Whether a picture has the value that the report says is its worst.
fn is_judged(picture: &Picture, worst: &Value) -> bool {
    if worst.is_null() {
        return true;
    }
    let place = |name: &str| worst[name].as_u64().and_then(|at| usize::try_from(at).ok());
    let channel = ["R", "G", "B"].iter().position(|name| worst["channel"] == *name);
    let (Some(x), Some(y), Some(channel)) = (place("x"), place("y"), channel) else { return false };
    let [width, height] = picture.size.map(|side| side as usize);
    let Some(value) =
        (x < width && y < height).then(|| picture.values.get(3 * (y * width + x) + channel)).flatten()
    else {
        return false;
    };
    match worst["found"].as_str() {
        Some("nan") => value.is_nan(),
        Some("inf") => *value == f32::INFINITY,
        Some("-inf") => *value == f32::NEG_INFINITY,
        Some(_) => false,
        None => worst["found"].as_f64().is_some_and(|found| found as f32 == *value),
    }
}

fn size_of(item: &Value) -> Option<[u32; 2]> {
    let side = |at: usize| item["size"][at].as_u64().and_then(|side| u32::try_from(side).ok());
    Some([side(0)?, side(1)?])
}

/// The picture, if it is of the case's size.
fn fitting(picture: Picture, size: Option<[u32; 2]>, file: &str) -> Result<Picture, String> {
    let [width, height] = picture.size;
    match size {
        Some(size) if size != picture.size => {
            Err(format!("{file} is {width} x {height}, which is not the size of the case"))
        }
        _ => Ok(picture),
    }
}
