//! Writes `random.rs`: kernels that nobody would write, for the corners between the topics.
//!
//! `LOBE_BLESS=1 cargo test -p lobe-codegen --test language generate` writes the file anew.

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/language/random.rs");
const KERNELS: usize = 40;

/// `i32`, `u32`, `f32`, `bool`, `Vec3`, `[i32; 3]`, `Duo`.
const TYPES: [char; 7] = ['i', 'u', 'f', 'b', 'v', 'a', 's'];

struct Variable {
    name: String,
    ty: char,
    mutable: bool,
}

/// Writes one kernel.
struct Writer {
    state: u64,
    variables: Vec<Variable>,
    names: usize,
    loops: usize,
}

impl Writer {
    fn below(&mut self, n: usize) -> usize {
        self.state = self.state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.state >> 33) as usize % n
    }

    fn pick(&mut self, list: &[&str]) -> String {
        list[self.below(list.len())].to_owned()
    }

    fn fresh(&mut self, ty: char, mutable: bool) -> String {
        self.names += 1;
        let name = format!("v{}", self.names);
        self.variables.push(Variable { name: name.clone(), ty, mutable });
        name
    }

    fn known(&mut self, ty: Option<char>, to_change: bool) -> Option<(String, char)> {
        let fit: Vec<_> = self
            .variables
            .iter()
            .filter(|v| ty.is_none_or(|ty| v.ty == ty) && (v.mutable || !to_change))
            .map(|v| (v.name.clone(), v.ty))
            .collect();
        (!fit.is_empty()).then(|| fit[self.below(fit.len())].clone())
    }

    /// Fills `template`: each `i`, `u`, .. in braces becomes an expression of that type.
    fn fill(&mut self, template: &str, depth: usize) -> String {
        let mut out = String::new();
        for (i, part) in template.split('$').enumerate() {
            match part.chars().next() {
                Some(ty) if i > 0 => {
                    out += &self.expr(ty, depth);
                    out += &part[1..];
                }
                _ => out += part,
            }
        }
        out
    }

    fn leaf(&mut self, ty: char) -> String {
        if self.below(4) > 0
            && let Some((name, _)) = self.known(Some(ty), false)
        {
            return name;
        }
        match ty {
            'i' => format!("{}i32", self.below(10)),
            'u' => format!("{}u32", self.below(10)),
            'f' => format!("{:?}", self.below(40) as f32 / 8.0),
            'b' => self.pick(&["true", "false"]),
            'v' => self.fill("Vec3::new($f, $f, 1.5)", 0),
            'a' => self.fill("[$i, 2, 3]", 0),
            _ => self.fill("Duo { n: $i, w: $v }", 0),
        }
    }

    fn expr(&mut self, ty: char, depth: usize) -> String {
        if depth == 0 || self.below(6) == 0 {
            return self.leaf(ty);
        }
        let depth = depth - 1;
        match self.below(10) {
            0 => {
                let condition = self.expr('b', depth);
                let (a, b) = (self.block_value(ty, depth), self.block_value(ty, depth));
                return format!("(if {condition} {a} else {b})");
            }
            1 => {
                let selector = self.expr('i', depth);
                let arms: Vec<_> = (0..3).map(|_| self.block_value(ty, depth)).collect();
                return format!(
                    "(match {selector} {{ -1 | 2 => {} 3 => {} _ => {} }})",
                    arms[0], arms[1], arms[2]
                );
            }
            2 => return self.block_value(ty, depth),
            _ => {}
        }
        let template = self.pick(match ty {
            'i' => &[
                "($i).wrapping_add($i)",
                "($i).wrapping_mul($i)",
                "($i & $i)",
                "($u as i32)",
                "($f as i32)",
                "($b as i32)",
                "($a)[($u % 3) as usize]",
                "($s).n",
                "helper($i, $i)",
                "($i >> ($u & 7))",
                "(5 ^ $i)",
            ],
            'u' => &[
                "($u).wrapping_add($u)",
                "($u ^ $u)",
                "($i as u32)",
                "($u % 7)",
                "($u << 2)",
                "({ let k = 6; k | $u })",
            ],
            'f' => &[
                "($f + $f)",
                "($f * $f)",
                "($f - $f)",
                "($i as f32)",
                "($v).y",
                "($v).dot($v)",
                "min($f, $f)",
            ],
            'b' => &[
                "($i < $i)",
                "($f >= $f)",
                "($b && $b)",
                "($b || $b)",
                "!$b",
                "($b ^ $b)",
                "($v == $v)",
                "($u == $u)",
            ],
            'v' => &["($v + $v)", "($v * $f)", "($s).w", "Vec3::new($f, $f, $f)"],
            'a' => &["[$i, $i, $i]"],
            _ => &["Duo { w: $v, n: $i }", "Duo { n: $i, ..$s }"],
        });
        self.fill(&template, depth)
    }

    fn block_value(&mut self, ty: char, depth: usize) -> String {
        let mark = self.variables.len();
        let statements: String = if depth > 1 {
            (0..self.below(3)).map(|_| self.statement(depth - 1)).collect()
        } else {
            String::new()
        };
        let value = self.expr(ty, depth.saturating_sub(1));
        self.variables.truncate(mark);
        format!("{{ {statements}{value} }}")
    }

    fn block(&mut self, depth: usize) -> String {
        let mark = self.variables.len();
        let statements: String =
            (0..1 + self.below(3)).map(|_| self.statement(depth.saturating_sub(1))).collect();
        self.variables.truncate(mark);
        format!("{{ {statements}}}")
    }

    fn statement(&mut self, depth: usize) -> String {
        match self.below(20) {
            0..=4 => self.declaration(),
            5..=9 => self.assignment(),
            _ if depth == 0 => self.assignment(),
            10 | 11 => format!("if {} {} ", self.expr('b', 2), self.block(depth)),
            12 => format!("if {} {} else {} ", self.expr('b', 2), self.block(depth), self.block(depth)),
            13 | 14 => self.repetition(depth),
            15 => {
                let selector = self.expr('u', 1);
                let (a, b, c) = (self.block(depth), self.block(depth), self.block(depth));
                format!("match {selector} {{ 0 | 1 => {a} 2 => {b} _ => {c} }} ")
            }
            16 | 17 if self.loops > 0 => self.jump(depth),
            18 => self.fill("if $b { return $f; } ", 1),
            _ => self.block(depth),
        }
    }

    fn declaration(&mut self) -> String {
        let ty = TYPES[self.below(7)];
        let value = self.expr(ty, 2);
        if self.below(5) == 0 {
            let (condition, other) = (self.expr('b', 1), self.expr(ty, 1));
            let name = self.fresh(ty, false);
            return format!(
                "let {name}; if {condition} {{ {name} = {value}; }} else {{ {name} = {other}; }} "
            );
        }
        let mutable = self.below(3) > 0;
        let name = self.fresh(ty, mutable);
        let annotation = if ty == 'f' { ": f32" } else { "" };
        format!("let {}{name}{annotation} = {value}; ", if mutable { "mut " } else { "" })
    }

    fn assignment(&mut self) -> String {
        let Some((name, ty)) = self.known(None, true) else { return self.declaration() };
        let template = self.pick(match ty {
            'i' => &["@ = $i; ", "@ ^= $i; "],
            'u' => &["@ = $u; ", "@ |= $u; "],
            'f' => &["@ = $f; ", "@ += $f; ", "@ *= $f; "],
            'b' => &["@ = $b; ", "@ ^= $b; ", "@ &= $b; "],
            'v' => &["@ = $v; ", "@.z += $f; ", "@.x = $f; "],
            'a' => &["@ = $a; ", "@[1] = $i; ", "@[($u % 3) as usize] ^= $i; "],
            _ => &["@ = $s; ", "@.n = $i; ", "@.w.y = $f; "],
        });
        self.fill(&template, 2).replace('@', &name)
    }

    fn repetition(&mut self, depth: usize) -> String {
        let (first, last) = (self.below(4) as i32 - 2, self.below(5));
        let mark = self.variables.len();
        self.loops += 1;
        let text = if self.below(2) == 0 {
            let counter = self.fresh('i', false);
            let dots = self.pick(&["..", "..="]);
            format!("for {counter} in {first}i32{dots}{last} {} ", self.block(depth))
        } else {
            let condition = self.expr('b', 1);
            let counter = self.fresh('i', false);
            let head = if self.below(2) == 0 { "loop".to_owned() } else { format!("while {condition}") };
            let body = self.block(depth);
            format!(
                "let mut {counter} = 0i32; {head} {{ {counter} += 1; if {counter} > 5 {{ break; }} {body} }} "
            )
        };
        self.variables.truncate(mark);
        self.loops -= 1;
        text
    }

    fn jump(&mut self, depth: usize) -> String {
        let out = self.pick(&["break", "continue", "return 1.5"]);
        match self.below(3) {
            0 => self.fill(&format!("if $b {{ {out}; }} "), 1),
            1 => {
                let (selector, body) = (self.expr('i', 1), self.block(depth));
                format!("match {selector} {{ 0 => {out}, 2 | 3 => {body} _ => {{}} }} ")
            }
            _ => {
                let ty = ['i', 'f', 'v'][self.below(3)];
                let (selector, a, b) = (self.expr('i', 1), self.expr(ty, 1), self.block_value(ty, 2));
                let name = self.fresh(ty, false);
                format!("let {name} = match {selector} {{ 1 => {out}, 0 | 4 => {a}, _ => {b} }}; ")
            }
        }
    }
}

fn kernel(seed: usize) -> String {
    let mut writer =
        Writer { state: seed as u64 * 0x9e3779b9 + 1, variables: Vec::new(), names: 0, loops: 0 };
    for (name, ty) in [("pi", 'i'), ("pu", 'u'), ("pf", 'f'), ("pb", 'b'), ("pv", 'v')] {
        writer.variables.push(Variable { name: name.to_owned(), ty, mutable: false });
    }
    let statements: String = (0..4).map(|_| writer.statement(3)).collect();
    let value = writer.expr('f', 3);
    format!(
        "#[kernel]\nfn random_{seed}(pi: i32, pu: u32, pf: f32, pb: bool, pv: Vec3) -> f32 {{\n    {}\n    \
         {value}\n}}\n",
        statements.trim_end().replace("; ", ";\n    ")
    )
}

fn file() -> String {
    let mut text = "//! Written by `generate.rs`; do not edit.\n\nuse crate::check::agrees;\n\
                    use lobe_codegen::kernels;\nuse lobe_codegen::prelude::*;\n\n\
                    #[kernel]\nstruct Duo {\n    n: i32,\n    w: Vec3,\n}\n\n\
                    #[kernel]\nfn helper(a: i32, b: i32) -> i32 {\n    if a > b {\n        \
                    return b.wrapping_sub(a);\n    }\n    a.wrapping_mul(3) ^ b\n}\n\n"
        .to_owned();
    for seed in 0..KERNELS {
        text += &kernel(seed);
        text += "\n";
    }
    text += "#[test]\nfn random_kernels_mean_what_rust_means() {\n";
    for seed in 0..KERNELS {
        text += &format!("    agrees(kernels![random_{seed}][0]);\n");
    }
    text + "}\n"
}

#[test]
fn random_kernels_are_those_written_here() {
    let text = file();
    if std::env::var_os("LOBE_BLESS").is_some_and(|v| v == "1") {
        std::fs::write(FILE, text).expect("the kernels are written");
        return;
    }
    let found = std::fs::read_to_string(FILE).expect("random.rs");
    assert!(found == text, "{FILE} is stale: run this test with LOBE_BLESS=1");
}
