//! Lines that are too long are broken, where a reader would: behind a comma or before an operator, outside of as many
//! parentheses as possible.

use std::borrow::Cow;

/// Characters in a line.
const WIDTH: usize = 110;
/// Spaces before the rest of a broken line, beyond its own.
const INDENT: usize = 4;

/// The line, broken as often as it takes; without a line break at its end.
pub(super) fn wrap(line: &str) -> Cow<'_, str> {
    if line.len() <= WIDTH {
        return Cow::Borrowed(line);
    }
    let start = line.len() - line.trim_start().len();
    let is_comment = line.trim_start().starts_with(['/', '#']);
    let mut rest = line.to_owned();
    let mut lines = Vec::new();
    while rest.chars().count() > WIDTH && !is_comment {
        let Some(at) = place(&rest) else { break };
        lines.push(rest[..at].trim_end().to_owned());
        rest = format!("{}{}", " ".repeat(start + INDENT), rest[at..].trim_start());
    }
    lines.push(rest);
    lines.join("\n").into()
}

/// Where to break: the last of the best places, not so early that little is on the first line.
fn place(line: &str) -> Option<usize> {
    let begin = line.len() - line.trim_start().len() + INDENT;
    let any = || line.char_indices().skip(WIDTH).find(|&(i, c)| c == ' ' && looseness(line, i).is_some());
    best(line, begin.max(WIDTH / 3)).or_else(|| best(line, begin)).or_else(|| any().map(|(at, _)| at))
}

/// The last of the places behind `from` that are in the fewest parentheses, and there at the loosest operator.
fn best(line: &str, from: usize) -> Option<usize> {
    let mut depth = 0usize;
    let mut best: Option<((usize, usize), usize)> = None;
    for (i, character) in line.char_indices().take(WIDTH) {
        match character {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ' ' if i > from => {
                let rank = looseness(line, i).map(|looseness| (depth, looseness));
                best = rank
                    .filter(|rank| best.is_none_or(|(least, _)| *rank <= least))
                    .map(|rank| (rank, i))
                    .or(best);
            }
            _ => {}
        }
    }
    best.map(|(_, at)| at)
}

/// How loosely what is beside the blank at `i` binds; 0 behind a comma.
fn looseness(line: &str, i: usize) -> Option<usize> {
    let operators = ["? ", ": ", "|| ", "&& ", "+ ", "- ", "* ", "/ "];
    if line[..i].ends_with(',') {
        return Some(0);
    }
    operators.iter().position(|operator| line[i + 1..].starts_with(operator)).map(|at| at / 2 + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_line_is_broken_outside_of_its_parentheses() {
        let (first, second) = ("a".repeat(40), "b".repeat(40));
        let line = format!("    let x = f({first}, {second}) + g({first}, {second});");
        let expected = format!("    let x = f({first}, {second})\n        + g({first}, {second});");
        assert_eq!(wrap(&line), expected);
        let line = format!("    let x = f({first}, {second}, {first});");
        assert_eq!(wrap(&line), format!("    let x = f({first}, {second},\n        {first});"));
    }

    #[test]
    fn what_fits_or_cannot_be_broken_stays() {
        for line in
            [format!("let x = {};", "y".repeat(90)), "z".repeat(200), format!("/// {}", "a b ".repeat(60))]
        {
            assert_eq!(wrap(&line), line);
        }
    }
}
