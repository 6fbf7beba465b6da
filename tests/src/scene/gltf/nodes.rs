//! Nodes, and where they are in the world.

use crate::scene::SceneError;
use crate::scene::limits::{place, refused};
use gltf::scene::Transform;
use gltf::{Node, Scene};
use lobe_codegen::glam::{DMat4, DQuat, DVec3};
use std::collections::HashSet;

/// A node, and its coordinates in those of the world.
pub(super) struct Placed<'a> {
    pub(super) node: Node<'a>,
    pub(super) to_world: DMat4,
}

impl Placed<'_> {
    /// Its place in messages.
    pub(super) fn at(&self) -> String {
        named(&self.node)
    }

    /// Where it is, m.
    pub(super) fn position(&self) -> Result<DVec3, SceneError> {
        place(&self.at(), self.to_world.w_axis.truncate().to_array())
    }

    /// Which way one of its axes points.
    pub(super) fn direction(&self, axis: DVec3) -> Result<DVec3, SceneError> {
        match self.to_world.transform_vector3(axis).try_normalize() {
            Some(direction) => Ok(direction),
            None => refused(&self.at(), "its scale leaves it no direction; scale by something else than 0"),
        }
    }
}

fn named(node: &Node) -> String {
    let name = node.name().map(|name| format!(" ({name})")).unwrap_or_default();
    format!("nodes[{}]{name}", node.index())
}

/// All nodes of a scene, parents first.
pub(super) fn placed<'a>(scene: &Scene<'a>) -> Result<Vec<Placed<'a>>, SceneError> {
    let (mut found, mut seen) = (Vec::new(), HashSet::new());
    let mut waiting: Vec<_> = scene.nodes().map(|root| (root, DMat4::IDENTITY)).collect();
    waiting.reverse();
    while let Some((node, parent)) = waiting.pop() {
        if !seen.insert(node.index()) {
            return refused(&named(&node), "it hangs in two places, or below itself; nodes are a tree");
        }
        let to_world = parent * local(&node)?;
        if !to_world.is_finite() {
            return refused(&named(&node), "its transform is not finite");
        }
        let below = waiting.len();
        waiting.extend(node.children().map(|child| (child, to_world)));
        waiting[below..].reverse();
        found.push(Placed { node, to_world });
    }
    Ok(found)
}

fn local(node: &Node) -> Result<DMat4, SceneError> {
    match node.transform() {
        Transform::Matrix { matrix } => {
            Ok(DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from))))
        }
        Transform::Decomposed { translation, rotation, scale } => {
            let turn = DQuat::from_array(rotation.map(f64::from));
            if !(turn.length_squared().is_finite() && turn.length_squared() > 0.0) {
                return refused(
                    &format!("{}.rotation", named(node)),
                    "it is no rotation; [0, 0, 0, 1] is none at all",
                );
            }
            let [scale, translation] = [scale, translation].map(|v| DVec3::from_array(v.map(f64::from)));
            Ok(DMat4::from_scale_rotation_translation(scale, turn.normalize(), translation))
        }
    }
}
