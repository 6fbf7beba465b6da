//! Gives each varying register a slot, by a linear scan, and each uniform one a cell of its own.
//!
//! A slot is free again when its register was read for the last time, but not yet for the result of the
//! operation that reads it: a result never lies where an operand does.

use super::super::program::{Block, Program, Reg, Stmt, Value};
use super::ops;

/// Slots of either width that `link` uses for masks and copies come first.
pub(super) struct Allocation {
    /// The slot of each varying register, the cell of each uniform one.
    pub(super) places: Vec<u32>,
    pub(super) narrow: usize,
    pub(super) wide: usize,
    pub(super) cells: usize,
}

/// From where it is computed to where it is read last.
#[derive(Debug, Clone, Copy)]
struct Range {
    first: u32,
    last: u32,
}

struct Scan<'p> {
    program: &'p Program,
    ranges: Vec<Option<Range>>,
    loops: Vec<Range>,
    at: u32,
}

impl Scan<'_> {
    fn touch(&mut self, value: Value) {
        if let Value::Reg(Reg(reg)) = value
            && self.program.registers[reg as usize].varying
        {
            let at = self.at;
            self.ranges[reg as usize].get_or_insert(Range { first: at, last: at }).last = at;
        }
    }

    fn block(&mut self, block: &Block) {
        for (rank, stmt) in block.iter().enumerate() {
            self.at += 1;
            let mut operands = Vec::new();
            stmt.operands(&mut |v| operands.push(v));
            // `link` makes one step of the two, which reads the operands of the first.
            if let [.., Stmt::Eval(first)] = &block[..rank]
                && let Stmt::Eval(second) = stmt
                && ops::chained(first, second)
            {
                operands.extend(first.args.iter().copied());
            }
            operands.into_iter().for_each(|v| self.touch(v));
            stmt.targets().for_each(|to| self.touch(Value::Reg(to)));
            self.inner(stmt);
        }
    }

    fn inner(&mut self, stmt: &Stmt) {
        match stmt {
            Stmt::If { condition, accept, reject } => {
                self.block(accept);
                // The other arm asks for the condition again.
                self.at += 1;
                self.touch(*condition);
                self.block(reject);
            }
            Stmt::Loop { body, .. } => {
                let first = self.at;
                self.block(body);
                self.at += 1;
                self.loops.push(Range { first, last: self.at });
            }
            Stmt::Scope { body, .. } => self.block(body),
            Stmt::Eval(_)
            | Stmt::Set { .. }
            | Stmt::Store { .. }
            | Stmt::Atomic(_)
            | Stmt::Texture(_)
            | Stmt::Subgroup(_)
            | Stmt::Leave(_)
            | Stmt::Barrier { .. } => {}
        }
    }
}

/// The ranges of varying registers. What a loop finds computed it may read in each round.
fn ranges(program: &Program) -> (Vec<Option<Range>>, u32) {
    let ranges = vec![None; program.registers.len()];
    let mut scan = Scan { program, ranges, loops: Vec::new(), at: 0 };
    scan.block(&program.body);
    scan.at += 1;
    program.results.iter().for_each(|v| scan.touch(*v));
    let innermost = innermost(scan.loops, scan.at);
    for range in scan.ranges.iter_mut().flatten() {
        let mut around = innermost[range.last as usize];
        while let Some(inside) = around.filter(|l| range.first <= l.first) {
            range.last = inside.last;
            around = innermost[inside.first as usize];
        }
    }
    (scan.ranges, scan.at)
}

/// The innermost loop around each place up to `end`; around a loop is what is around its begin.
fn innermost(mut loops: Vec<Range>, end: u32) -> Vec<Option<Range>> {
    loops.sort_unstable_by_key(|l| l.first);
    let mut loops = loops.into_iter().peekable();
    let mut open: Vec<Range> = Vec::new();
    let inside = |at: u32| {
        while open.last().is_some_and(|l| l.last <= at) {
            open.pop();
        }
        let around = open.last().copied();
        open.extend(loops.next_if(|l| l.first == at));
        around
    };
    (0..=end).map(inside).collect()
}

/// Slots of one width.
#[derive(Default)]
struct File {
    free: Vec<u32>,
    used: u32,
}

impl File {
    fn take(&mut self) -> u32 {
        self.free.pop().unwrap_or_else(|| {
            self.used += 1;
            self.used - 1
        })
    }
}

/// Allocates; the first `narrow` and `wide` slots and the first `cells` are taken.
pub(super) fn allocate(program: &Program, narrow: u32, wide: u32, cells: u32) -> Allocation {
    let (ranges, end) = ranges(program);
    let mut starts = vec![Vec::new(); end as usize + 1];
    let mut ends = vec![Vec::new(); end as usize + 1];
    let mut places = vec![u32::MAX; program.registers.len()];
    let mut cells = cells;
    for (reg, range) in ranges.iter().enumerate() {
        match range {
            Some(range) => {
                starts[range.first as usize].push(reg);
                ends[range.last as usize].push(reg);
            }
            None => {
                places[reg] = cells;
                cells += 1;
            }
        }
    }
    let mut files = [File { used: narrow, ..File::default() }, File { used: wide, ..File::default() }];
    let file = |reg: usize| usize::from(program.registers[reg].scalar.wide());
    for at in 0..=end as usize {
        for reg in &starts[at] {
            places[*reg] = files[file(*reg)].take();
        }
        for reg in &ends[at] {
            files[file(*reg)].free.push(places[*reg]);
        }
    }
    let [narrow, wide] = files.map(|f| f.used as usize);
    Allocation { places, narrow, wide, cells: cells as usize }
}
