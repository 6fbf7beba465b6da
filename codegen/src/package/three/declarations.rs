//! What the module declares, for TypeScript.

use super::items::{self, Item, Kind, in_tsl};
use super::{Contents, is_exported};
use crate::emit::reflect;

pub(super) fn declarations(contents: &Contents<'_>, items: &[Item<'_>]) -> String {
    let mut text = format!("// Written by Lobe {}.\n{HEAD}", env!("CARGO_PKG_VERSION"));
    let reflection = reflect(contents.module);
    for item in items.iter().filter(|item| is_exported(contents, item)) {
        let declared = match item.kind {
            Kind::Structure => structure(item, items),
            Kind::Constant => continue,
            Kind::Function { .. } => {
                let Some(function) = reflection.functions.iter().find(|f| f.name == item.name) else {
                    continue;
                };
                let parameter = |p: &reflect::ParameterInfo| (p.name.clone(), node(&p.ty, items));
                let parameters: Vec<_> = function.parameters.iter().map(parameter).collect();
                let returns = function.returns.as_deref().map_or("Node".to_owned(), |ty| node(ty, items));
                format!("export const {}: Kernel<{}, {returns}>;\n", item.exported, list(&parameters))
            }
        };
        text += &format!("\n{}{declared}", items::comment(&item.docs, ""));
    }
    text
}

const HEAD: &str = "
import type { Node } from 'three/webgpu';

/** What stands for an argument: a number will do for a scalar. */
type Argument<T> = T extends Node<'float'> | Node<'int'> | Node<'uint'> ? T | number : T;

/** A function of a shader, called with its arguments by name. */
type Kernel<Arguments, Result> = (values: { [Name in keyof Arguments]: Argument<Arguments[Name]> }) => Result;

/** Structures, kernels and pieces of code as the includes of a `wgslFn` or a `wgsl`. */
export const using: (...items: unknown[]) => Node[];

/** A structure of a shader, whose members are nodes. */
type Structure<Members> = { get<Name extends keyof Members>(name: Name): Members[Name] } & Omit<Node, 'get'>;
";

/// A structure's members, its values, and how one is made.
fn structure(item: &Item<'_>, items: &[Item<'_>]) -> String {
    let members: Vec<(String, String)> =
        item.members().iter().map(|m| (m.name.to_owned(), node(m.ty, items))).collect();
    let name = item.exported;
    format!(
        "export type {name} = Structure<{}>;\nexport const {name}: (members: {}) => {name};\n",
        list(&members),
        list(&members)
    )
}

/// The node of a type in WGSL.
fn node(ty: &str, items: &[Item<'_>]) -> String {
    match items.iter().find(|item| item.name == ty) {
        Some(structure) => structure.exported.to_owned(),
        None if in_tsl(ty) == ty && ty != "bool" => "Node".to_owned(),
        None => format!("Node<'{}'>", in_tsl(ty)),
    }
}

fn list(entries: &[(String, String)]) -> String {
    let entries: Vec<String> = entries.iter().map(|(name, ty)| format!("{name}: {ty}")).collect();
    if entries.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", entries.join("; ")) }
}
