//! The near end of a worker process: jobs come in as lines of JSON, steps and reports go out.

use super::job::{Job, Step};
use super::report::Report;
use super::routes::Routes;
use super::run;
use std::io::{BufRead, Write};

/// Begins each line that is meant for the supervisor; drivers and compilers print as they like.
pub(super) const MARK: &str = "@lobe ";

/// Deeply nested shaders make parsers and writers recurse.
const STACK: usize = 1 << 29;

/// What a worker says.
#[derive(Debug, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Event {
    /// It waits for jobs.
    Ready,
    /// It begins this step.
    Step(Step),
    /// It has ended a job.
    Reports(Vec<Report>),
}

/// Runs the jobs that standard input brings, until it ends.
///
/// # Errors
/// When standard input or output breaks, or there is no memory for a thread.
pub fn serve() -> std::io::Result<()> {
    let thread = std::thread::Builder::new().name("jobs".to_owned()).stack_size(STACK).spawn(jobs)?;
    thread.join().unwrap_or_else(|_| Err(std::io::Error::other("the thread of jobs panicked")))
}

fn jobs() -> std::io::Result<()> {
    let mut routes = Routes::look();
    say(&Event::Ready)?;
    for line in std::io::stdin().lock().lines() {
        let job: Job = serde_json::from_str(&line?)?;
        let mut broken = Ok(());
        let reports = run(&job, &mut routes, &mut |step| broken = say(&Event::Step(step.clone())));
        broken?;
        say(&Event::Reports(reports))?;
    }
    Ok(())
}

fn say(event: &Event) -> std::io::Result<()> {
    let mut out = std::io::stdout().lock();
    // What stands before may be half a line of somebody else's.
    write!(out, "\n{MARK}{}\n", serde_json::to_string(event)?)?;
    out.flush()
}
