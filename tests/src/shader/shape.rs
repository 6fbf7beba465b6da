//! Where the scalars of a resource lie, and what they are called.

use naga::{ArraySize, Handle, Module, Scalar, Type, TypeInner, VectorSize};

/// A type in host memory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Scalar {
        /// Kind and width.
        scalar: Scalar,
        /// Whether only atomics may touch it.
        is_atomic: bool,
    },
    /// Equal parts at equal distances.
    List {
        /// What each is.
        part: Box<Self>,
        /// How many; `None` when the buffer's length says it.
        count: Option<u32>,
        /// Bytes from one to the next.
        stride: u32,
        /// Whether the parts are components, called `x`, `y`, `z`, `w`.
        is_vector: bool,
    },
    /// A structure.
    Struct(Vec<Member>),
}

/// A member of a structure.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Member {
    /// Its name; its number if the module names none.
    pub name: String,
    /// Bytes from the structure's begin.
    pub offset: u32,
    /// Its type.
    pub shape: Shape,
}

/// Most members of a structure, those of its members included.
pub const MEMBERS: u32 = 1 << 16;

const COMPONENTS: [&str; 4] = ["x", "y", "z", "w"];

impl Shape {
    /// The shape of `ty`; `None` if values of it do not lie in memory that the host shares, or if it has more than
    /// [`MEMBERS`] members in all.
    #[must_use]
    pub fn of(module: &Module, ty: Handle<Type>) -> Option<Self> {
        Self::within(module, ty, &mut { MEMBERS })
    }

    fn within(module: &Module, ty: Handle<Type>, left: &mut u32) -> Option<Self> {
        let vector = |size: VectorSize, scalar: Scalar| Self::List {
            part: Box::new(Self::Scalar { scalar, is_atomic: false }),
            count: Some(size as u32),
            stride: u32::from(scalar.width),
            is_vector: true,
        };
        match module.types[ty].inner {
            TypeInner::Scalar(scalar) => Some(Self::Scalar { scalar, is_atomic: false }),
            TypeInner::Atomic(scalar) => Some(Self::Scalar { scalar, is_atomic: true }),
            TypeInner::Vector { size, scalar } => Some(vector(size, scalar)),
            TypeInner::Matrix { columns, rows, scalar } => Some(Self::List {
                part: Box::new(vector(rows, scalar)),
                count: Some(columns as u32),
                // Three rows take the room of four.
                stride: if rows == VectorSize::Bi { 2 } else { 4 } * u32::from(scalar.width),
                is_vector: false,
            }),
            TypeInner::Array { base, size, stride } => {
                let count = match size {
                    ArraySize::Constant(n) => Some(n.get()),
                    ArraySize::Dynamic => None,
                    ArraySize::Pending(_) => return None,
                };
                Some(Self::List {
                    part: Box::new(Self::within(module, base, left)?),
                    count,
                    stride,
                    is_vector: false,
                })
            }
            TypeInner::Struct { ref members, .. } => {
                let member = |(index, m): (usize, &naga::StructMember)| {
                    let name = m.name.clone().unwrap_or_else(|| index.to_string());
                    *left = left.checked_sub(1)?;
                    Some(Member { name, offset: m.offset, shape: Self::within(module, m.ty, left)? })
                };
                members.iter().enumerate().map(member).collect::<Option<_>>().map(Self::Struct)
            }
            _ => None,
        }
    }

    /// Offset and stride of the array at its end whose length the buffer says, if there is one.
    #[must_use]
    pub fn tail(&self) -> Option<(u32, u32)> {
        match self {
            Self::List { count: None, stride, .. } => Some((0, *stride)),
            Self::Struct(members) => {
                let last = members.last()?;
                last.shape.tail().map(|(offset, stride)| (last.offset + offset, stride))
            }
            Self::Scalar { .. } | Self::List { .. } => None,
        }
    }

    /// Parts of a list that lies at `at` in a buffer of `end` bytes.
    #[must_use]
    pub fn length(count: Option<u32>, stride: u32, at: usize, end: usize) -> usize {
        let fitting = end.saturating_sub(at) / stride.max(1) as usize;
        count.map_or(fitting, |n| n as usize)
    }

    /// Offset and kind of every scalar of a buffer of `end` bytes, in order.
    pub fn visit(&self, end: usize, f: &mut impl FnMut(usize, Scalar, bool)) {
        self.visit_at(0, end, f);
    }

    fn visit_at(&self, at: usize, end: usize, f: &mut impl FnMut(usize, Scalar, bool)) {
        match self {
            Self::Scalar { scalar, is_atomic } => {
                if at + usize::from(scalar.width) <= end {
                    f(at, *scalar, *is_atomic);
                }
            }
            Self::List { part, count, stride, .. } => {
                for index in 0..Self::length(*count, *stride, at, end) {
                    part.visit_at(at + index * *stride as usize, end, f);
                }
            }
            Self::Struct(members) => {
                members.iter().for_each(|m| m.shape.visit_at(at + m.offset as usize, end, f));
            }
        }
    }

    /// What the scalar at `offset` is called, after the name of the buffer: `[3].color.y`.
    #[must_use]
    pub fn path(&self, offset: usize) -> String {
        match self {
            Self::Scalar { .. } => String::new(),
            Self::List { part, stride, is_vector, .. } => {
                let (index, rest) = (offset / (*stride).max(1) as usize, offset % (*stride).max(1) as usize);
                match COMPONENTS.get(index).filter(|_| *is_vector) {
                    Some(component) => format!(".{component}"),
                    None => format!("[{index}]{}", part.path(rest)),
                }
            }
            Self::Struct(members) => match members.iter().rev().find(|m| m.offset as usize <= offset) {
                Some(member) => {
                    format!(".{}{}", member.name, member.shape.path(offset - member.offset as usize))
                }
                None => String::new(),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
        struct Item { flag: u32, color: vec3<f32>, frame: mat3x3<f32>, thin: mat2x2<f32> }
        struct All { count: atomic<u32>, items: array<Item> }
        @group(0) @binding(0) var<storage, read_write> all: All;
        @compute @workgroup_size(1) fn main() { all.items[0].flag = 1u; }
    ";

    fn all() -> Shape {
        let module = lobe_codegen::validate::foreign_wgsl(TEXT).expect("valid");
        let module = module.module();
        Shape::of(module, module.global_variables.iter().next().expect("a variable").1.ty).expect("a shape")
    }

    #[test]
    fn scalars_are_visited_in_order_and_called_by_their_path() {
        let (shape, stride) = (all(), 96);
        assert_eq!(shape.tail(), Some((16, stride)));
        let mut found = Vec::new();
        shape.visit(16 + 2 * stride as usize + 50, &mut |at, _, _| found.push((at, shape.path(at))));
        assert_eq!(found.len(), 1 + 2 * (1 + 3 + 9 + 4));
        for (offset, path) in [
            (0, ".count"),
            (16, ".items[0].flag"),
            (40, ".items[0].color.z"),
            (48, ".items[0].frame[0].x"),
            (88, ".items[0].frame[2].z"),
            (100, ".items[0].thin[0].y"),
        ] {
            let known = found.iter().find(|(at, _)| *at == offset).map(|(_, path)| path.as_str());
            assert_eq!(known, Some(path), "at {offset}");
        }
    }
}
