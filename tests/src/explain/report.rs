//! What was found, in the words of a report.

use super::chain::{Chain, Total};
use super::line::{Line, lines};
use super::local::{Judged, Local};
use super::rule::{EXACT, rule};
use super::share::{Share, Shares};
use super::value::{Place, Value};
use super::{ExplainError, ulps};
use crate::subject::Subject;
use crate::value::{Floats, args_json, format_hex, format_hex_f64};
use lobe_backends::executor::Program;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::Site;
use naga::ScalarKind;
use serde::Serialize;

/// Operations that are named by their share of the error.
const NAMED: usize = 3;

/// Why a result is as it is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Explanation {
    /// The kernel.
    pub kernel: &'static str,
    /// The route.
    pub route: String,
    /// The row, floats in hexadecimal.
    pub arguments: serde_json::Value,
    /// The floats of the result.
    pub results: Vec<Outcome>,
    /// The one that is explained.
    pub explained: usize,
    /// Whether the route returns the same bits without traces.
    pub same_bits: bool,
    /// Numbers written down.
    pub records: usize,
    /// Operations judged, each time that they ran.
    pub judged: usize,
    /// The first operation whose value its rule does not permit for its operands.
    pub broken: Option<Step>,
    /// The first value outside what any driver may compute from the arguments.
    pub outside: Option<Step>,
    /// A decision that the interpreter takes otherwise.
    pub decision: Option<Decision>,
    /// Operations whose errors do most to the result, the largest first.
    pub shares: Vec<Step>,
    /// What is left of the result's error once all operations' shares are taken off: the formula's own error.
    pub formula_error: f64,
    /// Errors that were not put in, since there are too many.
    pub left_out: usize,
}

/// A float of the result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Outcome {
    /// Its name in the result.
    pub path: String,
    /// The route's, in hexadecimal.
    pub value: String,
    /// In real numbers.
    pub exact: String,
    /// How far it is above that.
    pub error: f64,
    /// The same in ULP.
    pub ulp: f64,
    /// The largest that any driver may have; none where nothing is promised.
    pub permitted: Option<f64>,
    /// What the kernel states.
    pub budget: Option<f64>,
    #[serde(skip)]
    leaf: usize,
}

/// An operation of the trace.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Step {
    /// Its function.
    pub function: String,
    /// Its Rust text.
    pub rust: Option<String>,
    /// Where that stands.
    pub place: Option<String>,
    /// naga's expression.
    pub naga: String,
    /// Its lines in the emitted artifacts.
    pub lines: Vec<Line>,
    /// Which execution of it, from 1.
    pub execution: u32,
    /// What it read; empty of what only moves values.
    pub operands: Vec<Operand>,
    /// Which scalar of it.
    pub component: usize,
    /// The route's value; floats in hexadecimal.
    pub value: String,
    /// What it is in real numbers, for these operands.
    pub exact: Option<String>,
    /// Its own error, in ULP.
    pub ulp: Option<f64>,
    /// The largest that is permitted, in ULP; none where nothing is promised.
    pub permitted_ulp: Option<f64>,
    /// The values that are permitted for these operands.
    pub permitted: Option<[String; 2]>,
    /// The values that are permitted from the arguments on.
    pub permitted_from_arguments: Option<[String; 2]>,
    /// Whether a product and a sum were contracted.
    pub contracted: bool,
    /// Whether the terms of a sum were taken in another order.
    pub reordered: bool,
    /// The accuracy rule.
    pub rule: String,
    /// What its own error does to the result.
    pub effect: Option<f64>,
}

/// What an operation read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Operand {
    /// Its Rust text.
    pub rust: Option<String>,
    /// Its scalars.
    pub values: Vec<String>,
}

/// A decision that was taken otherwise.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Decision {
    /// The condition.
    pub step: Step,
    /// Whether drivers may take it either way.
    pub ambiguous: bool,
}

impl Explanation {
    /// Whether every operation keeps its rule and every value lies inside its bound, the results too.
    #[must_use]
    pub fn holds(&self) -> bool {
        let is_inside = |o: &Outcome| o.permitted.is_none_or(|permitted| o.error.abs() <= permitted);
        self.broken.is_none()
            && self.outside.is_none()
            && self.decision.as_ref().is_none_or(|d| d.ambiguous)
            && self.results.iter().all(is_inside)
    }
}

/// The floats of the result, against what is permitted.
pub(super) fn outcomes(
    subject: &Subject,
    row: &Columns,
    results: &Columns,
) -> Result<Vec<Outcome>, ExplainError> {
    let shadow = subject.program().shadow(row, None)?;
    let budgets = subject.permitted(row, &shadow)?;
    let leaves = subject.program().results().iter().zip(&shadow.columns).enumerate();
    let floats = leaves.filter_map(|(leaf, (named, column))| {
        let ShadowColumn::Float { exact, bound, .. } = column else { return None };
        let value = f32::from_bits(results.columns[leaf][0]);
        let error = f64::from(value) - exact[0];
        Some(Outcome {
            path: named.path.clone(),
            value: format_hex(value),
            exact: format_hex_f64(exact[0]),
            error,
            ulp: ulps(error, exact[0]),
            permitted: Some(bound[0]).filter(|b| b.is_finite()),
            budget: budgets[leaf].as_ref().map(|budget| budget[0]),
            leaf,
        })
    });
    Ok(floats.collect())
}

/// The scalar of the result that is worst, by its budget or else by its bound.
pub(super) fn worst(outcomes: &[Outcome]) -> Option<usize> {
    let share = |o: &Outcome| match o.budget.or(o.permitted) {
        Some(permitted) if permitted > 0.0 => o.error.abs() / permitted,
        _ => o.ulp,
    };
    outcomes.iter().max_by(|a, b| share(a).total_cmp(&share(b))).map(|o| o.leaf)
}

/// All that was found.
pub(super) struct Found<'a> {
    pub(super) program: &'a Program,
    pub(super) sites: &'a [Site],
    pub(super) values: Vec<Value>,
    pub(super) judged: Vec<Judged>,
    pub(super) chain: Chain,
    pub(super) shares: Shares,
}

impl Found<'_> {
    pub(super) fn explanation(
        &self,
        route: String,
        row: &Columns,
        results: Vec<Outcome>,
        leaf: usize,
        same_bits: bool,
    ) -> Explanation {
        let explained = results.iter().position(|o| o.leaf == leaf).unwrap_or(0);
        let broken = self.judged.iter().find_map(|judged| {
            let component = judged.scalars.iter().position(|s| s.breaks())?;
            Some(self.step(judged.value, component))
        });
        let of_record = |record: usize| {
            let at = self.values.partition_point(|v| v.first <= record).saturating_sub(1);
            self.step(at, record - self.values[at].first)
        };
        let ambiguous = |record: usize| {
            let total = self.chain.totals.get(record).copied().flatten();
            !matches!(total, Some(Total::Word { is_known: true, .. }))
        };
        let shares = self.shares.shares.iter().take(NAMED).filter(|s| s.effect != 0.0);
        let all: f64 = self.shares.shares.iter().map(|s| s.effect).filter(|e| e.is_finite()).sum();
        let formula_error = results[explained].error - all;
        Explanation {
            kernel: self.program.name(),
            route,
            arguments: args_json(self.program.def(), &row.row(0), Floats::Hex),
            explained,
            same_bits,
            records: self.values.iter().map(|v| v.bits.len()).sum(),
            judged: self.judged.len(),
            broken,
            outside: self.chain.outside.map(of_record),
            decision: self
                .chain
                .decision
                .map(|record| Decision { step: of_record(record), ambiguous: ambiguous(record) }),
            shares: shares.map(|share| self.of_share(*share)).collect(),
            formula_error,
            left_out: self.shares.left_out,
            results,
        }
    }

    fn of_share(&self, share: Share) -> Step {
        let step = self.step(self.judged[share.judged].value, share.component);
        Step { effect: Some(share.effect), ..step }
    }

    /// What there is to say of a scalar of a value.
    fn step(&self, at: usize, component: usize) -> Step {
        let value = &self.values[at];
        let (function, expression) = value.place;
        let module = self.program.module().module();
        let own = &module.functions[function];
        let judged = self.judged.iter().find(|j| j.value == at);
        let local = judged.and_then(|j| j.scalars.get(component)).copied();
        let (exact, error, bound) = match local {
            Some(Local::Float { exact, bound, .. }) => {
                (Some(exact), local.and_then(Local::error), Some(bound))
            }
            _ => (None, None, None),
        };
        let bound = bound.filter(|b| b.is_finite());
        let total = self.chain.totals.get(value.first + component).copied().flatten();
        let place = self.place(value.place);
        Step {
            function: own.name.clone().unwrap_or_default(),
            rust: place.map(|p| p.text.to_owned()),
            place: place.map(|p| p.to_string()),
            naga: format!("{:?} = {:?}", expression, own.expressions[expression]),
            lines: lines(self.program, value.place),
            execution: value.hit + 1,
            operands: judged.map(|j| self.operands(j)).unwrap_or_default(),
            component,
            value: self.shown(value.place, value.bits[component]),
            exact: match local {
                Some(Local::Word { wanted, .. }) => Some(self.shown(value.place, wanted)),
                _ => exact.map(format_hex_f64),
            },
            ulp: exact.zip(error).map(|(exact, error)| ulps(error, exact)),
            permitted_ulp: exact.zip(bound).map(|(exact, bound)| ulps(bound, exact)),
            permitted: exact.zip(bound).map(interval),
            permitted_from_arguments: total.map(|total| match total {
                Total::Float { exact, bound } => interval((exact, bound)),
                Total::Word { wanted, .. } => [wanted, wanted].map(|w| self.shown(value.place, w)),
            }),
            contracted: judged.is_some_and(|j| j.contracted),
            reordered: judged.is_some_and(|j| j.reordered),
            rule: if exact.is_some() { rule(&own.expressions[expression]) } else { EXACT.to_owned() },
            effect: None,
        }
    }

    fn place(&self, (function, expression): Place) -> Option<lobe_codegen::source::RustPlace> {
        let module = self.program.module();
        module.meta().sources.place(module.module().functions[function].expressions.get_span(expression))
    }

    fn operands(&self, judged: &Judged) -> Vec<Operand> {
        let shown = |(place, bits): &(Place, Vec<u32>)| Operand {
            rust: self.place(*place).map(|p| p.text.to_owned()),
            values: bits.iter().map(|bits| self.shown(*place, *bits)).collect(),
        };
        judged.operands.iter().map(shown).collect()
    }

    /// A scalar of an expression as text.
    fn shown(&self, place: Place, bits: u32) -> String {
        let site = self.sites.iter().find(|s| (s.function, s.expression) == place);
        match site.map(|s| s.kind) {
            Some(ScalarKind::Float) => format_hex(f32::from_bits(bits)),
            Some(ScalarKind::Sint) => (bits as i32).to_string(),
            Some(ScalarKind::Bool) => (bits != 0).to_string(),
            _ => bits.to_string(),
        }
    }
}

fn interval((exact, bound): (f64, f64)) -> [String; 2] {
    [exact - bound, exact + bound].map(format_hex_f64)
}
