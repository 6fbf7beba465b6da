//! Decisions.

use super::{Float, Truth};

impl Truth {
    pub(super) fn sure(value: bool) -> Self {
        Self { value, exact: value, ambiguous: false }
    }

    pub(super) fn not(self) -> Self {
        Self { value: !self.value, exact: !self.exact, ..self }
    }

    /// A side that is surely false decides alone.
    pub(super) fn and(self, b: Self) -> Self {
        let refuses = |t: Self| !t.ambiguous && !t.value;
        Self {
            value: self.value && b.value,
            exact: self.exact && b.exact,
            ambiguous: (self.ambiguous || b.ambiguous) && !refuses(self) && !refuses(b),
        }
    }

    pub(super) fn xor(self, b: Self) -> Self {
        Self {
            value: self.value != b.value,
            exact: self.exact != b.exact,
            ambiguous: self.ambiguous || b.ambiguous,
        }
    }
}

/// Decided by the intervals when they leave no doubt.
fn decide(a: Float, b: Float, value: bool, exact: bool, always: bool, never: bool) -> Truth {
    let sure = a.bounded() && b.bounded() && (always || never);
    Truth { value, exact, ambiguous: !sure }
}

pub(super) fn less(a: Float, b: Float) -> Truth {
    decide(a, b, a.value < b.value, a.exact < b.exact, a.high < b.low, a.low >= b.high)
}

pub(super) fn less_equal(a: Float, b: Float) -> Truth {
    decide(a, b, a.value <= b.value, a.exact <= b.exact, a.high <= b.low, a.low > b.high)
}

pub(super) fn equal(a: Float, b: Float) -> Truth {
    let always = a.is_point() && b.is_point() && a.low == b.low;
    decide(a, b, a.value == b.value, a.exact == b.exact, always, a.high < b.low || b.high < a.low)
}
