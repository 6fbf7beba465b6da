//! Question 4: are `native` and `interp` equal bit for bit, and all routes on one driver?
//!
//! Any NaN equals any NaN: drivers and languages do not keep payloads.

use super::expected::Expected;
use super::worst::{Sample, Worst};
use super::{Answer, Batch, Question, Verdict};
use crate::subject::as_f64;
use lobe_backends::route::Route;
use lobe_codegen::data::Columns;
use lobe_codegen::def::Scalar;

/// Collects the rows, group by group.
#[derive(Debug)]
pub struct Agree {
    groups: Vec<Group>,
}

#[derive(Debug)]
struct Group {
    label: String,
    members: Vec<usize>,
    cases: usize,
    different: usize,
    first: Option<(Worst, String)>,
    /// The routes that ran, the one that others are compared with first.
    ran: Vec<String>,
    /// Those that differ from it.
    differing: Vec<String>,
}

impl Agree {
    /// The groups among `routes`: those that must be equal.
    #[must_use]
    pub fn new(routes: &[Route]) -> Self {
        let index = |wanted: &Route| routes.iter().position(|r| r == wanted);
        let strict: Vec<usize> = [Route::Native, Route::Interp].iter().filter_map(index).collect();
        let mut groups = vec![Group::new("native = interp".to_owned(), strict)];
        for (at, route) in routes.iter().enumerate() {
            let Some(driver) = route.driver() else { continue };
            let label = format!("@{driver}");
            match groups.iter_mut().find(|g| g.label == label) {
                Some(group) => group.members.push(at),
                None => groups.push(Group::new(label, vec![at])),
            }
        }
        Self { groups }
    }

    /// Takes a batch.
    pub fn absorb(&mut self, batch: &Batch<'_>) {
        for group in &mut self.groups {
            group.absorb(batch);
        }
    }

    /// An answer for each group.
    #[must_use]
    pub fn finish(self, expected: &Expected<'_>) -> Vec<Answer> {
        self.groups.into_iter().map(|group| group.finish(expected)).collect()
    }
}

impl Group {
    fn new(label: String, members: Vec<usize>) -> Self {
        Self { label, members, cases: 0, different: 0, first: None, ran: Vec::new(), differing: Vec::new() }
    }

    fn absorb(&mut self, batch: &Batch<'_>) {
        let outputs = self.members.iter().filter_map(|m| {
            let (route, output) = &batch.outputs[*m];
            output.as_ref().ok().map(|columns| (route, columns))
        });
        let outputs: Vec<(&Route, &Columns)> = outputs.collect();
        let [(base_route, base), others @ ..] = &outputs[..] else { return };
        if others.is_empty() {
            return;
        }
        self.cases += batch.args.rows;
        outputs.iter().for_each(|(route, _)| note(&mut self.ran, route));
        for row in 0..batch.args.rows {
            let mut is_different = false;
            for (route, other) in others {
                let Some(leaf) = first_difference(batch, base, other, row) else { continue };
                is_different = true;
                note(&mut self.differing, route);
                self.first.get_or_insert_with(|| {
                    let sample = sample(batch, base, other, row, leaf);
                    (batch.worst(row, leaf, sample), format!("{route} differs from {base_route}"))
                });
            }
            self.different += usize::from(is_different);
        }
    }

    fn finish(self, expected: &Expected<'_>) -> Answer {
        let verdict = match (&self.first, self.cases) {
            (Some((_, which)), cases) => {
                Verdict::FallsShort(format!("{which} on {} of {cases} rows", self.different))
            }
            (None, 0) => Verdict::NotAsked("needs two routes that ran".to_owned()),
            (None, _) => Verdict::Holds,
        };
        let verdict = expected.of_group(&self.ran, &self.differing, verdict);
        let n = self.members.len();
        let subject =
            if self.label.starts_with('@') { format!("{n} routes {}", self.label) } else { self.label };
        Answer {
            cases: self.cases,
            worst: self.first.map(|(worst, _)| worst),
            ..Answer::bare(Question::Agree, subject, verdict)
        }
    }
}

/// Adds a route that is not there yet.
fn note(routes: &mut Vec<String>, route: &Route) {
    let name = route.to_string();
    if !routes.contains(&name) {
        routes.push(name);
    }
}

fn first_difference(batch: &Batch<'_>, a: &Columns, b: &Columns, row: usize) -> Option<usize> {
    let leaves = batch.subject.program().results();
    (0..leaves.len()).find(|&leaf| !equal(leaves[leaf].scalar, a.columns[leaf][row], b.columns[leaf][row]))
}

fn equal(scalar: Scalar, a: u32, b: u32) -> bool {
    let both_nan = || f32::from_bits(a).is_nan() && f32::from_bits(b).is_nan();
    a == b || (scalar == Scalar::F32 && both_nan())
}

fn sample(batch: &Batch<'_>, base: &Columns, other: &Columns, row: usize, leaf: usize) -> Sample {
    let scalar = batch.subject.program().results()[leaf].scalar;
    let (wanted, found) = (as_f64(scalar, base.columns[leaf][row]), as_f64(scalar, other.columns[leaf][row]));
    Sample { found, wanted, error: (found - wanted).abs(), permitted: 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equality_is_of_bits_but_for_nan() {
        let (quiet, other) = (0x7fc0_0000, 0xffc0_0001);
        assert!(equal(Scalar::F32, quiet, other));
        assert!(!equal(Scalar::U32, quiet, other));
        assert!(!equal(Scalar::F32, 0.0f32.to_bits(), (-0.0f32).to_bits()));
    }
}
