//! A figure as SVG: text stays text, and the same figure gives the same bytes.

use super::axis::{Axis, Scale};
use super::plot::{Corner, Figure, Mark, Panel, Series};
use super::theme::{Palette, Theme};
use std::fmt::Write;

/// Width of a figure.
const WIDTH: f64 = 820.0;
const MARGIN: f64 = 18.0;
/// Between a panel's frame and the left end of its cell: numbers and label.
const LEFT: f64 = 58.0;
const RIGHT: f64 = 10.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 46.0;
/// Height of a panel's frame.
const HEIGHT: f64 = 208.0;
const HEADING: f64 = 44.0;
const LINE: f64 = 17.0;
/// Characters of a line of the caption.
const CAPTION: usize = 124;
const FONT: &str = "Ubuntu, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";

/// A rectangle of the picture.
#[derive(Clone, Copy)]
struct Frame {
    x: f64,
    y: f64,
    width: f64,
    height: f64,
}

/// The name of the file.
#[must_use]
pub fn file_name(figure: &Figure, theme: Theme) -> String {
    format!("{}-{}.svg", figure.name, theme.name())
}

struct Writer {
    out: String,
    palette: Palette,
}

/// The text of the file.
#[must_use]
pub fn render(figure: &Figure, theme: Theme) -> String {
    let caption = wrap(&figure.caption, CAPTION);
    let rows = figure.panels.len().div_ceil(2);
    let body = rows as f64 * (TOP + HEIGHT + BOTTOM);
    let height = HEADING + body + LINE * caption.len() as f64 + MARGIN;
    let mut writer = Writer { out: String::new(), palette: theme.palette() };
    writer.begin(figure, height);
    let cell = (WIDTH - 2.0 * MARGIN) / 2.0;
    for (index, panel) in figure.panels.iter().enumerate() {
        let x = MARGIN + cell * (index % 2) as f64 + LEFT;
        let y = HEADING + (index / 2) as f64 * (TOP + HEIGHT + BOTTOM) + TOP;
        writer.panel(index, panel, Frame { x, y, width: cell - LEFT - RIGHT, height: HEIGHT });
    }
    for (index, line) in caption.iter().enumerate() {
        let y = HEADING + body + LINE * (index as f64 + 0.7);
        let quiet = writer.palette.quiet;
        writer.text(MARGIN, y, 12.5, quiet, "start", line);
    }
    writer.out + "</svg>\n"
}

impl Writer {
    fn begin(&mut self, figure: &Figure, height: f64) {
        let Palette { page, text, .. } = self.palette;
        let _ = writeln!(
            self.out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} \
             {height}\" font-family=\"{FONT}\" role=\"img\">\n<title>{}</title>\n<desc>{}</desc>\n<rect width=\"100%\" \
             height=\"100%\" fill=\"{page}\"/>",
            plain(&figure.title),
            plain(&figure.caption)
        );
        self.text(MARGIN, 30.0, 18.0, text, "start", &figure.title);
    }

    fn panel(&mut self, index: usize, panel: &Panel, frame: Frame) {
        let Frame { x, y, width, height } = frame;
        let (ink, outline) = (self.palette.text, self.palette.frame);
        self.text(x, y - 9.0, 13.5, ink, "start", &panel.title);
        self.ticks(panel, frame);
        let _ = writeln!(
            self.out,
            "<clipPath id=\"p{index}\"><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/></clipPath>\n<g \
             clip-path=\"url(#p{index})\">"
        );
        for series in &panel.series {
            self.series(panel, frame, series);
        }
        let _ = writeln!(
            self.out,
            "</g>\n<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"{outline}\"/>"
        );
        if let Some(corner) = panel.legend {
            self.legend(panel, frame, corner);
        }
    }

    fn ticks(&mut self, panel: &Panel, frame: Frame) {
        let Frame { x, y, width, height } = frame;
        let Palette { text, quiet, grid, .. } = self.palette;
        for place in minor(&panel.x) {
            let at = x + place * width;
            self.rule(at, y + height, at, y + height + 3.0);
        }
        for place in minor(&panel.y) {
            let at = y + (1.0 - place) * height;
            self.rule(x - 3.0, at, x, at);
        }
        for tick in panel.x.ticks() {
            let at = x + tick.at * width;
            self.line(at, y, at, y + height, grid);
            self.rule(at, y + height, at, y + height + 5.0);
            self.text(at, y + height + 18.0, 12.0, quiet, "middle", &tick.label);
        }
        for tick in panel.y.ticks() {
            let at = y + (1.0 - tick.at) * height;
            self.line(x, at, x + width, at, grid);
            self.rule(x - 5.0, at, x, at);
            self.text(x - 8.0, at + 4.0, 12.0, quiet, "end", &tick.label);
        }
        self.text(x + 0.5 * width, y + height + 36.0, 12.5, text, "middle", &panel.x.label);
        let (cx, cy) = (x - 44.0, y + 0.5 * height);
        let _ = write!(self.out, "<g transform=\"translate({cx:.2} {cy:.2}) rotate(-90)\">");
        self.text(0.0, 0.0, 12.5, text, "middle", &panel.y.label);
        let _ = writeln!(self.out, "</g>");
    }

    fn series(&mut self, panel: &Panel, frame: Frame, series: &Series) {
        let colour = self.palette.series[series.colour % self.palette.series.len()];
        match &series.mark {
            Mark::Line(points) => {
                let _ = writeln!(
                    self.out,
                    "<path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.9\" stroke-linejoin=\"round\"/>",
                    path(panel, frame, points)
                );
            }
            Mark::Dashes(points) => {
                let _ = writeln!(
                    self.out,
                    "<path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.9\" stroke-dasharray=\"6 4\"/>",
                    path(panel, frame, points)
                );
            }
            Mark::Dots(points) => {
                for point in points {
                    let (cx, cy) = place(panel, frame, *point);
                    let _ = writeln!(
                        self.out,
                        "<circle cx=\"{cx:.2}\" cy=\"{cy:.2}\" r=\"2.6\" fill=\"{colour}\"/>"
                    );
                }
            }
            Mark::Band(points) => {
                let upper = points.iter().map(|(x, _, high)| (*x, *high));
                let lower = points.iter().rev().map(|(x, low, _)| (*x, *low));
                let outline: Vec<(f64, f64)> = upper.chain(lower).collect();
                let _ = writeln!(
                    self.out,
                    "<path d=\"{}Z\" fill=\"{colour}\" fill-opacity=\"0.55\" stroke=\"{colour}\" \
                     stroke-width=\"0.5\"/>",
                    path(panel, frame, &outline)
                );
            }
        }
    }

    fn legend(&mut self, panel: &Panel, frame: Frame, corner: Corner) {
        let entries: Vec<&Series> = panel.series.iter().filter(|s| !s.label.is_empty()).collect();
        let longest = entries.iter().map(|s| plain(&s.label).chars().count()).max().unwrap_or(0);
        let (width, height) = (44.0 + 6.4 * longest as f64, 8.0 + LINE * entries.len() as f64);
        let x = match corner {
            Corner::TopLeft | Corner::BottomLeft => frame.x + 8.0,
            Corner::TopRight | Corner::BottomRight => frame.x + frame.width - 8.0 - width,
        };
        let y = match corner {
            Corner::TopLeft | Corner::TopRight => frame.y + 8.0,
            Corner::BottomLeft | Corner::BottomRight => frame.y + frame.height - 8.0 - height,
        };
        let Palette { page, grid, text, .. } = self.palette;
        let _ = writeln!(
            self.out,
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" rx=\"4\" fill=\"{page}\" \
             fill-opacity=\"0.88\" stroke=\"{grid}\"/>"
        );
        for (index, series) in entries.into_iter().enumerate() {
            let middle = y + 4.0 + LINE * (index as f64 + 0.5);
            self.key(x + 8.0, middle, series);
            self.text(x + 38.0, middle + 4.2, 12.0, text, "start", &series.label);
        }
    }

    /// The sign of a series, 22 wide.
    fn key(&mut self, x: f64, y: f64, series: &Series) {
        let colour = self.palette.series[series.colour % self.palette.series.len()];
        let end = x + 22.0;
        let _ = match series.mark {
            Mark::Line(_) => writeln!(
                self.out,
                "<path d=\"M{x:.2} {y:.2}H{end:.2}\" stroke=\"{colour}\" stroke-width=\"1.9\"/>"
            ),
            Mark::Dashes(_) => writeln!(
                self.out,
                "<path d=\"M{x:.2} {y:.2}H{end:.2}\" stroke=\"{colour}\" stroke-width=\"1.9\" stroke-dasharray=\"6 4\"/>"
            ),
            Mark::Dots(_) => {
                writeln!(
                    self.out,
                    "<circle cx=\"{:.2}\" cy=\"{y:.2}\" r=\"2.6\" fill=\"{colour}\"/>",
                    x + 11.0
                )
            }
            Mark::Band(_) => writeln!(
                self.out,
                "<rect x=\"{x:.2}\" y=\"{:.2}\" width=\"22\" height=\"8\" fill=\"{colour}\" fill-opacity=\"0.55\"/>",
                y - 4.0
            ),
        };
    }

    fn rule(&mut self, x0: f64, y0: f64, x1: f64, y1: f64) {
        let frame = self.palette.frame;
        self.line(x0, y0, x1, y1, frame);
    }

    fn line(&mut self, x0: f64, y0: f64, x1: f64, y1: f64, colour: &str) {
        let _ = writeln!(self.out, "<path d=\"M{x0:.2} {y0:.2}L{x1:.2} {y1:.2}\" stroke=\"{colour}\"/>");
    }

    fn text(&mut self, x: f64, y: f64, size: f64, colour: &str, anchor: &str, text: &str) {
        let _ = writeln!(
            self.out,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-size=\"{size}\" fill=\"{colour}\" text-anchor=\"{anchor}\">{}</text>",
            marked(text, size)
        );
    }
}

/// Places between the numbered ticks of a logarithmic axis: 2 ..= 9 of each decade, if there are few.
fn minor(axis: &Axis) -> Vec<f64> {
    let decades = libm::log10(axis.range.1 / axis.range.0).round() as i32;
    if axis.scale == Scale::Linear || decades > 6 {
        return Vec::new();
    }
    let decade = |d: i32| (2..10).map(move |digit| f64::from(digit) * libm::pow(10.0, d.into()));
    (0..decades).flat_map(decade).map(|times| axis.place(axis.range.0 * times)).collect()
}

fn place(panel: &Panel, frame: Frame, (x, y): (f64, f64)) -> (f64, f64) {
    // Far outside is as good as anywhere outside, and keeps the numbers short.
    let up = panel.y.place(y).clamp(-1.0, 2.0);
    (frame.x + panel.x.place(x) * frame.width, frame.y + (1.0 - up) * frame.height)
}

fn path(panel: &Panel, frame: Frame, points: &[(f64, f64)]) -> String {
    let mut out = String::new();
    for (index, point) in points.iter().enumerate() {
        let (x, y) = place(panel, frame, *point);
        let _ = write!(out, "{}{x:.2} {y:.2}", if index == 0 { "M" } else { "L" });
    }
    out
}

/// Escaped for XML, with `^{..}` and `_{..}` as smaller text above and below the line.
fn marked(text: &str, size: f64) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((start, inner, after)) = mark(rest) {
        let shift = if rest[start..].starts_with('^') { -0.36 * size } else { 0.22 * size };
        let small = 0.75 * size;
        let (before, inner) = (escape(&rest[..start]), escape(inner));
        let _ = write!(
            out,
            "{before}<tspan dy=\"{shift:.2}\" font-size=\"{small:.2}\">{inner}</tspan><tspan dy=\"{:.2}\">",
            -shift
        );
        // The way back holds the text up to the next mark.
        let next = mark(after).map_or(after.len(), |(start, ..)| start);
        let _ = write!(out, "{}</tspan>", escape(&after[..next]));
        rest = &after[next..];
    }
    out + &escape(rest)
}

/// The first mark in `text`: where it begins, what is in it, and what follows.
fn mark(text: &str) -> Option<(usize, &str, &str)> {
    let start = text.find("^{").into_iter().chain(text.find("_{")).min()?;
    let (inner, after) = text[start + 2..].split_once('}')?;
    Some((start, inner, after))
}

/// Escaped for XML, the marks read as words.
fn plain(text: &str) -> String {
    escape(&text.replace("^{", "^").replace("_{", "_").replace('}', ""))
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let used = lines.last().map_or(0, |line| plain(line).chars().count());
        if used > 0 && used + 1 + plain(word).chars().count() > width {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn raised_text_comes_back_to_the_line() {
        assert_eq!(marked("a < b", 10.0), "a &lt; b");
        assert!(marked("clamped_cosine by 10^{−4}", 10.0).contains(">−4</tspan>"));
        let out = marked("10^{−4} of A_{k}", 10.0);
        assert_eq!(out.matches("<tspan").count(), out.matches("</tspan>").count());
        assert!(out.contains("dy=\"-3.60\"") && out.contains("dy=\"3.60\"> of A</tspan>"), "{out}");
    }

    #[test]
    fn captions_are_wrapped_between_words() {
        assert_eq!(wrap("aa bb cc", 5), ["aa bb", "cc"]);
    }
}
