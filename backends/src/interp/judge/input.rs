//! What a program is given: arguments of rows, or who an invocation is.

use super::super::model::Model;
use super::super::program::Scalar;
use super::super::program::op::{Input, Op};
use super::column::{Column, Family, family};
use super::{Machine, Res};
use lobe_codegen::data::Columns;

/// What the lanes of a batch are.
#[derive(Debug, Clone, Copy)]
pub(super) enum Inputs<'a> {
    /// Rows, from this one on, with the exact values of their floats.
    Rows { args: &'a Columns, exact: Option<&'a [Vec<f64>]>, first: usize },
    /// The invocations of a workgroup.
    Group { group: [u32; 3], groups: [u32; 3], size: [u32; 3], subgroup: u32 },
}

impl Inputs<'_> {
    pub(super) fn workgroup(&self) -> bool {
        matches!(self, Self::Group { .. })
    }
}

/// Place of an invocation in its workgroup.
pub(super) fn local([w, h, _]: [u32; 3], lane: usize) -> [u32; 3] {
    let lane = lane as u32;
    [lane % w, lane / w % h, lane / (w * h)]
}

impl<M: Model> Machine<'_, M> {
    pub(super) fn input(&self, input: Input, scalar: Scalar, to: &mut Column<M>) -> Res<()> {
        match (self.inputs, input) {
            (Inputs::Rows { args, exact, first }, Input::Column(column)) => {
                let words = &args.columns[column as usize][first..];
                let exact = exact.map(|e| &e[column as usize][first..]);
                self.column(words, exact, scalar, to)
            }
            (Inputs::Group { group, groups, size, subgroup }, input) => {
                let word = |lane: usize| {
                    let at = |axis: u8| usize::from(axis);
                    Some(match input {
                        Input::GlobalInvocationId(axis) => {
                            let axis = at(axis);
                            group[axis].wrapping_mul(size[axis]).wrapping_add(local(size, lane)[axis])
                        }
                        Input::LocalInvocationId(axis) => local(size, lane)[at(axis)],
                        Input::LocalInvocationIndex => lane as u32,
                        Input::WorkGroupId(axis) => group[at(axis)],
                        Input::NumWorkGroups(axis) => groups[at(axis)],
                        Input::WorkGroupSize(axis) => size[at(axis)],
                        Input::SubgroupInvocationId => lane as u32 % subgroup,
                        Input::SubgroupId => lane as u32 / subgroup,
                        Input::SubgroupSize => subgroup,
                        Input::NumSubgroups => (self.lanes as u32).div_ceil(subgroup),
                        Input::Column(_) => return None,
                    })
                };
                if word(0).is_none() {
                    return Err(self.refuse(format!("{:?}", Op::Input(input, scalar))));
                }
                self.each_word(to, |m, lane| m.word(word(lane).unwrap_or(0).into()))
            }
            (Inputs::Rows { .. }, input) => Err(self.refuse(format!("{:?}", Op::Input(input, scalar)))),
        }
    }

    fn column(&self, words: &[u32], exact: Option<&[f64]>, scalar: Scalar, to: &mut Column<M>) -> Res<()> {
        match family::<M>(scalar) {
            Family::Float => by_width!(self.model, scalar, m => self.each_float(to, |_, lane| {
                let value = f32::from_bits(words[lane]);
                m.float(value, exact.map_or(value.into(), |e| e[lane]))
            })),
            Family::Word => self.each_word(to, |m, lane| m.word(words[lane].into())),
            Family::Bool => self.each_bool(to, |m, lane| m.boolean(words[lane] != 0)),
        }
    }
}
