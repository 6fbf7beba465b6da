//! Proxies as JSON: `tests/schema/proxies-1.json`.

use super::{Proxies, ProxiesError, Proxy, Summary};
use serde::{Deserialize, Serialize};

/// Version of the format.
const SCHEMA: u32 = 1;
/// Its name.
const REPORT: &str = "proxies";

#[derive(Serialize)]
struct Written<'a> {
    schema: u32,
    report: &'static str,
    #[serde(flatten)]
    summary: Summary,
    proxies: &'a [Proxy],
}

#[derive(Deserialize)]
struct Read {
    schema: u32,
    report: String,
    area: f64,
    proxies: Vec<Proxy>,
}

/// Three numbers in brackets.
pub(super) mod triple {
    use lobe_codegen::prelude::Vec3;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(in crate::proxies) fn serialize<S: Serializer>(
        value: &Vec3,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        value.to_array().serialize(serializer)
    }

    pub(in crate::proxies) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec3, D::Error> {
        <[f32; 3]>::deserialize(deserializer).map(Vec3::from_array)
    }
}

impl Proxies {
    /// The report as JSON, a proxy a line.
    ///
    /// # Errors
    /// When a number is not finite, which no proxies of [`super::proxies`] have.
    pub fn to_json(&self) -> Result<String, ProxiesError> {
        let refused = |error: serde_json::Error| ProxiesError::Json { message: error.to_string() };
        let head = Written { schema: SCHEMA, report: REPORT, summary: self.summary(), proxies: &[] };
        let head = serde_json::to_string(&head).map_err(refused)?;
        let lines: Result<Vec<_>, _> = self.rectangles.iter().map(serde_json::to_string).collect();
        let lines = lines.map_err(refused)?.join(",\n");
        Ok(format!("{}\n{lines}\n]}}\n", head.trim_end_matches("]}")))
    }

    /// Reads what [`Proxies::to_json`] writes.
    ///
    /// # Errors
    /// When the text is no such JSON, or a number is out of its range.
    pub fn from_json(text: &str) -> Result<Self, ProxiesError> {
        let Read { schema, report, area, proxies } = serde_json::from_str(text)
            .map_err(|error| ProxiesError::Json { message: format!("these are no proxies: {error}") })?;
        if (schema, report.as_str()) != (SCHEMA, REPORT) {
            let message = format!(
                "it is {report:?} of version {schema}, and this reads {REPORT:?} of version {SCHEMA}"
            );
            return Err(ProxiesError::Json { message });
        }
        if proxies.is_empty() {
            return refused("proxies".to_owned(), "there is none; `lobe proxies SCENE` makes them");
        }
        if !(0.0..f64::INFINITY).contains(&area) {
            return refused("area".to_owned(), "it is negative or no number");
        }
        proxies.iter().enumerate().try_for_each(|(i, proxy)| check(i, proxy))?;
        Ok(Self { rectangles: proxies, area })
    }
}

fn refused<T>(at: String, message: &str) -> Result<T, ProxiesError> {
    Err(ProxiesError::Value { at, message: message.to_owned() })
}

/// How far from one a length may be, and from a right angle a cosine.
const SLANT: f32 = 1e-4;
/// Coordinates and lengths, m.
const LARGEST: f32 = 1e9;

fn check(index: usize, proxy: &Proxy) -> Result<(), ProxiesError> {
    let is_unit = |length: f32| (length - 1.0).abs() <= SLANT;
    let is_length = |half: f32| half > 0.0 && half <= LARGEST;
    for (holds, member, message) in [
        (proxy.position.abs().max_element() <= LARGEST, "position", "it is not in -1e9 ..= 1e9"),
        (is_unit(proxy.normal.length()), "normal", "it is not of length one"),
        (is_unit(proxy.tangent.length()), "tangent", "it is not of length one"),
        (proxy.normal.dot(proxy.tangent).abs() <= SLANT, "tangent", "it is not perpendicular to the normal"),
        (is_length(proxy.half_x), "half_x", "it is not above 0 and at most 1e9"),
        (is_length(proxy.half_y), "half_y", "it is not above 0 and at most 1e9"),
        (proxy.fill > 0.0 && proxy.fill <= 1.0, "fill", "it is not above 0 and at most 1"),
    ] {
        if !holds {
            return refused(format!("proxies[{index}].{member}"), message);
        }
    }
    Ok(())
}
