//! The values of a trace: its records, vector by vector.

use lobe_codegen::trace::{Origin, Record, Site};
use naga::{Expression, Function, Handle};
use std::collections::HashMap;

/// An expression of a function.
pub type Place = (Handle<Function>, Handle<Expression>);

/// One execution of an expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Value {
    /// Which.
    pub place: Place,
    /// How it comes about.
    pub origin: Origin,
    /// Its first record.
    pub first: usize,
    /// Executions of the same before it.
    pub hit: u32,
    /// Its scalars.
    pub bits: Vec<u32>,
}

/// The values of `records`; a last one that the buffer cut off is left out.
#[must_use]
pub fn values(sites: &[Site], records: &[Record]) -> Vec<Value> {
    let mut hits: HashMap<Place, u32> = HashMap::new();
    let (mut values, mut first) = (Vec::new(), 0);
    while let Some(record) = records.get(first) {
        let Some(site) = sites.get(record.site as usize) else { break };
        let end = first + site.width.max(1) as usize;
        let Some(whole) = records.get(first..end) else { break };
        let place = (site.function, site.expression);
        let hit = hits.entry(place).or_default();
        let bits = whole.iter().map(|r| r.bits).collect();
        values.push(Value { place, origin: site.origin, first, hit: *hit, bits });
        *hit += 1;
        first = end;
    }
    values
}
