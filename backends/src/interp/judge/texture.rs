//! Textures, lane after lane.

use super::super::model::Model;
use super::super::program::texture::{Access, Operands, Sampling, TextureOp};
use super::super::program::{Reg, Value};
use super::super::texture::{Reach, Texels, TexelsMut, perform, reach, texel_at, wanted};
use super::column::{Column, Family, family};
use super::picture::{Picture, Stored};
use super::{MISMATCH, Machine, Res, integer};
use crate::texture::{Known, Sampler};

impl<M: Model> Machine<'_, M> {
    pub(super) fn texture(&mut self, access: &Access) -> Res<()> {
        let lanes: Vec<usize> = self.flow.active.lanes().collect();
        for lane in lanes {
            let operands = self.texture_operands(access, lane)?;
            if access.op == TextureOp::Store {
                self.store_texel(access, &operands, lane)?;
                continue;
            }
            let found = self.found(access, &operands, lane)?;
            self.note_written(access, &operands, lane, Stored::Anything)?;
            let sampler = match access.op {
                TextureOp::Sample(sampling) => self.sampler(sampling, &operands).copied(),
                _ => None,
            };
            let image = self.image_mut(access, &operands)?;
            let result = perform(image, sampler.as_ref(), access.op, &operands);
            self.texture_results(access, lane, result, found)?;
        }
        Ok(())
    }

    /// Puts what comes out of an operation in its registers; `found` is what drivers may have.
    fn texture_results(
        &mut self,
        access: &Access,
        lane: usize,
        result: [u64; 4],
        found: Option<[Known; 4]>,
    ) -> Res<()> {
        for (channel, (to, bits)) in access.to.iter().zip(result).enumerate() {
            let Some(Reg(at)) = *to else { continue };
            let scalar = self.program.registers[at as usize].scalar;
            let mut to = std::mem::take(&mut self.registers[at as usize]);
            match (&mut to, found) {
                (Column::Float(to), Some(known)) => {
                    to[lane] = self.model.ranged(f32::from_bits(bits as u32), known[channel]);
                }
                (to, Some(known)) if known[channel].low == known[channel].high => {
                    self.set(to, scalar, lane, self.model.word(bits));
                }
                (to, Some(_) | None) => {
                    self.flags.tainted[lane] = true;
                    self.set(to, scalar, lane, self.model.forget(self.model.word(bits)));
                }
            }
            self.registers[at as usize] = to;
        }
        Ok(())
    }

    /// What drivers may get of an operation, if that is known; an integer that all have is that of the strict path.
    fn found(&self, access: &Access, operands: &Operands<u64>, lane: usize) -> Res<Option<[Known; 4]>> {
        let image = self.image(access, operands)?;
        let is_known = !M::SHADOW || self.is_place_known(access, lane)?;
        Ok(match access.op {
            TextureOp::Load if is_known => image.found(texel_at(image.shape(), operands)),
            TextureOp::Size | TextureOp::Levels | TextureOp::Layers | TextureOp::Samples if is_known => {
                Some([Known::point(0.0); 4])
            }
            TextureOp::Sample(sampling) => self.sampled(access, sampling, operands, lane)?,
            TextureOp::Atomic(_) if !M::SHADOW => Some([Known::point(0.0); 4]),
            _ => None,
        })
    }

    /// What drivers may get of a sample.
    fn sampled(
        &self,
        access: &Access,
        sampling: Sampling,
        operands: &Operands<u64>,
        lane: usize,
    ) -> Res<Option<[Known; 4]>> {
        let range = |value: Value| Ok(self.model.range(self.floats(value)?.at(lane)));
        let is_known =
            |value: Option<Value>| value.map_or(Ok(true), |v| Ok(self.model.known(self.word(v, lane)?)));
        let Operands { layer, texture, sampler, .. } = access.operands;
        let level = access.operands.level.map_or(Ok(Known::point(0.0)), range)?;
        for value in [layer, texture, sampler] {
            if !is_known(value)? {
                return Ok(None);
            }
        }
        let Some(sampler) = self.sampler(sampling, operands) else { return Ok(None) };
        if level.low < level.high {
            return Ok(None);
        }
        let mut coordinates = [Known::point(0.0); 3];
        for (to, value) in coordinates.iter_mut().zip(access.operands.place) {
            *to = value.map_or(Ok(*to), range)?;
        }
        let reference = access.operands.reference.map(range).transpose()?;
        let sample = wanted(sampler, sampling, operands);
        Ok(reach(self.image(access, operands)?, &sample, &Reach { coordinates, reference }))
    }

    /// Whether all drivers look at the same place.
    fn is_place_known(&self, access: &Access, lane: usize) -> Res<bool> {
        let place = Operands { values: [None; 4], reference: None, ..access.operands };
        let mut known = Ok(true);
        place.map(|value| match self.word(value, lane) {
            Ok(word) if self.model.known(word) => {}
            Ok(_) => known = known.clone().map(|_| false),
            Err(error) => known = Err(error),
        });
        known
    }

    /// Stores a texel.
    fn store_texel(&mut self, access: &Access, operands: &Operands<u64>, lane: usize) -> Res<()> {
        let stored = self.stored(access, lane)?;
        self.note_written(access, operands, lane, stored)?;
        let is_taken = !self.flow.unsure(lane) || self.flow.pick(lane).value;
        let shape = self.image(access, operands)?.shape();
        if let (true, Some(at)) = (is_taken, texel_at(shape, operands)) {
            let numbers = operands.values.map(Option::unwrap_or_default);
            let texel = self.model.texel(shape.format, numbers);
            self.image_mut(access, operands)?.set_texel(at, texel);
        }
        Ok(())
    }

    /// What is known of what is stored.
    fn stored(&self, access: &Access, lane: usize) -> Res<Stored> {
        let mut numbers = [Known::point(0.0); 4];
        for (number, value) in numbers.iter_mut().zip(access.operands.values) {
            let Some(value) = value else { continue };
            match family::<M>(self.program.scalar(value)) {
                Family::Float => *number = self.model.range(self.floats(value)?.at(lane)),
                Family::Word | Family::Bool if self.model.known(self.word(value, lane)?) => {}
                Family::Word | Family::Bool => return Ok(Stored::Anything),
            }
        }
        Ok(Stored::Numbers(numbers))
    }

    /// Notes what a store or an atomic leaves in a texel.
    fn note_written(
        &mut self,
        access: &Access,
        operands: &Operands<u64>,
        lane: usize,
        stored: Stored,
    ) -> Res<()> {
        if !M::SHADOW || !access.op.writes() {
            return Ok(());
        }
        let is_known = self.is_place_known(access, lane)?;
        let is_unsure = self.flow.unsure(lane);
        let is_any = match access.operands.texture {
            Some(number) => !self.model.known(self.word(number, lane)?),
            None => false,
        };
        let variable = Some(access.image as usize);
        // Drivers may have chosen another element.
        let others = self.images.iter_mut().filter(|i| is_any && i.found.variable == variable);
        others.for_each(|image| image.spoiled = true);
        let image = self.image_mut(access, operands)?;
        image.spoiled |= !is_known;
        if let Some(at) = texel_at(image.shape(), operands) {
            let stored = if is_unsure { image.perhaps(at, stored) } else { stored };
            image.stored.insert(at, stored);
        }
        Ok(())
    }

    /// The texture that an operation is on.
    pub(super) fn image(&self, access: &Access, operands: &Operands<u64>) -> Res<&Picture> {
        let at = operands.texture.unwrap_or(access.image.into());
        self.images.get(at as usize).ok_or(MISMATCH)
    }

    fn image_mut(&mut self, access: &Access, operands: &Operands<u64>) -> Res<&mut Picture> {
        let at = operands.texture.unwrap_or(access.image.into());
        self.images.get_mut(at as usize).ok_or(MISMATCH)
    }

    fn sampler(&self, sampling: Sampling, operands: &Operands<u64>) -> Option<&Sampler> {
        self.samplers.get(operands.sampler.unwrap_or(sampling.sampler.into()) as usize)
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
