//! Textures, lane after lane.

use super::super::model::Model;
use super::super::program::texture::{Access, Operands, TextureOp};
use super::super::program::{Reg, Value};
use super::super::texture::perform;
use super::column::{Column, Family, family};
use super::{Machine, Res, integer};

impl<M: Model> Machine<'_, M> {
    pub(super) fn texture(&mut self, access: &Access) -> Res<()> {
        let lanes: Vec<usize> = self.flow.active.lanes().collect();
        for lane in lanes {
            let known = self.promised(access, lane)?;
            let operands = self.texture_operands(access, lane)?;
            let sampler = match access.op {
                TextureOp::Sample(sampling) => self.samplers.get(sampling.sampler as usize).copied(),
                _ => None,
            };
            let image = &mut self.images[access.image as usize];
            let result = perform(image, sampler.as_ref(), access.op, &operands);
            for (to, bits) in access.to.iter().zip(result) {
                let Some(Reg(at)) = *to else { continue };
                let mut to = std::mem::take(&mut self.registers[at as usize]);
                let promised = known && !matches!(to, Column::Float(_));
                self.flags.tainted[lane] |= !promised;
                let word = self.model.word(bits);
                let scalar = self.program.registers[at as usize].scalar;
                self.set(&mut to, scalar, lane, if promised { word } else { self.model.forget(word) });
                self.registers[at as usize] = to;
            }
        }
        Ok(())
    }

    /// Whether every driver finds the same integers: those of a texture that nobody writes, at a place that is known.
    fn promised(&self, access: &Access, lane: usize) -> Res<bool> {
        let fixed = match access.op {
            TextureOp::Size | TextureOp::Levels | TextureOp::Layers | TextureOp::Samples => true,
            TextureOp::Load => !self.program.images[access.image as usize].written,
            TextureOp::Store | TextureOp::Atomic(_) | TextureOp::Sample(_) => false,
        };
        if !M::SHADOW || !fixed {
            return Ok(!M::SHADOW);
        }
        let mut known = Ok(true);
        access.operands.map(|value| match self.word(value, lane) {
            Ok(word) if self.model.known(word) => {}
            Ok(_) => known = known.clone().map(|_| false),
            Err(error) => known = Err(error),
        });
        known
    }

    /// The bits of all operands in a lane.
    pub(super) fn texture_operands(&self, access: &Access, lane: usize) -> Res<Operands<u64>> {
        let mut failed = None;
        let operands = access.operands.map(|value| {
            self.operand(value, lane).unwrap_or_else(|error| {
                failed = Some(error);
                0
            })
        });
        failed.map_or(Ok(operands), Err)
    }

    /// The bits of an operand; a signed integer fills all 64.
    fn operand(&self, value: Value, lane: usize) -> Res<u64> {
        let scalar = self.program.scalar(value);
        let bits = self.model.word_value(self.word(value, lane)?);
        let signed = family::<M>(scalar) == Family::Word && scalar.signed();
        Ok(if signed { integer::number(bits, scalar) as u64 } else { bits })
    }
}
