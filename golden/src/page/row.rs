//! A line of the page's list: what it is filtered, sorted and searched by. All else of a case is loaded when it is opened.

use serde_json::{Value, json};

/// Names of all routes: those of the report, and what its cases name besides.
pub(super) fn routes(report: &Value) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let cases = list(report, "items").iter().flat_map(|item| list(item, "routes"));
    for route in list(report, "routes").iter().chain(cases) {
        let name = text(route, "route");
        if !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names
}

pub(super) fn of(item: &Value, names: &[String], is_lacking: bool) -> Value {
    let routes = list(item, "routes").iter().map(|route| {
        let at = names.iter().position(|name| name == text(route, "route"));
        json!([at, text(route, "verdict"), text(route, "change")])
    });
    json!({
        "scene": text(item, "scene"),
        "method": text(item, "method"),
        "kind": text(item, "kind"),
        "size": item.get("size"),
        "verdict": text(item, "verdict"),
        "chain": item.get("chain").map_or("", |chain| text(chain, "hash")),
        "is_lacking": is_lacking,
        "is_pending": is_pending(item),
        "worst": worst(item),
        "routes": routes.collect::<Vec<Value>>(),
    })
}

/// Whether a new golden waits to be decided on: its truth was computed, and is not just the accepted one again.
fn is_pending(item: &Value) -> bool {
    let is_there = item["rendered"] == true && item["chain"]["hash"].is_string();
    is_there && item["verdict"] != "holds" && item["verdict"] != "failed"
}

/// The largest share of what is permitted, of all routes; null if none has one.
fn worst(item: &Value) -> Value {
    let share = |route: &Value| {
        let share = route.get("worst")?.get("share")?.clone();
        Some((number(&share)?, share))
    };
    let all = list(item, "routes").iter().filter_map(share);
    all.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(Value::Null, |(_, share)| share)
}

fn number(value: &Value) -> Option<f64> {
    match value.as_str() {
        Some("inf" | "nan") => Some(f64::INFINITY),
        Some(_) => None,
        None => value.as_f64(),
    }
}

fn text<'a>(value: &'a Value, name: &str) -> &'a str {
    value.get(name).and_then(Value::as_str).unwrap_or_default()
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value.get(name).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_share_is_that_of_all_routes() {
        let of = |shares: &[Value]| {
            let routes: Vec<Value> =
                shares.iter().map(|share| json!({ "worst": { "share": share } })).collect();
            worst(&json!({ "routes": routes }))
        };
        assert_eq!(of(&[json!(0.25), json!(1.5)]), json!(1.5));
        assert_eq!(of(&[json!("inf"), json!(1.5)]), json!("inf"));
        assert_eq!(of(&[Value::Null]), Value::Null);
    }
}
