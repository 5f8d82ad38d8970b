//! The refined mesh with numbers for its user: points that went again have none.

use sweep_cdt::crossings::Exact;

use crate::mesh::{number, turned};
use crate::refine::work::{OUTSIDE, Work};
use crate::refine::{Left, Reason, Refined};

impl<S: Exact> Work<'_, '_, S> {
    /// The mesh as its user has it.
    pub(super) fn refined(self) -> Refined<S> {
        // Vertices that went again have no numbers in the mesh that is returned.
        let points: Vec<usize> = self.mesh.points().collect();
        let mut new = vec![usize::MAX; self.kinds.len()];
        for (i, &point) in points.iter().enumerate() {
            new[point] = i;
        }
        let places = points.iter().map(|&point| {
            let v = self.vertex(number(point));
            self.mesh.points.place(v).clone()
        });
        let (mut edges, mut edge_of) = (Vec::new(), Vec::new());
        let mut is_of_edge = vec![false; self.first_parts];
        let mut push = |chain: &[usize], edge: Option<usize>| {
            for pair in chain.windows(2) {
                edges.push([new[pair[0]], new[pair[1]]]);
                edge_of.push(edge);
            }
        };
        for (edge, parts) in self.chains.iter().enumerate() {
            let mut chain = Vec::new();
            for &(part, is_forward) in parts {
                is_of_edge[part as usize] = true;
                self.follow(part, is_forward, &mut chain);
            }
            push(&chain, Some(edge));
        }
        for part in (0..self.first_parts).filter(|&part| !is_of_edge[part]) {
            let mut chain = Vec::new();
            self.follow(number(part), true, &mut chain);
            push(&chain, None);
        }
        let inside = self
            .mesh
            .mesh
            .all()
            .filter(|&t| self.labels[t as usize] != OUTSIDE);
        let mut triangles: Vec<([usize; 3], u32)> = inside
            .map(|t| {
                let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
                (turned(vertices.map(|v| new[self.mesh.points.name(v)])), t)
            })
            .collect();
        triangles.sort_unstable();
        let region = |&(_, t): &([usize; 3], u32)| {
            self.labels[t as usize]
                .checked_sub(2)
                .map(|region| region as usize)
        };
        let left = triangles.iter().enumerate().filter_map(|(i, &(_, t))| {
            let vertices = self.mesh.mesh.triangle(t).expect("a triangle");
            let bound = self
                .bounds_of(t)
                .broken(vertices.map(|v| self.mesh.points.place(v)))?;
            let reason = self
                .stays
                .get(&self.key(vertices))
                .copied()
                .unwrap_or(Reason::Limit);
            Some(Left {
                triangle: i,
                bound,
                reason,
            })
        });
        Refined {
            points: places.collect(),
            edges,
            edge_of,
            regions: triangles.iter().map(region).collect(),
            left: left.collect(),
            triangles: triangles.iter().map(|&(triangle, _)| triangle).collect(),
        }
    }
}
