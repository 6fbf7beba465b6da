//! Races: two invocations touch the same word, one of them writes, not both by atomics, and no barrier lies between.

use super::super::super::error::Res;
use super::super::super::finding::Fault;
use super::super::super::model::Model;
use super::super::super::program::{Place, Scalar};
use super::super::Machine;
use super::Watch;
use naga::Span;
use std::collections::HashMap;

/// How a word is touched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Touch {
    writes: bool,
    atomic: bool,
}

impl Touch {
    pub(super) const READ: Self = Self { writes: false, atomic: false };
    pub(super) const WRITE: Self = Self { writes: true, atomic: false };
    pub(super) const ATOMIC: Self = Self { writes: true, atomic: true };

    fn verb(self) -> &'static str {
        match (self.writes, self.atomic) {
            (false, _) => "reads",
            (true, false) => "writes",
            (true, true) => "updates",
        }
    }
}

/// Who touched a word, how, and after how many barriers.
#[derive(Debug, Clone, Copy)]
struct Access {
    group: usize,
    lane: usize,
    passed: u32,
    touch: Touch,
}

impl Access {
    fn is_by_same(&self, other: &Self) -> bool {
        (self.group, self.lane) == (other.group, other.lane)
    }

    /// Whether a barrier lies between this and a later access.
    fn is_before(&self, later: &Self) -> bool {
        self.group == later.group && self.passed < later.passed
    }

    fn races(&self, later: &Self) -> bool {
        let both_atomic = self.touch.atomic && later.touch.atomic;
        !(both_atomic || self.is_by_same(later) || self.is_before(later))
    }
}

/// The last accesses of a word.
#[derive(Debug, Default)]
struct Word {
    write: Option<Access>,
    /// Of two invocations, since then.
    reads: [Option<Access>; 2],
}

impl Word {
    /// The access that this one races with; notes this one.
    fn add(&mut self, now: Access) -> Option<Access> {
        let reads = if now.touch.writes { self.reads } else { [None; 2] };
        let before = std::iter::once(self.write).chain(reads).flatten().find(|a| a.races(&now));
        if now.touch.writes {
            *self = Self { write: Some(now), reads: [None; 2] };
            return before;
        }
        for read in &mut self.reads {
            *read = read.filter(|r| !r.is_before(&now) && !r.is_by_same(&now));
        }
        let free = usize::from(self.reads[0].is_some());
        self.reads[free] = Some(now);
        before
    }
}

/// All words that were touched.
#[derive(Debug, Default)]
pub(super) struct Races {
    words: HashMap<(u32, usize), Word>,
}

impl Races {
    /// Memory of a workgroup is new to each.
    pub(super) fn begin<M: Model>(&mut self, m: &Machine<'_, M>) {
        self.words.retain(|(buffer, _), _| m.program.buffers[*buffer as usize].binding.is_some());
    }
}

impl Watch {
    /// The active lanes touch a place, one scalar each.
    pub(super) fn touch<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        place: Place,
        scalar: Scalar,
        touch: Touch,
        at: Span,
    ) -> Res<()> {
        let Place::Buffer { buffer, offset, index } = place else {
            return Ok(());
        };
        // Two halves of a word are two places.
        if !m.program.buffers[buffer as usize].writable || scalar.bytes() < 4 {
            return Ok(());
        }
        let addresses = m.addresses(offset, index)?;
        for lane in m.flow.active.lanes() {
            let word = addresses[lane] / 4;
            let now = Access { group: m.order.group, lane, passed: m.order.passed, touch };
            if let Some(before) = self.races.words.entry((buffer, word)).or_default().add(now) {
                let message = || race(m, (buffer, word), &before, &now);
                self.report(m, (Fault::Race, at), lane, message);
            }
        }
        Ok(())
    }
}

fn race<M: Model>(m: &Machine<'_, M>, (buffer, word): (u32, usize), before: &Access, now: &Access) -> String {
    let other = if before.group == now.group { "of the same workgroup" } else { "of another workgroup" };
    let mut name = m.program.buffers[buffer as usize].name.clone();
    let mut word = word;
    if let Some(elements) = &m.shared[buffer as usize].elements {
        let (element, byte) = elements.element(4 * word);
        (name, word) = (format!("{name}[{element}]"), byte / 4);
    }
    format!(
        "it {} word {word} of `{name}`, which invocation {} {other} {} without a barrier between",
        now.touch.verb(),
        before.lane,
        before.touch.verb(),
    )
}
