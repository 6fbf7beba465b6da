//! Scales and their ticks.

/// How values spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithm.
    Log,
}

/// An axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it shows; `^{..}` raises, `_{..}` lowers.
    pub label: String,
    /// How.
    pub scale: Scale,
    /// From where to where.
    pub range: (f64, f64),
    /// Distance of the ticks of a linear axis; those of a logarithmic one are decades, so many apart.
    pub step: f64,
}

/// A tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Where, in 0 ..= 1 of the axis.
    pub at: f64,
    /// Its number, with the marks of [`Axis::label`].
    pub label: String,
}

impl Axis {
    /// A linear axis.
    #[must_use]
    pub fn linear(label: &str, low: f64, high: f64, step: f64) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear, range: (low, high), step }
    }

    /// A logarithmic axis, over powers of ten, with a number at each `step`th.
    #[must_use]
    pub fn log(label: &str, low: i32, high: i32, step: u32) -> Self {
        let power = |e: i32| libm::pow(10.0, e.into());
        Self {
            label: label.to_owned(),
            scale: Scale::Log,
            range: (power(low), power(high)),
            step: step.into(),
        }
    }

    /// Where `value` lies, 0 at the begin and 1 at the end of the axis.
    #[must_use]
    pub fn place(&self, value: f64) -> f64 {
        let (low, high) = self.range;
        match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log => libm::log(value / low) / libm::log(high / low),
        }
    }

    /// The value at `place`.
    #[must_use]
    pub fn value(&self, place: f64) -> f64 {
        let (low, high) = self.range;
        match self.scale {
            Scale::Linear => low + place * (high - low),
            Scale::Log => low * libm::exp(place * libm::log(high / low)),
        }
    }

    /// Values over the whole axis, evenly spread, `n` of them.
    pub fn values(&self, n: usize) -> impl Iterator<Item = f64> + '_ {
        (0..n).map(move |i| self.value(i as f64 / (n - 1) as f64))
    }

    /// The ticks.
    #[must_use]
    pub fn ticks(&self) -> Vec<Tick> {
        let (low, high) = self.range;
        match self.scale {
            Scale::Linear => {
                let first = (low / self.step - 1e-9).ceil() as i64;
                let last = (high / self.step + 1e-9).floor() as i64;
                let digits = (0..6).find(|d| is_whole(self.step * libm::pow(10.0, f64::from(*d))));
                let tick = |i: i64| {
                    let value = i as f64 * self.step;
                    let label = format!("{value:.*}", digits.unwrap_or(6) as usize).replace('-', "−");
                    Tick { at: self.place(value), label }
                };
                (first..=last).map(tick).collect()
            }
            Scale::Log => {
                let exponent = |v: f64| libm::log10(v).round() as i32;
                let label = |e: i32| match e {
                    0 => "1".to_owned(),
                    1 => "10".to_owned(),
                    e => format!("10^{{{}}}", e.to_string().replace('-', "−")),
                };
                let tick = |e: i32| Tick { at: self.place(libm::pow(10.0, e.into())), label: label(e) };
                (exponent(low)..=exponent(high)).step_by(self.step as usize).map(tick).collect()
            }
        }
    }
}

fn is_whole(value: f64) -> bool {
    (value - value.round()).abs() < 1e-9
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|t| t.label).collect()
    }

    #[test]
    fn ticks_carry_as_many_digits_as_their_step_needs() {
        assert_eq!(labels(&Axis::linear("", -1.0, 1.0, 0.5)), ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(labels(&Axis::linear("", 0.0, 90.0, 30.0)), ["0", "30", "60", "90"]);
        assert_eq!(labels(&Axis::log("", -2, 1, 1)), ["10^{−2}", "10^{−1}", "1", "10"]);
    }

    #[test]
    fn places_and_values_are_each_others_inverse() {
        for axis in [Axis::linear("", -3.0, 5.0, 1.0), Axis::log("", -3, 5, 2)] {
            for place in [0.0, 0.3, 1.0] {
                assert!((axis.place(axis.value(place)) - place).abs() < 1e-12);
            }
        }
    }
}
