//! The names in SPIR-V, as a compiler wrote them for debuggers.

use std::collections::BTreeMap;

const HEADER: usize = 5;
const OP_NAME: u32 = 5;
const OP_MEMBER_NAME: u32 = 6;
const OP_ENTRY_POINT: u32 = 15;
const OP_TYPE_STRUCT: u32 = 30;
const OP_TYPE_POINTER: u32 = 32;
const OP_FUNCTION: u32 = 54;
const OP_VARIABLE: u32 = 59;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
const DECORATION_ARRAY_STRIDE: u32 = 6;
const DECORATION_BINDING: u32 = 33;
const DECORATION_SET: u32 = 34;
const DECORATION_OFFSET: u32 = 35;

/// What a module of SPIR-V declares.
#[derive(Debug, Default)]
pub(crate) struct Symbols {
    /// Functions; glslang's carry their parameters' types behind a parenthesis.
    pub(crate) functions: Vec<String>,
    /// The members of each structure, in order; a structure may be there twice, once as it lies in buffers.
    pub(crate) structures: Vec<(String, Vec<String>)>,
    /// Offsets of the members of structures that lie in buffers, beside their names.
    pub(crate) offsets: Vec<(String, Vec<(String, u32)>)>,
    /// Entry points.
    pub(crate) entries: Vec<String>,
    /// Name, group and binding of each resource; without a name where GLSL has one for its block alone.
    pub(crate) bindings: Vec<(String, (u32, u32))>,
    /// Group and binding of each resource that is an array, and the bytes from one element to the next.
    pub(crate) strides: Vec<((u32, u32), u32)>,
}

/// Reads them out of `words`.
pub(crate) fn symbols(words: &[u32]) -> Symbols {
    let mut names = BTreeMap::new();
    let mut members: BTreeMap<u32, BTreeMap<u32, String>> = BTreeMap::new();
    let mut offsets: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    let mut places: BTreeMap<u32, (Option<u32>, Option<u32>)> = BTreeMap::new();
    let mut functions = Vec::new();
    let mut strides = BTreeMap::new();
    // The type that is behind a type: of a variable's pointer, of a block's first member.
    let mut inner = BTreeMap::new();
    let mut out = Symbols::default();
    for (op, rest) in instructions(words) {
        match (op, rest) {
            (OP_NAME, [id, name @ ..]) => drop(names.insert(*id, text(name))),
            (OP_MEMBER_NAME, [id, index, name @ ..]) => {
                members.entry(*id).or_default().insert(*index, text(name));
            }
            (OP_ENTRY_POINT, [_, _, name @ ..]) => out.entries.push(text(name)),
            (OP_FUNCTION, [_, id, ..]) => functions.push(*id),
            (OP_TYPE_POINTER, [id, _, to]) => drop(inner.insert(*id, *to)),
            (OP_TYPE_STRUCT, [id, first, ..]) => drop(inner.insert(*id, *first)),
            (OP_VARIABLE, [ty, id, ..]) => drop(inner.insert(*id, *ty)),
            (OP_DECORATE, [id, DECORATION_ARRAY_STRIDE, stride]) => drop(strides.insert(*id, *stride)),
            (OP_DECORATE, [id, DECORATION_SET, set]) => places.entry(*id).or_default().0 = Some(*set),
            (OP_DECORATE, [id, DECORATION_BINDING, at]) => places.entry(*id).or_default().1 = Some(*at),
            (OP_MEMBER_DECORATE, [id, index, DECORATION_OFFSET, offset]) => {
                offsets.entry(*id).or_default().insert(*index, *offset);
            }
            _ => {}
        }
    }
    out.functions = functions.iter().filter_map(|id| names.get(id).cloned()).collect();
    for (id, members) in &members {
        let name = names.get(id).cloned().unwrap_or_default();
        if let Some(offsets) = offsets.get(id) {
            let at = members.iter().filter_map(|(i, member)| Some((member.clone(), *offsets.get(i)?)));
            out.offsets.push((name.clone(), at.collect()));
        }
        out.structures.push((name, members.values().cloned().collect()));
    }
    let bound = places.iter().filter_map(|(id, place)| Some((names.get(id)?.clone(), (place.0?, place.1?))));
    out.bindings = bound.collect();
    for (variable, place) in &places {
        // Variable, pointer, block, array.
        let array = (0..3).try_fold(*variable, |at, _| inner.get(&at).copied());
        if let (Some(stride), (Some(set), Some(at))) = (array.and_then(|a| strides.get(&a)), place) {
            out.strides.push(((*set, *at), *stride));
        }
    }
    out
}

/// Opcode and operands of each instruction.
fn instructions(words: &[u32]) -> impl Iterator<Item = (u32, &[u32])> {
    let mut rest = words.get(HEADER..).unwrap_or_default();
    std::iter::from_fn(move || {
        let first = *rest.first()?;
        let (instruction, after) = rest.split_at_checked((first >> 16).max(1) as usize)?;
        rest = after;
        Some((first & 0xffff, &instruction[1..]))
    })
}

/// The text that words hold, to its end.
fn text(words: &[u32]) -> String {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).take_while(|b| *b != 0).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}
