//! One job, from the file to the reports.

use super::compare::{Permit, compare};
use super::feed::{self, Feed};
use super::job::{Entry, GivenUp, Job, Step};
use super::json;
use super::number;
use super::report::{Input, Report, RouteReport, RouteStatus, Status};
use super::resource::{self, Resource};
use super::routes::{Routes, ShaderRoute, Subject};
use lobe_backends::interp::{Buffer, InterpError, Interpreter};
use lobe_codegen::ValidModule;
use lobe_codegen::foreign::{self, ForeignError, Language, Override, Source};
use std::path::Path;
use std::time::Duration;

/// What a buffer holds of which nothing is said.
const USUAL: Feed = Feed::Random(0);

/// Most invocations of a run.
const INVOCATIONS: u64 = 1 << 36;

/// Why an entry point has no comparison.
struct Stop {
    status: Status,
    message: String,
}

type Res<T> = Result<T, Stop>;

fn stop<T>(status: Status, message: impl Into<String>) -> Res<T> {
    Err(Stop { status, message: message.into() })
}

/// Runs `job` on the interpreter and on its routes; `begin` hears of each step before it is taken.
pub fn run(job: &Job, routes: &mut Routes, begin: &mut dyn FnMut(&Step)) -> Vec<Report> {
    let mut run = Run { job, routes, begin };
    match run.read() {
        Ok((source, module, entries)) => {
            entries.iter().map(|entry| run.entry(&source, &module, entry)).collect()
        }
        Err(Stop { status, message }) => vec![Report::of(run.file(), None, status, message)],
    }
}

struct Run<'r> {
    job: &'r Job,
    routes: &'r mut Routes,
    begin: &'r mut dyn FnMut(&Step),
}

impl Run<'_> {
    fn file(&self) -> String {
        self.job.file.display().to_string()
    }

    /// Says what comes next, unless it is known to end badly.
    fn step(&mut self, entry: Option<&str>, name: &str) -> Result<(), GivenUp> {
        let step = Step { entry: entry.map(str::to_owned), name: name.to_owned() };
        if let Some(known) = self.job.given_up.iter().find(|g| g.step == step) {
            return Err(known.clone());
        }
        (self.begin)(&step);
        Ok(())
    }

    fn read(&mut self) -> Res<(Source, ValidModule, Vec<String>)> {
        self.step(None, "read")?;
        let name = self.file();
        let Some(language) = Language::of(&self.job.file) else {
            return stop(Status::Error, format!("{name}: ends in none of .wgsl, .spv, .glsl, .comp"));
        };
        let bytes = std::fs::read(&self.job.file);
        let bytes = bytes.or_else(|e| stop(Status::Error, format!("{name}: cannot be read: {e}")))?;
        let source = Source { name, language, bytes };
        let module = foreign::read(&source)?;
        let entries = match &self.job.entry {
            Entry::Named(wanted) => vec![foreign::choose(&source, &module, Some(wanted))?],
            Entry::Only => vec![foreign::choose(&source, &module, None)?],
            Entry::Each => match foreign::choose(&source, &module, None) {
                Err(ForeignError::SeveralEntries { entries, .. }) => entries,
                other => vec![other?],
            },
        };
        Ok((source, module, entries))
    }

    fn entry(&mut self, source: &Source, module: &ValidModule, entry: &str) -> Report {
        let mut report = Report::of(self.file(), Some(entry.to_owned()), Status::Ok, String::new());
        report.message = None;
        report.workgroups = self.job.workgroups;
        if let Err(Stop { status, message }) = self.judge(source, module, entry, &mut report) {
            report.status = status;
            report.message = Some(message);
        }
        report
    }

    fn judge(&mut self, source: &Source, module: &ValidModule, entry: &str, report: &mut Report) -> Res<()> {
        self.step(Some(entry), "interp")?;
        let overrides: Vec<Override> = self.job.overrides.iter().map(constant).collect();
        let isolated = foreign::isolate(source, module, entry, &overrides)?;
        let points = &isolated.module().entry_points;
        let index = points.iter().position(|p| p.name == entry && p.stage == naga::ShaderStage::Compute);
        let Some(index) = index else { return stop(Status::Refused, "the entry point was lost") };
        let resources = resource::of(&isolated, index)
            .or_else(|what| stop(Status::Refused, format!("unsupported: {what}")))?;
        report.workgroup_size = points[index].workgroup_size;
        let buffers = self.fill(&resources, report)?;
        let mut ours = buffers.clone();
        interpret(&isolated, index, self.job, &mut ours)?;
        self.write(&resources, &ours)?;
        let subject = Subject {
            source,
            module: &isolated,
            entry,
            is_as_written: module.module().overrides.is_empty(),
            workgroup_size: report.workgroup_size,
            workgroups: self.job.workgroups,
            resources: &resources,
        };
        for route in self.wanted(source.language)? {
            let found = self.route(&route, &subject, &buffers, &ours);
            report.add(found);
        }
        Ok(())
    }

    fn fill(&self, resources: &[Resource], report: &mut Report) -> Res<Vec<Buffer>> {
        let job = self.job;
        let named = job.inputs.iter().map(|i| &i.0).chain(job.sizes.iter().map(|s| &s.0));
        for name in named.chain(job.outputs.iter().map(|o| &o.0)) {
            known(resources, name)?;
        }
        let volume = |sides: [u32; 3]| sides.iter().map(|n| u64::from(*n)).fold(1, u64::saturating_mul);
        let invocations = volume(report.workgroup_size).saturating_mul(volume(job.workgroups));
        if invocations > INVOCATIONS {
            return stop(Status::Error, format!("{invocations} invocations are more than {INVOCATIONS}"));
        }
        let mut buffers = Vec::new();
        for resource in resources {
            let feed = last(&job.inputs, resource).unwrap_or(&USUAL);
            let size = last(&job.sizes, resource).copied();
            let data = feed::fill(resource, feed, size, invocations).or_else(|e| stop(Status::Error, e))?;
            report.inputs.push(Input {
                name: resource.name.clone(),
                place: resource.place(),
                bytes: data.len(),
                from: feed.to_string(),
            });
            buffers.push(Buffer { group: resource.group, binding: resource.binding, data });
        }
        Ok(buffers)
    }

    /// Writes the interpreter's results where they are asked for.
    fn write(&self, resources: &[Resource], buffers: &[Buffer]) -> Res<()> {
        for (name, path) in &self.job.outputs {
            let found = resources.iter().zip(buffers).find(|(r, _)| r.is_called(name));
            let Some((resource, buffer)) = found else { continue };
            let bytes = match path.extension() {
                Some(e) if e == "json" => {
                    format!("{}\n", json::value(&resource.shape, &buffer.data)).into_bytes()
                }
                _ => buffer.data.clone(),
            };
            let told = |e| stop(Status::Error, format!("{}: cannot be written: {e}", path.display()));
            std::fs::write(path, bytes).or_else(told)?;
        }
        Ok(())
    }

    fn wanted(&self, language: Language) -> Res<Vec<ShaderRoute>> {
        if self.job.routes.is_empty() {
            return Ok(self.routes.ready(language));
        }
        let named = self.job.routes.iter().filter(|r| *r != "interp");
        named.map(|r| r.parse().or_else(|e: String| stop(Status::Error, e))).collect()
    }

    fn route(
        &mut self,
        route: &ShaderRoute,
        subject: &Subject<'_>,
        buffers: &[Buffer],
        ours: &[Buffer],
    ) -> RouteReport {
        let name = route.to_string();
        if let Err(GivenUp { status, message, .. }) = self.step(Some(subject.entry), &name) {
            let status = if status == Status::Timeout { RouteStatus::Timeout } else { RouteStatus::Crashed };
            return RouteReport::without(&name, status, message);
        }
        // The supervisor ends a step before its driver is given up here.
        let timeout = Duration::from_secs(self.job.timeout.saturating_mul(2));
        let outcome = lobe_codegen::quietly(|| self.routes.run(route, subject, buffers, timeout));
        let found = match outcome {
            Ok(Ok(found)) => found,
            Ok(Err(failure)) => return RouteReport::without(&name, failure.status, failure.message),
            Err(message) => {
                return RouteReport::without(&name, RouteStatus::Crashed, format!("panicked: {message}"));
            }
        };
        let written = subject.resources.iter().zip(ours).filter(|(r, _)| r.is_writable());
        let compared = written.zip(&found).map(|((resource, ours), theirs)| {
            let permit = |_, scalar| if number::is_float(scalar) { Permit::Unknown } else { Permit::Bits };
            compare(resource, &ours.data, theirs, permit)
        });
        RouteReport::compared(&name, compared.collect())
    }
}

fn constant((name, value): &(String, f64)) -> Override {
    Override { name: name.clone(), value: *value }
}

/// The last of `list` that means `resource`: what comes later on a command line wins.
fn last<'l, T>(list: &'l [(String, T)], resource: &Resource) -> Option<&'l T> {
    list.iter().rev().find(|(name, _)| resource.is_called(name)).map(|(_, value)| value)
}

fn known(resources: &[Resource], name: &str) -> Res<()> {
    if resources.iter().any(|r| r.is_called(name)) {
        return Ok(());
    }
    let names: Vec<String> = resources.iter().map(|r| format!("`{}` ({})", r.name, r.place())).collect();
    let names = if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    stop(Status::Error, format!("the entry point uses no buffer `{name}`; it uses {names}"))
}

fn interpret(module: &ValidModule, entry: usize, job: &Job, buffers: &mut [Buffer]) -> Res<()> {
    let outcome = lobe_codegen::quietly(|| {
        Interpreter::new(module)?.with_fuel(job.fuel).run(entry, job.workgroups, buffers)
    });
    match outcome {
        Ok(Ok(())) => Ok(()),
        Ok(Err(error)) => {
            let status = match error {
                InterpError::OutOfFuel { .. } => Status::Timeout,
                InterpError::NonUniformBarrier { .. } => Status::Findings,
                _ => Status::Refused,
            };
            stop(status, error.to_string())
        }
        Err(message) => stop(Status::Crashed, format!("the interpreter panicked: {message}")),
    }
}

impl From<GivenUp> for Stop {
    fn from(given_up: GivenUp) -> Self {
        Self { status: given_up.status, message: format!("{}: {}", given_up.step.name, given_up.message) }
    }
}

impl From<ForeignError> for Stop {
    fn from(error: ForeignError) -> Self {
        let status = match error {
            ForeignError::Encoding { .. } | ForeignError::Parse { .. } | ForeignError::Invalid { .. } => {
                Status::Invalid
            }
            ForeignError::Panicked { .. } => Status::Crashed,
            ForeignError::NoEntry { .. } => Status::Refused,
            ForeignError::SeveralEntries { .. }
            | ForeignError::UnknownEntry { .. }
            | ForeignError::Override { .. } => Status::Error,
        };
        Self { status, message: error.to_string() }
    }
}

/// Whether a file of this name may be a shader.
#[must_use]
pub fn is_shader(path: &Path) -> bool {
    Language::of(path).is_some()
}
