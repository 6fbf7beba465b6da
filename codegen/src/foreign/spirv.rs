//! What naga's SPIR-V front end takes for something else, without a word.

const HEADER: usize = 5;
const OP_MEMBER_NAME: u32 = 6;
const OP_TYPE_INT: u32 = 21;
const OP_TYPE_FLOAT: u32 = 22;
const OP_TYPE_VECTOR: u32 = 23;
const OP_TYPE_MATRIX: u32 = 24;
const OP_TYPE_ARRAY: u32 = 28;
const OP_TYPE_RUNTIME_ARRAY: u32 = 29;
const OP_TYPE_STRUCT: u32 = 30;
const OP_MEMBER_DECORATE: u32 = 72;
/// OpAtomicSMin, OpAtomicSMax.
const SIGNED: [u32; 2] = [236, 238];
/// OpAtomicUMin, OpAtomicUMax.
const UNSIGNED: [u32; 2] = [237, 239];
const ROW_MAJOR: u32 = 4;
const MATRIX_STRIDE: u32 = 7;

/// What in `bytes` naga would misread; `None` if nothing is, or if it is no module.
pub(super) fn misread(bytes: &[u8]) -> Option<String> {
    let (chunks, _) = bytes.as_chunks();
    let words: Vec<u32> = chunks.iter().map(|chunk| u32::from_le_bytes(*chunk)).collect();
    instructions(&words).find_map(|instruction| match *instruction {
        [op, structure, member, ROW_MAJOR] if code(op) == OP_MEMBER_DECORATE => Some(format!(
            "{} is a matrix in row-major order, whose columns naga does not find; declare it in column-major order",
            described(&words, structure, member)
        )),
        [op, structure, member, MATRIX_STRIDE, stride] if code(op) == OP_MEMBER_DECORATE => {
            let natural = natural_stride(&words, structure, member)?;
            (natural != stride).then(|| {
                format!(
                    "{} has matrices whose columns begin every {stride} bytes; naga takes it to be {natural}",
                    described(&words, structure, member)
                )
            })
        }
        [op, ty, ..] if SIGNED.contains(&code(op)) || UNSIGNED.contains(&code(op)) => {
            let &[_, _, _, is_signed] = declared(&words, ty)? else { return None };
            let wanted = u32::from(SIGNED.contains(&code(op)));
            (is_signed != wanted).then(|| {
                "an atomic minimum or maximum takes numbers for signed that are not, or the reverse; naga goes by their type"
                    .to_owned()
            })
        }
        _ => None,
    })
}

/// From column to column of a member's matrices, as naga has it.
fn natural_stride(words: &[u32], structure: u32, member: u32) -> Option<u32> {
    let mut ty = *declared(words, structure)?.get(member as usize + 2)?;
    loop {
        match *declared(words, ty)? {
            [op, _, part, ..]
                if [OP_TYPE_ARRAY, OP_TYPE_RUNTIME_ARRAY, OP_TYPE_MATRIX].contains(&code(op)) =>
            {
                ty = part;
            }
            [op, _, scalar, count] if code(op) == OP_TYPE_VECTOR => {
                let &[_, _, width, ..] = declared(words, scalar)? else { return None };
                return Some(width / 8 * if count == 2 { 2 } else { 4 });
            }
            _ => return None,
        }
    }
}

/// The instruction that declares a type.
fn declared(words: &[u32], ty: u32) -> Option<&[u32]> {
    const TYPES: [u32; 7] = [
        OP_TYPE_INT,
        OP_TYPE_FLOAT,
        OP_TYPE_VECTOR,
        OP_TYPE_MATRIX,
        OP_TYPE_ARRAY,
        OP_TYPE_RUNTIME_ARRAY,
        OP_TYPE_STRUCT,
    ];
    instructions(words).find(|i| matches!(i, [op, id, ..] if TYPES.contains(&code(*op)) && *id == ty))
}

/// A member of a structure, by its number and its name.
fn described(words: &[u32], structure: u32, member: u32) -> String {
    let is_its = |i: &&[u32]| matches!(i, [op, s, m, ..] if code(*op) == OP_MEMBER_NAME && [*s, *m] == [structure, member]);
    let name = instructions(words).find(is_its).map(|i| text(&i[3..])).filter(|name| !name.is_empty());
    let name = name.map_or_else(String::new, |name| format!(" `{name}`"));
    format!("member {member}{name} of structure %{structure}")
}

fn code(op: u32) -> u32 {
    op & 0xffff
}

/// The instructions of a module, each with all its words.
fn instructions(words: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut rest = words.get(HEADER..).unwrap_or_default();
    std::iter::from_fn(move || {
        let count = *rest.first()? as usize >> 16;
        let (one, more) = rest.split_at_checked(count.max(1))?;
        rest = more;
        Some(one)
    })
}

/// A literal string, which a zero byte ends.
fn text(words: &[u32]) -> String {
    let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).take_while(|b| *b != 0).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A module of a structure %4 whose member 0, `m`, is an array of 2x2 matrices, decorated like this.
    fn module(decoration: &[u32]) -> Vec<u8> {
        let instructions = [
            &[OP_MEMBER_NAME, 4, 0, u32::from_le_bytes(*b"m\0\0\0")],
            &[&[OP_MEMBER_DECORATE, 4, 0], decoration].concat()[..],
            &[OP_TYPE_FLOAT, 1, 32],
            &[OP_TYPE_VECTOR, 2, 1, 2],
            &[OP_TYPE_MATRIX, 3, 2, 2],
            &[OP_TYPE_ARRAY, 5, 3, 9],
            &[OP_TYPE_STRUCT, 4, 5],
        ];
        let mut words = vec![0x0723_0203, 0x0001_0300, 0, 9, 0];
        for instruction in instructions {
            words.push((instruction.len() as u32) << 16 | instruction[0]);
            words.extend(&instruction[1..]);
        }
        words.iter().flat_map(|w| w.to_le_bytes()).collect()
    }

    #[test]
    fn matrices_that_naga_misreads_are_named() {
        const COL_MAJOR: u32 = 5;
        for (decoration, expected) in [
            (&[COL_MAJOR][..], None),
            (&[MATRIX_STRIDE, 8], None),
            (&[ROW_MAJOR], Some("member 0 `m` of structure %4 is a matrix in row-major")),
            (&[MATRIX_STRIDE, 16], Some("begin every 16 bytes; naga takes it to be 8")),
        ] {
            let found = misread(&module(decoration));
            let is_right = match expected {
                Some(part) => found.as_ref().is_some_and(|found| found.contains(part)),
                None => found.is_none(),
            };
            assert!(is_right, "{found:?}");
        }
    }

    #[test]
    fn an_atomic_of_the_other_sign_is_refused() {
        let module = |op: u32, is_signed: u32| {
            let words = [
                [0x0723_0203, 0x0001_0300, 0, 9, 0].as_slice(),
                &[4 << 16 | OP_TYPE_INT, 1, 32, is_signed],
                &[7 << 16 | op, 1, 5, 6, 7, 8, 9],
            ];
            words.concat().iter().flat_map(|w: &u32| w.to_le_bytes()).collect::<Vec<u8>>()
        };
        for (op, is_signed) in [(SIGNED[0], 1), (SIGNED[1], 1), (UNSIGNED[0], 0), (UNSIGNED[1], 0)] {
            assert_eq!(misread(&module(op, is_signed)), None);
            assert!(misread(&module(op, 1 - is_signed)).is_some_and(|what| what.contains("signed")));
        }
    }

    #[test]
    fn what_is_no_module_has_nothing_to_misread() {
        for bytes in [&[][..], &[1, 2, 3], &[0; 64], &[255; 64]] {
            assert_eq!(misread(bytes), None);
        }
    }
}
