//! Named tests of a user's own kernels: [`check!`](crate::check) writes one for each kernel and route.
//!
//! `cargo test` and nextest can then filter, split and repeat them. A test opens the one driver that it is named after;
//! listing them opens nothing.

mod asked;
mod options;

pub use options::Options;

use crate::cases::Cases;
use crate::files;
use crate::judge::{Plan, judge};
use crate::oracle::Mapping;
use crate::report::part::Whole;
use crate::report::{KernelReport, Part, Report, Skipped, human, json};
use asked::Asked;
use lobe_codegen::def::FunctionRef;
use std::path::{Path, PathBuf};

/// Names the folder that tests leave their parts of the report in, for `lobe merge`.
pub const REPORT_DIR: &str = "LOBE_REPORT_DIR";

/// Asks of each test before those that are named after routes.
const FIRST: [&str; 3] = ["correct", "robust", "sanitized"];

/// Asked last.
const LAST: &str = "agree";

/// Tests that one [`check!`](crate::check) writes.
#[derive(Clone, Copy, Debug)]
pub struct Tests {
    /// The package.
    pub package: &'static str,
    /// Its folder.
    pub folder: &'static str,
    /// The module that the tests are in.
    pub module: &'static str,
    /// The kernels.
    pub kernels: &'static [&'static str],
    /// The tests that are named after routes.
    pub routes: &'static [&'static str],
    /// What else was said.
    pub options: Options,
}

/// How a test ends.
pub type Outcome = Result<(), Failure>;

/// Why a test fails, in the words of `lobe check`.
pub struct Failure(String);

/// Test runners print errors by this.
impl std::fmt::Debug for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.0.trim_end())
    }
}

/// Writes a test for each of your kernels and each question and route: `check::my_kernel::robust`,
/// `check::my_kernel::spirv_lavapipe`, ..
///
/// ```
/// # mod kernels {
/// use lobe_codegen::prelude::*;
///
/// /// Light that fades out towards `radius`.
/// #[kernel(domain(d = 0.0..=100.0, radius = 1.0..=100.0), budget(1e-5))]
/// pub fn falloff(d: f32, radius: f32) -> f32 {
///     let share = clamp(d / radius, 0.0, 1.0);
///     (1.0 - share) * (1.0 - share)
/// }
/// # }
/// # use kernels::*;
///
/// lobe_tests::check!(falloff);
/// # fn main() {}
/// ```
///
/// The tests are `correct`, `robust` and `sanitized`, which need no driver, one for each route (`native`, `interp`,
/// `spirv_lavapipe`, `wgsl_naga_lavapipe`, `hlsl_dxc_lavapipe`, `wgsl_tint_lavapipe`, four for
/// SwiftShader, and `glsl_llvmpipe`), and `agree`.
/// One whose driver is missing says so and passes; with `LOBE_REQUIRE_TOOLS=1` it fails.
///
/// Kernels are named as they are in scope, several with commas between; then options may follow, as in
/// `check!(falloff, glow, inputs = 10_000, seed = 7, routes = [interp, spirv_gpu])`: `routes` names the tests for
/// routes (`spirv_gpu` is the first driver of hardware; `hlsl_slang_` and `glsl_glslang_` are roads too), the others
/// are those of [`Options`](crate::named::Options).
/// Rows that once went wrong lie in `tests/cases/<kernel>.jsonl`, known faults of drivers in
/// `tests/cases/expectations.toml`.
/// The tests lie in a module `check`, so there is one `check!` in a module.
///
/// With `LOBE_REPORT_DIR=DIR` each test leaves its part of the report in DIR; `lobe merge DIR` makes one of them.
#[macro_export]
macro_rules! check {
    (@kernels [$($known:ident)*] $next:ident = $($rest:tt)*) => {
        $crate::check! { @usual [$($known)*] $next = $($rest)* }
    };
    (@kernels [$($known:ident)*] $next:ident, $($rest:tt)+) => {
        $crate::check! { @kernels [$($known)* $next] $($rest)+ }
    };
    (@kernels [$($known:ident)*] $next:ident $(,)?) => {
        $crate::check! { @usual [$($known)* $next] }
    };
    (@usual $kernels:tt $($options:tt)*) => {
        $crate::check! { @options $kernels [
            native interp
            spirv_lavapipe wgsl_naga_lavapipe hlsl_dxc_lavapipe wgsl_tint_lavapipe
            spirv_swiftshader wgsl_naga_swiftshader hlsl_dxc_swiftshader wgsl_tint_swiftshader
            glsl_llvmpipe
        ] [] $($options)* }
    };
    (@options $kernels:tt $routes:tt $options:tt routes = [$($route:ident),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::check! { @options $kernels [$($route)+] $options $($($rest)*)? }
    };
    (@options $kernels:tt $routes:tt [$($options:tt)*] $name:ident = $value:tt $(, $($rest:tt)*)?) => {
        $crate::check! { @options $kernels $routes [$($options)* .$name($value)] $($($rest)*)? }
    };
    (@options $kernels:tt $routes:tt $options:tt) => {
        $crate::check! { @module $kernels $routes $routes $options }
    };
    (@module [$($kernel:ident)+] [$($route:ident)+] $routes:tt [$($options:tt)*]) => {
        #[cfg(test)]
        mod check {
            const TESTS: $crate::named::Tests = $crate::named::Tests {
                package: env!("CARGO_PKG_NAME"),
                folder: env!("CARGO_MANIFEST_DIR"),
                module: module_path!(),
                kernels: &[$(stringify!($kernel)),+],
                routes: &[$(stringify!($route)),+],
                options: $crate::named::Options::new() $($options)*,
            };
            $($crate::check! { @kernel $kernel $routes })+
        }
    };
    (@kernel $kernel:ident [$($route:ident)+]) => {
        mod $kernel {
            use super::super::*;
            $crate::check! { @test $kernel correct }
            $crate::check! { @test $kernel robust }
            $crate::check! { @test $kernel sanitized }
            $($crate::check! { @test $kernel $route })+
            $crate::check! { @test $kernel agree }
        }
    };
    (@test $kernel:ident $test:ident) => {
        #[test]
        fn $test() -> $crate::named::Outcome {
            super::TESTS.run($crate::kernels![$kernel][0], stringify!($test))
        }
    };
    ($($kernels:tt)+) => {
        $crate::check! { @kernels [] $($kernels)+ }
    };
}

impl Tests {
    /// Runs the test named `test` of `kernel`.
    ///
    /// # Errors
    /// When an answer falls short, a route is missing that is required, or a file cannot be read or written.
    pub fn run(&self, kernel: FunctionRef, test: &str) -> Outcome {
        let report = self.report(kernel, test).map_err(|why| Failure(format!("{}: {why}", kernel().name)))?;
        report.skipped.iter().for_each(|skipped| self.tell(kernel().name, test, skipped));
        if let Some(folder) = std::env::var_os(REPORT_DIR).filter(|value| !value.is_empty()) {
            self.leave(PathBuf::from(folder), kernel().name, test, &report)?;
        }
        let is_required = std::env::var_os("LOBE_REQUIRE_TOOLS").is_some_and(|value| value == "1");
        match report.skipped.first() {
            Some(Skipped { route, what, mend }) if is_required => {
                let why = format!("{route} is required (LOBE_REQUIRE_TOOLS=1) but missing: {what}; {mend}");
                Err(Failure(why))
            }
            _ if report.holds() => Ok(()),
            _ => Err(Failure(report.kernels.iter().map(shown).collect())),
        }
    }

    /// The part of the report that the test named `test` of `kernel` is for.
    ///
    /// # Errors
    /// When an option is none, a file cannot be read, or a driver does not open.
    pub fn report(&self, kernel: FunctionRef, test: &str) -> Result<Report, String> {
        let asked = Asked::of(test)?;
        let cases = Cases::of_package(self.folder);
        let plan = Plan {
            inputs: self.options.inputs,
            seed: self.options.seed,
            expected: self.options.expected(self.folder, &cases).map_err(|e| e.to_string())?,
            cases,
            mapping: Mapping::none(),
            sanitize: asked == Asked::Sanitized,
            accuracy: self.options.accuracy()?,
            drivers: 0,
            search: None,
        };
        let mut opened = asked.open(self.routes)?;
        let report = Report::new("check", plan.seed).with_accuracy(plan.accuracy);
        let mut report = report.with_routes(&opened.executors);
        report.part = Some(self.part(kernel().name, test));
        let is_run = opened.skipped.is_empty() || !opened.executors.is_empty();
        report.skipped = opened.skipped;
        if is_run {
            let mut found = judge(kernel, &plan, &mut opened.executors, &|_| {});
            keep(&mut found, &asked);
            let again = |args: &serde_json::Value| self.again(kernel().name, test, args);
            found
                .answers
                .iter_mut()
                .filter_map(|a| a.worst.as_mut())
                .for_each(|w| w.again = Some(again(&w.args)));
            report.kernels.push(found);
        }
        Ok(report)
    }

    fn part(&self, kernel: &str, test: &str) -> Part {
        let tests = || FIRST.iter().chain(self.routes).chain([&LAST]);
        let parts =
            self.kernels.iter().flat_map(|kernel| tests().map(move |test| format!("{kernel}::{test}")));
        let whole = Whole {
            whole: format!("{} {}", self.package, self.module),
            parts: parts.collect(),
            kernels: self.kernels.iter().map(|name| (*name).to_owned()).collect(),
        };
        Part { whole, name: format!("{kernel}::{test}"), inputs: self.options.inputs }
    }

    /// The command, for the package's folder, that lists a row, so that it is always taken, and runs the test again.
    fn again(&self, kernel: &str, test: &str, args: &serde_json::Value) -> String {
        let module = self.module.split_once("::").map_or("", |(_, module)| module);
        let cases = Cases::of_package(self.folder);
        // The same on every machine, wherever the package lies there.
        let near = |path: &Path| path.strip_prefix(self.folder).unwrap_or(path).display().to_string();
        let (folder, rows) = (near(cases.folder()), near(&cases.rows(kernel)));
        let again = format!("cargo test -p {} {module}::{kernel}::{test}", self.package);
        format!("mkdir -p {folder} && echo '{args}' >> {rows} && {again}")
    }

    /// Says aloud, past the capture of test runners, that a route is missing.
    fn tell(&self, kernel: &str, test: &str, Skipped { route, what, mend }: &Skipped) {
        use std::io::Write;
        let _ = writeln!(std::io::stderr(), "SKIPPED: {kernel}::{test}: {route} is missing: {what}; {mend}");
    }

    /// Writes the part of a report that a test is.
    fn leave(&self, folder: PathBuf, kernel: &str, test: &str, report: &Report) -> Outcome {
        let module = self.module.replace("::", ".");
        let path = folder.join(format!("{}.{module}.{kernel}.{test}.json", self.package));
        let written = std::fs::create_dir_all(&folder)
            .and_then(|()| files::write(&path, json::render(report).as_bytes()));
        written.map_err(|cause| {
            Failure(format!("{}: cannot be written: {cause}; {REPORT_DIR} names its folder", path.display()))
        })
    }
}

/// Drops answers that other tests are for; one that says why the kernel cannot be judged is for all.
fn keep(report: &mut KernelReport, asked: &Asked) {
    if report.answers.iter().any(|answer| asked.is_answered_by(answer)) {
        report.answers.retain(|answer| asked.is_answered_by(answer));
    }
}

fn shown(report: &KernelReport) -> String {
    human::render_kernel(report, human::Style::default())
}
