//! Programs by chance: what lanes do on each instruction set is what the judge does, and no driver leaves its bounds.

use crate::soundness::{Seen, check};
use crate::support::{Chance, call, columns};

/// Programs that a run tries.
const PROGRAMS: usize = 250;

/// Rows of each: some batches, and one in part.
const ROWS: usize = 300;

/// Writes programs with three floats, an integer and an array as variables.
pub(crate) struct Writer {
    pub(crate) chance: Chance,
    loops: usize,
    names: usize,
}

impl Writer {
    fn one_of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.chance.below(words.len())]
    }

    fn number(&mut self, depth: usize) -> String {
        let leaf = ["a", "b", "c", "y", "0.5", "3.0", "v[n % 4u]", "f32(n)"];
        if depth == 0 {
            return self.one_of(&leaf).to_owned();
        }
        let (p, q) = (self.number(depth - 1), self.number(depth - 1));
        match self.chance.below(8) {
            0 => format!("({p} + {q})"),
            1 => format!("({p} - {q})"),
            2 => format!("({p} * {q})"),
            3 => format!("min({p}, {q})"),
            4 => format!("select({p}, {q}, {})", self.condition()),
            5 => format!("({p} * {q} - {p})"),
            6 => format!("g({p}, {q})"),
            _ => self.one_of(&leaf).to_owned(),
        }
    }

    fn condition(&mut self) -> String {
        match self.chance.below(4) {
            0 => format!("n % 3u == {}u", self.chance.below(3)),
            1 => format!("x > {}u", self.chance.below(6)),
            _ => format!("{} < {}", self.one_of(&["a", "b", "c"]), self.one_of(&["y", "b", "1.0"])),
        }
    }

    fn block(&mut self, depth: usize) -> String {
        let count = 1 + self.chance.below(4);
        (0..count).map(|_| self.statement(depth)).collect::<Vec<_>>().join(" ")
    }

    fn statement(&mut self, depth: usize) -> String {
        if depth == 0 || self.chance.below(3) == 0 {
            return self.simple();
        }
        match self.chance.below(4) {
            0 => format!("if {} {{ {} }}", self.condition(), self.block(depth - 1)),
            1 => format!(
                "if {} {{ {} }} else {{ {} }}",
                self.condition(),
                self.block(depth - 1),
                self.block(depth - 1)
            ),
            2 => format!(
                "switch n % 3u {{ case 0u: {{ {} }} default: {{ {} }} }}",
                self.block(depth - 1),
                self.block(depth - 1)
            ),
            _ => self.looped(depth),
        }
    }

    fn looped(&mut self, depth: usize) -> String {
        self.names += 1;
        self.loops += 1;
        let (i, rounds) = (format!("i{}", self.names), 1 + self.chance.below(4));
        let body = self.block(depth - 1);
        self.loops -= 1;
        format!("for (var {i} = 0u; {i} < {rounds}u; {i}++) {{ {body} }}")
    }

    fn simple(&mut self) -> String {
        self.names += 1;
        match self.chance.below(9) {
            0 if self.loops > 0 => format!("if {} {{ break; }}", self.condition()),
            1 if self.loops > 0 => format!("if {} {{ continue; }}", self.condition()),
            2 => format!("if {} {{ return vec4(a, b, c, {}); }}", self.condition(), self.number(1)),
            3 => "n = n * 5u + x;".to_owned(),
            4 => format!("v[(n + x) % 4u] = {};", self.number(1)),
            5 => format!("let t{0} = a; a = b; b = t{0};", self.names),
            6 => "h(&c, a);".to_owned(),
            _ => format!("{} = {};", self.one_of(&["a", "b", "c"]), self.number(2)),
        }
    }
}

pub(crate) fn writer() -> Writer {
    let seed = std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(0x1a9e);
    println!("seed {seed:#x}");
    Writer { chance: Chance(seed), loops: 0, names: 0 }
}

/// A program whose variables begin like this.
pub(crate) fn program(writer: &mut Writer, first: &str) -> String {
    let body = writer.block(3);
    format!(
        "fn g(p: f32, q: f32) -> f32 {{ if p < q {{ return q - p; }} return p * 0.5; }}
        fn h(p: ptr<function, f32>, q: f32) {{ if q > 0.0 {{ *p += q; }} else {{ *p = -*p; }} }}
        fn f(x: u32, y: f32) -> vec4<f32> {{
            {first} var n = x; var v = array<f32, 4>(1.0, -1.0, y, 0.25);
            {body}
            return vec4(a, b, c + v[0] + v[3], f32(n));
        }}"
    )
}

#[test]
fn chance_programs_leave_what_the_judge_leaves() {
    let mut writer = writer();
    for _ in 0..PROGRAMS {
        let text = program(&mut writer, "var a = y; var b = 2.0; var c = 3.0;");
        let whole: Vec<u32> = (0..ROWS).map(|_| writer.chance.below(9) as u32).collect();
        let floats: Vec<u32> = writer.chance.floats(ROWS).iter().map(|x| x.to_bits()).collect();
        call(&text, &columns(&[whole, floats]));
    }
}

#[test]
fn halves_of_lanes_meet_soundly() {
    const FEW: [f32; 6] = [0.5, 1.0, 1.1, 2.0, 2.2, 3.0];
    let (mut writer, mut seen) = (writer(), Seen::default());
    for _ in 0..PROGRAMS {
        // Numbers that drivers round apart, so that comparisons are open.
        let text = program(&mut writer, "var a = y * 1.1; var b = 2.0 * 1.1; var c = 3.3 / 3.0;");
        let whole: Vec<u32> = (0..ROWS / 4).map(|_| writer.chance.below(9) as u32).collect();
        let few = (0..ROWS / 4).map(|_| FEW[writer.chance.below(6)].to_bits()).collect();
        let seed = writer.chance.0;
        check(&text, &columns(&[whole, few]), seed, &mut seen);
    }
    println!("{} of {} bounded, {} rows ambiguous", seen.bounded, seen.rows, seen.ambiguous);
    assert!(seen.ambiguous * 20 > seen.rows / 4 && seen.bounded * 2 > seen.rows);
}
