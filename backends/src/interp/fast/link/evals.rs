//! Operations, memory and assignments.

use super::super::super::error::Res;
use super::super::super::program::op::Input;
use super::super::super::program::{Access, Atomic, Count, Eval, Op, Place, Reg, Stmt, Subgroup, Value};
use super::super::control::Blend;
use super::super::shape::{Ask, Each, Same, exec};
use super::super::together::{self, Operand, SubgroupCall, TextureCall};
use super::super::{Inst, memory, ops};
use super::flow::Mask;
use super::{COPIES, Linker, direct, wide};

impl<const N: usize> Linker<'_, N> {
    pub(super) fn eval(&mut self, eval: &Eval, arrays: &[u32]) -> Res<()> {
        let d = self.place(Value::Reg(eval.to));
        match eval.op {
            Op::Input(input, scalar) => {
                if input == Input::GlobalInvocationId(0) {
                    self.numbers.insert(Value::Reg(eval.to));
                }
                self.input(input, d, scalar == super::Scalar::Bool, eval);
                Ok(())
            }
            Op::Index { count, stride } => {
                self.address(eval, count, stride, d);
                Ok(())
            }
            // `within` has spelt it out.
            Op::IndexWithin { .. } => Err(self.refuse(format!("{:?}", eval.op))),
            Op::Length { buffer, begin, stride } => {
                let run = memory::length(self.isa);
                self.insts.push(Inst { run, d, s: [0; 4], n: [buffer, begin, stride] });
                Ok(())
            }
            Op::Load { place: Place::Element { .. }, .. } => {
                self.load_elements(&[Stmt::Eval(*eval)]);
                Ok(())
            }
            Op::Load { place, scalar, .. } => self.load(place, scalar, d, arrays),
            op @ (Op::Copy(_)
            | Op::Float(..)
            | Op::Int(..)
            | Op::Compare(..)
            | Op::Logic(_)
            | Op::IsNan(_)
            | Op::IsInf(_)
            | Op::Select(_)
            | Op::Convert(..)
            | Op::Bitcast(..)
            | Op::Exponent(_)
            | Op::Ldexp(_)
            | Op::Mark(..)
            | Op::Fused { .. }
            | Op::Horner { .. }) => self.operation(op, eval, d),
        }
    }

    fn operation(&mut self, op: Op, eval: &Eval, mut d: u32) -> Res<()> {
        if let Some(to) = self.direct.get(&eval.to).copied() {
            d = self.place(Value::Reg(to));
            if self.program.varying(Value::Reg(to)) && eval.args.contains(&Value::Reg(to)) {
                return self.update(op, eval, to);
            }
        }
        let (mut ask, mut s) = self.operands(eval);
        let missing = || self.refuse(format!("{op:?}"));
        let mut found = ops::find::<N>(op, ask).ok_or_else(missing)?;
        if found.is_none() {
            for (at, arg) in eval.args.iter().enumerate() {
                (s[at], ask.varying[at]) = (self.slot(*arg, at as u32), true);
            }
            found = ops::find::<N>(op, ask).flatten();
        }
        let run = found.ok_or_else(|| self.refuse(format!("{op:?}")))?;
        let n = match op {
            Op::Horner { first, count, begun } => [first, count, begun.into()],
            _ => [0; 3],
        };
        self.insts.push(Inst { run, d, s, n });
        Ok(())
    }

    /// An operation on a slot in place.
    fn update(&mut self, op: Op, eval: &Eval, to: Reg) -> Res<()> {
        let (form, others) = direct::in_place(eval, to).ok_or_else(|| self.refuse(format!("{op:?}")))?;
        let mut ask = Ask { isa: self.isa, varying: [false; 4] };
        let mut s = [0; 4];
        for (at, value) in others.into_iter().enumerate() {
            (s[at], ask.varying[at]) = (self.place(value), self.program.varying(value));
        }
        if form.needs_slot() && !ask.varying[0] {
            s.swap(0, 1);
            ask.varying.swap(0, 1);
        }
        let run = ops::update(form, ask);
        self.insts.push(Inst { run, d: self.place(Value::Reg(to)), s, n: [0; 3] });
        Ok(())
    }

    fn input(&mut self, input: Input, d: u32, boolean: bool, eval: &Eval) {
        let (run, n) = match memory::input(input) {
            Some([kind, part]) if self.program.varying(Value::Reg(eval.to)) => {
                (memory::provide(self.isa), [kind, part, boolean.into()])
            }
            Some([_, axis]) => (memory::provide_same(self.isa), [2, axis, 0]),
            None => {
                let (which, axis) = match input {
                    Input::NumWorkGroups(axis) => (0, axis.into()),
                    Input::WorkGroupSize(axis) => (1, axis.into()),
                    Input::SubgroupSize => (3, 0),
                    Input::NumSubgroups => (4, 0),
                    Input::Column(_)
                    | Input::GlobalInvocationId(_)
                    | Input::LocalInvocationId(_)
                    | Input::LocalInvocationIndex
                    | Input::SubgroupInvocationId
                    | Input::SubgroupId
                    | Input::WorkGroupId(_) => (2, 0),
                };
                (memory::provide_same(self.isa), [which, axis, 0])
            }
        };
        self.insts.push(Inst { run, d, s: [0; 4], n });
    }

    fn address(&mut self, eval: &Eval, count: Count, stride: u32, d: u32) {
        let (index, base) = (self.index(eval.args.first().copied()), self.index(eval.args.get(1).copied()));
        let n = bounds(count, stride);
        let run = memory::index(index.1, base.1, self.isa);
        self.insts.push(Inst { run, d, s: [index.0, base.0, 0, 0], n });
    }

    fn load(&mut self, place: Place, scalar: super::Scalar, d: u32, arrays: &[u32]) -> Res<()> {
        let (index, varying) = self.index(place.index());
        let (run, n) = match place {
            Place::Buffer { buffer, offset, .. } => {
                (memory::load(scalar, varying, self.isa), [buffer, offset, 0])
            }
            Place::Lane { array, offset, .. } => {
                let shape = self.program.arrays[array as usize];
                let run = memory::lane_load(scalar, shape.wide, varying);
                (run, [arrays[array as usize], offset, shape.len.saturating_sub(1)])
            }
            // `elements` links these.
            Place::Element { .. } => return Ok(()),
        };
        self.insts.push(Inst { run, d, s: [index, 0, 0, 0], n });
        Ok(())
    }

    pub(super) fn store(&mut self, place: Place, value: Value, mask: Mask, arrays: &[u32]) -> Res<()> {
        let scalar = self.program.scalar(value);
        let (index, varying) = self.index(place.index());
        let value = (self.place(value), self.program.varying(value));
        let (run, n) = match place {
            Place::Buffer { buffer, offset, .. } => {
                (memory::store(scalar, varying, value.1), [buffer, offset, 0])
            }
            Place::Lane { array, offset, .. } => {
                let shape = self.program.arrays[array as usize];
                let run = memory::lane_store(scalar, shape.wide, [varying, value.1]);
                (run, [arrays[array as usize], offset, shape.len.saturating_sub(1)])
            }
            Place::Element { .. } => {
                self.store_element(place, value, mask.slot);
                return Ok(());
            }
        };
        self.insts.push(Inst { run, d: 0, s: [index, value.0, mask.slot, 0], n });
        Ok(())
    }

    pub(super) fn atomic(&mut self, atomic: &Atomic, mask: Mask) -> Res<()> {
        let Place::Buffer { buffer, offset, index } = atomic.place else {
            return Err(self.refuse("atomics of a lane's own memory".to_owned()));
        };
        let scalar = self.program.scalar(atomic.value);
        let run = memory::atomic(scalar, atomic.fun);
        let run = run.ok_or_else(|| self.refuse(format!("atomics of {scalar:?}")))?;
        let index = match index {
            Some(index) => self.slot(index, 0),
            None => self.zero_slot(),
        };
        let value = self.slot(atomic.value, 1);
        let expected = atomic.expected.map_or(value, |e| self.slot(e, 2));
        // Without a reader the old word goes where copies lie.
        let unread = if scalar.wide() { COPIES - 1 } else { COPIES };
        let d = atomic.old.map_or(unread, |old| self.place(Value::Reg(old)));
        let n = [buffer, offset, memory::number(atomic.fun)];
        self.insts.push(Inst { run, d, s: [index, value, mask.slot, expected], n });
        Ok(())
    }

    pub(super) fn texture(&mut self, access: &Access, mask: Mask) {
        let to = access.to.map(|to| to.map(|to| self.result(to)));
        let operands = access.operands.map(|value| self.operand(value));
        let call = TextureCall { image: access.image, op: access.op, operands, to };
        let at = self.calls.textures.len() as u32;
        self.calls.textures.push(call);
        self.push::<together::Texture>(0, [mask.slot, 0, 0, 0], [at, 0, 0]);
    }

    pub(super) fn subgroup(&mut self, subgroup: &Subgroup, mask: Mask) {
        let call = SubgroupCall {
            op: subgroup.op,
            value: self.operand(subgroup.value),
            index: subgroup.index.map(|index| self.operand(index)),
            to: self.result(subgroup.to),
        };
        let at = self.calls.subgroups.len() as u32;
        self.calls.subgroups.push(call);
        self.push::<together::Together>(0, [mask.slot, 0, 0, 0], [at, 0, 0]);
    }

    fn operand(&self, value: Value) -> Operand {
        let (varying, scalar) = (self.program.varying(value), self.program.scalar(value));
        Operand { place: self.place(value), varying, scalar }
    }

    fn result(&self, to: Reg) -> (u32, bool) {
        let value = Value::Reg(to);
        (self.place(value), wide(self.program.scalar(value)))
    }

    /// A slot of zeros.
    fn zero_slot(&mut self) -> u32 {
        let run = ops::splat(super::Scalar::U32, self.isa);
        self.insts.push(Inst { run, d: 1, s: [self.zero, 0, 0, 0], n: [0; 3] });
        1
    }

    /// Assigns a kept register: in the lanes of the mask, or in all where it was first set under this one.
    pub(super) fn set(&mut self, to: Reg, value: Value, mask: Mask) {
        self.assigned.insert(to);
        if matches!(value, Value::Reg(from) if self.direct.get(&from) == Some(&to)) {
            return;
        }
        let scalar = self.program.scalar(value);
        let (d, s) = (self.place(Value::Reg(to)), self.place(value));
        let whole = self.masks.declared.get(&to) == Some(&mask.owner);
        let (to, from) = (self.program.varying(Value::Reg(to)), self.program.varying(value));
        let run = match (to, from, whole) {
            (true, false, true) => ops::splat(scalar, self.isa),
            (false, _, _) | (true, true, true) => {
                let ask = Ask { isa: self.isa, varying: [from, false, false, false] };
                match ops::find::<N>(Op::Copy(scalar), ask).flatten() {
                    Some(run) => run,
                    None => return,
                }
            }
            (true, true, false) if wide(scalar) => exec::<Blend<u64, Each>, N>(self.isa),
            (true, true, false) => exec::<Blend<u32, Each>, N>(self.isa),
            (true, false, false) if wide(scalar) => exec::<Blend<u64, Same>, N>(self.isa),
            (true, false, false) => exec::<Blend<u32, Same>, N>(self.isa),
        };
        let s = if whole || !to { [s, 0, 0, 0] } else { [mask.slot, s, 0, 0] };
        self.insts.push(Inst { run, d, s, n: [0; 3] });
    }
}

/// Stride and number of elements as steps that compute addresses take them.
pub(super) fn bounds(count: Count, stride: u32) -> [u32; 3] {
    match count {
        Count::Fixed(count) => [stride, count, 0],
        Count::Runtime { buffer, begin } => [stride, begin, buffer + 1],
    }
}
