//! What a check asks beside the comparison with the interpreter: of the bounds, and of routes to the same driver.

use super::compare::{Compared, Permit, compare};
use super::given::Given;
use super::machine::{self, Bounds};
use super::report::{Agreement, Outputs};
use super::routes::ShaderRoute;

/// The scalars that the shader may write, and those among them that nothing is known of.
pub(super) fn outputs(given: &[Given], bounds: Option<&Bounds>) -> Outputs {
    let mut outputs = Outputs { scalars: 0, indeterminate: 0 };
    for given in given.iter().filter(|given| given.is_written()) {
        given.shape.visit(given.data.len(), &mut |at, scalar, _| {
            let permit = machine::permit(bounds, given, at, scalar, &given.data);
            let is_unknown = match permit {
                Permit::Unknown => true,
                Permit::Around { exact, bound } => !exact.is_finite() || !bound.is_finite(),
                Permit::Bits | Permit::Texel { .. } => false,
            };
            outputs.scalars += 1;
            outputs.indeterminate += usize::from(is_unknown);
        });
    }
    outputs
}

/// How the routes to each driver stand to each other, by what they left.
pub(super) fn agreements(given: &[Given], left: &[(ShaderRoute, Vec<Vec<u8>>)]) -> Vec<Agreement> {
    let mut groups: Vec<(Agreement, &Vec<Vec<u8>>)> = Vec::new();
    for (route, found) in left {
        let ShaderRoute::Gpu { driver, .. } = route else { continue };
        let Some((agreement, first)) = groups.iter_mut().find(|(known, _)| known.driver == *driver) else {
            let routes = vec![route.to_string()];
            groups.push((Agreement { driver: driver.clone(), routes, differing: Vec::new() }, found));
            continue;
        };
        agreement.routes.push(route.to_string());
        let different = first_difference(given, first, found);
        agreement.differing.extend(different.map(|compared| (route.to_string(), compared)));
    }
    groups.into_iter().map(|(agreement, _)| agreement).collect()
}

fn first_difference(given: &[Given], first: &[Vec<u8>], found: &[Vec<u8>]) -> Option<Compared> {
    let written = given.iter().filter(|given| given.is_written()).zip(first.iter().zip(found));
    let mut compared =
        written.map(|(given, (first, found))| compare(given, first, found, |_, _| Permit::Bits));
    compared.find(|compared| compared.differing > 0)
}
