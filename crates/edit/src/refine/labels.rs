//! Labels: whether each triangle is inside, and in which region. They spread from the parts of edges.
//!
//! Why it is right: a label changes only across parts, since all that bounds the inside is one. Each part knows the
//! labels on its two sides, and its halves have the same. A new triangle reaches, through sides that are free, a
//! triangle whose label is known or a part. Cost: constant time for each new triangle.

use sweep_cdt::crossings::Exact;

use crate::mesh::NONE;
use crate::refine::work::{OUTSIDE, UNKNOWN, Work};

impl<S: Exact> Work<'_, '_, S> {
    /// Labels what the last edit swept; returns its triangles inside.
    pub(super) fn relabel(&mut self) -> Vec<u32> {
        let mut swept = std::mem::take(&mut self.mesh.swept);
        swept.retain(|&t| self.mesh.mesh.triangle(t).is_some());
        swept.sort_unstable();
        swept.dedup();
        for &t in &swept {
            if self.labels.len() <= t as usize {
                self.labels.resize(t as usize + 1, UNKNOWN);
            }
            self.labels[t as usize] = UNKNOWN;
        }
        for &t in &swept {
            if self.labels[t as usize] == UNKNOWN {
                self.spread(t);
            }
        }
        swept.retain(|&t| self.labels[t as usize] != OUTSIDE);
        swept
    }

    /// Finds the label of a triangle, and gives it to all new ones that hang together with it.
    fn spread(&mut self, first: u32) {
        let mesh = &self.mesh.mesh;
        let (mut found, mut label, mut waiting) = (Vec::new(), OUTSIDE, vec![first]);
        // While they are looked at, they count as outside.
        self.labels[first as usize] = OUTSIDE;
        while let Some(t) = waiting.pop() {
            found.push(t);
            for side in 3 * t..3 * t + 3 {
                let across = mesh.twin(side);
                if mesh.covers(side) > 0 {
                    label = label.max(self.label_left_of(side));
                } else if across != NONE {
                    match &mut self.labels[across as usize / 3] {
                        unknown if *unknown == UNKNOWN => {
                            *unknown = OUTSIDE;
                            waiting.push(across / 3);
                        }
                        known => label = label.max(*known),
                    }
                }
            }
        }
        for t in found {
            self.labels[t as usize] = label;
        }
    }

    /// The label that the part on a side has on the left of the side.
    fn label_left_of(&self, side: u32) -> u32 {
        let part = &self.parts[self.part_at(side) as usize];
        let is_along = part.ends[0] == self.name(self.mesh.mesh.ends(side)[0]);
        part.labels[usize::from(!is_along)]
    }
}
