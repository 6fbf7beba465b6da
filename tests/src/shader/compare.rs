//! What a route left in a buffer, against what the interpreter left there.

use super::given::Given;
use super::number;
use naga::Scalar;

/// What may stand in the place of a scalar.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Permit {
    /// The interpreter's bits alone.
    Bits,
    /// Any float so far from the exact value.
    Around {
        /// In real numbers.
        exact: f64,
        /// Largest distance.
        bound: f64,
    },
    /// A number in a texel that may, or may not, stand there.
    Texel {
        /// Whether it may.
        is_near: bool,
        /// Largest distance of two that may.
        bound: f64,
    },
    /// Nothing is known about it.
    Unknown,
}

/// How the scalars of a buffer stand to the interpreter's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// All bits are equal.
    Equal,
    /// Floats differ, within what is permitted.
    Within,
    /// Floats differ, and nothing says by how much they may.
    Unjudged,
    /// Something differs by more than is permitted.
    Beyond,
}

/// One scalar that differs.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Difference {
    /// What it is called: `out[3].color.y`.
    pub path: String,
    /// The interpreter's value; floats in hexadecimal.
    pub interp: String,
    /// The route's.
    pub found: String,
    /// Floats between them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ulp: Option<u64>,
    /// The largest permitted distance from the exact value.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
}

/// A buffer of one route.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Compared {
    /// The buffer.
    pub buffer: String,
    /// How it stands; the worst of its scalars.
    pub standing: Standing,
    /// Scalars.
    pub scalars: usize,
    /// Those whose bits differ.
    pub differing: usize,
    /// Largest distance of two floats that differ.
    pub max_ulp: u64,
    /// Largest distance from the exact value as a share of the bound, of scalars that differ and have one.
    #[serde(default, skip_serializing_if = "is_zero", with = "crate::question::float")]
    pub share: f64,
    /// The first of the worst.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub first: Option<Difference>,
}

fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// Compares a buffer; `permit` says of the scalar at an offset what may stand there.
pub fn compare(
    given: &Given,
    interp: &[u8],
    found: &[u8],
    permit: impl Fn(usize, Scalar) -> Permit,
) -> Compared {
    let mut compared = Compared {
        buffer: given.title(),
        standing: Standing::Equal,
        scalars: 0,
        differing: 0,
        max_ulp: 0,
        share: 0.0,
        first: None,
    };
    given.shape.visit(interp.len().min(found.len()), &mut |at, scalar, _| {
        compared.scalars += 1;
        let range = at..at + usize::from(scalar.width);
        let (ours, theirs) = (&interp[range.clone()], &found[range]);
        if ours != theirs && !are_nan(scalar, ours, theirs) {
            let permit = permit(at, scalar);
            compared
                .note(scalar, ours, theirs, permit, || format!("{}{}", given.title(), given.shape.path(at)));
        }
    });
    compared
}

impl Compared {
    fn note(
        &mut self,
        scalar: Scalar,
        ours: &[u8],
        theirs: &[u8],
        permit: Permit,
        path: impl Fn() -> String,
    ) {
        self.differing += 1;
        let ulp = number::is_float(scalar).then(|| number::ulps(scalar.width, ours, theirs));
        self.max_ulp = self.max_ulp.max(ulp.unwrap_or(0));
        let standing = standing(scalar, theirs, permit);
        if let Permit::Around { exact, bound } = permit {
            let error = (number::float(scalar.width, theirs) - exact).abs();
            self.share =
                self.share.max(if error == 0.0 || bound.is_infinite() { 0.0 } else { error / bound });
        }
        if self.first.is_none() || standing > self.standing {
            self.first = Some(Difference {
                path: path(),
                interp: number::text(scalar, ours),
                found: number::text(scalar, theirs),
                ulp,
                bound: match permit {
                    Permit::Around { bound, .. } | Permit::Texel { bound, .. } => Some(bound),
                    Permit::Bits | Permit::Unknown => None,
                },
            });
        }
        self.standing = self.standing.max(standing);
    }
}

fn standing(scalar: Scalar, theirs: &[u8], permit: Permit) -> Standing {
    match permit {
        Permit::Bits => Standing::Beyond,
        Permit::Unknown => Standing::Unjudged,
        Permit::Texel { is_near: true, .. } => Standing::Within,
        Permit::Texel { is_near: false, .. } => Standing::Beyond,
        Permit::Around { exact, bound } => {
            let found = number::float(scalar.width, theirs);
            let is_within = bound.is_infinite() || found == exact || (found - exact).abs() <= bound;
            if is_within { Standing::Within } else { Standing::Beyond }
        }
    }
}

/// NaNs are one value: their bits are the processor's choice.
fn are_nan(scalar: Scalar, a: &[u8], b: &[u8]) -> bool {
    number::is_float(scalar)
        && number::float(scalar.width, a).is_nan()
        && number::float(scalar.width, b).is_nan()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shader::shape::Shape;
    use lobe_backends::gpu::BindingKind;

    fn floats() -> Given {
        let part = Box::new(Shape::Scalar { scalar: Scalar::F32, is_atomic: false });
        let shape = Shape::List { part, count: None, stride: 4, is_vector: false };
        let kind = BindingKind::StorageReadWrite;
        let (name, data) = ("out".to_owned(), Vec::new());
        Given { name, group: 0, binding: 0, element: None, kind, data, shape, is_coded: false }
    }

    fn bytes(values: &[f32]) -> Vec<u8> {
        values.iter().flat_map(|v| v.to_le_bytes()).collect()
    }

    #[test]
    fn floats_are_judged_by_what_is_permitted() {
        let (ours, theirs) = (bytes(&[1.0, 2.0, f32::NAN]), bytes(&[1.0, 2.0_f32.next_up(), -f32::NAN]));
        let judged = |permit| compare(&floats(), &ours, &theirs, |_, _| permit);
        for (permit, standing) in [
            (Permit::Bits, Standing::Beyond),
            (Permit::Unknown, Standing::Unjudged),
            (Permit::Around { exact: 2.0, bound: 1e-6 }, Standing::Within),
            (Permit::Around { exact: 2.0, bound: 1e-9 }, Standing::Beyond),
        ] {
            let compared = judged(permit);
            assert_eq!((compared.standing, compared.differing, compared.max_ulp), (standing, 1, 1));
            let first = compared.first.expect("a difference");
            assert_eq!((first.path.as_str(), first.found.as_str()), ("out[1]", "0x1.000002p1"));
        }
        let same = compare(&floats(), &ours, &ours, |_, _| Permit::Bits);
        assert_eq!((same.standing, same.scalars, same.first), (Standing::Equal, 3, None));
    }

    #[test]
    fn a_nan_where_a_number_is_known_is_beyond() {
        let permit = Permit::Around { exact: 1.0, bound: 1e-6 };
        let compared = compare(&floats(), &bytes(&[1.0]), &bytes(&[f32::NAN]), |_, _| permit);
        assert_eq!(compared.standing, Standing::Beyond);
    }
}
