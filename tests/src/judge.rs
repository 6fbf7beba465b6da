//! Asks a kernel the four questions.

use crate::cases::Cases;
use crate::domain::{DomainError, Inputs};
use crate::expectation::Expectation;
use crate::oracle::{self, Mapping};
use crate::perturbed::Perturbed;
use crate::question::agree::Agree;
use crate::question::conformant::Conformant;
use crate::question::correct::Approximation;
use crate::question::expected::Expected;
use crate::question::robust::Robust;
use crate::question::sanitized::Sanitized;
use crate::question::{Answer, Batch, Question, Verdict};
use crate::report::KernelReport;
use crate::search::{Hunt, Limit};
use crate::subject::{Permitted, Subject};
use crate::value::RowError;
use lobe_backends::executor::{Ahead, ExecError, Executor};
use lobe_backends::interp::ShadowColumns;
use lobe_backends::route::Route;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::{FunctionDef, FunctionRef};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::Scope;

/// Rows judged at once: enough to occupy every thread and driver, little enough to show progress.
const BATCH: usize = 8192;

/// What a kernel is asked with.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Rows to draw from the domain.
    pub inputs: usize,
    /// Where the drawing begins.
    pub seed: u64,
    /// Where listed cases and oracle tables lie.
    pub cases: Cases,
    /// Which table speaks of which kernel.
    pub mapping: Mapping,
    /// Whether to look for mistakes of the kernels themselves.
    pub sanitize: bool,
    /// What drivers are permitted.
    pub accuracy: &'static Model,
    /// Drivers drawn by chance that run every row too.
    pub drivers: usize,
    /// How long to look for worse rows than those drawn, if at all.
    pub search: Option<Limit>,
    /// Faults of routes that are known.
    pub expected: Vec<Expectation>,
}

/// Why a kernel could not be judged.
#[derive(Debug, thiserror::Error)]
pub enum JudgeError {
    /// It does not run.
    #[error("{0}")]
    Exec(#[from] ExecError),
    /// Its inputs cannot be drawn.
    #[error("{0}")]
    Domain(#[from] DomainError),
    /// A file of listed cases cannot be used.
    #[error("{}: {cause}", path.display())]
    Listed {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        cause: RowError,
    },
    /// A file cannot be read.
    #[error("{}: cannot be read: {cause}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's words.
        cause: std::io::Error,
    },
    /// There is nothing to judge.
    #[error("{kernel} returns no value, so there is nothing to judge")]
    NoResult {
        /// The kernel.
        kernel: &'static str,
    },
}

/// A kernel and the inputs to judge it with.
#[derive(Debug)]
pub struct Prepared {
    kernel: FunctionRef,
    ready: Result<(Subject, Inputs), JudgeError>,
}

impl Prepared {
    /// Lowers `kernel` and draws its inputs; what keeps it from that is part of the judgement.
    #[must_use]
    pub fn new(kernel: FunctionRef, plan: &Plan) -> Self {
        Self { kernel, ready: prepare(kernel, plan) }
    }

    /// Prepares `kernels`, each while the one before it is judged: `ahead` translates it then too, since some compilers
    /// take as long as a driver takes to run a kernel.
    pub fn each<'scope>(
        scope: &'scope Scope<'scope, '_>,
        kernels: impl IntoIterator<Item = FunctionRef>,
        plan: &'scope Plan,
        ahead: Arc<[Ahead]>,
    ) -> impl Iterator<Item = Self> {
        one_ahead(scope, kernels.into_iter(), move |kernel| {
            let prepared = Self::new(kernel, plan);
            if let Ok((subject, _)) = &prepared.ready {
                ahead.iter().for_each(|route| route.prepare(subject.program()));
            }
            prepared
        })
    }

    /// The kernel.
    #[must_use]
    pub fn def(&self) -> &'static FunctionDef {
        (self.kernel)()
    }
}

/// What can be done for the kernels of `routes` before they run.
#[must_use]
pub fn ahead(routes: &[Box<dyn Executor>]) -> Arc<[Ahead]> {
    routes.iter().filter_map(|route| route.ahead()).collect()
}

fn prepare(kernel: FunctionRef, plan: &Plan) -> Result<(Subject, Inputs), JudgeError> {
    let subject = Subject::new(kernel)?.with_accuracy(plan.accuracy);
    if subject.program().results().is_empty() {
        return Err(JudgeError::NoResult { kernel: subject.def().name });
    }
    let listed = plan.cases.listed(subject.def())?;
    let inputs = Inputs::draw(subject.def(), plan.inputs, plan.seed, &listed)?;
    Ok((subject, inputs))
}

/// Makes something of each item on another thread, while the caller is busy with the one before it.
fn one_ahead<'scope, T: Send + 'scope, R: Send + 'scope>(
    scope: &'scope Scope<'scope, '_>,
    mut items: impl Iterator<Item = T>,
    make: impl Fn(T) -> R + Clone + Send + 'scope,
) -> impl Iterator<Item = R> {
    let begin = move |item| {
        let make = make.clone();
        scope.spawn(move || make(item))
    };
    let mut next = items.next().map(&begin);
    std::iter::from_fn(move || {
        let made = next.take()?.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        next = items.next().map(&begin);
        Some(made)
    })
}

/// Judges `kernel` on `routes`; what keeps it from being judged becomes an answer that falls short.
///
/// `progress` is called with the number of rows done.
pub fn judge(
    kernel: FunctionRef,
    plan: &Plan,
    routes: &mut [Box<dyn Executor>],
    progress: &dyn Fn(usize),
) -> KernelReport {
    judge_prepared(Prepared::new(kernel, plan), plan, routes, progress)
}

/// The same, of a kernel that was prepared with the same plan.
pub fn judge_prepared(
    prepared: Prepared,
    plan: &Plan,
    routes: &mut [Box<dyn Executor>],
    progress: &dyn Fn(usize),
) -> KernelReport {
    let mut report = KernelReport::new(prepared.def());
    match prepared.ready.and_then(|ready| answers(ready, plan, routes, progress, &mut report)) {
        Ok(answers) => report.answers = answers,
        Err(error) => {
            let verdict = Verdict::FallsShort(error.to_string());
            report.answers = vec![Answer::bare(Question::Correct, "", verdict)];
        }
    }
    report
}

fn answers(
    (subject, inputs): (Subject, Inputs),
    plan: &Plan,
    routes: &mut [Box<dyn Executor>],
    progress: &dyn Fn(usize),
    report: &mut KernelReport,
) -> Result<Vec<Answer>, JudgeError> {
    report.take_inputs(&inputs);
    let mut questions = Questions::new(routes, plan.sanitize);
    let mut hunt = plan.search.map(|limit| (Hunt::default(), limit));
    let mut perturbed = (plan.drivers > 0).then(|| Perturbed::new(plan.drivers, plan.seed));
    each_batch(&subject, &inputs.args, routes, &mut |batch| {
        questions.ask(batch);
        hunt.iter_mut().for_each(|(hunt, _)| hunt.absorb(batch));
        perturbed.iter_mut().for_each(|perturbed| perturbed.absorb(batch));
        progress(batch.args.rows);
    })?;
    if let Some((mut hunt, limit)) = hunt {
        hunt.run(&subject, (limit, plan.seed), routes, &mut |batch| questions.ask_of_found(batch))?;
        report.search = Some(hunt.finish(subject.def()));
    }
    let expected = Expected::new(subject.def().name, &plan.expected, drivers(routes));
    let mut answers = oracle::judge_kernel(&subject, &plan.mapping, &plan.cases);
    answers.extend(questions.finish(&subject, &expected));
    if let Some(perturbed) = perturbed {
        let (answer, tightness) = perturbed.finish();
        answers.push(answer);
        report.tightness = tightness;
    }
    Ok(answers)
}

/// What the driver of each route says of itself.
fn drivers(routes: &[Box<dyn Executor>]) -> Vec<(String, String)> {
    routes.iter().map(|r| (r.route().to_string(), r.driver_info().to_owned())).collect()
}

/// Runs `args` on `routes`, batch by batch; the bounds of the next batch are derived meanwhile.
pub(crate) fn each_batch(
    subject: &Subject,
    args: &Columns,
    routes: &mut [Box<dyn Executor>],
    take: &mut dyn FnMut(&Batch<'_>),
) -> Result<(), JudgeError> {
    std::thread::scope(|scope| {
        let starts = (0..args.rows).step_by(BATCH);
        let batches = starts.map(|start| args.slice(start..(start + BATCH).min(args.rows)));
        for bounded in one_ahead(scope, batches, |args| Bounded::new(subject, args)) {
            let Bounded { args, shadow, permitted } = bounded?;
            let outputs: Vec<_> = routes
                .iter_mut()
                .map(|r| (r.route().clone(), r.run(subject.program(), &args).map_err(|e| e.to_string())))
                .collect();
            take(&Batch { subject, args: &args, shadow: &shadow, permitted: &permitted, outputs: &outputs });
        }
        Ok(())
    })
}

/// Rows with what may come of them.
struct Bounded {
    args: Columns,
    shadow: ShadowColumns,
    permitted: Permitted,
}

impl Bounded {
    fn new(subject: &Subject, args: Columns) -> Result<Self, ExecError> {
        let shadow = subject.program().shadow(&args, None)?;
        let permitted = subject.permitted(&args, &shadow)?;
        Ok(Self { args, shadow, permitted })
    }
}

struct Questions {
    approximation: Approximation,
    robust: Robust,
    conformant: Conformant,
    agree: Agree,
    sanitized: Option<Sanitized>,
}

impl Questions {
    fn new(routes: &[Box<dyn Executor>], sanitize: bool) -> Self {
        let names: Vec<Route> = routes.iter().map(|r| r.route().clone()).collect();
        Self {
            approximation: Approximation::default(),
            robust: Robust::default(),
            conformant: Conformant::default(),
            agree: Agree::new(&names),
            sanitized: sanitize.then(Sanitized::default),
        }
    }

    fn ask(&mut self, batch: &Batch<'_>) {
        self.robust.absorb(batch);
        self.conformant.absorb(batch);
        self.ask_the_others(batch);
    }

    /// Of rows that were looked for.
    fn ask_of_found(&mut self, batch: &Batch<'_>) {
        self.robust.absorb_found(batch);
        self.conformant.absorb_found(batch);
        self.ask_the_others(batch);
    }

    fn ask_the_others(&mut self, batch: &Batch<'_>) {
        self.approximation.absorb(batch);
        self.agree.absorb(batch);
        self.sanitized.iter_mut().for_each(|sanitized| sanitized.absorb(batch));
    }

    fn finish(self, subject: &Subject, expected: &Expected<'_>) -> Vec<Answer> {
        let mut answers: Vec<Answer> = self.approximation.finish(subject).into_iter().collect();
        answers.push(self.robust.finish(subject));
        answers.extend(self.sanitized.map(|sanitized| sanitized.finish(subject)));
        answers.extend(self.conformant.finish(expected));
        answers.extend(self.agree.finish(expected));
        answers
    }
}
