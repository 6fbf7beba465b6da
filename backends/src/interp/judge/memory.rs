//! Memory: of each lane, and shared.
//!
//! Shared memory is 32-bit words, each as it was written last: a float keeps what the model knows of it.
//! Indices out of bounds were clamped before ([`Machine::index`]); an empty runtime-sized array leads nowhere:
//! it reads as zero.
//! What a divided lane stores may not happen, so the word is then what it was *or* what is stored.
//! Invocations reach a word in any order: what an atomic returns is not known, nor is a word that drivers may
//! find before or after another invocation's atomic. Programs are taken to be free of races.

use super::super::model::Model;
use super::super::program::{Count, Place, Scalar, Value};
use super::column::{Column, Family, family};
use super::shared::{Cell, Other, gathered, joined, stored};
use super::{MISMATCH, Machine, Res};

impl<M: Model> Machine<'_, M> {
    /// `args[1] + min(args[0], count - 1) * stride`
    pub(super) fn index(&self, count: Count, stride: u32, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let last = self.count(count, stride).saturating_sub(1);
        let index = self.words(*args.first().ok_or(MISMATCH)?)?;
        let base = args.get(1).map(|base| self.words(*base)).transpose()?;
        self.each_word(to, |m, lane| {
            let units = m.map_w(index.at(lane), |i| i.min(last) * u64::from(stride));
            match &base {
                Some(base) => m.zip_w(units, base.at(lane), |a, b| a + b),
                None => units,
            }
        })
    }

    /// `args[1] + min(args[0], args[2] - 1) * stride`
    pub(super) fn index_within(&self, stride: u32, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let &[index, base, count] = args else { return Err(MISMATCH) };
        let (index, base, count) = (self.words(index)?, self.words(base)?, self.words(count)?);
        self.each_word(to, |m, lane| {
            let inside = m.zip_w(index.at(lane), count.at(lane), |i, n| i.min(n.saturating_sub(1)));
            m.zip_w(inside, base.at(lane), |i, base| base + i * u64::from(stride))
        })
    }

    pub(super) fn count(&self, count: Count, stride: u32) -> u64 {
        match count {
            Count::Fixed(count) => count.into(),
            Count::Runtime { buffer, begin } => self.elements(buffer, begin, stride),
        }
    }

    /// Elements of a runtime-sized array.
    pub(super) fn elements(&self, buffer: u32, begin: u32, stride: u32) -> u64 {
        let bytes = 4 * self.shared[buffer as usize].cells.len() as u64;
        bytes.saturating_sub(begin.into()) / u64::from(stride.max(1))
    }

    /// The unit that a place is in each lane, on the f32 path.
    pub(super) fn addresses(&self, offset: u32, index: Option<Value>) -> Res<Vec<usize>> {
        let Some(index) = index else {
            return Ok(vec![offset as usize; self.lanes]);
        };
        let index = self.words(index)?;
        let mut out = vec![0; self.lanes];
        for lane in self.flow.active.lanes() {
            out[lane] = offset as usize + self.model.word_value(index.at(lane)) as usize;
        }
        Ok(out)
    }

    pub(super) fn load(&self, place: Place, scalar: Scalar, to: &mut Column<M>) -> Res<()> {
        match place {
            Place::Lane { array, offset, index } => {
                let at = self.addresses(offset, index)?;
                self.load_lanes(&self.arrays[array as usize], &at, to)?;
                self.forget_unknown(index, to)
            }
            Place::Buffer { buffer, offset, index } => {
                let at = self.addresses(offset, index)?;
                self.load_shared(buffer, &at, scalar, to)?;
                self.forget_unknown(index, to)
            }
            Place::Element { .. } => Err(self.refuse(format!("{place:?}"))),
        }
    }

    /// Nothing is known of what lies at a place that is not known.
    fn forget_unknown(&self, index: Option<Value>, to: &mut Column<M>) -> Res<()> {
        if let Some(index) = index
            && M::SHADOW
        {
            self.unknown(index)?.lanes().for_each(|lane| to.forget(&self.model, lane));
        }
        Ok(())
    }

    fn load_lanes(&self, cells: &[Column<M>], at: &[usize], to: &mut Column<M>) -> Res<()> {
        let cell = |lane: usize| &cells[at[lane].min(cells.len() - 1)];
        let m = &self.model;
        match to {
            Column::Float(_) => self.each_float(to, |_, lane| match cell(lane) {
                Column::Float(lanes) => lanes[lane],
                Column::Word(_) | Column::Bool(_) => m.float(0.0, 0.0),
            }),
            Column::Word(_) => self.each_word(to, |_, lane| match cell(lane) {
                Column::Word(lanes) if !lanes.is_empty() => lanes[lane],
                Column::Word(_) | Column::Float(_) | Column::Bool(_) => m.word(0),
            }),
            Column::Bool(_) => self.each_bool(to, |_, lane| match cell(lane) {
                Column::Bool(lanes) => lanes[lane],
                Column::Float(_) | Column::Word(_) => m.boolean(false),
            }),
        }
    }

    fn load_shared(&self, buffer: u32, at: &[usize], scalar: Scalar, to: &mut Column<M>) -> Res<()> {
        let shared = &self.shared[buffer as usize];
        let cell = |m: &M, at: usize| {
            let cell = shared.get(m, at);
            if self.order.disputes(buffer, at) { cell.forgotten(m) } else { cell }
        };
        match family::<M>(scalar) {
            Family::Float if scalar == Scalar::F32 => {
                self.each_float(to, |m, lane| cell(m, at[lane] / 4).float(m))
            }
            Family::Float => by_width!(self.model, scalar, n => self.each_float(to, |m, lane| {
                let at = at[lane];
                match shared.other(m, scalar, at) {
                    Some(a) if self.order.disputes(buffer, at / 4) => m.unpromised(a),
                    Some(a) => a,
                    None => n.float_of_bits(gathered(m, scalar, at, cell)),
                }
            })),
            Family::Bool => self.each_bool(to, |m, lane| {
                m.compare_w(cell(m, at[lane] / 4).word(m), m.word(0), |a, b| a != b)
            }),
            Family::Word if scalar.is_word() => self.each_word(to, |m, lane| cell(m, at[lane] / 4).word(m)),
            Family::Word => self.each_word(to, |m, lane| gathered(m, scalar, at[lane], cell)),
        }
    }

    pub(super) fn store(&mut self, place: Place, value: Value) -> Res<()> {
        match place {
            Place::Lane { array, offset, index } => self.store_lanes(array, offset, index, value),
            Place::Buffer { buffer, offset, index } => {
                self.spoil_if_unknown(buffer, index)?;
                let at = self.addresses(offset, index)?;
                self.store_shared(buffer, &at, value)
            }
            Place::Element { .. } => Err(self.refuse(format!("{place:?}"))),
        }
    }

    /// A buffer may be written anywhere.
    pub(super) fn spoil_if_unknown(&mut self, buffer: u32, index: Option<Value>) -> Res<()> {
        if let Some(index) = index
            && M::SHADOW
            && self.unknown(index)?.any()
        {
            self.shared[buffer as usize].spoiled = true;
        }
        Ok(())
    }

    fn store_lanes(&mut self, array: u32, offset: u32, index: Option<Value>, value: Value) -> Res<()> {
        let at = self.addresses(offset, index)?;
        let scalar = self.program.scalar(value);
        let mut written = Column::zero(&self.model, scalar, self.lanes);
        self.copy(value, &mut written)?;
        let mut cells = std::mem::take(&mut self.arrays[array as usize]);
        let last = cells.len() - 1;
        let active: Vec<usize> = self.flow.active.lanes().collect();
        for lane in active {
            let cell = &mut cells[at[lane].min(last)];
            if !cell.holds(scalar) || cell.len() == 0 {
                *cell = Column::zero(&self.model, scalar, self.lanes);
            }
            cell.set(&written, lane)?;
        }
        if let Some(index) = index
            && M::SHADOW
        {
            for lane in self.unknown(index)?.lanes() {
                cells.iter_mut().filter(|c| c.len() > 0).for_each(|c| c.forget(&self.model, lane));
            }
        }
        self.arrays[array as usize] = cells;
        Ok(())
    }

    fn store_shared(&mut self, buffer: u32, at: &[usize], value: Value) -> Res<()> {
        let scalar = self.program.scalar(value);
        let lanes: Vec<usize> = self.flow.active.lanes().collect();
        for lane in lanes {
            let (at, m) = (at[lane], &self.model);
            let other = match family::<M>(scalar) {
                Family::Float if scalar != Scalar::F32 => Some(self.other_after(buffer, at, value, lane)?),
                Family::Float | Family::Word | Family::Bool => None,
            };
            let (first, second) = match family::<M>(scalar) {
                Family::Float if scalar == Scalar::F32 => (Cell::Float(self.floats(value)?.at(lane)), None),
                Family::Bool => (Cell::Word(super::cast::number(m, self.bools(value)?.at(lane))), None),
                Family::Float | Family::Word if scalar.bytes() == 2 => {
                    let (half, old) = (self.word(value, lane)?, &self.shared[buffer as usize]);
                    let shift = 8 * (at & 2);
                    let both = m.zip_w(old.get(m, at / 4).word(m), half, |old, half| {
                        old & !(0xffff << shift) | stored(scalar, half) << shift
                    });
                    (Cell::Word(both), None)
                }
                Family::Float | Family::Word => {
                    let word = self.word(value, lane)?;
                    let low = Cell::Word(m.map_w(word, |w| w & u64::from(u32::MAX)));
                    (low, scalar.wide().then(|| Cell::Word(m.map_w(word, |w| w >> 32))))
                }
            };
            self.shared[buffer as usize].overwrite(at, scalar.bytes());
            self.put(buffer, at / 4, lane, first);
            if let Some(second) = second {
                self.put(buffer, at / 4 + 1, lane, second);
            }
            if let Some(other) = other {
                self.shared[buffer as usize].others.insert(at, other);
            }
        }
        Ok(())
    }

    /// What a float of 16 or 64 bits will be, once a lane has stored it.
    fn other_after(&self, buffer: u32, at: usize, value: Value, lane: usize) -> Res<Other<M>> {
        let (m, scalar) = (&self.model, self.program.scalar(value));
        let new = self.floats(value)?.at(lane);
        if !self.flow.unsure(lane) {
            return Ok(Other { scalar, float: new });
        }
        let shared = &self.shared[buffer as usize];
        let old = shared.other(m, scalar, at).unwrap_or_else(|| {
            let word = gathered(m, scalar, at, |m, at| shared.get(m, at));
            by_width!(self.model, scalar, m => m.float_of_bits(word))
        });
        Ok(Other { scalar, float: m.join_f(new, old, self.flow.pick(lane)) })
    }

    /// Writes a word of shared memory.
    pub(super) fn put(&mut self, buffer: u32, at: usize, lane: usize, cell: Cell<M>) {
        let m = &self.model;
        let Some(place) = self.shared[buffer as usize].cells.get_mut(at) else {
            return;
        };
        let mut cell = cell;
        if self.flow.unsure(lane) {
            cell = joined(m, *place, cell, self.flow.pick(lane));
        }
        *place = cell;
        self.order.written(buffer, at);
    }
}
