//! The far end of worker processes: jobs are handed out, steps watched, and what crashes or hangs is started anew.

use super::job::{GivenUp, Job, Step};
use super::report::{Report, Status};
use super::serve::{Event, MARK};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// How long a worker may take to look for drivers.
const START: Duration = Duration::from_secs(120);

/// Steps of a job that may crash or hang before the rest is given up too.
const PATIENCE: usize = 32;

/// How workers are started.
#[derive(Debug, Clone)]
pub struct Plan {
    /// A program that calls [`serve`](super::serve::serve).
    pub program: PathBuf,
    /// Its arguments.
    pub arguments: Vec<String>,
    /// Workers at a time.
    pub workers: usize,
    /// Threads that each may use; `None`: as many as it likes.
    pub threads: Option<usize>,
}

/// Runs all jobs, and hands out the reports of each in the order of the jobs.
pub fn supervise(plan: &Plan, jobs: &[Job], each: &mut (dyn FnMut(&Job, Vec<Report>) + Send)) {
    let next = AtomicUsize::new(0);
    let ordered = Mutex::new(Ordered { waiting: BTreeMap::new(), next: 0, each });
    std::thread::scope(|scope| {
        for _ in 0..plan.workers.clamp(1, jobs.len().max(1)) {
            scope.spawn(|| {
                let mut post = Post { plan, worker: None };
                while let Some((index, job)) = take(&next, jobs) {
                    let reports = post.run(job);
                    ordered.lock().unwrap_or_else(PoisonError::into_inner).deliver(jobs, index, reports);
                }
            });
        }
    });
}

fn take<'j>(next: &AtomicUsize, jobs: &'j [Job]) -> Option<(usize, &'j Job)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    jobs.get(index).map(|job| (index, job))
}

/// Reports that wait for those of jobs before them.
struct Ordered<'e> {
    waiting: BTreeMap<usize, Vec<Report>>,
    next: usize,
    each: &'e mut (dyn FnMut(&Job, Vec<Report>) + Send),
}

impl Ordered<'_> {
    fn deliver(&mut self, jobs: &[Job], index: usize, reports: Vec<Report>) {
        self.waiting.insert(index, reports);
        while let Some(reports) = self.waiting.remove(&self.next) {
            (self.each)(&jobs[self.next], reports);
            self.next += 1;
        }
    }
}

/// A place for a worker, which may be replaced.
struct Post<'p> {
    plan: &'p Plan,
    worker: Option<Worker>,
}

impl Post<'_> {
    /// Runs a job to its end, with a new worker after each step that ends badly.
    fn run(&mut self, job: &Job) -> Vec<Report> {
        let mut job = job.clone();
        let told = |step: Option<&Step>, status, message| {
            vec![Report::of(
                job.file.display().to_string(),
                step.and_then(|s| s.entry.clone()),
                status,
                message,
            )]
        };
        loop {
            let worker = match self.worker.take().map_or_else(|| Worker::start(self.plan), Ok) {
                Ok(worker) => worker,
                Err(message) => return told(None, Status::Error, message),
            };
            match worker.ask(&job) {
                Ok((worker, reports)) => {
                    self.worker = Some(worker);
                    return reports;
                }
                Err(end) if end.step.entry.is_none() || job.given_up.len() >= PATIENCE => {
                    let message = format!("{}: {}", end.step.name, end.message);
                    return told(Some(&end.step), end.status, message);
                }
                Err(end) => job.given_up.push(end),
            }
        }
    }
}

/// A worker process.
struct Worker {
    child: Child,
    input: ChildStdin,
    events: Receiver<Event>,
    /// The last line on its standard error.
    complaint: Arc<Mutex<String>>,
}

impl Worker {
    fn start(plan: &Plan) -> Result<Self, String> {
        let mut command = Command::new(&plan.program);
        command.args(&plan.arguments);
        for name in ["RAYON_NUM_THREADS", "LP_NUM_THREADS"] {
            if let Some(threads) = plan.threads.filter(|_| std::env::var_os(name).is_none()) {
                command.env(name, threads.to_string());
            }
        }
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let told = |e| format!("no worker process could be started: {e}");
        let mut child = command.spawn().map_err(|e| told(e.to_string()))?;
        let (input, output, errors) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (Some(input), Some(output), Some(errors)) = (input, output, errors) else {
            return Err(told("it has no pipes".to_owned()));
        };
        let complaint = Arc::new(Mutex::new(String::new()));
        let worker = Self { child, input, events: listen(output), complaint: Arc::clone(&complaint) };
        std::thread::spawn(move || keep_last(errors, &complaint));
        match worker.events.recv_timeout(START) {
            Ok(Event::Ready) => Ok(worker),
            _ => Err(told(format!("it does not answer; {}", worker.last_words()))),
        }
    }

    /// Gives the worker a job and waits for the reports; a worker that fails is gone.
    fn ask(mut self, job: &Job) -> Result<(Self, Vec<Report>), GivenUp> {
        let mut step = Step { entry: None, name: "read".to_owned() };
        let limit = Duration::from_secs(job.timeout);
        let line = serde_json::to_string(job).unwrap_or_default();
        // A worker that has ended shows below, as a closed channel.
        let _ = writeln!(self.input, "{line}").and_then(|()| self.input.flush());
        loop {
            match self.events.recv_timeout(limit) {
                Ok(Event::Ready) => {}
                Ok(Event::Step(next)) => step = next,
                Ok(Event::Reports(reports)) => return Ok((self, reports)),
                Err(RecvTimeoutError::Timeout) => {
                    let message = format!("not done after {} s", limit.as_secs());
                    return Err(GivenUp { step, status: Status::Timeout, message });
                }
                Err(RecvTimeoutError::Disconnected) => {
                    let message = self.last_words_of_the_dead();
                    return Err(GivenUp { step, status: Status::Crashed, message });
                }
            }
        }
    }

    fn last_words(&self) -> String {
        self.complaint.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    fn last_words_of_the_dead(&mut self) -> String {
        let ended = self.child.wait().map_or_else(|e| e.to_string(), |status| status.to_string());
        match self.last_words().as_str() {
            "" => ended,
            words => format!("{ended}; {words}"),
        }
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // It may have ended already; and a driver that hangs would not hear of a closed pipe.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The events on a worker's standard output.
fn listen(output: impl std::io::Read + Send + 'static) -> Receiver<Event> {
    let (there, events) = mpsc::channel();
    std::thread::spawn(move || {
        for line in BufReader::new(output).split(b'\n').map_while(Result::ok) {
            let event = line.strip_prefix(MARK.as_bytes()).and_then(|json| serde_json::from_slice(json).ok());
            if event.is_some_and(|event| there.send(event).is_err()) {
                break;
            }
        }
    });
    events
}

fn keep_last(errors: impl std::io::Read, last: &Mutex<String>) {
    for line in BufReader::new(errors).split(b'\n').map_while(Result::ok) {
        let line = String::from_utf8_lossy(&line).trim().to_owned();
        if !line.is_empty() {
            *last.lock().unwrap_or_else(PoisonError::into_inner) = line;
        }
    }
}
