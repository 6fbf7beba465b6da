//! What the runs of one entry point say to each question.

use crate::expectation::Fault;
use crate::question::expected::Expected;
use crate::question::sanitized::SANITIZED;
use crate::question::{Answer, Question, Verdict, Worst};
use crate::shader::compare::{Compared, Difference};
use crate::shader::feed::Feed;
use crate::shader::job::Job;
use crate::shader::report::{Agreement, Mistake, Report, RouteReport, RouteStatus, Status};
use crate::value::parse_hex;
use serde_json::json;

/// What routes that are drawn by chance are called together.
const PERTURBED: &str = "perturbed";

/// No mistake where numbers are drawn as large as their type has them: they overflow.
const OVERFLOWN: &str = "NanBirth";

/// Mistakes that an answer tells; it counts the others.
const TOLD: usize = 3;

/// Collects runs.
#[derive(Default)]
pub(super) struct Answers {
    inputs: usize,
    scalars: usize,
    indeterminate: usize,
    /// Inputs on which the interpreter did not come to its end, and the first of them.
    stopped: usize,
    stop: Option<String>,
    mistakes: Vec<(Mistake, String)>,
    routes: Vec<OfRoute>,
    groups: Vec<Group>,
}

/// What one route left, over all inputs.
struct OfRoute {
    route: String,
    inputs: usize,
    scalars: usize,
    unjudged: usize,
    /// The worst ending, on so many inputs, and a word on the first of them.
    fault: Option<(Fault, usize, String)>,
    share: f64,
    ulp: u64,
    absolute: f64,
    worst: Option<(Rank, Worst)>,
}

/// The larger the worse: the ending, the share of the bound, the distance in ULP.
type Rank = (u8, f64, u64);

/// Routes to one driver.
struct Group {
    driver: String,
    routes: Vec<String>,
    differing: Vec<String>,
    inputs: usize,
    different: usize,
    first: Option<(String, Worst)>,
}

impl Answers {
    /// Takes what came of an input.
    pub(super) fn take(&mut self, run: &Job, report: &Report) {
        self.inputs += 1;
        let outputs = report.outputs.iter();
        outputs.for_each(|o| {
            (self.scalars, self.indeterminate) =
                (self.scalars + o.scalars, self.indeterminate + o.indeterminate)
        });
        let entry = report.entry.as_deref();
        if let Some(message) = report.message.as_ref().filter(|_| report.status != Status::Findings) {
            self.stopped += 1;
            let told = || format!("{}: {message}; {}", report.status.name(), run.command(entry, "interp"));
            self.stop.get_or_insert_with(told);
        }
        let is_far = matches!(run.usual, Feed::Edges(_));
        for mistake in report.findings.iter().filter(|m| !(is_far && m.kind == OVERFLOWN)) {
            let is_known =
                |(known, _): &(Mistake, String)| known.kind == mistake.kind && known.at == mistake.at;
            if !self.mistakes.iter().any(is_known) {
                let command = format!("{} --sanitize", run.command(entry, "interp"));
                self.mistakes.push((mistake.clone(), command));
            }
        }
        for found in &report.routes {
            let command = run.command(entry, &found.route);
            let is_drawn = found.route.starts_with(PERTURBED);
            let name = if is_drawn { PERTURBED } else { &found.route };
            self.route(name).take(found, run, command);
        }
        report
            .agreements
            .iter()
            .for_each(|agreement| self.group(&agreement.driver).take(agreement, run, entry));
    }

    fn route(&mut self, name: &str) -> &mut OfRoute {
        let at = self.routes.iter().position(|of| of.route == name).unwrap_or_else(|| {
            self.routes.push(OfRoute::new(name));
            self.routes.len() - 1
        });
        &mut self.routes[at]
    }

    fn group(&mut self, driver: &str) -> &mut Group {
        let at = self.groups.iter().position(|of| of.driver == driver).unwrap_or_else(|| {
            self.groups.push(Group::new(driver));
            self.groups.len() - 1
        });
        &mut self.groups[at]
    }

    /// The answers, in the order of the questions.
    pub(super) fn finish(self, expected: &Expected<'_>) -> Vec<Answer> {
        let verdict = Verdict::NotAsked("no budget stated".to_owned());
        let bare = Answer::bare(Question::Robust, "", verdict);
        let mut answers = vec![Answer { cases: self.scalars, indeterminate: self.indeterminate, ..bare }];
        let sanitized = Answer::bare(Question::Robust, SANITIZED, sanitized(&self.mistakes));
        answers.push(Answer { cases: self.scalars, ..sanitized });
        if let Some(stop) = self.stop {
            let (status, why) = stop.split_once(": ").unwrap_or(("stopped", &stop));
            let why = format!("{status} on {} of {} inputs: {why}", self.stopped, self.inputs);
            answers.push(Answer::bare(Question::Conformant, "interp", Verdict::FallsShort(why)));
        }
        let is_within =
            |route: &String| self.routes.iter().any(|of| of.route == *route && of.fault.is_none());
        let agree = self.groups.into_iter().map(|group| {
            let is_permitted = group.routes.first().into_iter().chain(&group.differing).all(is_within);
            group.finish(expected, is_permitted)
        });
        let agree: Vec<Answer> = agree.collect();
        answers.extend(self.routes.into_iter().map(|of| of.finish(expected)));
        answers.extend(agree);
        answers
    }
}

fn sanitized(mistakes: &[(Mistake, String)]) -> Verdict {
    let told = mistakes.iter().take(TOLD).map(|(Mistake { kind, at, message }, command)| {
        let at = at.map(|(line, column)| format!(" at {line}:{column}")).unwrap_or_default();
        format!("{kind}{at}: {message}; {command}")
    });
    let told: Vec<String> = told.collect();
    match (told.is_empty(), mistakes.len().saturating_sub(TOLD)) {
        (true, _) => Verdict::Holds,
        (false, 0) => Verdict::FallsShort(told.join("; ")),
        (false, more) => Verdict::FallsShort(format!("{}; and {more} more", told.join("; "))),
    }
}

impl OfRoute {
    fn new(route: &str) -> Self {
        Self {
            route: route.to_owned(),
            inputs: 0,
            scalars: 0,
            unjudged: 0,
            fault: None,
            share: 0.0,
            ulp: 0,
            absolute: 0.0,
            worst: None,
        }
    }

    fn take(&mut self, found: &RouteReport, run: &Job, command: String) {
        self.inputs += 1;
        let fault = fault(found.status);
        if let Some(fault) = fault {
            let word = match &found.message {
                Some(message) => format!(": {message}; {command}"),
                None => String::new(),
            };
            match &mut self.fault {
                Some((known, inputs, _)) if *known == fault => *inputs += 1,
                Some((known, ..)) if severity(Some(*known)) > severity(Some(fault)) => {}
                _ => self.fault = Some((fault, 1, word)),
            }
        }
        for buffer in &found.buffers {
            self.scalars += buffer.scalars;
            self.share = self.share.max(buffer.share);
            self.ulp = self.ulp.max(buffer.max_ulp);
            let Some(first) = &buffer.first else { continue };
            let worst = worst(first, run, command.clone(), fault);
            let error = (worst.found - worst.wanted).abs();
            self.absolute = if error.is_nan() { self.absolute } else { self.absolute.max(error) };
            self.unjudged += if fault == Some(Fault::Unjudged) { buffer.differing } else { 0 };
            let rank = (severity(fault), buffer.share, buffer.max_ulp);
            if self.worst.as_ref().is_none_or(|(known, _)| rank > *known) {
                self.worst = Some((rank, worst));
            }
        }
    }

    fn finish(self, expected: &Expected<'_>) -> Answer {
        let on = |inputs: usize| format!("on {inputs} of {} inputs", self.inputs);
        let fault = self.fault.as_ref().map(|(fault, ..)| *fault);
        let verdict = match self.fault {
            None => Verdict::Holds,
            Some((Fault::Beyond | Fault::Differs, n, _)) => {
                Verdict::FallsShort(format!("beyond the bound {}", on(n)))
            }
            Some((fault @ (Fault::Timeout | Fault::Crashed), n, word)) => {
                let ended = if fault == Fault::Timeout { "did not end in time" } else { "crashed" };
                Verdict::FallsShort(format!("{ended} {}{word}", on(n)))
            }
            Some((Fault::Refused, n, word)) => Verdict::NotAsked(format!("refused {}{word}", on(n))),
            // An integer that depends on how floats were rounded has no one value.
            Some((Fault::Unjudged, ..)) if self.route == PERTURBED => Verdict::Holds,
            Some((Fault::Unjudged, n, _)) => Verdict::NotAsked(format!(
                "{} results differ and nothing says by how much they may; --within NAME=BOUND does",
                on(n)
            )),
        };
        let answer =
            Answer::bare(Question::Conformant, &self.route, expected.of_route(&self.route, fault, verdict));
        Answer {
            cases: self.scalars,
            indeterminate: self.unjudged,
            share: self.share,
            ulp: self.ulp as f64,
            absolute: self.absolute,
            worst: self.worst.map(|(_, worst)| worst),
            ..answer
        }
    }
}

impl Group {
    fn new(driver: &str) -> Self {
        let (routes, differing) = (Vec::new(), Vec::new());
        Self { driver: driver.to_owned(), routes, differing, inputs: 0, different: 0, first: None }
    }

    fn take(&mut self, agreement: &Agreement, run: &Job, entry: Option<&str>) {
        for route in &agreement.routes {
            note(&mut self.routes, route);
        }
        self.inputs += usize::from(agreement.routes.len() > 1);
        self.different += usize::from(!agreement.differing.is_empty());
        for (route, Compared { first, .. }) in &agreement.differing {
            note(&mut self.differing, route);
            let (Some(first), Some(base)) = (first, agreement.routes.first()) else { continue };
            let which = || format!("{route} differs from {base}");
            let worst = || worst(first, run, run.command(entry, route), Some(Fault::Differs));
            self.first.get_or_insert_with(|| (which(), worst()));
        }
    }

    /// The answer; routes that are all within the bound may differ, since translators may choose what computes a result.
    fn finish(self, expected: &Expected<'_>, is_permitted: bool) -> Answer {
        let verdict = match (&self.first, self.inputs) {
            (Some((which, _)), inputs) => {
                let why = format!("{which} on {} of {inputs} inputs", self.different);
                match is_permitted {
                    true => Verdict::NotAsked(format!("{why}, both within the bound")),
                    false => Verdict::FallsShort(why),
                }
            }
            (None, 0) => Verdict::NotAsked("needs two routes that ran".to_owned()),
            (None, _) => Verdict::Holds,
        };
        let verdict = expected.of_group(&self.routes, &self.differing, verdict);
        let subject = format!("{} routes @{}", self.routes.len(), self.driver);
        let answer = Answer::bare(Question::Agree, subject, verdict);
        Answer { cases: self.inputs, worst: self.first.map(|(_, worst)| worst), ..answer }
    }
}

fn note(names: &mut Vec<String>, name: &str) {
    if !names.iter().any(|known| known == name) {
        names.push(name.to_owned());
    }
}

/// What is wrong with a route that ended so.
fn fault(status: RouteStatus) -> Option<Fault> {
    match status {
        RouteStatus::Equal | RouteStatus::Within => None,
        RouteStatus::Unjudged => Some(Fault::Unjudged),
        RouteStatus::Beyond | RouteStatus::Unexpected => Some(Fault::Beyond),
        RouteStatus::Refused => Some(Fault::Refused),
        RouteStatus::Timeout => Some(Fault::Timeout),
        RouteStatus::Crashed => Some(Fault::Crashed),
    }
}

fn severity(fault: Option<Fault>) -> u8 {
    match fault {
        None => 0,
        Some(Fault::Unjudged) => 1,
        Some(Fault::Refused) => 2,
        Some(Fault::Differs | Fault::Beyond) => 3,
        Some(Fault::Timeout) => 4,
        Some(Fault::Crashed) => 5,
    }
}

/// A scalar that differs, with the input that it differs on.
fn worst(first: &Difference, run: &Job, again: String, fault: Option<Fault>) -> Worst {
    let number = |text: &str| parse_hex(text).or_else(|| text.parse().ok()).unwrap_or(f64::NAN);
    let unbounded = if fault == Some(Fault::Unjudged) { f64::INFINITY } else { 0.0 };
    Worst {
        args: json!({ "fill": run.usual.to_string() }),
        leaf: first.path.clone(),
        found: number(&first.found),
        wanted: number(&first.interp),
        permitted: first.bound.unwrap_or(unbounded),
        again: Some(again),
    }
}
