//! A case, judged: what was accepted, what is true now, and what routes make of it.

use super::cases::Case;
use super::evidence::Evidence;
use super::picture::Opened;
use super::report::{
    Accepted, ChainReport, Change, Files, Item, Metrics, PixelCount, RouteReport, RouteVerdict, Share,
    TruthReport, Verdict,
};
use super::{Routes, environment};
use crate::metrics::{self, Image, Pair, Range, Viewing};
use crate::render::Renderer;
use lobe_backends::route::Route;
use lobe_codegen::glam::Vec3;
use lobe_golden::image::{Picture, write_golden};
use lobe_golden::{Found, Golden, Hash, Record, RouteRecord, Store, StoreError, of_floats};
use std::path::PathBuf;

/// What a check does besides judging.
#[derive(Debug, Clone, Default)]
pub struct Choice {
    /// Leaves cases out whose hashes are those that were accepted.
    pub only_affected: bool,
    /// Computes the truth of all cases, whatever their hashes.
    pub every_truth: bool,
    /// Writes goldens that wait for a decision.
    pub writes_pending: bool,
    /// Writes all pictures to this folder.
    pub evidence: Option<PathBuf>,
}

/// Judges cases by a store.
pub struct Session<'r> {
    renderer: &'r Renderer,
    store: &'r Store,
    routes: Routes<'r>,
    choice: Choice,
}

impl<'r> Session<'r> {
    /// A session.
    #[must_use]
    pub fn new(renderer: &'r Renderer, store: &'r Store, routes: Routes<'r>, choice: Choice) -> Self {
        Self { renderer, store, routes, choice }
    }

    /// The routes.
    #[must_use]
    pub fn routes(&self) -> &Routes<'r> {
        &self.routes
    }

    /// Judges a case.
    ///
    /// # Errors
    /// When the store cannot be read or written, apart from a golden that cannot be used, which is a verdict.
    pub fn check(&mut self, case: &Case) -> Result<Item, StoreError> {
        match Opened::new(case, self.renderer) {
            Ok(opened) => self.check_opened(case, &opened),
            Err(why) => Ok(Item { verdict: Verdict::Failed, why, ..blank(case) }),
        }
    }

    /// Judges a case that is open.
    ///
    /// # Errors
    /// As of [`Session::check`].
    pub fn check_opened(&mut self, case: &Case, opened: &Opened<'r>) -> Result<Item, StoreError> {
        let mut item = Item { chain: opened.chain().into(), ..blank(case) };
        let (accepted, verdict, why) = match self.store.golden(&case.name) {
            Ok(Some(found)) => (Some(found), Verdict::Holds, String::new()),
            Ok(None) => (None, Verdict::Missing, "there is no golden".to_owned()),
            Err(StoreError::Unusable(unusable)) => (None, Verdict::Damaged, unusable.to_string()),
            Err(error) => return Err(error),
        };
        (item.verdict, item.why) = (verdict, why);
        item.accepted = accepted.as_ref().map(|found| Accepted::from(&found.record));
        let is_affected = accepted.as_ref().is_none_or(|a| a.record.chain.hash != opened.chain().hash);
        if !is_affected {
            item.proof = Some(opened.chain().proof());
            if self.choice.only_affected {
                return Ok(item);
            }
        }
        let fresh = match is_affected || self.choice.every_truth {
            false => None,
            true => match opened.truth() {
                Ok(golden) => Some(golden),
                Err(why) => return Ok(Item { verdict: Verdict::Failed, why, ..item }),
            },
        };
        self.judge(case, opened, item, accepted, fresh)
    }

    fn judge(
        &mut self,
        case: &Case,
        opened: &Opened<'r>,
        mut item: Item,
        accepted: Option<Found>,
        fresh: Option<Golden>,
    ) -> Result<Item, StoreError> {
        item.rendered = fresh.is_some();
        let Some(truth) = fresh.as_ref().or(accepted.as_ref().map(|found| &found.golden)) else {
            return Ok(item);
        };
        if let (Some(accepted), Some(fresh)) = (&accepted, &fresh) {
            compare(&mut item, opened, accepted, fresh);
        }
        let is_same_truth = fresh.is_none() || !matches!(item.verdict, Verdict::Changed);
        let before = accepted.as_ref().map(|found| &found.record);
        for at in 0..self.routes.len() {
            if opened.is_render() && *self.routes.route(at) == Route::Native {
                continue;
            }
            let report = self.route(case, opened, truth, before, at, is_same_truth);
            item.routes.push(report);
        }
        conclude(&mut item, case, truth);
        if let Some(folder) = self.choice.evidence.clone() {
            let accepted = accepted.as_ref().map(|found| &found.golden);
            match files(&Evidence(folder), case, accepted, fresh.as_ref()) {
                Ok(files) => item.files = files,
                Err(why) => return Ok(Item { verdict: Verdict::Failed, why, ..item }),
            }
        }
        self.propose(case, opened, &mut item, fresh.as_ref())?;
        Ok(item)
    }

    /// What a route makes of it.
    fn route(
        &mut self,
        case: &Case,
        opened: &Opened<'r>,
        truth: &Golden,
        before: Option<&Record>,
        at: usize,
        is_same_truth: bool,
    ) -> RouteReport {
        let route = self.routes.route(at).clone();
        let mut report = RouteReport {
            route: route.to_string(),
            driver: self.routes.driver(at).to_owned(),
            verdict: RouteVerdict::Failed,
            why: String::new(),
            change: Change::New,
            emitted: None,
            output: None,
            pixels: PixelCount::default(),
            worst: None,
            shares: [Share(0.0); 4],
            metrics: None,
            picture: None,
        };
        let outcome = self.judged(case, opened, truth, at, &mut report);
        report.why = outcome.err().unwrap_or_default();
        report.change = change(&report, before, is_same_truth);
        report
    }

    fn judged(
        &mut self,
        case: &Case,
        opened: &Opened<'r>,
        truth: &Golden,
        at: usize,
        report: &mut RouteReport,
    ) -> Result<(), String> {
        if let Route::Gpu { road, .. } = self.routes.route(at) {
            report.emitted = Some(opened.emitted(road.target())?);
        }
        let picture = opened.picture(&mut self.routes, at)?;
        let verdict = truth.judge(picture.size, &picture.values).map_err(|error| error.to_string())?;
        report.output = Some(of_floats(&picture.values));
        report.pixels = verdict.pixels.into();
        report.worst = verdict.worst.map(Into::into);
        report.shares = verdict.shares.map(Share);
        report.metrics = Some(metrics(&picture, truth)?);
        report.verdict = if verdict.passes() { RouteVerdict::Inside } else { RouteVerdict::Outside };
        if let Some(folder) = &self.choice.evidence {
            report.picture = Some(Evidence(folder.clone()).picture(case, &report.route, &picture)?);
        }
        match &report.worst {
            Some(worst) if !verdict.passes() => Err(format!(
                "{} pixels are outside; column {}, row {}, {} is {} for {} within {}",
                verdict.pixels.outside,
                worst.x,
                worst.y,
                worst.channel,
                worst.found.0,
                worst.truth.0,
                worst.permitted.0
            )),
            _ => Ok(()),
        }
    }

    /// Puts what is to be decided where it waits, and takes away what is not any more.
    fn propose(
        &self,
        case: &Case,
        opened: &Opened<'r>,
        item: &mut Item,
        fresh: Option<&Golden>,
    ) -> Result<(), StoreError> {
        let is_proposed = item.verdict != Verdict::Holds;
        let Some(fresh) = fresh.filter(|_| is_proposed) else {
            return match self.choice.writes_pending {
                true => self.store.clear_pending(&case.name),
                false => Ok(()),
            };
        };
        let bytes =
            write_golden(fresh).map_err(|cause| StoreError::Image { case: case.name.clone(), cause })?;
        if let Some(rejection) = self.store.rejection(&case.name, &Hash::of(&bytes))? {
            item.why += &format!("; {} rejected this picture: {}", rejection.by, rejection.reason);
        }
        if !self.choice.writes_pending {
            return Ok(());
        }
        let chain = opened.chain().clone();
        let mut record = Record::new(case.name.clone(), case.kind(), case.size, Hash::of(&bytes), chain);
        record.environment = environment();
        record.settings = case.settings();
        record.routes = item.routes.iter().filter_map(route_record).collect();
        self.store.put_pending(fresh, &record).map(drop)
    }
}

/// An item of which nothing is known.
fn blank(case: &Case) -> Item {
    Item {
        scene: case.name.scene.to_string(),
        method: case.name.method.to_string(),
        kind: case.kind().to_owned(),
        size: case.size,
        settings: case.settings(),
        verdict: Verdict::Holds,
        why: String::new(),
        chain: ChainReport { hash: None, scene: None, settings: case.settings_hash(), kernels: Vec::new() },
        accepted: None,
        rendered: false,
        proof: None,
        truth: None,
        files: Files::default(),
        routes: Vec::new(),
        texts: Vec::new(),
        physics: Vec::new(),
    }
}

/// The new truth against the accepted one.
fn compare(item: &mut Item, opened: &Opened<'_>, accepted: &Found, fresh: &Golden) {
    let changes = opened.chain().changes(&accepted.record.chain);
    let because = if changes.is_empty() { "nothing in its hashes".to_owned() } else { changes.join(", ") };
    let Ok(distance) = accepted.golden.distance(fresh) else {
        item.verdict = Verdict::Changed;
        item.why = format!("the size is another (changed: {because})");
        return;
    };
    item.truth = Some(TruthReport {
        differing: distance.differing,
        furthest_ulp: distance.furthest,
        beyond_permitted: distance.beyond,
    });
    let bits = |golden: &Golden| of_floats(golden.permitted());
    (item.verdict, item.why) = match (distance.differing, bits(&accepted.golden) == bits(fresh)) {
        (0, true) if changes.is_empty() => (Verdict::Holds, String::new()),
        (0, true) => {
            (Verdict::Restated, format!("the truth is the same to the last bit; changed: {because}"))
        }
        (0, false) => (
            Verdict::Changed,
            format!("the truth is the same, but drivers are permitted other errors; changed: {because}"),
        ),
        (differing, _) => {
            let all = fresh.truth().len();
            (Verdict::Changed, format!("{differing} of {all} true values are others; changed: {because}"))
        }
    };
}

/// The verdict, once all routes are judged.
fn conclude(item: &mut Item, case: &Case, truth: &Golden) {
    let pixels = truth.truth().len() / 3;
    let share = truth.unbounded() as f64 / pixels as f64;
    let is_unknown = share > case.most_indeterminate;
    if is_unknown {
        for route in item.routes.iter_mut().filter(|route| route.verdict == RouteVerdict::Inside) {
            route.verdict = RouteVerdict::Indeterminate;
        }
    }
    if !item.verdict.holds() {
        return;
    }
    let bad: Vec<String> = item
        .routes
        .iter()
        .filter(|route| matches!(route.verdict, RouteVerdict::Outside | RouteVerdict::Failed))
        .map(|route| format!("{}: {}", route.route, route.why))
        .collect();
    if !bad.is_empty() {
        (item.verdict, item.why) = (Verdict::FallsShort, bad.join("; "));
    } else if is_unknown {
        let (most, found) = (case.most_indeterminate, truth.unbounded());
        item.verdict = Verdict::FallsShort;
        item.why = format!(
            "nothing is promised of {found} of {pixels} pixels, a share of {share:.4}; {most} is allowed"
        );
    } else if item.routes.is_empty() {
        (item.verdict, item.why) = (Verdict::FallsShort, "no route was asked".to_owned());
    }
}

/// Why a route returned what it did before, or not.
fn change(report: &RouteReport, before: Option<&Record>, is_same_truth: bool) -> Change {
    let of = |record: &&Record| record.routes.iter().find(|known| known.route == report.route).cloned();
    let Some(known) = before.as_ref().and_then(of) else { return Change::New };
    match () {
        () if report.output.as_ref() == Some(&known.output) => Change::Same,
        () if !is_same_truth => Change::Mathematics,
        () if report.emitted != known.emitted => Change::Emission,
        () if report.driver != known.driver => Change::Driver,
        () => Change::Unexplained,
    }
}

/// A picture as metrics take it: what is no number is as far off as can be said.
pub(super) fn looked_at(size: [u32; 2], values: &[f32]) -> Image {
    let value = |x: f32| if x.is_finite() { x } else { f32::MAX.sqrt() };
    let pixels = values.as_chunks::<3>().0.iter().map(|p| Vec3::from_array(p.map(value))).collect();
    Image { size, pixels }
}

fn metrics(picture: &Picture, truth: &Golden) -> Result<Metrics, String> {
    let (found, wanted) = (looked_at(picture.size, &picture.values), looked_at(picture.size, truth.truth()));
    let pair = Pair::new(&found, &wanted).map_err(|error| error.to_string())?;
    let viewing = Viewing::default();
    let hdr = metrics::compare(&pair, Range::High, &viewing);
    let ldr = metrics::compare(&pair, Range::Low, &viewing);
    Ok(Metrics {
        mean_ratio: hdr.radiometry.mean_ratio.map(Share),
        relative_rmse: hdr.radiometry.relative_rmse.map(Share),
        furthest: hdr.radiometry.worst.into(),
        flip_hdr: hdr.flip,
        flip_ldr: ldr.flip,
    })
}

fn files(
    evidence: &Evidence,
    case: &Case,
    accepted: Option<&Golden>,
    fresh: Option<&Golden>,
) -> Result<Files, String> {
    let put =
        |name: &str, golden: Option<&Golden>| golden.map(|g| evidence.golden(case, name, g)).transpose();
    Ok(Files { accepted: put("accepted", accepted)?, fresh: put("fresh", fresh)? })
}

/// What is written down of a route.
fn route_record(route: &RouteReport) -> Option<RouteRecord> {
    let metrics = route.metrics.as_ref()?;
    Some(RouteRecord {
        route: route.route.clone(),
        driver: route.driver.clone(),
        emitted: route.emitted.clone(),
        output: route.output.clone()?,
        share: route.shares[3].0,
        relative_rmse: metrics.relative_rmse.map(|share| share.0),
        flip_hdr: metrics.flip_hdr.mean,
        flip_ldr: metrics.flip_ldr.mean,
    })
}
