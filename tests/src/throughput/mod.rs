//! Throughput: the same kernels on every executor, side by side, round after round.
//!
//! What is reported are medians over the rounds, of times and of the ratios within a round: a machine that is busy
//! slows the executors of one round alike.

mod executor;
mod workload;

pub use executor::{BenchError, Executor};
pub use workload::{MOST, Maker, WORKLOADS, Workload};

use crate::domain::Rng;
use executor::Subject;
use lobe_backends::interp::Isa;
use std::collections::BTreeMap;

/// What one executor did on one kernel.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Measurement {
    /// The workload.
    pub kernel: &'static str,
    /// `interp` or `native`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub executor: Option<&'static str>,
    /// The route to a driver.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub route: Option<String>,
    /// The interpreter's instruction set.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub isa: Option<String>,
    /// Threads that it could use.
    pub threads: usize,
    /// Invocations.
    pub items: usize,
    /// Median time of one pass over all items.
    pub seconds: f64,
    /// Rounds.
    pub rounds: usize,
    /// How many times as fast as each of the others, the median of the rounds.
    pub ratio_to: BTreeMap<String, f64>,
}

/// Passes of an executor in a round, of which the median counts: the first meets what the one before left behind.
const PASSES: usize = 3;

/// Measures `workload` on all executors, `rounds` times after one round that is not counted.
///
/// # Errors
/// When an executor gives up.
pub fn measure(
    workload: &Workload,
    executors: &mut [Executor],
    rounds: usize,
) -> Result<Vec<Measurement>, BenchError> {
    let module = executor::module(workload)?;
    let mut subject = Subject::new(workload, &module)?;
    let mut times = vec![Vec::with_capacity(rounds); executors.len()];
    let names: Vec<String> = executors.iter().map(Executor::name).collect();
    for round in 0..=rounds {
        for at in order(names.len(), round) {
            let mut passes = Vec::new();
            for _ in 0..PASSES {
                passes.push(subject.time(&mut executors[at])?.as_secs_f64());
            }
            if round > 0 {
                times[at].push(median(passes));
            }
        }
    }
    let measurement = |(at, executor): (usize, &Executor)| {
        let others = (0..names.len()).filter(|other| *other != at);
        let ratio = |other: usize| {
            let ratios = times[other].iter().zip(&times[at]).map(|(theirs, ours)| theirs / ours);
            (names[other].clone(), median(ratios.collect()))
        };
        Measurement {
            kernel: workload.name,
            executor: match executor {
                Executor::Interp(_) => Some("interp"),
                Executor::Native => Some("native"),
                Executor::Gpu { .. } => None,
            },
            route: matches!(executor, Executor::Gpu { .. }).then(|| names[at].clone()),
            isa: match executor {
                Executor::Interp(isa) => Some(isa.to_string()),
                Executor::Native | Executor::Gpu { .. } => None,
            },
            threads: rayon::current_num_threads(),
            items: workload.items,
            seconds: median(times[at].clone()),
            rounds,
            ratio_to: others.map(ratio).collect(),
        }
    };
    Ok(executors.iter().enumerate().map(measurement).collect())
}

/// Who runs when in a round: one who comes after a driver finds caches and processors as that left them, so everyone takes
/// turns at coming first, and at coming after each of the others.
pub(crate) fn order(executors: usize, round: usize) -> Vec<usize> {
    let mut rng = Rng::new(round as u64, "order");
    let mut order: Vec<_> = (0..executors).collect();
    for at in (1..executors).rev() {
        order.swap(at, rng.below(at + 1));
    }
    order
}

pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

impl Measurement {
    /// What others call it in their `ratio_to`.
    #[must_use]
    pub fn name(&self) -> String {
        match (&self.route, &self.isa) {
            (Some(route), _) => route.clone(),
            (None, Some(isa)) => format!("interp/{isa}"),
            (None, None) => "native".to_owned(),
        }
    }
}

/// How many times as fast as lavapipe the interpreter shall be on each workload, in the order of [`WORKLOADS`].
#[must_use]
pub fn goals(isa: Isa) -> Option<[f64; WORKLOADS.len()]> {
    match isa {
        Isa::Avx512 => Some([1.4, 3.2, 8.0]),
        Isa::Avx2 => Some([1.0, 2.4, 8.0]),
        Isa::Portable => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of some executors, whoever they are: each follows each other about as often.
    #[test]
    fn everyone_comes_after_everyone() {
        let mut after = [[0; 5]; 5];
        for round in 0..1000 {
            let order = order(5, round);
            order.windows(2).for_each(|pair| after[pair[0]][pair[1]] += 1);
        }
        for (before, counts) in after.iter().enumerate() {
            let others = counts.iter().enumerate().filter(|(at, _)| *at != before);
            assert!(others.clone().all(|(_, n)| (150..250).contains(n)) && counts[before] == 0, "{after:?}");
        }
    }

    #[test]
    fn executors_compute_the_same_and_name_each_other() {
        for maker in &WORKLOADS {
            let workload = maker.make(1000);
            let native = workload.run_native();
            let module = executor::module(&workload).expect("valid");
            let mut subject = Subject::new(&workload, &module).expect("valid");
            subject.time(&mut Executor::Interp(Isa::Portable)).expect("it runs");
            let interp = subject.output();
            let differing = native.iter().zip(&interp).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
            assert_eq!((native.len(), differing), (1000, 0), "{}", maker.name);
            let mut executors = [Executor::Native, Executor::Interp(Isa::Portable)];
            let measured = measure(&workload, &mut executors, 3).expect("it runs");
            assert_eq!(measured[0].ratio_to.keys().collect::<Vec<_>>(), ["interp/portable"]);
            assert_eq!(measured[1].ratio_to.keys().collect::<Vec<_>>(), ["native"]);
            let product = measured[0].ratio_to["interp/portable"] * measured[1].ratio_to["native"];
            assert!(
                (product - 1.0).abs() < 1e-9,
                "the ratios of one median are each other's inverse: {product}"
            );
        }
    }
}
