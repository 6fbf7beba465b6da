//! Reads just enough of a SPIR-V module to keep nonsense away from drivers.
//!
//! A driver may crash on words that are no SPIR-V, or on an entry point that does not exist, for Vulkan leaves both
//! undefined. This is no validator: it follows the instruction lengths and looks at a few instructions.

use std::collections::{BTreeMap, BTreeSet};

const MAGIC: u32 = 0x0723_0203;
const HEADER_WORDS: usize = 5;

const OP_ENTRY_POINT: u32 = 15;
const OP_EXECUTION_MODE: u32 = 16;
const OP_FUNCTION: u32 = 54;
const OP_DECORATE: u32 = 71;
const GL_COMPUTE: u32 = 5;
const LOCAL_SIZE: u32 = 17;
const BINDING: u32 = 33;
const DESCRIPTOR_SET: u32 = 34;

/// Checks that `words` hold the compute entry point `entry`; where its workgroup size is a literal, that it is
/// `workgroup_size`; and where it is the only entry point, that every buffer that its functions name is in `bound` (group and binding).
pub(super) fn check(
    words: &[u32],
    entry: &str,
    workgroup_size: [u32; 3],
    bound: &BTreeSet<(u32, u32)>,
) -> Result<(), String> {
    check_header(words)?;
    let module = Declarations::read(words)?;
    let id = module.entry_point(entry)?;
    match module.local_sizes.get(&id) {
        Some(&declared) if declared != workgroup_size => {
            return Err(format!(
                "entry point `{entry}` has workgroup size {declared:?}, the job says {workgroup_size:?}"
            ));
        }
        _ => {}
    }
    // With several entry points it would take the call graph to know which of them uses a buffer.
    let unbound = module.places().find(|place| !bound.contains(place));
    match unbound {
        Some((group, binding)) if module.entry_points.len() == 1 => {
            Err(format!("it uses group {group}, binding {binding}, which the job does not bind"))
        }
        _ => Ok(()),
    }
}

/// What a module says about its entry points and buffers, by id.
#[derive(Default)]
struct Declarations {
    entry_points: Vec<(u32, String)>,
    local_sizes: BTreeMap<u32, [u32; 3]>,
    groups: BTreeMap<u32, u32>,
    bindings: BTreeMap<u32, u32>,
    /// The words of functions, those that are ids among them.
    named: BTreeSet<u32>,
}

impl Declarations {
    fn read(words: &[u32]) -> Result<Self, String> {
        let mut module = Self::default();
        let mut is_declared = false;
        for instruction in Instructions::of(words) {
            let (opcode, operands) = instruction?;
            is_declared |= opcode == OP_FUNCTION;
            if is_declared {
                module.named.extend(operands);
                continue;
            }
            match (opcode, operands) {
                (OP_ENTRY_POINT, [GL_COMPUTE, id, name @ ..]) => {
                    module.entry_points.push((*id, literal_string(name)));
                }
                (OP_EXECUTION_MODE, &[id, LOCAL_SIZE, x, y, z]) => {
                    module.local_sizes.insert(id, [x, y, z]);
                }
                (OP_DECORATE, &[id, DESCRIPTOR_SET, group]) => {
                    module.groups.insert(id, group);
                }
                (OP_DECORATE, &[id, BINDING, binding]) => {
                    module.bindings.insert(id, binding);
                }
                _ => {}
            }
        }
        Ok(module)
    }

    fn entry_point(&self, wanted: &str) -> Result<u32, String> {
        if let Some((id, _)) = self.entry_points.iter().find(|(_, name)| name == wanted) {
            return Ok(*id);
        }
        let names: Vec<_> = self.entry_points.iter().map(|(_, name)| format!("`{name}`")).collect();
        Err(match names.as_slice() {
            [] => format!("it has no compute entry point, `{wanted}` is asked for"),
            names => format!("it has no compute entry point `{wanted}`, only {}", names.join(", ")),
        })
    }

    /// Group and binding of every buffer that a function names.
    fn places(&self) -> impl Iterator<Item = (u32, u32)> {
        let used = self.groups.iter().filter(|(id, _)| self.named.contains(id));
        used.filter_map(|(id, &group)| Some((group, *self.bindings.get(id)?)))
    }
}

fn check_header(words: &[u32]) -> Result<(), String> {
    match words.first() {
        None => Err("there are no words".to_owned()),
        Some(&first) if first == MAGIC.swap_bytes() => Err("its bytes are in the other order".to_owned()),
        Some(&first) if first != MAGIC => Err(format!("it starts with {first:#010x}, not {MAGIC:#010x}")),
        Some(_) if words.len() < HEADER_WORDS => {
            Err(format!("it ends after {} of the header's {HEADER_WORDS} words", words.len()))
        }
        Some(_) => Ok(()),
    }
}

/// Opcodes with their operands; the last item is an error if the lengths do not add up.
struct Instructions<'a> {
    words: &'a [u32],
    at: usize,
}

impl<'a> Instructions<'a> {
    fn of(words: &'a [u32]) -> Self {
        Self { words, at: HEADER_WORDS }
    }
}

impl<'a> Iterator for Instructions<'a> {
    type Item = Result<(u32, &'a [u32]), String>;

    fn next(&mut self) -> Option<Self::Item> {
        let at = self.at;
        let &first = self.words.get(at)?;
        let (length, opcode) = ((first >> 16) as usize, first & 0xffff);
        if length == 0 || at + length > self.words.len() {
            self.at = self.words.len();
            let left = self.words.len() - at;
            return Some(Err(format!("the instruction at word {at} claims {length} words, {left} are left")));
        }
        self.at = at + length;
        Some(Ok((opcode, &self.words[at + 1..at + length])))
    }
}

fn literal_string(words: &[u32]) -> String {
    let bytes: Vec<u8> =
        words.iter().flat_map(|word| word.to_le_bytes()).take_while(|&byte| byte != 0).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Header, entry point `main` (id 7), LocalSize 64 1 1, a buffer (id 3) at group 1, binding 2, which `main` names.
    #[rustfmt::skip]
    const MODULE: [u32; 33] = [
        MAGIC, 0x0001_0300, 0, 8, 0,
        (5 << 16) | OP_ENTRY_POINT, GL_COMPUTE, 7, u32::from_le_bytes(*b"main"), 0,
        (6 << 16) | OP_EXECUTION_MODE, 7, LOCAL_SIZE, 64, 1, 1,
        (4 << 16) | OP_DECORATE, 3, DESCRIPTOR_SET, 1,
        (4 << 16) | OP_DECORATE, 3, BINDING, 2,
        (5 << 16) | OP_FUNCTION, 1, 7, 0, 2,
        (4 << 16) | OP_LOAD, 4, 5, 3,
    ];

    const OP_LOAD: u32 = 61;

    const SIZE: [u32; 3] = [64, 1, 1];

    #[track_caller]
    fn refused(words: &[u32], entry: &str, size: [u32; 3], part: &str) {
        let message = check(words, entry, size, &BTreeSet::from([(1, 2)])).expect_err("should be refused");
        assert!(message.contains(part), "{message}");
    }

    #[test]
    fn sound_words_pass() {
        assert_eq!(check(&MODULE, "main", SIZE, &BTreeSet::from([(0, 0), (1, 2)])), Ok(()));
    }

    #[test]
    fn nonsense_is_named() {
        refused(&[], "main", SIZE, "no words");
        refused(&[1, 2, 3], "main", SIZE, "starts with 0x00000001");
        refused(&[MAGIC.swap_bytes()], "main", SIZE, "other order");
        refused(&MODULE[..3], "main", SIZE, "after 3 of");
        refused(&MODULE[..12], "main", SIZE, "at word 10 claims 6 words, 2 are left");
        let mut zero_length = MODULE;
        zero_length[5] = OP_ENTRY_POINT;
        refused(&zero_length, "main", SIZE, "claims 0 words");
    }

    #[test]
    fn entry_point_and_size_must_fit() {
        refused(&MODULE, "other", SIZE, "only `main`");
        refused(&MODULE, "main", [32, 1, 1], "[64, 1, 1], the job says [32, 1, 1]");
        refused(&MODULE[..5], "main", SIZE, "no compute entry point");
    }

    #[test]
    fn every_buffer_must_be_bound() {
        let message = check(&MODULE, "main", SIZE, &BTreeSet::from([(2, 1)])).expect_err("should be refused");
        assert!(message.contains("uses group 1, binding 2"), "{message}");
        let unnamed = &MODULE[..MODULE.len() - 4];
        assert_eq!(check(unnamed, "main", SIZE, &BTreeSet::from([(2, 1)])), Ok(()));
    }
}
