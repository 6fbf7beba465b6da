//! What naga's SPIR-V front end takes for something else, without a word.

const HEADER: usize = 5;
const OP_MEMBER_NAME: u32 = 6;
const OP_MEMBER_DECORATE: u32 = 72;
const ROW_MAJOR: u32 = 4;

/// What in `bytes` naga would misread; `None` if nothing is, or if it is no module.
pub(super) fn misread(bytes: &[u8]) -> Option<String> {
    let (chunks, _) = bytes.as_chunks();
    let words: Vec<u32> = chunks.iter().map(|chunk| u32::from_le_bytes(*chunk)).collect();
    let decorated = |i: &&[u32]| matches!(i, [op, _, _, ROW_MAJOR, ..] if op & 0xffff == OP_MEMBER_DECORATE);
    let &[_, structure, member, ..] = instructions(&words).find(decorated)? else { return None };
    let named = |i: &&[u32]| matches!(i, [op, s, m, ..] if op & 0xffff == OP_MEMBER_NAME && [*s, *m] == [structure, member]);
    let name = instructions(&words).find(named).map(|i| text(&i[3..])).filter(|name| !name.is_empty());
    let name = name.map_or_else(String::new, |name| format!(" `{name}`"));
    Some(format!(
        "member {member}{name} of structure %{structure} is a matrix in row-major order, whose columns naga does not find; \
         declare it in column-major order"
    ))
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

    fn module(instructions: &[&[u32]]) -> Vec<u8> {
        let mut words = vec![0x0723_0203, 0x0001_0300, 0, 9, 0];
        for instruction in instructions {
            words.push((instruction.len() as u32) << 16 | instruction[0]);
            words.extend(&instruction[1..]);
        }
        words.iter().flat_map(|w| w.to_le_bytes()).collect()
    }

    #[test]
    fn a_matrix_in_row_major_order_is_named() {
        const COL_MAJOR: u32 = 5;
        let name: &[u32] = &[OP_MEMBER_NAME, 7, 2, u32::from_le_bytes(*b"m\0\0\0")];
        let decorated = |how| [OP_MEMBER_DECORATE, 7, 2, how];
        assert_eq!(misread(&module(&[name, &decorated(COL_MAJOR)])), None);
        let found = misread(&module(&[name, &decorated(ROW_MAJOR)])).unwrap();
        assert!(found.starts_with("member 2 `m` of structure %7 is a matrix in row-major"), "{found}");
        assert!(misread(&module(&[&decorated(ROW_MAJOR)])).is_some());
    }

    #[test]
    fn what_is_no_module_has_nothing_to_misread() {
        for bytes in [&[][..], &[1, 2, 3], &[0; 64], &[255; 64]] {
            assert_eq!(misread(bytes), None);
        }
    }
}
