//! The groups that the author made of a function's statements: blank lines and comments of the Rust source, which no
//! writer has, put back before the lines that came of the statements behind them.
//!
//! A line is known by what it declares, assigns or returns, and by how many alike come before it.
//! Where the text has more or fewer of these lines than the source has statements, they stay as they are.

use super::docs::without_links;
use super::tidy::one_line;
use crate::def::{Block, Expr, ExprKind, FunctionDef, Stmt, StmtKind};
use naga::FastHashMap as HashMap;

/// What a line is known by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind<'a> {
    /// It declares a variable of this name.
    Declares(&'a str),
    /// It assigns to a variable of this name, or to a part of it.
    Assigns(&'a str),
    /// It returns a value.
    Returns,
    /// It begins an `if`.
    If,
}

/// What stands before a statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Lead {
    /// Whether a blank line does.
    pub(super) is_blank: bool,
    /// The lines of a comment, without its marks.
    pub(super) comment: Vec<String>,
}

/// The statements of a kind, and the lines that are known by it, each by its number.
#[derive(Default)]
struct Alike {
    statements: Vec<usize>,
    lines: Vec<usize>,
}

type Kinds<'a> = HashMap<Kind<'a>, Alike>;

/// What comes before which line of a function of `def`, in order; its statements are lines.
pub(super) fn leads(text: &str, def: &'static FunctionDef, with_comments: bool) -> Vec<(usize, Lead)> {
    let mut statements = Reader::read(def, with_comments);
    if statements.iter().all(|(_, lead)| lead.is_none()) {
        return Vec::new();
    }
    let kinds = kinds(text, &statements);
    let mut leads = Vec::new();
    for Alike { statements: alike, lines } in
        kinds.into_values().filter(|it| it.lines.len() == it.statements.len())
    {
        let lead = |(line, statement): (usize, usize)| Some((line, statements[statement].1.take()?));
        leads.extend(lines.into_iter().zip(alike).filter_map(lead));
    }
    leads.sort_unstable_by_key(|(line, _)| *line);
    leads
}

/// The kinds of statements, with the lines of the text.
fn kinds<'t>(text: &'t str, statements: &Statements) -> Kinds<'t> {
    let mut kinds = Kinds::with_capacity_and_hasher(statements.len(), Default::default());
    for (i, (kind, _)) in statements.iter().enumerate() {
        kinds.entry(*kind).or_default().statements.push(i);
    }
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    for (i, line) in lines.iter().enumerate() {
        let kind = kind(line, &kinds).filter(|_| !is_of_loop(&lines[i..]));
        if let Some(alike) = kind.and_then(|kind| kinds.get_mut(&kind)) {
            alike.lines.push(i);
        }
    }
    kinds
}

/// Whether the lines begin with an `if` that a writer makes of a loop: it leaves the loop, or ends a round.
fn is_of_loop(lines: &[&str]) -> bool {
    match lines {
        [line, ..] if line.starts_with("if (!loop_init") => true,
        [line, "} else {", "break;", ..] => line.starts_with("if ("),
        _ => false,
    }
}

/// What a line of any target is known by.
fn kind<'t>(line: &'t str, wanted: &Kinds<'_>) -> Option<Kind<'t>> {
    if line.starts_with("if (") || line.starts_with("} else if (") {
        return Some(Kind::If);
    }
    let statement = line.strip_suffix(';')?;
    if statement.starts_with("return ") {
        return Some(Kind::Returns);
    }
    let left = statement.split_once(" = ").map_or(statement, |(left, _)| left);
    let name = |text: &'t str| text.split(['.', '[', ':', ' ']).next().unwrap_or_default();
    let declared = match left.strip_prefix("let ").or_else(|| left.strip_prefix("var ")) {
        Some(declared) => Some(name(declared)),
        None if left.contains('(') => None,
        None => left.split_once(' ').map(|(_, declared)| name(declared)),
    };
    match declared {
        Some(name) => Some(Kind::Declares(base(name, wanted))),
        None if statement.contains(" = ") => Some(Kind::Assigns(base(name(left), wanted))),
        None => None,
    }
}

/// The declared name: the second variable of a name has a number behind it.
fn base<'t>(name: &'t str, wanted: &Kinds<'_>) -> &'t str {
    let is_wanted =
        |name| wanted.contains_key(&Kind::Declares(name)) || wanted.contains_key(&Kind::Assigns(name));
    match name.rsplit_once('_') {
        Some((base, number))
            if !is_wanted(name) && is_wanted(base) && number.bytes().all(|b| b.is_ascii_digit()) =>
        {
            base
        }
        _ => name,
    }
}

/// Statements as they were written, and what stands before each.
type Statements = Vec<(Kind<'static>, Option<Lead>)>;

/// Goes through the statements as they were written.
struct Reader {
    def: &'static FunctionDef,
    /// The lines of the source that statements stand on, and those above.
    lines: Vec<&'static str>,
    /// The number of the first of them.
    first: u32,
    statements: Statements,
    with_comments: bool,
}

impl Reader {
    fn read(def: &'static FunctionDef, with_comments: bool) -> Statements {
        let (first, lines) = body(def);
        let mut reader = Self { def, lines, first, statements: Vec::new(), with_comments };
        reader.block(&def.body, true);
        reader.statements
    }

    fn block(&mut self, block: &Block, is_body: bool) {
        for stmt in block.stmts {
            self.statement(stmt);
        }
        let Some(value) = block.value else { return };
        match value.kind {
            ExprKind::If { .. } | ExprKind::Match { .. } | ExprKind::Block(_) => {
                self.expression(value, value.span.start.0);
            }
            _ if is_body => self.note(Kind::Returns, value.span.start.0),
            _ => {}
        }
    }

    fn statement(&mut self, stmt: &Stmt) {
        let line = stmt.span.start.0;
        match &stmt.kind {
            StmtKind::Let { local, init: Some(init), .. } => {
                if let Some(local) = self.def.locals.get(*local as usize) {
                    // Variables are declared where the function begins.
                    let kind = if local.mutable { Kind::Assigns } else { Kind::Declares };
                    self.note(kind(local.name), line);
                }
                self.expression(init, 0);
            }
            StmtKind::Assign { place, value, .. } => {
                if let Some(name) = self.root(place) {
                    self.note(Kind::Assigns(name), line);
                }
                self.expression(value, 0);
            }
            StmtKind::Expr(expr) => self.expression(expr, line),
            StmtKind::Return(Some(value)) => {
                self.note(Kind::Returns, line);
                self.expression(value, 0);
            }
            StmtKind::While { body, .. } | StmtKind::For { body, .. } | StmtKind::Loop(body) => {
                self.block(body, false);
            }
            StmtKind::Let { init: None, .. }
            | StmtKind::Break
            | StmtKind::Continue
            | StmtKind::Return(None) => {}
        }
    }

    /// What of an expression is lines of its own; `line` is where it begins as a statement, or 0.
    fn expression(&mut self, expr: &Expr, line: u32) {
        match &expr.kind {
            ExprKind::If { accept, reject, .. } => {
                self.note(Kind::If, line);
                self.block(accept, false);
                reject.iter().for_each(|reject| self.block(reject, false));
            }
            ExprKind::Match { arms, .. } => arms.iter().for_each(|arm| self.block(&arm.body, false)),
            ExprKind::Block(block) => self.block(block, false),
            _ => {}
        }
    }

    fn root(&self, place: &Expr) -> Option<&'static str> {
        match &place.kind {
            ExprKind::Local(local) => self.def.locals.get(*local as usize).map(|local| local.name),
            ExprKind::Field(base, _) | ExprKind::Index(base, _) => self.root(base),
            _ => None,
        }
    }

    fn note(&mut self, kind: Kind<'static>, line: u32) {
        let lead = self.lead(line);
        self.statements.push((kind, lead));
    }

    /// What stands above a line of the source.
    fn lead(&self, line: u32) -> Option<Lead> {
        let above = line.checked_sub(self.first)? as usize;
        let lines = self.lines.get(..above)?;
        let count = lines.iter().rev().take_while(|line| is_comment(line)).count();
        let (rest, comment) = lines.split_at(lines.len() - count);
        let is_blank = rest.last().is_some_and(|line| line.is_empty());
        let text = |line: &&str| one_line(&without_links(line.trim_start_matches('/').trim_start()));
        let comment = comment.iter().filter(|_| self.with_comments).map(text).collect();
        Some(Lead { is_blank, comment }).filter(|lead| lead.is_blank || !lead.comment.is_empty())
    }
}

fn is_comment(line: &str) -> bool {
    line.starts_with("//") && !line.starts_with("///")
}

/// The last lines of a function's source, from above its first statement on, and the number of the first of them: what
/// is before is documentation.
fn body(def: &'static FunctionDef) -> (u32, Vec<&'static str>) {
    let (text, body) = (def.source.text, &def.body);
    let begin = body.stmts.first().map(|stmt| stmt.span).or(body.value.map(|value| value.span));
    let begin = begin.map_or(def.source.line, |span| span.start.0);
    let breaks = text.bytes().map(|byte| u32::from(byte == b'\n')).sum::<u32>();
    let mut number = def.source.line + breaks + 1;
    let mut lines = Vec::new();
    for line in text.rsplit('\n').map(str::trim) {
        number -= 1;
        lines.push(line);
        if number < begin && !is_comment(line) {
            break;
        }
    }
    lines.reverse();
    (number, lines)
}
