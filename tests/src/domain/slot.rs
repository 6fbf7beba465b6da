//! Which values a kernel's arguments may have, scalar by scalar.

use lobe_codegen::def::{Domain, FunctionDef, Scalar, TypeDef};

/// A part of the arguments that is drawn at once.
#[derive(Clone, Debug, PartialEq)]
pub enum Slot {
    /// One scalar.
    Number {
        /// Its column.
        column: usize,
        /// Its kind.
        scalar: Scalar,
        /// Its values.
        values: Values,
    },
    /// The components of a vector of length one.
    Unit {
        /// The column of its first component.
        column: usize,
        /// How many components.
        n: usize,
        /// What ties it to vectors that were drawn before.
        relation: Relation,
    },
}

/// How a unit vector stands to others, which are named by the columns of their first components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Not at all.
    Free,
    /// Perpendicular to one.
    NormalTo(usize),
    /// The cross product of two.
    Cross(usize, usize),
}

/// The values of a scalar.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// A closed range.
    Range(f64, f64),
    /// Just these.
    Listed(Vec<f64>),
}

/// Why a kernel's inputs cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DomainError {
    /// Nothing says which values an argument may have.
    #[error(
        "{kernel}: no domain is stated for `{path}`; write domain({path} = lo..=hi) into its #[kernel(..)], or \
         #[domain(..)] at the structure's field"
    )]
    None {
        /// The kernel.
        kernel: &'static str,
        /// The scalar.
        path: String,
    },
    /// The domain does not fit the type, or is empty.
    #[error("{kernel}: the domain of `{path}` {reason}")]
    Bad {
        /// The kernel.
        kernel: &'static str,
        /// The argument or field.
        path: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A domain for something that the kernel does not take.
    #[error("{kernel}: a domain is stated for `{path}`, which is none of its arguments or their fields")]
    Stray {
        /// The kernel.
        kernel: &'static str,
        /// The path as stated.
        path: &'static str,
    },
}

/// The slots of `kernel`'s arguments, in the order of their columns.
///
/// A domain in the kernel's contract goes before one at a structure's field; one for a vector, matrix or
/// array holds for each of its scalars.
///
/// # Errors
/// When a scalar has no domain, or a domain does not fit.
pub fn slots(kernel: &'static FunctionDef) -> Result<Vec<Slot>, DomainError> {
    let mut walk = Walk {
        kernel,
        used: vec![false; kernel.contract.domain.len()],
        column: 0,
        slots: Vec::new(),
        units: Vec::new(),
    };
    for param in kernel.params {
        walk.visit(param.name, &param.ty, None)?;
    }
    match walk.used.iter().position(|used| !used) {
        Some(stray) => {
            Err(DomainError::Stray { kernel: kernel.name, path: kernel.contract.domain[stray].path })
        }
        None => Ok(walk.slots),
    }
}

struct Walk {
    kernel: &'static FunctionDef,
    used: Vec<bool>,
    column: usize,
    slots: Vec<Slot>,
    /// The unit vectors of three components so far, and their columns.
    units: Vec<(String, usize)>,
}

impl Walk {
    fn visit(&mut self, path: &str, ty: &TypeDef, inherited: Option<Domain>) -> Result<(), DomainError> {
        let domain = self.stated(path).or(inherited);
        match *ty {
            TypeDef::Scalar(scalar) => self.number(path, scalar, domain),
            TypeDef::Vector(n, Scalar::F32) if domain == Some(Domain::Unit) => {
                self.unit(path, n, Relation::Free);
                Ok(())
            }
            TypeDef::Vector(3, Scalar::F32)
                if matches!(domain, Some(Domain::NormalTo(_) | Domain::Cross(..))) =>
            {
                let relation = self.relation(path, domain)?;
                self.unit(path, 3, relation);
                Ok(())
            }
            TypeDef::Vector(n, scalar) => {
                let names = ["x", "y", "z", "w"].iter().take(n.into());
                names
                    .into_iter()
                    .try_for_each(|c| self.visit(&format!("{path}.{c}"), &TypeDef::Scalar(scalar), domain))
            }
            TypeDef::Matrix(columns, rows) => {
                let names = ["x_axis", "y_axis", "z_axis", "w_axis"].iter().take(columns.into());
                let column = TypeDef::Vector(rows, Scalar::F32);
                names.into_iter().try_for_each(|axis| self.visit(&format!("{path}.{axis}"), &column, domain))
            }
            TypeDef::Array(element, n) => {
                (0..n).try_for_each(|i| self.visit(&format!("{path}[{i}]"), element, domain))
            }
            TypeDef::Struct(def) => {
                let mut fields = def().fields.iter();
                fields.try_for_each(|f| self.visit(&format!("{path}.{}", f.name), &f.ty, f.domain))
            }
            TypeDef::Slice(_) | TypeDef::Atomic(_) => {
                Err(self.bad(path, format!("cannot be drawn: {ty} does not travel by value")))
            }
        }
    }

    fn unit(&mut self, path: &str, n: u8, relation: Relation) {
        if n == 3 {
            self.units.push((path.to_owned(), self.column));
        }
        self.slots.push(Slot::Unit { column: self.column, n: n.into(), relation });
        self.column += usize::from(n);
    }

    fn relation(&self, path: &str, domain: Option<Domain>) -> Result<Relation, DomainError> {
        let prefix = path.rfind('.').map_or("", |dot| &path[..=dot]);
        let column = |sibling: &str| {
            let wanted = format!("{prefix}{sibling}");
            let found = self.units.iter().find(|(name, _)| *name == wanted);
            found.map(|(_, column)| *column).ok_or_else(|| {
                self.bad(
                    path,
                    format!("speaks of `{wanted}`, which is no unit vector that is declared before"),
                )
            })
        };
        match domain {
            Some(Domain::NormalTo(z)) => Ok(Relation::NormalTo(column(z)?)),
            Some(Domain::Cross(z, x)) => Ok(Relation::Cross(column(z)?, column(x)?)),
            _ => Ok(Relation::Free),
        }
    }

    fn stated(&mut self, path: &str) -> Option<Domain> {
        let at = self.kernel.contract.domain.iter().position(|d| d.path == path)?;
        self.used[at] = true;
        Some(self.kernel.contract.domain[at].domain)
    }

    fn number(&mut self, path: &str, scalar: Scalar, domain: Option<Domain>) -> Result<(), DomainError> {
        let values = match domain {
            Some(Domain::Range(lo, hi)) if lo <= hi && fits(scalar, lo) && fits(scalar, hi) => {
                Values::Range(lo, hi)
            }
            Some(Domain::Range(lo, hi)) => {
                return Err(
                    self.bad(path, format!("is {lo:?}..={hi:?}, which is no range of {}", scalar.name()))
                );
            }
            Some(Domain::Values(list)) if !list.is_empty() && list.iter().all(|v| fits(scalar, *v)) => {
                Values::Listed(list.to_vec())
            }
            Some(Domain::Values(list)) => {
                return Err(self.bad(path, format!("is {list:?}, which are no values of {}", scalar.name())));
            }
            Some(Domain::Unit) => {
                let reason = "is `unit`, which only Vec2, Vec3 and Vec4 can be".to_owned();
                return Err(self.bad(path, reason));
            }
            Some(Domain::NormalTo(_) | Domain::Cross(..)) => {
                let reason = "is in relation to a vector, which only Vec3 can be".to_owned();
                return Err(self.bad(path, reason));
            }
            None if scalar == Scalar::Bool => Values::Listed(vec![0.0, 1.0]),
            None => return Err(DomainError::None { kernel: self.kernel.name, path: path.to_owned() }),
        };
        self.slots.push(Slot::Number { column: self.column, scalar, values });
        self.column += 1;
        Ok(())
    }

    fn bad(&self, path: &str, reason: String) -> DomainError {
        DomainError::Bad { kernel: self.kernel.name, path: path.to_owned(), reason }
    }
}

fn fits(scalar: Scalar, value: f64) -> bool {
    match scalar {
        Scalar::F32 => (value as f32).is_finite(),
        Scalar::I32 => value == f64::from(value as i32),
        Scalar::U32 => value == f64::from(value as u32),
        Scalar::Bool => value == 0.0 || value == 1.0,
    }
}

/// The word of `value`, which lies in the domain of a scalar of this kind.
pub(super) fn word(scalar: Scalar, value: f64) -> u32 {
    match scalar {
        Scalar::F32 => (value as f32).to_bits(),
        Scalar::I32 => value as i32 as u32,
        Scalar::U32 => value as u32,
        Scalar::Bool => u32::from(value != 0.0),
    }
}
