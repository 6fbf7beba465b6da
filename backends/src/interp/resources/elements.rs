//! The elements of binding arrays among the resources of a dispatch.

use super::super::error::{InterpError, Res};
use super::super::program::{BindingArray, Content, Program};
use super::{Buffer, Found, FoundBuffer, FoundImage, Resources, check_sampler, check_size, check_texture};
use std::ops::Range;

/// Bytes that the begin of an element is a multiple of.
const ALIGN: usize = 16;

/// Buffers that lie one behind the other.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(in super::super) struct Elements {
    list: Vec<Element>,
    /// Bytes in all.
    bytes: usize,
}

/// One of them.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Element {
    /// Which of the resources.
    at: usize,
    /// Its bytes.
    range: Range<usize>,
}

impl Elements {
    /// Such buffers, each by its place among the resources and its bytes; `None` if addresses do not reach.
    fn of(buffers: impl Iterator<Item = (usize, usize)>) -> Option<Self> {
        let mut elements = Self::default();
        for (at, bytes) in buffers {
            let (begin, end) = (elements.bytes, elements.bytes.checked_add(bytes)?);
            elements.list.push(Element { at, range: begin..end });
            elements.bytes = end.checked_next_multiple_of(ALIGN)?;
        }
        u32::try_from(elements.bytes).is_ok().then_some(elements)
    }

    /// The bytes of each.
    pub(in super::super) fn ranges(&self) -> impl Iterator<Item = Range<usize>> {
        self.list.iter().map(|element| element.range.clone())
    }

    /// The element that byte `at` lies in, and which of its bytes it is.
    pub(in super::super) fn element(&self, at: usize) -> (usize, usize) {
        let element = self.list.partition_point(|element| element.range.start <= at).saturating_sub(1);
        (element, at - self.list.get(element).map_or(0, |element| element.range.start))
    }

    /// The bytes of all.
    pub(in super::super) fn gather(&self, buffers: &[Buffer]) -> Vec<u8> {
        let mut bytes = vec![0; self.bytes];
        for Element { at, range } in &self.list {
            bytes[range.clone()].copy_from_slice(&buffers[*at].data);
        }
        bytes
    }

    /// Gives each its part of the bytes of all.
    pub(in super::super) fn scatter(&self, bytes: &[u8], buffers: &mut [Buffer]) {
        for Element { at, range } in &self.list {
            buffers[*at].data.copy_from_slice(&bytes[range.clone()]);
        }
    }
}

impl Found {
    /// Finds the elements of the program's binding arrays, and fills their directories.
    pub(super) fn elements(&mut self, program: &Program, resources: &Resources<'_>) -> Res<()> {
        for (at, wanted) in program.buffers.iter().enumerate() {
            let Some(place) = wanted.binding else { continue };
            let arrays = Wanted { name: &wanted.name, place };
            match wanted.content {
                Content::Variable | Content::Places(_) => {}
                Content::Elements(array) => {
                    let buffers = resources.buffers.iter().map(|b| (b.group, b.binding));
                    let found = arrays.elements(array, buffers)?;
                    found.iter().try_for_each(|at| check_size(wanted, &resources.buffers[*at]))?;
                    let sizes = found.iter().map(|at| (*at, resources.buffers[*at].data.len()));
                    let too_large = || InterpError::ElementsTooLarge { name: wanted.name.clone() };
                    let elements = Elements::of(sizes).ok_or_else(too_large)?;
                    let places = elements.ranges().flat_map(|r| [r.start as u32, r.end as u32]);
                    self.buffers[array.directory as usize] = FoundBuffer::Directory(places.collect());
                    self.buffers[at] = FoundBuffer::Elements(elements);
                }
                Content::Textures(array) => {
                    let textures = resources.textures.iter().map(|t| (t.group, t.binding));
                    let found = arrays.elements(array, textures)?;
                    let variable = program.images.iter().position(|i| i.variable == wanted.variable);
                    for image in variable.iter().map(|at| &program.images[*at]) {
                        found.iter().try_for_each(|at| check_texture(image, &resources.textures[*at]))?;
                    }
                    self.buffers[at] = numbers(self.images.len(), found.len());
                    let elements = (0..).zip(found);
                    self.images.extend(elements.map(|(element, at)| FoundImage { at, variable, element }));
                }
                Content::Samplers(array) => {
                    let samplers = resources.samplers.iter().map(|s| (s.group, s.binding));
                    let found: Vec<_> = arrays.elements(array, samplers)?;
                    let found = found.into_iter().map(|at| resources.samplers[at].sampler);
                    let before = self.samplers.len();
                    self.samplers.extend(found);
                    let found = &self.samplers[before..];
                    for variable in program.samplers.iter().filter(|s| s.variable == wanted.variable) {
                        found.iter().try_for_each(|sampler| check_sampler(variable, sampler))?;
                    }
                    self.buffers[at] = numbers(before, found.len());
                }
            }
        }
        Ok(())
    }
}

/// A directory of so many numbers from `first` on.
fn numbers(first: usize, count: usize) -> FoundBuffer {
    FoundBuffer::Directory((first..first + count).map(|number| number as u32).collect())
}

/// A variable that stands for several resources.
struct Wanted<'w> {
    name: &'w str,
    place: (u32, u32),
}

impl Wanted<'_> {
    /// Which of the resources at these places are its elements.
    fn elements(&self, array: BindingArray, places: impl Iterator<Item = (u32, u32)>) -> Res<Vec<usize>> {
        let here = places.enumerate().filter(|(_, place)| *place == self.place).map(|(at, _)| at);
        let most = array.count.map_or(usize::MAX, |count| count as usize);
        let found: Vec<usize> = here.take(most).collect();
        let expected = array.count.map_or(1, |count| count as usize);
        if found.len() < expected {
            let ((group, binding), name) = (self.place, self.name.to_owned());
            return Err(InterpError::MissingElements { name, group, binding, expected, found: found.len() });
        }
        Ok(found)
    }
}
