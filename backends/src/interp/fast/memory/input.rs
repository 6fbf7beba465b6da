//! What the executor provides: arguments, built-ins.
#![allow(unsafe_code, reason = "steps on slots and cells at once")]

use super::super::super::program::op::Input;
use super::super::machine::Machine;
use super::super::shape::{Body, Exec, exec, set_cell, target};
use super::super::{Inst, Isa};

/// Fills `d` with input `n[0]`, part `n[1]`; `n[2]` says that it is a boolean.
struct Provide;

impl<const N: usize> Body<N> for Provide {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let d: &mut [u32; N] = unsafe { target(m, i.d) };
        if m.position.line && i.n[..2] == NUMBER {
            let first = m.position.first as u32;
            d.iter_mut().enumerate().for_each(|(lane, d)| *d = first.wrapping_add(lane as u32));
        } else {
            m.provide(i.n, d);
        }
        at + 1
    }
}

/// The kind and part of the number of an invocation along the first axis.
const NUMBER: [u32; 2] = [1, 0];

impl<const N: usize> Machine<N> {
    fn provide(&self, [kind, part, boolean]: [u32; 3], d: &mut [u32; N]) {
        let p = self.position;
        if kind == 0 {
            // SAFETY: a column has as many rows as the batch has lanes, from its first row on.
            let column =
                unsafe { std::slice::from_raw_parts(self.columns[part as usize].add(p.first), p.live) };
            d[p.live..].fill(0);
            if boolean == 0 {
                d[..p.live].copy_from_slice(column);
            } else {
                d.iter_mut().zip(column).for_each(|(d, c)| *d = u32::from(*c != 0).wrapping_neg());
            }
            return;
        }
        let axis = part as usize;
        self.each_invocation(|lane, local, group, index| {
            d[lane] = match kind {
                1 => group[axis].wrapping_mul(p.size[axis]).wrapping_add(local[axis]),
                2 => local[axis],
                3 => index,
                5 => index % p.subgroup.max(1),
                6 => index / p.subgroup.max(1),
                _ => group[axis],
            };
        });
    }

    /// Calls `f` with lane, place in the workgroup, workgroup and index in it.
    fn each_invocation(&self, mut f: impl FnMut(usize, [u32; 3], [u32; 3], u32)) {
        let p = self.position;
        let volume: usize = p.size.iter().map(|n| *n as usize).product();
        let split = |at: usize, size: [u32; 3]| {
            let (w, h) = (size[0].max(1) as usize, size[1].max(1) as usize);
            [at % w, at / w % h, at / (w * h)].map(|n| n as u32)
        };
        let (mut workgroup, mut index) = (p.first / volume.max(1), p.first % volume.max(1));
        let (mut group, mut local) = (split(workgroup, p.groups), split(index, p.size));
        for lane in 0..N {
            f(lane, local, group, index as u32);
            index += 1;
            local[0] += 1;
            if local[0] == p.size[0] {
                local = [0, local[1] + 1, local[2]];
                if local[1] == p.size[1] {
                    local = [0, 0, local[2] + 1];
                }
            }
            if index == volume {
                (index, workgroup, local) = (0, workgroup + 1, [0; 3]);
                group = split(workgroup, p.groups);
            }
        }
    }
}

/// The kind and part of a lane input, as [`Provide`] takes them; `None` for uniform ones.
pub(in super::super) fn input(input: Input) -> Option<[u32; 2]> {
    match input {
        Input::Column(column) => Some([0, column]),
        Input::GlobalInvocationId(axis) => Some([1, axis.into()]),
        Input::LocalInvocationId(axis) => Some([2, axis.into()]),
        Input::LocalInvocationIndex => Some([3, 0]),
        Input::WorkGroupId(axis) => Some([4, axis.into()]),
        Input::SubgroupInvocationId => Some([5, 0]),
        Input::SubgroupId => Some([6, 0]),
        Input::NumWorkGroups(_) | Input::WorkGroupSize(_) | Input::SubgroupSize | Input::NumSubgroups => None,
    }
}

/// A uniform built-in: `n[0]` which, `n[1]` the axis.
struct ProvideSame;

impl<const N: usize> Body<N> for ProvideSame {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let p = m.position;
        let axis = i.n[1] as usize;
        let value = match i.n[0] {
            0 => p.groups[axis],
            1 => p.size[axis],
            3 => p.subgroup,
            4 => p.size.iter().product::<u32>().div_ceil(p.subgroup.max(1)),
            _ => {
                let volume: usize = p.size.iter().map(|n| *n as usize).product();
                let at = p.first / volume.max(1);
                let (w, h) = (p.groups[0].max(1) as usize, p.groups[1].max(1) as usize);
                [at % w, at / w % h, at / (w * h)][axis] as u32
            }
        };
        // SAFETY: as `Body` promises.
        unsafe { set_cell(m, i.d, value) };
        at + 1
    }
}

pub(in super::super) fn provide<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<Provide, N>(isa)
}

pub(in super::super) fn provide_same<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<ProvideSame, N>(isa)
}
