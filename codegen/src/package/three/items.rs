//! A library of WGSL as its items, with what each of them uses.

use crate::emit::scan::{self, Piece, PieceKind};

/// What an item declares.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A structure.
    Structure,
    /// A constant.
    Constant,
    /// A function.
    Function {
        /// Whether it returns a value.
        returns: bool,
    },
}

/// An item of a library.
#[derive(Debug)]
pub(super) struct Item<'a> {
    /// What it declares.
    pub(super) kind: Kind,
    /// Its name in WGSL.
    pub(super) name: &'a str,
    /// The same without the prefix.
    pub(super) exported: &'a str,
    /// Its doc comment, a line an item.
    pub(super) docs: Vec<&'a str>,
    /// Its text, without the doc comment.
    pub(super) code: String,
    /// The items before it that its text names.
    pub(super) uses: Vec<usize>,
}

/// A member of a structure.
#[derive(Debug, PartialEq)]
pub(super) struct Member<'a> {
    /// Its name.
    pub(super) name: &'a str,
    /// Its type in WGSL.
    pub(super) ty: &'a str,
    /// Its doc comment.
    pub(super) docs: Vec<&'a str>,
}

impl Item<'_> {
    /// Whether three.js takes it as a piece of code, and not as a function or a structure.
    pub(super) fn is_code(&self) -> bool {
        matches!(self.kind, Kind::Constant | Kind::Function { returns: false })
    }

    /// The type that a function returns; empty for none.
    pub(super) fn returns(&self) -> &str {
        let head = self.code.split('{').next().unwrap_or_default();
        head.split_once("->").map_or("", |(_, ty)| ty.trim())
    }

    /// The members of a structure.
    pub(super) fn members(&self) -> Vec<Member<'_>> {
        let mut members = Vec::new();
        let mut docs = Vec::new();
        for line in self.code.lines().map(str::trim) {
            if let Some(doc) = doc(line) {
                docs.push(doc);
            } else if let Some((name, ty)) = line.trim_end_matches(',').split_once(": ") {
                members.push(Member { name, ty, docs: std::mem::take(&mut docs) });
            }
        }
        members
    }
}

/// The items of `library`, whose names begin with `prefix`; each comes after what it uses, since a writer puts them so.
pub(super) fn items<'a>(library: &'a str, prefix: &str) -> Vec<Item<'a>> {
    let pieces = scan::pieces(library);
    let mut items: Vec<Item<'a>> = Vec::new();
    for pieces in scan::items(&pieces) {
        if let Some(item) = item(pieces, prefix, &items) {
            items.push(item);
        }
    }
    items
}

fn item<'a>(pieces: &[Piece<'a>], prefix: &str, before: &[Item<'a>]) -> Option<Item<'a>> {
    let start = pieces.iter().position(|p| p.kind == PieceKind::Word)?;
    let words: Vec<&str> =
        pieces[start..].iter().filter(|p| p.kind == PieceKind::Word).map(|p| p.text).collect();
    let (&keyword, &name) = (words.first()?, words.get(1)?);
    let code: String = pieces[start..].iter().map(|p| p.text).collect();
    let kind = match keyword {
        "struct" => Kind::Structure,
        "const" => Kind::Constant,
        "fn" => Kind::Function { returns: code.split('{').next().is_some_and(|head| head.contains("->")) },
        _ => return None,
    };
    let is_used = |item: &Item<'_>| words[2..].contains(&item.name);
    Some(Item {
        kind,
        name,
        exported: name.strip_prefix(prefix).unwrap_or(name),
        docs: pieces[..start].iter().filter_map(|p| doc(p.text)).collect(),
        code,
        uses: before.iter().enumerate().filter(|(_, item)| is_used(item)).map(|(i, _)| i).collect(),
    })
}

/// The structure `ty`, those of its members, and so on, by their exported names; none for other types.
pub(super) fn structures<'a>(ty: &str, items: &[Item<'a>]) -> Vec<&'a str> {
    let Some(item) = items.iter().find(|item| item.name == ty && item.kind == Kind::Structure) else {
        return Vec::new();
    };
    let mut found = vec![item.exported];
    for name in item.members().iter().flat_map(|member| structures(member.ty, items)) {
        if !found.contains(&name) {
            found.push(name);
        }
    }
    found
}

/// What a line of a doc comment says.
fn doc(line: &str) -> Option<&str> {
    let rest = line.strip_prefix("///")?;
    Some(rest.strip_prefix(' ').unwrap_or(rest))
}

/// A doc comment as JavaScript has it; nothing for no lines.
pub(super) fn comment(lines: &[&str], indent: &str) -> String {
    let inside = |line: &&str| line.replace("*/", "* /");
    match lines {
        [] => String::new(),
        [line] => format!("{indent}/** {} */\n", inside(line)),
        lines => {
            let line = |line: &&str| format!("{indent} * {}", inside(line)).trim_end().to_owned() + "\n";
            format!("{indent}/**\n{}{indent} */\n", lines.iter().map(line).collect::<String>())
        }
    }
}

/// A type of WGSL as TSL calls it; what it has no name for keeps its own.
pub(super) fn in_tsl(ty: &str) -> &str {
    match ty {
        "f32" => "float",
        "i32" => "int",
        "u32" => "uint",
        "vec2<f32>" => "vec2",
        "vec3<f32>" => "vec3",
        "vec4<f32>" => "vec4",
        "vec2<i32>" => "ivec2",
        "vec3<i32>" => "ivec3",
        "vec4<i32>" => "ivec4",
        "vec2<u32>" => "uvec2",
        "vec3<u32>" => "uvec3",
        "vec4<u32>" => "uvec4",
        "vec2<bool>" => "bvec2",
        "vec3<bool>" => "bvec3",
        "vec4<bool>" => "bvec4",
        "mat2x2<f32>" => "mat2",
        "mat3x3<f32>" => "mat3",
        "mat4x4<f32>" => "mat4",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIBRARY: &str = "// Written by Lobe.\n\n/// A lobe.\nstruct p_Sg {\n    /// Its axis.\n    axis: vec3<f32>,\n    \
                           sharpness: f32,\n}\n\nconst p_PI: f32 = 3.1415927f;\n\nfn p_note(x: f32) {\n}\n\n/// Half of \
                           it.\n///\n/// More.\nfn p_half(sg: p_Sg) -> f32 {\n    return p_PI * sg.sharpness;\n}\n";

    const PAIR: &str =
        "struct p_Sg {\n    sharpness: f32,\n}\n\nstruct p_Pair {\n    a: p_Sg,\n    b: p_Sg,\n}\n";

    #[test]
    fn items_know_what_they_are_called_and_what_they_use() {
        let items = items(LIBRARY, "p_");
        let names: Vec<&str> = items.iter().map(|item| item.exported).collect();
        assert_eq!(names, ["Sg", "PI", "note", "half"]);
        assert_eq!(items[0].members()[0], Member { name: "axis", ty: "vec3<f32>", docs: vec!["Its axis."] });
        assert_eq!(items[2].kind, Kind::Function { returns: false });
        assert_eq!(items[3].kind, Kind::Function { returns: true });
        assert_eq!(items[3].uses, [0, 1]);
        assert_eq!(items[3].returns(), "f32");
        assert_eq!(structures("p_Pair", &super::items(PAIR, "p_")), ["Pair", "Sg"]);
        assert_eq!(comment(&items[3].docs, ""), "/**\n * Half of it.\n *\n * More.\n */\n");
        assert!(items[3].code.starts_with("fn p_half("), "{}", items[3].code);
    }

    #[test]
    fn no_line_ends_its_comment() {
        assert_eq!(comment(&["a */ b"], "  "), "  /** a * / b */\n");
    }
}
