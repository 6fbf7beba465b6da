//! Each device lives on a thread of its own, so that a driver that hangs can be left behind.
//!
//! A time limit on wgpu's `poll` is not enough: a driver's compiler may hang before anything is submitted, and closing a
//! device waits without limit for what still runs on it.

use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use super::device::Device;
use super::owned::OwnedJob;
use super::{Driver, GpuError, Job, check};

/// How long a job may take, compilation included, unless [`Gpu::set_timeout`] says otherwise.
pub const DEFAULT_TIMEOUT: Duration = Duration::from_secs(60);

/// How long an idle device may take to close before it is left behind.
const CLOSING_TIME: Duration = Duration::from_secs(5);

/// Stack of a device's thread: naga and drivers' compilers recurse as deeply as a shader nests.
const STACK: usize = 1 << 28;

/// An opened device, with the pipelines and buffers of its recent jobs.
pub struct Gpu {
    driver: Driver,
    limits: wgpu::Limits,
    timeout: Duration,
    /// `None` after the device was lost, until the next job.
    worker: Option<Worker>,
}

impl Gpu {
    /// Opens a device on `driver`.
    ///
    /// # Errors
    ///
    /// [`GpuError::Open`], or [`GpuError::Timeout`] if the driver hangs.
    pub fn open(driver: &Driver) -> Result<Self, GpuError> {
        let (worker, limits) = Worker::start(driver, DEFAULT_TIMEOUT)?;
        Ok(Self { driver: driver.clone(), limits, timeout: DEFAULT_TIMEOUT, worker: Some(worker) })
    }

    /// The driver that was opened.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        &self.driver
    }

    /// Sets how long a job may take from now on.
    pub fn set_timeout(&mut self, timeout: Duration) {
        self.timeout = timeout;
    }

    /// Runs one job and returns the final bytes of every [`StorageReadWrite`](super::BindingKind::StorageReadWrite)
    /// buffer and every [`StorageTexture`](super::BindingKind::StorageTexture) that may be written, in order.
    ///
    /// The same shader with new data is fast: its pipeline and buffers are kept.
    ///
    /// WGSL cannot reach outside its buffers. SPIR-V runs as it is, with whatever access its instructions make; the
    /// driver may or may not be robust against one that is out of bounds.
    ///
    /// # Errors
    ///
    /// A [`GpuError`] that says whose fault it was. After any of them the next job runs, on a fresh device if need be.
    pub fn run(&mut self, job: &Job) -> Result<Vec<Vec<u8>>, GpuError> {
        self.ask(job, 0)?.outputs
    }

    /// How long each of `rounds` dispatches of a job takes, from encoding to completion, its data staying on the
    /// device.
    ///
    /// # Errors
    ///
    /// As [`Gpu::run`].
    pub fn time(&mut self, job: &Job, rounds: usize) -> Result<Vec<Duration>, GpuError> {
        let answer = self.ask(job, rounds)?;
        answer.outputs.map(|_| answer.times)
    }

    /// Runs a job, or times it.
    fn ask(&mut self, job: &Job, rounds: usize) -> Result<Answer, GpuError> {
        check::check(&self.driver.name, &self.limits, job)?;
        check::check_formats(&self.driver, job)?;
        let worker = match self.worker.take() {
            Some(worker) => worker,
            None => Worker::start(&self.driver, self.timeout)?.0,
        };
        match worker.run((OwnedJob::of(job), rounds), self.timeout) {
            Ok(answer) => {
                if answer.is_device_well {
                    self.worker = Some(worker);
                }
                Ok(answer)
            }
            Err(why) => {
                worker.leave_behind();
                Err(given_up(&self.driver, why, self.timeout))
            }
        }
    }
}

impl std::fmt::Debug for Gpu {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Gpu")
            .field("driver", &self.driver)
            .field("timeout", &self.timeout)
            .finish_non_exhaustive()
    }
}

/// The near end of a device's thread.
struct Worker {
    /// `None` once the thread has been told to end.
    jobs: Option<Sender<Task>>,
    answers: Receiver<Answer>,
    thread: Option<JoinHandle<()>>,
}

/// A job, and how often it is timed; not at all if it is to be run.
type Task = (OwnedJob, usize);

struct Answer {
    outputs: Result<Vec<Vec<u8>>, GpuError>,
    times: Vec<Duration>,
    is_device_well: bool,
}

impl Worker {
    fn start(driver: &Driver, timeout: Duration) -> Result<(Self, wgpu::Limits), GpuError> {
        let (jobs, jobs_there) = mpsc::channel();
        let (answers_there, answers) = mpsc::channel();
        let (opened_there, opened) = mpsc::channel();
        let theirs = driver.clone();
        let builder = thread::Builder::new().name(format!("gpu {}", driver.name)).stack_size(STACK);
        let spawned = builder.spawn(move || {
            match Device::open(&theirs) {
                Ok(device) => {
                    if opened_there.send(Ok(device.limits())).is_ok() {
                        serve(device, &jobs_there, &answers_there);
                    }
                }
                // Nobody listens only if the time limit has passed, and then nobody needs the reason.
                Err(error) => drop(opened_there.send(Err(error))),
            }
        });
        let thread = spawned.map_err(|error| GpuError::Open {
            driver: driver.name.clone(),
            reason: format!("no thread: {error}"),
        })?;
        let limits = opened.recv_timeout(timeout).map_err(|why| given_up(driver, why, timeout))??;
        Ok((Self { jobs: Some(jobs), answers, thread: Some(thread) }, limits))
    }

    /// Hands `job` over and waits for the answer.
    fn run(&self, job: Task, timeout: Duration) -> Result<Answer, RecvTimeoutError> {
        if let Some(jobs) = &self.jobs {
            // A thread that has ended shows below, as a closed channel of answers.
            let _ = jobs.send(job);
        }
        self.answers.recv_timeout(timeout)
    }

    /// Gives up a thread that does not answer.
    fn leave_behind(mut self) {
        self.thread = None;
    }
}

impl Drop for Worker {
    /// Waits for the device to close, for a driver that is still at work while the process ends may crash; but not
    /// for one that hangs.
    fn drop(&mut self) {
        self.jobs = None;
        let Some(thread) = self.thread.take() else { return };
        if let Err(RecvTimeoutError::Disconnected) = self.answers.recv_timeout(CLOSING_TIME) {
            // An error would be a panic in wgpu on the way down, with the result long delivered.
            let _ = thread.join();
        }
    }
}

fn given_up(driver: &Driver, why: RecvTimeoutError, limit: Duration) -> GpuError {
    let driver = driver.name.clone();
    match why {
        RecvTimeoutError::Timeout => GpuError::Timeout { driver, limit },
        RecvTimeoutError::Disconnected => {
            GpuError::DeviceLost { driver, message: "wgpu panicked (see standard error)".to_owned() }
        }
    }
}

fn serve(mut device: Device, jobs: &Receiver<Task>, answers: &Sender<Answer>) {
    while let Ok((job, rounds)) = jobs.recv() {
        let mut times = Vec::new();
        let outputs = job.lend(|job| match rounds {
            0 => device.run(job),
            rounds => device.time(job, rounds).map(|t| {
                times = t;
                Vec::new()
            }),
        });
        let is_device_well = !device.is_lost();
        if answers.send(Answer { outputs, times, is_device_well }).is_err() || !is_device_well {
            break;
        }
    }
}
