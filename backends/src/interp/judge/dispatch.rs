//! Entry points over buffers.
//!
//! The invocations of a workgroup are the lanes of one batch, so a barrier needs nothing but all of them;
//! workgroups run one after the other.

use super::super::Buffer;
use super::super::finding::{Checks, Finding};
use super::super::model::Model;
use super::super::resources::{Found, FoundBuffer, Resources};
use super::super::shadow::{Promises, Shadow};
use super::super::strict::Strict;
use super::super::{ShadowBuffer, ShadowFloat, ShadowRun, ShadowTexel, ShadowTexture, ShadowWord};
use super::atomic::Order;
use super::input::Inputs;
use super::picture::{Picture, Stored};
use super::shared::{Cell, Other, Shared};
use super::watch::{self, Watch};
use super::{Code, Machine, Res};
use std::ops::Range;

/// A dispatch of a program.
pub(in super::super) struct Dispatch<'a> {
    pub(in super::super) code: &'a Code,
    pub(in super::super) size: [u32; 3],
    pub(in super::super) groups: [u32; 3],
    pub(in super::super) fuel: u64,
    /// Invocations of a subgroup.
    pub(in super::super) subgroup: u32,
}

/// What a dispatch leaves.
struct Left<M: Model> {
    /// That of the last workgroup.
    model: M,
    memory: Vec<Shared<M>>,
    images: Vec<Picture>,
}

impl Dispatch<'_> {
    /// Runs all workgroups; buffers and textures are updated in place.
    pub(in super::super) fn run<M: Model>(
        &self,
        resources: &mut Resources<'_>,
        model: impl Fn(usize) -> M,
    ) -> Res<()> {
        self.everything(resources, model, |_, _, _| {}, &mut None).map(|_| ())
    }

    /// The same, looking for mistakes.
    pub(in super::super) fn sanitize(
        &self,
        resources: &mut Resources<'_>,
        checks: Checks,
    ) -> Res<Vec<Finding>> {
        let mut watch = Some(Watch::new(checks));
        let outcome = self.everything(resources, |_| Strict, |_, _, _| {}, &mut watch);
        watch::findings(outcome.map(|_| ()), watch)
    }

    /// What the program may leave in buffers and textures that it may write.
    pub(in super::super) fn shadow(
        &self,
        promises: Promises,
        resources: &mut Resources<'_>,
    ) -> Res<ShadowRun> {
        let Left { model: m, memory, images } =
            self.everything(resources, |_| Shadow::new(promises), detach, &mut None)?;
        let written = self.code.program.buffers.iter().zip(&memory).filter(|(b, _)| b.written);
        let mut buffers: Vec<_> = written
            .filter_map(|(buffer, shared)| Some(told_buffers(&m, buffer.binding?, shared)))
            .flatten()
            .collect();
        buffers.sort_by_key(|b| (b.group, b.binding));
        let textures = images.iter().filter_map(|picture| {
            let image = &self.code.program.images[picture.found.variable?];
            image.written.then(|| told_texture(image.binding, picture))
        });
        Ok(ShadowRun { buffers, textures: textures.collect() })
    }

    /// Runs all workgroups, each with a model of its own; `after` sees each one's memory once it is done.
    fn everything<M: Model>(
        &self,
        resources: &mut Resources<'_>,
        model: impl Fn(usize) -> M,
        after: impl Fn(&M, &mut [Shared<M>], &Order),
        watch: &mut Option<Watch>,
    ) -> Res<Left<M>> {
        let found = Found::of(&self.code.program, resources)?;
        let mut memory = found.buffers.iter().map(|b| shared(b, resources.buffers)).collect();
        let images = found.images.iter().map(|i| Picture::new(resources.textures[i.at].texture.clone(), *i));
        let mut images: Vec<Picture> = images.collect();
        let mut order = Order::new(M::SHADOW);
        let mut last = model(0);
        for (index, group) in self.each_group().enumerate() {
            let lanes = self.size.iter().map(|n| *n as usize).product();
            let (groups, size, subgroup) = (self.groups, self.size, self.subgroup.max(1));
            let inputs = Inputs::Group { group, groups, size, subgroup };
            let mut machine = Machine::new(self.code, model(index), inputs, lanes, self.fuel);
            (machine.shared, machine.order, machine.images) = (memory, order, images);
            machine.samplers.clone_from(&found.samplers);
            self.clear_own(&mut machine.shared);
            machine.watch = watch.take();
            machine.watch_begin();
            let outcome = machine.run();
            *watch = machine.watch.take();
            outcome?;
            (memory, order, images, last) = (machine.shared, machine.order, machine.images, machine.model);
            after(&last, &mut memory, &order);
            order.leave_group(|buffer| self.code.program.buffers[buffer as usize].binding.is_none());
        }
        for (buffer, shared) in found.buffers.iter().zip(&memory) {
            match buffer {
                FoundBuffer::One(at) => write(&last, shared, &mut resources.buffers[*at].data),
                FoundBuffer::Elements(elements) => {
                    let mut bytes = elements.gather(resources.buffers);
                    write(&last, shared, &mut bytes);
                    elements.scatter(&bytes, resources.buffers);
                }
                FoundBuffer::Own | FoundBuffer::Directory(_) => {}
            }
        }
        for image in images.iter().filter(|image| image.found.variable.is_some()) {
            resources.textures[image.found.at].texture = image.texture.clone();
        }
        Ok(Left { model: last, memory, images })
    }

    fn each_group(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        let [w, h, d] = self.groups;
        (0..d).flat_map(move |z| (0..h).flat_map(move |y| (0..w).map(move |x| [x, y, z])))
    }

    /// Workgroup variables are zero.
    fn clear_own<M: Model>(&self, memory: &mut [Shared<M>]) {
        for (buffer, shared) in self.code.program.buffers.iter().zip(memory) {
            if buffer.binding.is_none() {
                let words = buffer.bytes.div_ceil(4) as usize;
                *shared = Shared::new(vec![Cell::Bits(0); words]);
            }
        }
    }
}

/// Words on the f32 path, as bytes.
fn write<M: Model>(m: &M, shared: &Shared<M>, bytes: &mut [u8]) {
    for (chunk, cell) in bytes.chunks_exact_mut(4).zip(&shared.cells) {
        let word = match cell {
            Cell::Bits(bits) => *bits,
            Cell::Float(a) => m.value(*a).to_bits(),
            Cell::Word(a) => m.word_value(*a) as u32,
        };
        chunk.copy_from_slice(&word.to_le_bytes());
    }
}

fn shared<M: Model>(found: &FoundBuffer, buffers: &[Buffer]) -> Shared<M> {
    let words = |bytes: &[u8]| {
        let words = bytes.as_chunks().0.iter();
        Shared::new(words.map(|c| Cell::Bits(u32::from_le_bytes(*c))).collect())
    };
    match found {
        FoundBuffer::Own => words(&[]),
        FoundBuffer::One(at) => words(&buffers[*at].data),
        FoundBuffer::Elements(elements) => {
            Shared { elements: Some(elements.clone()), ..words(&elements.gather(buffers)) }
        }
        FoundBuffer::Directory(entries) => {
            Shared::new(entries.iter().map(|word| Cell::Bits(*word)).collect())
        }
    }
}

/// Floats as they are without the tape of the workgroup that wrote them.
fn detach(m: &Shadow, memory: &mut [Shared<Shadow>], order: &Order) {
    for (buffer, at) in &order.written {
        if let Some(Cell::Float(a)) = memory[*buffer as usize].cells.get_mut(*at) {
            *a = m.detached(*a);
        }
        for (_, other) in memory[*buffer as usize].others.range_mut(4 * at..4 * at + 4) {
            other.float = m.detached(other.float);
        }
    }
}

fn told(m: &Shadow, cell: Cell<Shadow>) -> ShadowWord {
    match cell {
        Cell::Bits(value) => ShadowWord::Word { value, known: true },
        Cell::Float(a) => ShadowWord::Float { value: a.value as f32, exact: a.exact, bound: m.bound(a) },
        Cell::Word(a) => ShadowWord::Word { value: a.value as u32, known: a.known },
    }
}

/// What is left of a buffer, or of each element of a binding array.
fn told_buffers(m: &Shadow, (group, binding): (u32, u32), shared: &Shared<Shadow>) -> Vec<ShadowBuffer> {
    let told_one = |(element, bytes): (u32, Range<usize>)| {
        let words = bytes.start / 4..bytes.end / 4;
        let others = shared.others.range(bytes.clone()).filter(|_| !shared.spoiled);
        let float = |(at, other): (&usize, &Other<Shadow>)| {
            let a = other.float;
            ShadowFloat {
                at: at - bytes.start,
                bytes: other.scalar.bytes(),
                value: a.value,
                exact: a.exact,
                bound: m.bound(a),
            }
        };
        ShadowBuffer {
            group,
            binding,
            element,
            words: words.map(|at| told(m, shared.get(m, at))).collect(),
            floats: others.map(float).collect(),
        }
    };
    (0..).zip(shared.ranges()).map(told_one).collect()
}

fn told_texture((group, binding): (u32, u32), picture: &Picture) -> ShadowTexture {
    let told = |(at, stored): (&usize, &Stored)| {
        let ranges = match stored {
            Stored::Numbers(numbers) => Some(numbers.map(|known| [known.low, known.high])),
            Stored::Anything => None,
        };
        ShadowTexel { at: *at, ranges }
    };
    let texels = picture.stored.iter().map(told).collect();
    let (element, is_known) = (picture.found.element, !picture.spoiled);
    ShadowTexture { group, binding, element, texels, is_known }
}
