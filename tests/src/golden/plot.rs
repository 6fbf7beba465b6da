//! Kernels over a grid of two of their arguments.

use super::Axis;
use lobe_backends::executor::Program;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::data::Columns;
use lobe_codegen::def::Scalar;
use lobe_golden::Golden;
use lobe_golden::image::Picture;
use lobe_kernels::registry::{KERNELS, PARTS};
use std::collections::BTreeMap;

/// The kernel of this name.
pub(super) fn program(name: &str) -> Result<Program, String> {
    let found = KERNELS.iter().chain(PARTS).find(|kernel| kernel().name == name);
    let kernel = found.ok_or_else(|| format!("there is no kernel `{name}`; `lobe list` names all"))?;
    Program::new(*kernel).map_err(|error| error.to_string())
}

/// A row of arguments for each pixel, row by row from the top.
pub(super) fn arguments(
    program: &Program,
    [width, height]: [u32; 2],
    [columns, rows]: [&Axis; 2],
    fixed: &BTreeMap<String, f64>,
) -> Result<Columns, String> {
    let named = |name: &str| program.params().iter().any(|leaf| leaf.path == name);
    let known = || program.params().iter().map(|leaf| leaf.path.clone()).collect::<Vec<_>>().join(", ");
    let all = [&columns.argument, &rows.argument].into_iter().chain(fixed.keys());
    if let Some(name) = all.into_iter().find(|name| !named(name)) {
        return Err(format!("{} has no argument {name}; it has {}", program.name(), known()));
    }
    let count = (width * height) as usize;
    let mut found = Columns { columns: Vec::new(), rows: count };
    for leaf in program.params() {
        let value = |at: usize| {
            let (x, y) = (at as u32 % width, at as u32 / width);
            match () {
                () if leaf.path == columns.argument => Some(columns.at(x, width)),
                () if leaf.path == rows.argument => Some(rows.at(y, height)),
                () => fixed.get(&leaf.path).copied(),
            }
        };
        let word = |at: usize| -> Result<u32, String> {
            let value = value(at).ok_or_else(|| {
                format!("{} needs {}: it is no side of the plot and not fixed", program.name(), leaf.path)
            })?;
            match leaf.scalar {
                Scalar::F32 => Ok((value as f32).to_bits()),
                Scalar::U32 if value >= 0.0 && value.fract() == 0.0 => Ok(value as u32),
                Scalar::I32 if value.fract() == 0.0 => Ok(value as i32 as u32),
                other => Err(format!("{}: {value} is no {other:?}", leaf.path)),
            }
        };
        found.columns.push((0..count).map(word).collect::<Result<_, _>>()?);
    }
    Ok(found)
}

impl Axis {
    /// The value at one of `count` places.
    fn at(&self, place: u32, count: u32) -> f64 {
        let share = f64::from(place) / f64::from(count.max(2) - 1);
        match self.is_logarithmic {
            // The ends to the last digit.
            _ if place == 0 => self.from,
            _ if place + 1 == count => self.to,
            true => libm::exp(libm::log(self.from) * (1.0 - share) + libm::log(self.to) * share),
            false => self.from * (1.0 - share) + self.to * share,
        }
    }
}

/// A channel for each scalar of the result; all are the first where there is one.
const CHANNELS: usize = 3;

/// The scalar of the result that a channel shows, of so many; none for one that stays black.
fn shown(channel: usize, scalars: usize) -> Option<usize> {
    if scalars == 1 { Some(0) } else { (channel < scalars).then_some(channel) }
}

/// The values of the kernel with what is permitted.
pub(super) fn truth(program: &Program, args: &Columns, size: [u32; 2]) -> Result<Golden, String> {
    let shadow = program.shadow(args, None).map_err(|error| error.to_string())?;
    let scalars = shadow.columns.len();
    if !(1..=CHANNELS).contains(&scalars) {
        return Err(format!("{} returns {scalars} scalars; a plot shows 1 to 3", program.name()));
    }
    let (mut truth, mut permitted) = (Vec::new(), Vec::new());
    for row in 0..shadow.rows {
        for channel in 0..CHANNELS {
            let (value, bound) = match shown(channel, scalars).map(|at| &shadow.columns[at]) {
                None => (0.0, 0.0),
                Some(ShadowColumn::Float { exact, bound, .. }) => (exact[row], bound[row]),
                Some(ShadowColumn::Word { .. }) => {
                    return Err(format!("{} returns integers; a plot shows floats", program.name()));
                }
            };
            truth.push(value);
            permitted.push(if shadow.indeterminate[row] { f64::INFINITY } else { bound });
        }
    }
    Golden::new(size, &truth, &permitted).map_err(|error| error.to_string())
}

/// The results of a route as a picture.
pub(super) fn picture(found: &Columns, size: [u32; 2]) -> Result<Picture, String> {
    let value = |row: usize, channel: usize| {
        let at = shown(channel, found.width());
        at.map_or(0.0, |at| f32::from_bits(found.columns[at][row]))
    };
    let values = (0..found.rows).flat_map(|row| (0..CHANNELS).map(move |c| (row, c)));
    Ok(Picture { size, values: values.map(|(row, channel)| value(row, channel)).collect() })
}
