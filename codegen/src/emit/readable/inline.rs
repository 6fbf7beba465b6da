//! Temporaries that are used once are written where they are used.
//!
//! naga's writers give every call and every load a variable of its own, `_e7`; in Rust most of them stood in the
//! expression that uses them.
//! One is moved only past declarations, and only if it is a load of a local variable or a call of a function that
//! reads and writes nothing but its values: so nothing that it depends on can change on the way.

use super::lines::{Line, lines};
use crate::emit::mark::Role;
use crate::emit::scan::{Piece, PieceKind};
use crate::emit::tidy::collect_calls;
use crate::emit::words::Words;
use naga::FastHashSet as HashSet;
use naga::{Expression, Function, Handle, Module, TypeInner};
use std::collections::BTreeMap;
use std::ops::Range;

/// The pieces of `function` with its temporaries in their places; `pure` are the [functions of values](of_values).
pub(super) fn inline<'a>(
    pieces: &[Piece<'a>],
    function: &Function,
    words: &Words<'a>,
    pure: &[bool],
) -> Vec<Piece<'a>> {
    let movable = movable(function, pure);
    let lines = lines(pieces);
    let uses = uses(pieces, &lines, &movable);
    let mut text = Text { pieces, words, pure, movable, lines, uses, moved: BTreeMap::new() };
    for i in 0..text.lines.len() {
        if let Some(to) = text.target(i) {
            text.put(i, to);
        }
    }
    text.written()
}

/// Where a temporary is used.
#[derive(Debug, Clone, Copy, Default)]
struct Use {
    count: usize,
    /// The last time.
    last: Place,
}

/// A line, and a piece in it.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    line: usize,
    piece: usize,
}

/// Where each temporary is used that can be moved.
fn uses(pieces: &[Piece<'_>], lines: &[Line], movable: &[bool]) -> Vec<Use> {
    let mut uses = vec![Use::default(); movable.len()];
    for (i, line) in lines.iter().enumerate() {
        let declared = line.declares.and_then(|it| it.name);
        let words = line.pieces.clone().filter(|&at| pieces[at].kind == PieceKind::Word);
        for (piece, temporary) in words.filter_map(|at| Some((at, temporary(&pieces[at])?))) {
            if let Some(found) = uses.get_mut(temporary).filter(|_| declared != Some(piece)) {
                *found = Use { count: found.count + 1, last: Place { line: i, piece } };
            }
        }
    }
    uses
}

/// The number of a temporary: writers call that of the expression with this number `_e7`.
fn temporary(piece: &Piece<'_>) -> Option<usize> {
    let (PieceKind::Word, [b'_', b'e', digits @ ..]) = (piece.kind, piece.text.as_bytes()) else {
        return None;
    };
    let is_number = matches!(digits, [b'0'] | [b'1'..=b'9', ..]) && digits.len() < 10;
    let digit =
        |number: usize, &byte: &u8| byte.is_ascii_digit().then(|| number * 10 + usize::from(byte - b'0'));
    if is_number { digits.iter().try_fold(0, digit) } else { None }
}

/// The text of a function while values move.
struct Text<'p, 'a> {
    pieces: &'p [Piece<'a>],
    words: &'p Words<'a>,
    pure: &'p [bool],
    movable: Vec<bool>,
    lines: Vec<Line>,
    uses: Vec<Use>,
    /// The line whose value stands in the place of a piece now.
    moved: BTreeMap<usize, usize>,
}

impl<'a> Text<'_, 'a> {
    /// The later place that the value of line `i` can be moved to.
    fn target(&self, i: usize) -> Option<Place> {
        let name = self.lines[i].declares?.name?;
        let movable = temporary(&self.pieces[name]).filter(|&it| self.movable.get(it) == Some(&true));
        let to = match movable {
            Some(temporary) => Some(self.uses[temporary]).filter(|found| found.count == 1)?.last,
            None => self.returned(i, name)?,
        };
        let between = self.lines.get(i + 1..to.line)?;
        let is_behind_blank = self.lines[i + 1..=to.line].iter().any(|line| line.is_behind_blank);
        let is_free = !is_behind_blank && between.iter().all(|line| line.is_gone || self.is_pure(line));
        (to.line > i && is_free).then_some(to)
    }

    /// Where the variable is returned that naga's HLSL has for a structure: called after the structure, with a number
    /// behind it.
    fn returned(&self, i: usize, name: usize) -> Option<Place> {
        let word = self.words.of(&self.pieces[name])?;
        let is_result = matches!(word.role(), Some(Role::Struct(_))) && !word.is_whole_mark();
        let next = self.lines.get(i + 1).filter(|_| is_result)?.pieces.clone();
        match &self.pieces[next.clone()] {
            [keyword, _, it, end] if (keyword.text, it.text, end.text) == ("return", word.text, ";") => {
                Some(Place { line: i + 1, piece: next.start + 2 })
            }
            _ => None,
        }
    }

    /// Moves the value of line `i`.
    fn put(&mut self, i: usize, to: Place) {
        self.moved.insert(to.piece, i);
        self.lines[i].is_gone = true;
    }

    /// Whether a line declares a value, and no call in it changes anything.
    fn is_pure(&self, line: &Line) -> bool {
        line.value().is_some_and(|value| {
            let mut moved = self.moved.range(value.clone());
            moved.all(|(_, &line)| self.is_pure(&self.lines[line]))
                && self.pieces[value].iter().all(|piece| self.is_harmless(piece))
        })
    }

    /// Whether what a piece names changes nothing.
    fn is_harmless(&self, piece: &Piece<'_>) -> bool {
        match self.words.of(piece).and_then(|word| word.role()) {
            Some(Role::Function(callee)) => self.pure[callee.index()],
            _ => !matches!(piece.text, "{" | "}"),
        }
    }

    fn written(&self) -> Vec<Piece<'a>> {
        let mut out = Vec::with_capacity(self.pieces.len());
        for line in &self.lines {
            if let Some(blanks) = line.pieces.start.checked_sub(1).map(|before| self.pieces[before]) {
                out.extend(if line.is_gone { line_before(blanks) } else { Some(blanks) });
            }
            if !line.is_gone {
                self.write(line.pieces.clone(), &mut out);
            }
        }
        out
    }

    /// Writes pieces, and in their place what has moved there.
    fn write(&self, pieces: Range<usize>, out: &mut Vec<Piece<'a>>) {
        let mut from = pieces.start;
        for (&piece, &line) in self.moved.range(pieces.clone()) {
            out.extend_from_slice(&self.pieces[from..piece]);
            self.write(self.lines[line].value().unwrap_or_default(), out);
            from = piece + 1;
        }
        out.extend_from_slice(&self.pieces[from..pieces.end]);
    }
}

/// What is left of the blanks before a line that is taken out: lines without anything in them.
fn line_before(blanks: Piece<'_>) -> Option<Piece<'_>> {
    let end = blanks.text.rfind('\n').filter(|&end| end > 0)?;
    Some(Piece { text: &blanks.text[..end], ..blanks })
}

/// Which temporaries nothing else can change.
fn movable(function: &Function, pure: &[bool]) -> Vec<bool> {
    let is_free = |expression: &Expression| match expression {
        Expression::CallResult(callee) => pure[callee.index()],
        Expression::Load { pointer } => is_local(function, *pointer),
        _ => false,
    };
    let expressions = function.expressions.iter();
    expressions.map(|(handle, it)| is_free(it) && !function.named_expressions.contains_key(&handle)).collect()
}

/// Whether a pointer leads to a variable of the function.
fn is_local(function: &Function, pointer: Handle<Expression>) -> bool {
    match function.expressions[pointer] {
        Expression::LocalVariable(_) => true,
        Expression::AccessIndex { base, .. } | Expression::Access { base, .. } => is_local(function, base),
        _ => false,
    }
}

/// Which functions read and write nothing but their arguments, which are values, and their result.
pub(super) fn of_values(module: &Module) -> Vec<bool> {
    let mut pure = Vec::with_capacity(module.functions.len());
    for (_, function) in module.functions.iter() {
        pure.push(is_of_values(module, function, &pure));
    }
    pure
}

/// The same of one function; `pure` are those before it, and it calls no others.
fn is_of_values(module: &Module, function: &Function, pure: &[bool]) -> bool {
    let is_value = |ty: Handle<naga::Type>| {
        !matches!(module.types[ty].inner, TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
    };
    let is_global = |expression: &Expression| matches!(expression, Expression::GlobalVariable(_));
    let mut called = HashSet::default();
    collect_calls(&function.body, &mut called);
    function.result.is_some()
        && function.arguments.iter().all(|argument| is_value(argument.ty))
        && !function.expressions.iter().any(|(_, expression)| is_global(expression))
        && called.iter().all(|callee| pure.get(callee.index()) == Some(&true))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::{mark, scan};
    use crate::validate::foreign_wgsl;

    const SHADER: &str = "
        var<private> counter: f32;
        fn value(x: f32) -> f32 { return x * 2.0; }
        fn change(x: ptr<function, f32>) -> f32 { *x = 1.0; return 2.0; }
        fn count() -> f32 { counter += 1.0; return counter; }
        fn outer(x: f32) -> f32 { var y = x; let a = value(y) + value(2.0); let b = change(&y); return a + b + count(); }";

    /// The text with temporaries in their places; `_e7` and the like are those of `outer`.
    fn inlined(lines: &str) -> String {
        let module = foreign_wgsl(SHADER).unwrap();
        let marked = mark::mark(module.module().clone());
        let (_, outer) = module.module().functions.iter().nth(3).unwrap();
        // The first line is the function's head.
        let mut text = format!("{{\n{lines}");
        for (i, name) in ["value", "change", "count"].into_iter().enumerate() {
            let mark = marked.module.functions.iter().nth(i).unwrap().1.name.clone().unwrap();
            text = text.replace(name, &mark);
        }
        let mut calls = outer.expressions.iter().filter(|(_, e)| matches!(e, Expression::CallResult(_)));
        let load = outer.expressions.iter().find(|(_, e)| matches!(e, Expression::Load { .. })).unwrap().0;
        text = text.replace("LOAD", &format!("_e{}", load.index()));
        for name in ["FIRST", "SECOND"] {
            text = text.replace(name, &format!("_e{}", calls.next().unwrap().0.index()));
        }
        let mut pieces = scan::pieces(&text);
        let words = Words::number(&mut pieces, &marked.marks);
        let done = inline(&pieces, outer, &words, &of_values(module.module()));
        let mut done: String = done.iter().map(|piece| piece.text).collect();
        for (i, name) in ["value", "change", "count"].into_iter().enumerate() {
            let mark = marked.module.functions.iter().nth(i).unwrap().1.name.clone().unwrap();
            done = done.replace(&mark, name);
        }
        done.strip_prefix("{\n").unwrap().to_owned()
    }

    #[test]
    fn what_is_used_once_is_written_there() {
        let calls = "let FIRST = value(1.0);\nlet SECOND = value(FIRST);\nlet a = SECOND * b;";
        assert_eq!(inlined(calls), "let a = value(value(1.0)) * b;");
        assert_eq!(inlined("let LOAD = y;\nif (LOAD > 1.0) {\n}"), "if (y > 1.0) {\n}");
        assert_eq!(inlined("let LOAD = y;\nlet FIRST = value(LOAD);\ny = FIRST;"), "y = value(y);");
    }

    #[test]
    fn nothing_is_moved_past_what_may_change_it() {
        for kept in [
            "let LOAD = y;\ny = 1.0;\nlet a = (LOAD + 1.0);",
            "let LOAD = y;\nlet b = change(&y);\nlet a = (LOAD + 1.0);",
            "let LOAD = y;\nlet b = count();\nlet a = (LOAD + b);",
            "let LOAD = y;\nif (c) {\nlet a = (LOAD + b);\n}",
            "let LOAD = y;\nlet a = (LOAD + LOAD);",
            "let FIRST = value(x);\nlet a = FIRST;\nlet b = FIRST;",
            "let _e99 = value(x);\nlet a = _e99;",
        ] {
            let names = inlined(kept);
            assert_eq!(names.lines().count(), kept.lines().count(), "{names}");
        }
    }
}
