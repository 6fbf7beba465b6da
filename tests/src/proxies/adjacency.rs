//! Which triangles share an edge.

use crate::scene::Triangle;
use std::collections::HashMap;

/// Neighbours of each triangle, in one list.
#[derive(Debug)]
pub(super) struct Neighbours {
    /// Where the neighbours of a triangle begin; one more than there are triangles.
    starts: Vec<u32>,
    all: Vec<u32>,
}

impl Neighbours {
    /// Those of a triangle.
    pub(super) fn of(&self, triangle: usize) -> &[u32] {
        &self.all[self.starts[triangle] as usize..self.starts[triangle + 1] as usize]
    }
}

/// Triangles with two corners in common, bit for bit. Where more than two share an edge, each has the next as a neighbour.
pub(super) fn neighbours(triangles: &[Triangle]) -> Neighbours {
    let mut edges = edges(triangles);
    edges.sort_unstable();
    let pairs: Vec<[u32; 2]> =
        edges.windows(2).filter(|two| two[0].0 == two[1].0).map(|two| [two[0].1, two[1].1]).collect();
    listed(triangles.len(), &pairs)
}

/// Every edge as the numbers of its ends, the smaller first, with its triangle.
fn edges(triangles: &[Triangle]) -> Vec<([u32; 2], u32)> {
    let mut numbers: HashMap<[u32; 3], u32> = HashMap::with_capacity(triangles.len());
    let mut edges = Vec::with_capacity(3 * triangles.len());
    for (index, triangle) in triangles.iter().enumerate() {
        let [a, b, c] = triangle.vertices.map(|vertex| {
            let next = numbers.len() as u32;
            // The sum makes 0 of -0.
            *numbers.entry(vertex.to_array().map(|x| (x + 0.0).to_bits())).or_insert(next)
        });
        edges.extend([[a, b], [b, c], [c, a]].map(|[p, q]| ([p.min(q), p.max(q)], index as u32)));
    }
    edges
}

fn listed(count: usize, pairs: &[[u32; 2]]) -> Neighbours {
    let mut starts = vec![0u32; count + 1];
    for &triangle in pairs.as_flattened() {
        starts[triangle as usize + 1] += 1;
    }
    for i in 0..count {
        starts[i + 1] += starts[i];
    }
    let (mut next, mut all) = (starts.clone(), vec![0; 2 * pairs.len()]);
    for &[a, b] in pairs {
        for (from, to) in [(a, b), (b, a)] {
            all[next[from as usize] as usize] = to;
            next[from as usize] += 1;
        }
    }
    Neighbours { starts, all }
}
