//! Approximations whose errors are stated as quantiles of the ratio of result to value.

use super::mapping::Quantile;
use crate::question::{Answer, Question, Verdict};

/// Judges `ratios` by `stated`; the label tells what was found.
pub(super) fn answer(label: String, stated: &[Quantile], mut ratios: Vec<f64>, cases: usize) -> Answer {
    ratios.sort_by(f64::total_cmp);
    let found: Vec<(Quantile, f64)> =
        stated.iter().filter_map(|q| Some((*q, at(&ratios, q.share)?))).collect();
    if found.is_empty() {
        let why = "no row with a value other than 0, or no quantile is stated".to_owned();
        return Answer::bare(Question::Correct, label, Verdict::FallsShort(why));
    }
    let figures: Vec<String> =
        found.iter().map(|(q, ratio)| format!("{} % {ratio:.4}", 100.0 * q.share)).collect();
    let label = format!("{label}: ratio {}", figures.join(", "));
    let outside = found.iter().find(|(q, ratio)| !(q.low <= *ratio && *ratio <= q.high));
    let verdict = match outside {
        None => Verdict::Holds,
        Some((q, ratio)) => Verdict::FallsShort(format!(
            "{} % of the ratios of result to value are up to {ratio:.4}, which is not in {} ..= {}",
            100.0 * q.share,
            q.low,
            q.high
        )),
    };
    Answer { cases, ..Answer::bare(Question::Correct, label, verdict) }
}

/// The value that `share` of the sorted numbers do not exceed; `None` where there are none.
pub(crate) fn at(sorted: &[f64], share: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    sorted.get((share.clamp(0.0, 1.0) * last as f64).round() as usize).copied()
}

#[cfg(test)]
mod tests {
    use super::{Quantile, answer, at};

    #[test]
    fn quantiles_of_a_sorted_list() {
        let sorted = [1.0, 2.0, 3.0, 4.0, 5.0];
        assert_eq!([0.0, 0.5, 0.75, 1.0].map(|s| at(&sorted, s)), [1.0, 3.0, 4.0, 5.0].map(Some));
        assert_eq!(at(&[], 0.5), None);
    }

    #[test]
    fn what_lies_outside_or_is_not_stated_falls_short() {
        let median = |low, high| [Quantile { share: 0.5, low, high }];
        let ratios = || vec![0.9, 1.0, 1.3];
        assert!(!answer("t".into(), &median(0.9, 1.1), ratios(), 3).falls_short());
        assert!(answer("t".into(), &median(1.1, 1.2), ratios(), 3).falls_short());
        assert!(answer("t".into(), &[], ratios(), 3).falls_short());
        assert!(answer("t".into(), &median(0.9, 1.1), vec![], 3).falls_short());
        assert!(answer("t".into(), &median(0.9, 1.1), vec![f64::NAN; 3], 3).falls_short());
    }
}
