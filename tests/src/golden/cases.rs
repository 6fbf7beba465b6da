//! What there are golden images of: a file of cases, and each of them opened.

use crate::proxies::{self, Proxies};
use crate::render::{Method, Settings, VirtualLights};
use crate::scene::{Choices, Scene};
use lobe_golden::{CaseName, Hash, Name};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Columns and rows where a case does not say.
const SIZE: [u32; 2] = [128, 128];
/// The scene of plots.
const PLOTS: &str = "plots";

/// The file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    render: Vec<RenderFile>,
    #[serde(default)]
    plot: Vec<PlotFile>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RenderFile {
    scene: Name,
    file: PathBuf,
    methods: Vec<String>,
    #[serde(default = "default_size")]
    size: [u32; 2],
    lights: Option<u32>,
    map: Option<u32>,
    #[serde(default)]
    most_indeterminate: f64,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct PlotFile {
    name: Name,
    kernel: String,
    columns: Axis,
    rows: Axis,
    #[serde(default)]
    fixed: BTreeMap<String, f64>,
    #[serde(default = "default_size")]
    size: [u32; 2],
    #[serde(default)]
    most_indeterminate: f64,
}

fn default_size() -> [u32; 2] {
    SIZE
}

/// An argument along a side of a plot, both ends included.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// The scalar of the arguments, as `lobe.axis.x`.
    pub argument: String,
    /// At the left, or at the top.
    pub from: f64,
    /// At the right, or at the bottom.
    pub to: f64,
    /// Whether it grows by factors.
    #[serde(default)]
    pub is_logarithmic: bool,
}

/// A picture that there is a golden of.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its name.
    pub name: CaseName,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Share of pixels of which nothing may be promised.
    pub most_indeterminate: f64,
    /// What it shows.
    pub subject: Subject,
}

/// What a picture shows.
#[derive(Debug, Clone)]
pub enum Subject {
    /// A scene, by a method.
    Render {
        /// The file of the scene.
        file: PathBuf,
        /// How it is rendered.
        settings: Settings,
    },
    /// A kernel over a grid.
    Plot {
        /// The kernel.
        kernel: String,
        /// The argument along a row.
        columns: Axis,
        /// The argument along a column.
        rows: Axis,
        /// The other arguments.
        fixed: BTreeMap<String, f64>,
    },
}

/// Why there are no cases.
#[derive(Debug, thiserror::Error)]
pub enum CasesError {
    /// The file cannot be read.
    #[error("{}: cannot be read: {cause}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// The file is no list of cases.
    #[error("{}: {why}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        why: String,
    },
}

/// Reads the cases of a file; scenes are in the folder `scenes`.
///
/// # Errors
/// When it cannot be read, states no case, or states one that is none.
pub fn read(path: &Path, scenes: &Path) -> Result<Vec<Case>, CasesError> {
    let text =
        std::fs::read_to_string(path).map_err(|cause| CasesError::Read { path: path.to_owned(), cause })?;
    parse(&text, scenes).map_err(|why| CasesError::Form { path: path.to_owned(), why })
}

/// The cases of a text.
///
/// # Errors
/// What is wrong with it.
pub fn parse(text: &str, scenes: &Path) -> Result<Vec<Case>, String> {
    let file: File = toml::from_str(text).map_err(|error| error.to_string())?;
    let mut cases = Vec::new();
    for plot in file.plot {
        cases.push(plot.case()?);
    }
    for render in &file.render {
        for method in &render.methods {
            cases.push(render.case(method, scenes)?);
        }
    }
    for (at, case) in cases.iter().enumerate() {
        let [width, height] = case.size;
        if !(1..=512).contains(&width) || !(1..=512).contains(&height) {
            return Err(format!("{}: {width} x {height} pixels; take 1 to 512 along a side", case.name));
        }
        if !(0.0..=1.0).contains(&case.most_indeterminate) {
            return Err(format!("{}: most_indeterminate is a share, 0 to 1", case.name));
        }
        if cases[..at].iter().any(|before| before.name == case.name) {
            return Err(format!("{}: there are two cases of this name", case.name));
        }
    }
    match cases.is_empty() {
        true => Err("it states no case: nothing would be judged".to_owned()),
        false => Ok(cases),
    }
}

impl PlotFile {
    fn case(self) -> Result<Case, String> {
        for axis in [&self.columns, &self.rows] {
            let is_sound = axis.from.is_finite() && axis.to.is_finite();
            if !is_sound || (axis.is_logarithmic && (axis.from <= 0.0 || axis.to <= 0.0)) {
                let Axis { argument, from, to, .. } = axis;
                return Err(format!("{PLOTS}/{}: {argument} from {from} to {to} is no axis", self.name));
            }
        }
        let scene = PLOTS.parse::<Name>().map_err(|error| error.to_string())?;
        Ok(Case {
            name: CaseName { scene, method: self.name },
            size: self.size,
            most_indeterminate: self.most_indeterminate,
            subject: Subject::Plot {
                kernel: self.kernel,
                columns: self.columns,
                rows: self.rows,
                fixed: self.fixed,
            },
        })
    }
}

impl RenderFile {
    fn case(&self, method: &str, scenes: &Path) -> Result<Case, String> {
        let of_scene = |error: String| format!("{}: {error}", self.scene);
        let parsed: Method = method.parse().map_err(of_scene)?;
        if parsed == Method::Reference {
            return Err(of_scene(
                "`reference` draws by chance, and has no golden; take another method".to_owned(),
            ));
        }
        let default = VirtualLights::default();
        let virtual_lights = VirtualLights {
            count: self.lights.unwrap_or(default.count),
            map: self.map.unwrap_or(default.map),
            ..default
        };
        let method = method.parse::<Name>().map_err(|error| of_scene(error.to_string()))?;
        Ok(Case {
            name: CaseName { scene: self.scene.clone(), method },
            size: self.size,
            most_indeterminate: self.most_indeterminate,
            subject: Subject::Render {
                file: scenes.join(&self.file),
                settings: Settings { method: parsed, virtual_lights, ..Settings::default() },
            },
        })
    }
}

impl Case {
    /// `render` or `plot`.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self.subject {
            Subject::Render { .. } => "render",
            Subject::Plot { .. } => "plot",
        }
    }

    /// Parameters, by name.
    #[must_use]
    pub fn settings(&self) -> BTreeMap<String, String> {
        let mut found = BTreeMap::new();
        let mut put = |name: &str, value: String| drop(found.insert(name.to_owned(), value));
        put("size", format!("{} x {}", self.size[0], self.size[1]));
        match &self.subject {
            Subject::Render { settings, .. } => {
                put("method", settings.method.to_string());
                if settings.method.rect_pass().is_some() {
                    put("radius_factor", settings.radius_factor.to_string());
                }
                if settings.method.has_virtual_lights() {
                    put("virtual_lights", format!("{:?}", settings.virtual_lights));
                }
            }
            Subject::Plot { kernel, columns, rows, fixed } => {
                put("kernel", kernel.clone());
                put("columns", columns.to_string());
                put("rows", rows.to_string());
                for (argument, value) in fixed {
                    put(&format!("fixed {argument}"), value.to_string());
                }
            }
        }
        found
    }

    /// The hash of the parameters.
    #[must_use]
    pub fn settings_hash(&self) -> Hash {
        let lines = self.settings().into_iter().map(|(name, value)| format!("{name}\t{value}\n"));
        Hash::of(lines.collect::<String>().as_bytes())
    }
}

impl std::fmt::Display for Axis {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { argument, from, to, is_logarithmic } = self;
        let how = if *is_logarithmic { ", by factors" } else { "" };
        write!(f, "{argument} from {from} to {to}{how}")
    }
}

/// A scene, what stands in its place, and the hash of its file.
pub(super) fn open_scene(file: &Path, size: [u32; 2]) -> Result<(Scene, Proxies, Hash), String> {
    let bytes =
        std::fs::read(file).map_err(|cause| format!("{}: cannot be read: {cause}", file.display()))?;
    if file.extension().is_none_or(|ending| ending != "json") {
        let why = "a golden's scene is one file, in JSON: others may load files that no hash speaks of";
        return Err(format!("{}: {why}", file.display()));
    }
    let of_file = |error: String| format!("{}: {error}", file.display());
    let mut scene = Scene::open(file, &Choices::default()).map_err(|error| of_file(error.to_string()))?;
    scene.camera.size = size;
    let proxies = proxies::proxies(&scene, &proxies::Options::default());
    Ok((scene, proxies.map_err(|error| of_file(error.to_string()))?, Hash::of(&bytes)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        let error = parse(text, Path::new("scenes")).expect_err("it is no list of cases");
        assert!(error.contains(expected), "{error}");
    }

    #[test]
    fn what_is_no_list_of_cases_is_refused() {
        check("", "it states no case");
        check("[[plots]]\n", "unknown field `plots`");
        let render = |scene: &str, method: &str, more: &str| {
            format!("[[render]]\nscene = {scene:?}\nfile = \"a.json\"\nmethods = [{method:?}]\n{more}\n")
        };
        check(&render("../a", "direct", ""), "is no name");
        check(&render("a", "dire", ""), "`dire` is no method");
        check(&render("a", "reference", ""), "by chance");
        check(&render("a", "direct", "size = [0, 4]"), "0 x 4 pixels");
        check(&render("a", "direct", "most_indeterminate = 2.0"), "is a share");
        check(&(render("a", "direct", "") + &render("a", "direct", "")), "two cases");
        let plot = |from: &str| {
            let rows = "rows = { argument = \"y\", from = 0.0, to = 1.0 }";
            format!(
                "[[plot]]\nname = \"p\"\nkernel = \"k\"\ncolumns = {{ argument = \"x\", from = {from}, to = 1.0, is_logarithmic = true }}\n{rows}\n"
            )
        };
        check(&plot("0.0"), "is no axis");
        check(&plot("nan"), "is no axis");
    }

    #[test]
    fn parameters_make_the_hash() {
        let text = |size: u32| {
            format!(
                "[[render]]\nscene = \"a\"\nfile = \"a.json\"\nmethods = [\"rect\"]\nsize = [{size}, 4]\n"
            )
        };
        let hash = |size| parse(&text(size), Path::new("")).expect("cases")[0].settings_hash();
        assert_eq!(hash(4), hash(4));
        assert_ne!(hash(4), hash(5));
    }
}
