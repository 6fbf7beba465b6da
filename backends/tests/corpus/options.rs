//! What a module's first lines say about its run.
//!
//! Lines `// lobe: OPTIONS` hold the options with which `lobe run` would run the file:
//!
//! - `--workgroups X,Y,Z`
//! - `--size NAME=BYTES`, of a buffer whose type does not say it
//! - `--input NAME=zeros|random:SEED`, of a buffer or texture, else `random:0`
//! - `--texture NAME=FORMAT:WxHxD[:LAYERS[:LEVELS]]`
//! - `--sampler NAME=WORD,...` of `linear`, `mip-linear`, `repeat`, `mirror`, `less`, `greater-equal`, ..., `lod:LOW:HIGH`
//! - `--within NAME=BOUND`: floats may differ by so much; else they are the same bits

use lobe_backends::texture::{Address, Compare, Dimension, Filter, Format, Sampler, TextureShape};
use std::collections::HashMap;

/// How a buffer or texture begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Fill {
    Zeros,
    Random(u64),
}

/// A texture's shape, but for what its variable says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sketch {
    pub(crate) format: Format,
    size: [u32; 3],
    layers: u32,
    levels: u32,
}

/// All options of a module; names are those of variables.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Options {
    pub(crate) groups: [u32; 3],
    pub(crate) inputs: HashMap<String, Fill>,
    pub(crate) sizes: HashMap<String, usize>,
    pub(crate) textures: HashMap<String, Sketch>,
    pub(crate) samplers: HashMap<String, Sampler>,
    pub(crate) within: HashMap<String, f64>,
}

impl Sketch {
    pub(crate) fn shape(&self, dimension: Dimension) -> TextureShape {
        let shape = TextureShape::new(self.format, dimension, self.size).levelled(self.levels);
        shape.layered(shape.layers.max(self.layers))
    }
}

/// What begins a line with options.
const MARK: &str = "// lobe: ";

/// Whether a text has options.
pub(crate) fn are_in(text: &str) -> bool {
    text.lines().any(|line| line.starts_with(MARK))
}

impl Options {
    /// The options in a text.
    pub(crate) fn of(text: &str) -> Result<Self, String> {
        let lines = text.lines().filter_map(|line| line.strip_prefix(MARK));
        let words: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
        let mut options = Self {
            groups: [1; 3],
            inputs: HashMap::new(),
            sizes: HashMap::new(),
            textures: HashMap::new(),
            samplers: HashMap::new(),
            within: HashMap::new(),
        };
        for pair in words.chunks(2) {
            let [option, value] = pair else {
                return Err(format!("{pair:?} lacks its value"));
            };
            options.add(option, value).ok_or_else(|| format!("`{option} {value}` means nothing"))?;
        }
        Ok(options)
    }

    fn add(&mut self, option: &str, value: &str) -> Option<()> {
        if option == "--workgroups" {
            self.groups = three(value, ',')?;
            return Some(());
        }
        let (name, value) = value.split_once('=')?;
        let name = name.to_owned();
        match option {
            "--input" => drop(self.inputs.insert(name, fill(value)?)),
            "--size" => drop(self.sizes.insert(name, value.parse().ok()?)),
            "--texture" => drop(self.textures.insert(name, sketch(value)?)),
            "--sampler" => drop(self.samplers.insert(name, sampler(value)?)),
            "--within" => drop(self.within.insert(name, value.parse().ok()?)),
            _ => return None,
        }
        Some(())
    }
}

fn three(text: &str, by: char) -> Option<[u32; 3]> {
    let numbers = text.split(by).map(|n| n.parse().ok()).collect::<Option<Vec<u32>>>()?;
    numbers.try_into().ok()
}

fn fill(text: &str) -> Option<Fill> {
    match text.split_once(':') {
        None if text == "zeros" => Some(Fill::Zeros),
        Some(("random", seed)) => Some(Fill::Random(seed.parse().ok()?)),
        _ => None,
    }
}

fn sketch(text: &str) -> Option<Sketch> {
    let mut parts = text.split(':');
    let format = Format::named(parts.next()?).ok()?;
    let size = three(parts.next()?, 'x')?;
    let mut number = || parts.next().map_or(Some(1), |n| n.parse().ok());
    Some(Sketch { format, size, layers: number()?, levels: number()? })
}

fn sampler(text: &str) -> Option<Sampler> {
    let mut sampler = Sampler::default();
    for word in text.split(',') {
        let compare = |compare| Some(compare);
        sampler.compare = match word {
            "never" => compare(Compare::Never),
            "less" => compare(Compare::Less),
            "equal" => compare(Compare::Equal),
            "less-equal" => compare(Compare::LessEqual),
            "greater" => compare(Compare::Greater),
            "not-equal" => compare(Compare::NotEqual),
            "greater-equal" => compare(Compare::GreaterEqual),
            "always" => compare(Compare::Always),
            _ => sampler.compare,
        };
        match word {
            "linear" => (sampler.magnify, sampler.minify) = (Filter::Linear, Filter::Linear),
            "mip-linear" => sampler.mip = Filter::Linear,
            "repeat" => sampler.address = [Address::Repeat; 3],
            "mirror" => sampler.address = [Address::MirrorRepeat; 3],
            "nearest" => {}
            other => match other.strip_prefix("lod:").and_then(|range| range.split_once(':')) {
                Some((low, high)) => sampler.lod = [low.parse().ok()?, high.parse().ok()?],
                None if sampler.compare.is_some() => {}
                None => return None,
            },
        }
    }
    Some(sampler)
}
