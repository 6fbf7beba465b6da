//! What came of a run.

use super::compare::{Compared, Standing};
use super::routes::ORIGINAL;
use crate::expectation::Expectation;

/// How a run ended, the worst of its routes; better before worse.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// The interpreter ran it, and every route that ran agrees within what is permitted.
    Ok,
    /// Floats differ, and nothing says by how much they may.
    Unjudged,
    /// The interpreter does not execute something in it.
    Refused,
    /// What was asked for does not fit the shader.
    Error,
    /// It is no shader, by naga's front end and validator.
    Invalid,
    /// The program itself does something wrong.
    Findings,
    /// A route differs by more than is permitted.
    Differs,
    /// A step did not end in time.
    Timeout,
    /// A step crashed or panicked.
    Crashed,
}

impl Status {
    /// Its name, as reports print it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Unjudged => "unjudged",
            Self::Refused => "refused",
            Self::Error => "error",
            Self::Invalid => "invalid",
            Self::Findings => "findings",
            Self::Differs => "differs",
            Self::Timeout => "timeout",
            Self::Crashed => "crashed",
        }
    }
}

/// The outcome of one entry point, or of a file of which none could be run.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Report {
    /// The file.
    pub file: String,
    /// The entry point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub entry: Option<String>,
    /// How it ended.
    pub status: Status,
    /// Why, where that is not `ok`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// Invocations of a workgroup.
    pub workgroup_size: [u32; 3],
    /// Workgroups.
    pub workgroups: [u32; 3],
    /// What drivers were permitted, where that is not the default: the name of an accuracy model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// What the resources held.
    pub inputs: Vec<Input>,
    /// Mistakes of the program itself.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<Mistake>,
    /// What came of each route.
    pub routes: Vec<RouteReport>,
    /// Scalars that the shader may write, where that was asked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outputs: Option<Outputs>,
    /// How the routes to each driver stand to each other, where that was asked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub agreements: Vec<Agreement>,
}

/// Scalars that a shader may write.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Outputs {
    /// How many.
    pub scalars: usize,
    /// Those that nothing says of what they may be.
    pub indeterminate: usize,
}

/// What routes to one driver left, bit for bit.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Agreement {
    /// The driver.
    pub driver: String,
    /// The routes that left something; the others are compared with the first.
    pub routes: Vec<String>,
    /// Those that differ from it, with the first buffer in which they do.
    pub differing: Vec<(String, Compared)>,
}

/// A mistake of the program, where it showed.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Mistake {
    /// Its kind, as `OutOfBounds`.
    pub kind: String,
    /// Line and column, if the shader is text.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<(u32, u32)>,
    /// What happened, and to whom.
    pub message: String,
}

/// A resource before the run.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// `group:binding`.
    pub place: String,
    /// Its length.
    pub bytes: usize,
    /// Where the bytes came from.
    pub from: String,
}

/// The outcome of one route.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct RouteReport {
    /// Its name.
    pub route: String,
    /// What its driver says of itself.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub driver: String,
    /// How it ended.
    pub status: RouteStatus,
    /// Why there is no comparison.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// Why it is no matter that it ended so.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// Each resource that the shader may write.
    pub buffers: Vec<Compared>,
}

/// How a route ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RouteStatus {
    /// All bits are the interpreter's.
    Equal,
    /// Floats differ, within what is permitted.
    Within,
    /// Floats differ, and nothing says by how much they may.
    Unjudged,
    /// Something differs by more than is permitted.
    Beyond,
    /// A compiler or the driver does not take the shader.
    Refused,
    /// It did not end in time.
    Timeout,
    /// It crashed or panicked.
    Crashed,
    /// It was expected to fail, and did not, or in another way.
    Unexpected,
}

impl RouteStatus {
    /// Its name, as reports print it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Equal => "equal",
            Self::Within => "within",
            Self::Unjudged => "unjudged",
            Self::Beyond => "beyond",
            Self::Refused => "refused",
            Self::Timeout => "timeout",
            Self::Crashed => "crashed",
            Self::Unexpected => "unexpected",
        }
    }

    /// What it makes of the whole run.
    fn of_run(self) -> Status {
        match self {
            Self::Equal | Self::Within | Self::Refused => Status::Ok,
            Self::Unjudged => Status::Unjudged,
            Self::Beyond | Self::Unexpected => Status::Differs,
            Self::Timeout => Status::Timeout,
            Self::Crashed => Status::Crashed,
        }
    }
}

impl From<Standing> for RouteStatus {
    fn from(standing: Standing) -> Self {
        match standing {
            Standing::Equal => Self::Equal,
            Standing::Within => Self::Within,
            Standing::Unjudged => Self::Unjudged,
            Standing::Beyond => Self::Beyond,
        }
    }
}

impl RouteReport {
    /// A route that gave nothing to compare.
    #[must_use]
    pub fn without(route: &str, status: RouteStatus, message: String) -> Self {
        let driver = String::new();
        Self {
            route: route.to_owned(),
            driver,
            status,
            message: Some(message),
            expected: None,
            buffers: Vec::new(),
        }
    }

    /// A route that left these buffers.
    #[must_use]
    pub fn compared(route: &str, buffers: Vec<Compared>) -> Self {
        let worst = buffers.iter().map(|b| b.standing).max().unwrap_or(Standing::Equal);
        let (route, driver) = (route.to_owned(), String::new());
        Self { route, driver, status: worst.into(), message: None, expected: None, buffers }
    }

    /// The same in the light of what was expected.
    #[must_use]
    pub fn expected(mut self, expectation: &Expectation) -> Self {
        match expectation.excuse(self.status.name()) {
            Ok(reason) => self.expected = Some(reason),
            Err(message) => {
                self.message = Some(message);
                self.status = RouteStatus::Unexpected;
            }
        }
        self
    }
}

impl Report {
    /// A report of nothing but a status.
    #[must_use]
    pub fn of(file: String, entry: Option<String>, status: Status, message: String) -> Self {
        Self {
            file,
            entry,
            status,
            message: Some(message),
            workgroup_size: [0; 3],
            workgroups: [0; 3],
            model: None,
            inputs: Vec::new(),
            findings: Vec::new(),
            routes: Vec::new(),
            outputs: None,
            agreements: Vec::new(),
        }
    }

    /// The file, and the entry point if there is one.
    #[must_use]
    pub fn subject(&self) -> String {
        match &self.entry {
            Some(entry) => format!("{} {entry}", self.file),
            None => self.file.clone(),
        }
    }

    /// Whether what differs is what drivers made of the file's own SPIR-V, and nothing else.
    #[must_use]
    pub fn only_original_differs(&self) -> bool {
        let mut differing = self.routes.iter().filter(|r| r.status == RouteStatus::Beyond);
        differing.all(|r| r.route.starts_with(ORIGINAL))
    }

    /// Adds a route, and takes its status if that is worse.
    pub fn add(&mut self, route: RouteReport) {
        let status = if route.expected.is_some() { Status::Ok } else { route.status.of_run() };
        self.status = self.status.max(status);
        self.routes.push(route);
    }
}
