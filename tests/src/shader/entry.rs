//! One entry point: given its resources, run everywhere, compared.

use super::agree;
use super::compare::{Compared, Permit, compare};
use super::feed::{self, Feed, Said};
use super::given::{Given, Owned};
use super::job::{GivenUp, Job};
use super::json;
use super::machine::{self, Bounds, Machine, MachineError};
use super::number;
use super::report::{Input, Report, RouteReport, RouteStatus, Status};
use super::resource::{self, Called, Elements, Resource};
use super::routes::{Failure, Routes, ShaderRoute, Subject};
use super::run::{Res, Steps, Stop, stop};
use super::texture;
use crate::expectation::Fault;
use lobe_backends::gpu::BindingKind;
use lobe_codegen::ValidModule;
use lobe_codegen::accuracy::Model;
use lobe_codegen::foreign::{self, Override, Source};
use std::time::Duration;

/// Means all routes to drivers that can be taken here.
pub const READY: &str = "ready";

/// Elements of a binding array of which nobody says how many it has.
const ELEMENTS: u32 = 4;

/// Most elements of a binding array.
const MOST_ELEMENTS: u32 = 1 << 12;

/// Most invocations of a run.
const INVOCATIONS: u64 = 1 << 36;

/// An entry point under way.
pub(super) struct Trial<'t, 's> {
    steps: &'t mut Steps<'s>,
    routes: &'t mut Routes,
    report: Report,
}

/// What the interpreter leaves with subgroups of one size, and what drivers may leave, once that was asked.
struct Reference {
    subgroup: Option<u32>,
    ours: Owned,
    bounds: Option<Option<Bounds>>,
}

impl<'t, 's> Trial<'t, 's> {
    /// Runs `entry` of `module` by all routes of the job.
    pub(super) fn report(
        steps: &'t mut Steps<'s>,
        routes: &'t mut Routes,
        source: &Source,
        module: &ValidModule,
        entry: &str,
    ) -> Report {
        let mut report = Report::of(steps.file(), Some(entry.to_owned()), Status::Ok, String::new());
        report.message = None;
        report.workgroups = steps.job.workgroups;
        let mut trial = Self { steps, routes, report };
        if let Err(Stop { status, message }) = trial.judge(source, module, entry) {
            trial.report.status = trial.report.status.max(status);
            trial.report.message = Some(message);
        }
        trial.report
    }

    /// What the job permits drivers.
    fn accuracy(&mut self) -> Res<&'static Model> {
        let Some(name) = &self.steps.job.model else { return Ok(Model::portable()) };
        let Some(model) = Model::named(name) else {
            return stop(Status::Error, format!("no accuracy model `{name}`"));
        };
        self.report.model = model.unusual_name().map(str::to_owned);
        Ok(model)
    }

    fn judge(&mut self, source: &Source, module: &ValidModule, entry: &str) -> Res<()> {
        self.steps.begin(Some(entry), "interp")?;
        let job = self.steps.job;
        let all = resource::names(module.module());
        names(job).try_for_each(|name| known(&all, name))?;
        let overrides: Vec<Override> = job
            .overrides
            .iter()
            .map(|(name, value)| Override { name: name.clone(), value: *value })
            .collect();
        let isolated = foreign::isolate(source, module, entry, &overrides)?;
        let points = &isolated.module().entry_points;
        let index = points.iter().position(|p| p.name == entry && p.stage == naga::ShaderStage::Compute);
        let Some(index) = index else { return stop(Status::Refused, "the entry point was lost") };
        let resources = resource::of(&isolated, index)
            .or_else(|what| stop(Status::Refused, format!("unsupported: {what}")))?;
        self.report.workgroup_size = points[index].workgroup_size;
        let given = self.fill(&resources)?;
        let (workgroups, fuel) = (job.workgroups, job.fuel);
        let accuracy = self.accuracy()?;
        let machine = Machine { module: &isolated, entry: index, workgroups, fuel, accuracy, given: &given };
        let ours = machine.run(None).map_err(|error| located(error, source))?;
        write(job, &given, &ours)?;
        let subject = Subject {
            source,
            module: &isolated,
            entry,
            is_as_written: module.module().overrides.is_empty(),
            workgroup_size: self.report.workgroup_size,
            workgroups,
            given: &given,
            interp: machine,
        };
        let mut references = vec![Reference { subgroup: None, ours, bounds: None }];
        let mut left = Vec::new();
        for route in self.wanted(&subject)? {
            let outcome = self.drive(&route, &subject);
            let found = match outcome {
                Ok(found) => {
                    let compared = self.compare(&route, &subject, machine, &mut references, &found)?;
                    left.push((route.clone(), found));
                    compared
                }
                Err(Failure { status, message }) => RouteReport::without(&route.to_string(), status, message),
            };
            let found = self.expected(&route, found);
            self.report.add(found);
        }
        if job.check {
            let bounds = references.swap_remove(0).bounds;
            let bounds = bounds.unwrap_or_else(|| self.bounds(&subject, machine, None));
            self.report.outputs = Some(agree::outputs(&given, bounds.as_ref()));
            self.report.agreements = agree::agreements(&given, &left);
        }
        self.sanitize(&subject, machine)
    }

    /// What is given for each resource.
    fn fill(&mut self, resources: &[Resource]) -> Res<Vec<Given>> {
        let job = self.steps.job;
        let volume = |sides: [u32; 3]| sides.iter().map(|n| u64::from(*n)).fold(1, u64::saturating_mul);
        let invocations = volume(self.report.workgroup_size).saturating_mul(volume(job.workgroups));
        if invocations > INVOCATIONS {
            return stop(Status::Error, format!("{invocations} invocations are more than {INVOCATIONS}"));
        }
        let mut all = Vec::new();
        for resource in each(job, resources)? {
            let resource = &resource;
            let feed = last(&job.inputs, resource).unwrap_or(&job.usual);
            let said = Said {
                feed,
                size: last(&job.sizes, resource).copied(),
                texture: last(&job.textures, resource),
                sampler: last(&job.samplers, resource),
            };
            let given = feed::fill(resource, said, invocations).or_else(|e| stop(Status::Error, e))?;
            self.report.inputs.push(Input {
                name: resource.title(),
                place: resource.place(),
                bytes: given.data.len(),
                from: described(&given, feed),
            });
            all.push(given);
        }
        Ok(all)
    }

    fn wanted(&self, subject: &Subject<'_>) -> Res<Vec<ShaderRoute>> {
        let job = self.steps.job;
        if job.routes.is_empty() {
            return Ok(self.routes.ready(subject));
        }
        let mut wanted = Vec::new();
        for name in job.routes.iter().filter(|r| *r != "interp") {
            if name == READY {
                wanted.extend(self.routes.ready(subject));
            } else {
                wanted.push(name.parse().or_else(|e: String| stop(Status::Error, e))?);
            }
        }
        Ok(wanted)
    }

    /// What `route` leaves, or why it leaves nothing.
    fn drive(&mut self, route: &ShaderRoute, subject: &Subject<'_>) -> Result<Vec<Vec<u8>>, Failure> {
        let begun = self.steps.begin(Some(subject.entry), &route.to_string());
        if let Err(GivenUp { status, message, .. }) = begun {
            let is_late = status == Status::Timeout;
            return Err(Failure {
                status: if is_late { RouteStatus::Timeout } else { RouteStatus::Crashed },
                message,
            });
        }
        // Who watches over this process ends the step before its driver is given up here.
        let timeout = Duration::from_secs(self.steps.job.timeout.saturating_mul(2));
        let crashed =
            |message| Failure { status: RouteStatus::Crashed, message: format!("panicked: {message}") };
        lobe_codegen::quietly(|| self.routes.run(route, subject, timeout)).map_err(crashed)?
    }

    /// What a route came to, in the light of what was expected of it.
    fn expected(&self, route: &ShaderRoute, mut found: RouteReport) -> RouteReport {
        let driver = self.routes.driver_info(route);
        found.driver = driver.to_owned();
        let mut of_one_route = self.steps.job.expected.iter().filter(|e| e.fails != Fault::Differs);
        match of_one_route.find(|e| e.is_by(&found.route, driver)) {
            Some(expectation) => found.expected(expectation),
            None => found,
        }
    }

    /// Compares what a route left with the interpreter, by bounds where bits are not the same.
    fn compare(
        &mut self,
        route: &ShaderRoute,
        subject: &Subject<'_>,
        machine: Machine<'_>,
        references: &mut Vec<Reference>,
        found: &[Vec<u8>],
    ) -> Res<RouteReport> {
        let subgroup =
            if machine::uses_subgroups(subject.module) { self.routes.subgroup(route) } else { None };
        let known = references.iter().position(|r| r.subgroup == subgroup);
        let at = known.unwrap_or(references.len());
        if known.is_none() {
            references.push(Reference { subgroup, ours: machine.run(subgroup)?, bounds: None });
        }
        let reference = &mut references[at];
        if *route == ShaderRoute::Judge {
            return Ok(RouteReport::compared(&route.to_string(), same_bits(subject.given, reference, found)));
        }
        let within = &self.steps.job.within;
        let compared = compare_all(subject.given, reference, within, found);
        if reference.bounds.is_none() && compared.iter().any(|c| c.differing > 0) {
            reference.bounds = Some(self.bounds(subject, machine, subgroup));
            let within = &self.steps.job.within;
            let compared = compare_all(subject.given, reference, within, found);
            return Ok(RouteReport::compared(&route.to_string(), compared));
        }
        Ok(RouteReport::compared(&route.to_string(), compared))
    }

    /// What permitted drivers may leave, if that can be derived.
    fn bounds(
        &mut self,
        subject: &Subject<'_>,
        machine: Machine<'_>,
        subgroup: Option<u32>,
    ) -> Option<Bounds> {
        let begun = self.steps.begin(Some(subject.entry), "bounds");
        begun.ok().and_then(|()| machine.bounds(subgroup).ok())
    }

    /// Looks for mistakes of the program, if that is wanted, or if they may be why results differ.
    fn sanitize(&mut self, subject: &Subject<'_>, machine: Machine<'_>) -> Res<()> {
        let is_wanted = self.steps.job.sanitize;
        let differs = matches!(self.report.status, Status::Differs | Status::Unjudged);
        if !is_wanted && !differs {
            return Ok(());
        }
        // What WGSL defines to be zero, and naga makes so, SPIR-V leaves open.
        let is_open = differs && self.report.only_original_differs();
        let begun = self.steps.begin(Some(subject.entry), "sanitize");
        let found =
            begun.map_err(Stop::from).and_then(|()| Ok(machine.mistakes(subject.source.text(), is_open)?));
        match found {
            Ok(found) => self.report.findings = found,
            // Nobody asked, and the difference stands for itself.
            Err(_) if !is_wanted => {}
            Err(stop) => return Err(stop),
        }
        let explains = |kind: &str| match kind {
            "OutOfBounds" | "Race" | "NonUniformBarrier" | "AbsentLane" => true,
            "Unwritten" => is_open,
            _ => false,
        };
        let is_program = self.report.findings.iter().any(|f| explains(&f.kind));
        if differs && is_program {
            self.report.status = Status::Findings;
            self.report.message = Some("routes differ, and the program's mistakes permit it".to_owned());
        } else if is_wanted && !self.report.findings.is_empty() {
            self.report.status = self.report.status.max(Status::Findings);
        }
        Ok(())
    }
}

/// Every resource that the shader may write, by the bounds if they are known, else by what the user permits.
fn compare_all(
    given: &[Given],
    reference: &Reference,
    within: &[(String, f64)],
    found: &[Vec<u8>],
) -> Vec<Compared> {
    let bounds = reference.bounds.as_ref().and_then(Option::as_ref);
    let written = given.iter().filter(|g| g.is_written()).zip(found);
    let compared = written.map(|(given, theirs)| {
        let ours = reference.ours.bytes(given);
        let stated = within.iter().rev().find(|(name, _)| given.is_called(name)).map(|(_, bound)| *bound);
        let permit =
            |at, scalar: naga::Scalar| match (machine::permit(bounds, given, at, scalar, theirs), stated) {
                (Permit::Unknown | Permit::Around { bound: f64::INFINITY, .. }, Some(bound))
                    if number::is_float(scalar) =>
                {
                    let exact = number::float(scalar.width, &ours[at..at + usize::from(scalar.width)]);
                    Permit::Around { exact, bound }
                }
                (Permit::Unknown, Some(bound)) if given.is_coded => {
                    let is_near = |format| texture::is_near(format, at, [ours, theirs], bound);
                    given.format().map_or(Permit::Unknown, |f| Permit::Texel { is_near: is_near(f), bound })
                }
                (permit, _) => permit,
            };
        compare(given, ours, theirs, permit)
    });
    compared.collect()
}

/// Every resource that the shader may write, by its bits.
fn same_bits(given: &[Given], reference: &Reference, found: &[Vec<u8>]) -> Vec<Compared> {
    let written = given.iter().filter(|g| g.is_written()).zip(found);
    written
        .map(|(given, theirs)| compare(given, reference.ours.bytes(given), theirs, |_, _| Permit::Bits))
        .collect()
}

/// Why the interpreter has no answer, after the place in the file that is to blame, if it is known.
fn located(error: MachineError, source: &Source) -> Stop {
    let line = match &error {
        MachineError::Interp(error) => source.text().and_then(|text| error.line(text)),
        _ => None,
    };
    let Stop { status, message } = Stop::from(error);
    match line {
        Some((line, column)) => {
            Stop { status, message: format!("{}:{line}:{column}: {message}", source.name) }
        }
        None => Stop { status, message },
    }
}

/// Every name of a resource in the job.
fn names(job: &Job) -> impl Iterator<Item = &String> {
    let bytes = job.inputs.iter().map(|i| &i.0).chain(job.sizes.iter().map(|s| &s.0));
    let shapes = job.textures.iter().map(|t| &t.0).chain(job.samplers.iter().map(|s| &s.0));
    let results = job.outputs.iter().map(|o| &o.0).chain(job.within.iter().map(|w| &w.0));
    bytes.chain(shapes).chain(results).chain(job.elements.iter().map(|e| &e.0))
}

/// The last of `list` that means `resource`: what comes later on a command line wins.
fn last<'l, T>(list: &'l [(String, T)], resource: &Resource) -> Option<&'l T> {
    list.iter().rev().find(|(name, _)| resource.is_called(name)).map(|(_, value)| value)
}

fn known(all: &[Called], wanted: &str) -> Res<()> {
    if all.iter().any(|called| called.is(wanted)) {
        return Ok(());
    }
    let names: Vec<String> = all.iter().map(|c| format!("`{}` ({})", c.name, c.place)).collect();
    let names = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    stop(Status::Error, format!("the shader has no resource `{wanted}`; it has {names}"))
}

/// The resources, with the elements of binding arrays told apart.
fn each(job: &Job, resources: &[Resource]) -> Res<Vec<Resource>> {
    let mut all = Vec::new();
    for resource in resources {
        all.extend(resource.clone().each(count(job, resource)?));
    }
    Ok(all)
}

/// How many elements a resource has. A binding array that does not say it has those that the user names, and
/// [`ELEMENTS`] at least.
fn count(job: &Job, resource: &Resource) -> Res<u32> {
    let name = &resource.name;
    let named = names(job).filter_map(|name| resource.index_in(name)).max();
    let said = last(&job.elements, resource).copied();
    let count = match (resource.elements, said) {
        (Elements::One, None) => return Ok(1),
        (Elements::One, Some(_)) => return stop(Status::Error, format!("`{name}` is no binding array")),
        (Elements::Known(count), Some(said)) if said != count => {
            return stop(Status::Error, format!("`{name}` has {count} elements, not {said}"));
        }
        (Elements::Known(count), _) | (Elements::Bound, Some(count)) => count,
        (Elements::Bound, None) => named.map_or(0, |index| index.saturating_add(1)).max(ELEMENTS),
    };
    if count == 0 || count > MOST_ELEMENTS {
        return stop(
            Status::Error,
            format!("`{name}` would have {count} elements, not 1 to {MOST_ELEMENTS}"),
        );
    }
    match named.filter(|index| *index >= count) {
        Some(index) => {
            stop(Status::Error, format!("`{name}` has {count} elements, there is no {name}[{index}]"))
        }
        None => Ok(count),
    }
}

/// Where the bytes of a resource came from, and what it is if it is no buffer.
fn described(given: &Given, feed: &Feed) -> String {
    match given.kind {
        BindingKind::Texture(shape) | BindingKind::StorageTexture(shape, _) => {
            format!("{feed}, a texture of {shape}")
        }
        BindingKind::Sampler(sampler) => format!("{sampler:?}"),
        BindingKind::Uniform | BindingKind::StorageRead | BindingKind::StorageReadWrite => feed.to_string(),
    }
}

/// Writes the interpreter's results where they are asked for.
fn write(job: &Job, given: &[Given], ours: &Owned) -> Res<()> {
    for (name, path) in &job.outputs {
        let mut called = given.iter().filter(|g| g.is_called(name));
        let Some(given) = called.next() else { continue };
        if called.next().is_some() {
            return stop(Status::Error, format!("`{name}` has several elements; name one, as {name}[0]"));
        }
        let bytes = ours.bytes(given);
        let bytes = match path.extension() {
            Some(e) if e == "json" => format!("{}\n", json::value(&given.shape, bytes)).into_bytes(),
            _ => bytes.to_vec(),
        };
        let told = |e| stop(Status::Error, format!("{}: cannot be written: {e}", path.display()));
        std::fs::write(path, bytes).or_else(told)?;
    }
    Ok(())
}
