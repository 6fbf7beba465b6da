//! Textures and samplers.

use super::super::error::Res;
use super::super::program::texture::{Operands, Sampling, TextureOp};
use super::super::program::{Access, Content, Image, Op, Reg, SamplerVariable, Scalar, Stmt, Value};
use super::control::Flow;
use super::frame::{Choice, Frame, Item};
use super::{Lowerer, malformed};
use crate::texture::Dimension;
use naga::{
    AtomicFunction, Expression, GlobalVariable, Handle, ImageClass, ImageDimension, ImageQuery, SampleLevel,
    TypeInner,
};

/// What a view of a texture is called.
fn dimension(dim: ImageDimension, arrayed: bool) -> Option<Dimension> {
    match (dim, arrayed) {
        (ImageDimension::D1, false) => Some(Dimension::D1),
        (ImageDimension::D2, false) => Some(Dimension::D2),
        (ImageDimension::D2, true) => Some(Dimension::D2Array),
        (ImageDimension::D3, false) => Some(Dimension::D3),
        (ImageDimension::Cube, false) => Some(Dimension::Cube),
        (ImageDimension::Cube, true) => Some(Dimension::CubeArray),
        (ImageDimension::D1 | ImageDimension::D3, true) => None,
    }
}

/// The scalars of a list, each if it is there.
fn some<const N: usize>(values: &[Value]) -> [Option<Value>; N] {
    std::array::from_fn(|at| values.get(at).copied())
}

impl<'m> Lowerer<'m> {
    /// A texture or sampler variable; `None` for what is neither.
    pub(crate) fn texture_variable(&mut self, handle: Handle<GlobalVariable>) -> Res<Option<Item>> {
        let variable = &self.module.module().global_variables[handle];
        let name = variable.name.clone().unwrap_or_default();
        let binding = || {
            let place = variable.binding.as_ref().map(|b| (b.group, b.binding));
            place.ok_or(malformed("a texture or sampler has no binding"))
        };
        let choice = |at: usize| Choice { variable: at as u32, element: None };
        match *self.types().inner(self.bound_type(variable)) {
            TypeInner::Image { dim, arrayed, class } => {
                let dimension = dimension(dim, arrayed).ok_or(malformed("there is no such texture array"))?;
                if let Some(at) = self.b.program.images.iter().position(|i| i.variable == handle) {
                    return Ok(Some(Item::Image(choice(at))));
                }
                let array = self.binding_array(handle, Content::Textures)?;
                let (binding, written) = (binding()?, false);
                let image = Image { variable: handle, name, binding, dimension, class, written, array };
                self.b.program.images.push(image);
                Ok(Some(Item::Image(choice(self.b.program.images.len() - 1))))
            }
            TypeInner::Sampler { comparison } => {
                if let Some(at) = self.b.program.samplers.iter().position(|s| s.variable == handle) {
                    return Ok(Some(Item::Sampler(choice(at))));
                }
                let array = self.binding_array(handle, Content::Samplers)?;
                let (variable, binding) = (handle, binding()?);
                let sampler = SamplerVariable { variable, name, binding, comparison, array };
                self.b.program.samplers.push(sampler);
                Ok(Some(Item::Sampler(choice(self.b.program.samplers.len() - 1))))
            }
            _ => Ok(None),
        }
    }

    /// Reads, samples or asks about a texture.
    pub(crate) fn read_texture(&mut self, frame: &Frame<'m>, handle: Handle<Expression>) -> Res<Item> {
        let single = |e: Option<Handle<Expression>>| e.map(|e| frame.single(e)).transpose();
        let (image, op, operands) = match frame.function.expressions[handle] {
            Expression::ImageLoad { image, coordinate, array_index, sample, level } => {
                let place = some(&frame.data(coordinate)?);
                let [layer, sample, level] = [single(array_index)?, single(sample)?, single(level)?];
                (image, TextureOp::Load, Operands { place, layer, sample, level, ..Operands::default() })
            }
            Expression::ImageQuery { image, query } => {
                let (op, level) = match query {
                    ImageQuery::Size { level } => (TextureOp::Size, single(level)?),
                    ImageQuery::NumLevels => (TextureOp::Levels, None),
                    ImageQuery::NumLayers => (TextureOp::Layers, None),
                    ImageQuery::NumSamples => (TextureOp::Samples, None),
                };
                (image, op, Operands { level, ..Operands::default() })
            }
            Expression::ImageSample {
                image,
                sampler,
                gather,
                coordinate,
                array_index,
                offset,
                level,
                depth_ref,
                clamp_to_edge,
            } => {
                let offset = self.offset(frame, offset)?;
                let gather = gather.map(|channel| channel as u8);
                let sampler = frame.sampler(sampler)?;
                let sampling = Sampling { sampler: sampler.variable, offset, gather, clamp_to_edge };
                let place = some(&frame.data(coordinate)?);
                let [layer, reference] = [single(array_index)?, single(depth_ref)?];
                let sampler = sampler.element;
                let operands = Operands { place, layer, reference, sampler, ..Operands::default() };
                (image, TextureOp::Sample(sampling), self.level(frame, level, operands)?)
            }
            _ => return Err(malformed("no texture is read")),
        };
        let image = frame.image(image)?;
        let scalars = self.types().kinds(self.shape(frame, handle)?)?;
        let registers: Vec<Reg> = scalars.iter().map(|s| self.b.register(*s)).collect();
        let to = std::array::from_fn(|at| registers.get(at).copied());
        self.access_texture(frame, image, op, operands, to)?;
        Ok(Item::values(registers.into_iter().map(Value::Reg).collect()))
    }

    /// The operands with what says the level of a sample.
    fn level(
        &mut self,
        frame: &Frame<'m>,
        level: SampleLevel,
        operands: Operands<Value>,
    ) -> Res<Operands<Value>> {
        match level {
            SampleLevel::Auto | SampleLevel::Bias(_) => Err(frame.unsupported(
                "textureSample, textureSampleBias or textureSampleCompare: a level of detail that comes of \
                 derivatives, which only fragment shaders have; use textureSampleLevel or textureSampleGrad",
            )),
            SampleLevel::Zero => Ok(operands),
            SampleLevel::Exact(level) => {
                let level = frame.single(level)?;
                let scalar = self.b.scalar(level);
                let convert = Op::Convert(scalar, Scalar::F32);
                let level = if scalar.float() { level } else { self.b.eval(convert, &[level]) };
                Ok(Operands { level: Some(level), ..operands })
            }
            SampleLevel::Gradient { x, y } => {
                let gradient = [some(&frame.data(x)?), some(&frame.data(y)?)];
                Ok(Operands { gradient, ..operands })
            }
        }
    }

    /// A constant offset in texels.
    fn offset(&self, frame: &Frame<'m>, offset: Option<Handle<Expression>>) -> Res<[i32; 3]> {
        let mut out = [0; 3];
        if let Some(offset) = offset {
            for (to, value) in out.iter_mut().zip(frame.data(offset)?.iter()) {
                let known =
                    self.b.known(*value).ok_or(malformed("the offset of a sample is not constant"))?;
                *to = known as u32 as i32;
            }
        }
        Ok(out)
    }

    pub(crate) fn store_texel(
        &mut self,
        frame: &Frame<'m>,
        [image, coordinate, value]: [Handle<Expression>; 3],
        array_index: Option<Handle<Expression>>,
    ) -> Res<Flow> {
        self.write_texel(frame, [image, coordinate, value], array_index, TextureOp::Store)
    }

    pub(crate) fn update_texel(
        &mut self,
        frame: &Frame<'m>,
        [image, coordinate, value]: [Handle<Expression>; 3],
        array_index: Option<Handle<Expression>>,
        fun: AtomicFunction,
    ) -> Res<Flow> {
        let op = TextureOp::Atomic(super::atomic::update(&fun));
        self.write_texel(frame, [image, coordinate, value], array_index, op)
    }

    fn write_texel(
        &mut self,
        frame: &Frame<'m>,
        [image, coordinate, value]: [Handle<Expression>; 3],
        array_index: Option<Handle<Expression>>,
        op: TextureOp,
    ) -> Res<Flow> {
        let layer = array_index.map(|e| frame.single(e)).transpose()?;
        let (place, values) = (some(&frame.data(coordinate)?), some(&frame.data(value)?));
        let image = frame.image(image)?;
        self.b.program.images[image.variable as usize].written = true;
        self.access_texture(
            frame,
            image,
            op,
            Operands { place, layer, values, ..Operands::default() },
            [None; 4],
        )?;
        Ok(Flow::Falls)
    }

    fn access_texture(
        &mut self,
        frame: &Frame<'m>,
        image: Choice,
        op: TextureOp,
        operands: Operands<Value>,
        to: [Option<Reg>; 4],
    ) -> Res<()> {
        let operands = Operands { texture: image.element, ..operands };
        let image = image.variable;
        if self.b.program.images[image as usize].class == ImageClass::External {
            return Err(frame.unsupported("external textures"));
        }
        let at = self.b.at;
        self.b.push(Stmt::Texture(Box::new(Access { image, op, operands, to, at })));
        Ok(())
    }
}
