//! How the rows of a run spread over the share of the bound that they use: whether a route is near its bound
//! everywhere, or on one row in a million.

use serde::{Deserialize, Serialize};

/// Places of an octave: each is at most a sixteenth wide of what it holds.
const PLACES: u32 = 16;
/// Octaves below 1 that are told apart; what is smaller lies in the lowest bin with a number.
const OCTAVES: u32 = 8;
/// None of the bound; at most 2^-8 of it; the places up to 1; beyond.
const CELLS: usize = 3 + (PLACES * OCTAVES) as usize;
/// The top bits of an `f64` that count places: the exponent and four of the fraction.
const SHIFT: u32 = 52 - PLACES.trailing_zeros();

/// Counts shares while they come, without keeping them.
#[derive(Clone, Debug)]
pub struct Shares([u64; CELLS]);

/// The rows of an answer by the largest share of the bound that a scalar of their result uses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Distribution {
    /// Rows with a bound, of those drawn and listed; rows that a search looked for are left out.
    pub rows: u64,
    /// Half of the rows use at most so much. Quantiles are rounded up, by a sixteenth at most.
    #[serde(with = "super::float")]
    pub median: f64,
    /// 99 of 100 rows use at most so much.
    #[serde(with = "super::float")]
    pub p99: f64,
    /// 999 of 1000 rows use at most so much.
    #[serde(with = "super::float")]
    pub p999: f64,
    /// Rows of each bin: those of [`bin_ends`], and at last those beyond the bound.
    pub counts: Vec<u64>,
}

/// Where bins end, their ends included: 0, 1/256, 1.5/256, 2/256, 3/256, .. 1/2, 3/4, 1.
#[must_use]
pub fn bin_ends() -> Vec<f64> {
    let half = PLACES as usize / 2;
    (0..2).chain((2..CELLS - 1).step_by(half).map(|first| first + half - 1)).map(upto).collect()
}

impl Default for Shares {
    fn default() -> Self {
        Self([0; CELLS])
    }
}

impl Shares {
    /// Counts a row.
    pub fn take(&mut self, share: f64) {
        self.0[cell(share)] += 1;
    }

    /// What was counted; `None` where nothing was.
    #[must_use]
    pub fn finish(&self) -> Option<Distribution> {
        let rows = self.0.iter().sum();
        (rows > 0).then(|| Distribution {
            rows,
            median: self.quantile(rows, 0.5),
            p99: self.quantile(rows, 0.99),
            p999: self.quantile(rows, 0.999),
            counts: self.counts(),
        })
    }

    fn quantile(&self, rows: u64, part: f64) -> f64 {
        let wanted = (rows as f64 * part).ceil() as u64;
        let mut below = 0;
        let at = self.0.iter().position(|n| {
            below += n;
            below >= wanted
        });
        at.map_or(f64::INFINITY, upto)
    }

    /// Half an octave makes a bin.
    fn counts(&self) -> Vec<u64> {
        let (low, rest) = self.0.split_at(2);
        let (places, beyond) = rest.split_at(rest.len() - 1);
        let bins = places.chunks(PLACES as usize / 2).map(|bin| bin.iter().sum());
        low.iter().copied().chain(bins).chain(beyond.iter().copied()).collect()
    }
}

/// The cell of a share.
fn cell(share: f64) -> usize {
    let lowest = 1023 - u64::from(OCTAVES);
    match share {
        0.0 => 0,
        // The end belongs to the bin: the bits before it are those of its places.
        s if s <= 1.0 => {
            let place = (s.to_bits() - 1) >> SHIFT;
            1 + place.checked_sub(lowest * u64::from(PLACES)).map_or(0, |at| at as usize + 1)
        }
        _ => CELLS - 1,
    }
}

/// The end of a cell.
fn upto(cell: usize) -> f64 {
    match cell {
        0 => 0.0,
        c if c == CELLS - 1 => f64::INFINITY,
        c => {
            let lowest = (1023 - u64::from(OCTAVES)) * u64::from(PLACES);
            f64::from_bits((lowest + c as u64 - 1) << SHIFT)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_lies_in_its_cell() {
        let edges = (0..CELLS).map(upto).collect::<Vec<_>>();
        assert!(edges.is_sorted() && edges[CELLS - 2] == 1.0 && edges[1] == 1.0 / 256.0, "{edges:?}");
        for (at, edge) in edges.iter().enumerate().skip(1) {
            assert_eq!(cell(*edge), at, "the end {edge} belongs to the cell");
            let next = edge.next_up();
            assert!(edge.is_infinite() || cell(next) == at + 1, "{next} does not");
        }
        assert_eq!((cell(0.0), cell(1e-300), cell(5.0), cell(f64::NAN)), (0, 1, CELLS - 1, CELLS - 1));
    }

    #[test]
    fn bins_hold_all_rows_and_quantiles_those_that_they_say() {
        let mut shares = Shares::default();
        assert_eq!(shares.finish(), None);
        let all: Vec<f64> = (0..1000).map(|i| f64::from(i) / 1000.0).chain([2.0]).collect();
        all.iter().for_each(|share| shares.take(*share));
        let found = shares.finish().expect("rows");
        assert_eq!((found.rows, found.counts.iter().sum::<u64>()), (1001, 1001));
        for (part, quantile) in [(0.5, found.median), (0.99, found.p99), (0.999, found.p999)] {
            let exact = all[(1001.0 * part) as usize];
            assert!((exact..=exact * 17.0 / 16.0).contains(&quantile), "{part}: {quantile} for {exact}");
        }
        let ends = bin_ends();
        assert_eq!(
            (ends.len() + 1, ends[..3].to_vec()),
            (found.counts.len(), vec![0.0, 1.0 / 256.0, 1.5 / 256.0])
        );
        assert_eq!(ends[ends.len() - 3..], [0.5, 0.75, 1.0]);
        let bin = |from: f64, to: f64| all.iter().filter(|s| from < **s && **s <= to).count() as u64;
        let lower = [f64::NEG_INFINITY].into_iter().chain(ends.iter().copied());
        let upper = ends.iter().copied().chain([f64::INFINITY]);
        assert_eq!(found.counts, lower.zip(upper).map(|(from, to)| bin(from, to)).collect::<Vec<_>>());
    }
}
