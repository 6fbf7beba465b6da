//! Structures for the host, laid out as shaders read them: Rust with `bytemuck`, or a C and C++ header.
//!
//! Every byte between members is a member of its own, and each offset is asserted where the host's compiler sees it:
//! what compiles has the layout of the module, whatever the host's rules of alignment.

mod c;
mod rust;
mod shape;

use super::docs;
use super::mark::{Role, is_predeclared};
use crate::ValidModule;
use naga::{Handle, Module, Type, TypeInner};
use shape::Shape;

/// A language of hosts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Host {
    /// Rust, with the crate `bytemuck` and its feature `derive`.
    Rust,
    /// A header for C11 and C++11.
    C,
}

impl Host {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Rust, Self::C];

    /// Its name: `rust`, `c`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::C => "c",
        }
    }

    /// The extension of its files: `rs`, `h`.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Rust => "rs",
            Self::C => "h",
        }
    }
}

/// A structure in words.
struct Structure {
    name: String,
    docs: Vec<String>,
    fields: Vec<Field>,
    /// Bytes.
    size: u32,
}

/// A member, or the room between two.
struct Field {
    name: String,
    docs: Vec<String>,
    shape: Shape,
    /// Bytes from the structure's start.
    offset: u32,
    /// Nothing is in it.
    is_padding: bool,
}

/// The structures of `module` for a host, in an order in which each comes before those that hold it; without those that
/// no buffer can hold, whose names stand in a comment.
///
/// A structure with booleans has no layout: where an entry point takes it, it travels as `NAME_in_buffer`.
///
/// ```
/// use lobe_codegen::emit::{Host, host};
/// use lobe_codegen::prelude::*;
///
/// /// A ray.
/// #[kernel]
/// pub struct Ray {
///     /// Where it begins.
///     pub origin: Vec3,
///     /// Where it goes.
///     pub direction: Vec3,
/// }
///
/// /// The point at distance `t`.
/// #[kernel]
/// pub fn point_at(ray: Ray, t: f32) -> Vec3 {
///     ray.origin + t * ray.direction
/// }
///
/// let header = host(&lobe_codegen::lower(&lobe_codegen::kernels![point_at])?, Host::C);
/// // Three floats take the room of four.
/// assert!(header.contains("float origin[3];\n    uint32_t _pad0[1];"));
/// assert!(header.contains("static_assert(offsetof(Ray, direction) == 16"));
/// # Ok::<(), lobe_codegen::lower::LowerError>(())
/// ```
#[must_use]
pub fn host(module: &ValidModule, host: Host) -> String {
    let module = module.module();
    let (mut structures, mut left_out) = (Vec::new(), Vec::new());
    for (handle, ty) in module.types.iter().filter(|(handle, _)| !is_predeclared(module, *handle)) {
        let TypeInner::Struct { members, span } = &ty.inner else { continue };
        let name = ty.name.clone().unwrap_or_default();
        match fields(module, handle, members, *span) {
            Some(fields) => {
                let docs = docs::plain(module, Role::Struct(handle));
                structures.push(Structure { name, docs, fields, size: *span });
            }
            None => left_out.push(name),
        }
    }
    match host {
        Host::Rust => rust::write(&structures, &left_out),
        Host::C => c::write(&structures, &left_out),
    }
}

/// Members and the room between them; `None` when one of them has no layout.
fn fields(
    module: &Module,
    ty: Handle<Type>,
    members: &[naga::StructMember],
    span: u32,
) -> Option<Vec<Field>> {
    let mut fields = Vec::new();
    let mut end = 0;
    for (i, member) in members.iter().enumerate() {
        let shape = shape::of(module, member.ty)?;
        pad(&mut fields, end, member.offset);
        end = member.offset + shape.size;
        fields.push(Field {
            name: member.name.clone().unwrap_or_default(),
            docs: docs::plain(module, Role::Member(ty, i)),
            shape,
            offset: member.offset,
            is_padding: false,
        });
    }
    pad(&mut fields, end, span);
    Some(fields)
}

/// Fills the room from `end` to the byte `to`.
fn pad(fields: &mut Vec<Field>, end: u32, to: u32) {
    if to > end {
        let count = fields.iter().filter(|f| f.is_padding).count();
        fields.push(Field {
            // Names of the kernel language never begin so.
            name: format!("_pad{count}"),
            docs: Vec::new(),
            shape: Shape::words((to - end) / 4),
            offset: end,
            is_padding: true,
        });
    }
}

/// A comment on what is missing; empty if nothing is.
fn remark(left_out: &[String], mark: &str) -> String {
    match left_out {
        [] => String::new(),
        names => format!("\n{mark} No buffer can hold: {}.\n", names.join(", ")),
    }
}

#[cfg(test)]
mod tests;
