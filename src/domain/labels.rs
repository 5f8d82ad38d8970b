//! A domain: what a rule says of every triangle.

use super::loops;
use crate::Triangulation;
use crate::triangulation::canonical;

/// Which triangles of a triangulation are inside, and how deep each lies.
///
/// ```
/// use sweep_cdt::domain::Rule;
///
/// // A square with a square hole.
/// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// let domain = result.domain(Rule::EvenOdd)?;
/// assert_eq!(domain.inside().len(), 8);
/// assert_eq!(domain.boundary(), [vec![0, 1, 2, 3], vec![4, 7, 6, 5]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Domain<'a> {
    result: &'a Triangulation,
    depths: Vec<i32>,
    /// The triangles inside, in ascending order.
    inside: Vec<usize>,
    is_inside: Vec<bool>,
    /// For each triangle its region; empty if there are none.
    regions: Vec<Option<u32>>,
}

impl<'a> Domain<'a> {
    /// The domain of the triangles whose depth is one that counts as inside.
    pub(super) fn new(
        result: &'a Triangulation,
        depths: Vec<i32>,
        is_inside: impl Fn(i32) -> bool,
    ) -> Domain<'a> {
        let is_inside: Vec<bool> = depths.iter().map(|&depth| is_inside(depth)).collect();
        let inside = (0..result.len()).filter(|&t| is_inside[t]).collect();
        Domain {
            result,
            depths,
            inside,
            is_inside,
            regions: Vec::new(),
        }
    }

    /// The same domain with the region of each triangle.
    pub(super) fn with_regions(self, regions: Vec<Option<u32>>) -> Domain<'a> {
        Domain { regions, ..self }
    }

    /// All of the hull.
    pub(crate) fn whole(result: &'a Triangulation) -> Domain<'a> {
        Domain::new(result, vec![1; result.len()], |_| true)
    }

    /// The triangulation of the whole hull.
    pub fn triangulation(&self) -> &'a Triangulation {
        self.result
    }

    /// How deep triangle `t` lies. For [`EvenOdd`](super::Rule::EvenOdd) this is the least number of sides with
    /// an odd number of edges on them that a path from outside the hull to the triangle crosses. For
    /// [`NonZero`](super::Rule::NonZero) it is the winding number, how often the edges go round it
    /// counter-clockwise, less than 0 where they go clockwise. Otherwise it is 1 inside and 0 outside.
    ///
    /// # Panics
    /// If there is no triangle `t`.
    pub fn depth(&self, t: usize) -> i32 {
        self.depths[t]
    }

    /// Whether triangle `t` is inside.
    ///
    /// # Panics
    /// If there is no triangle `t`.
    pub fn is_inside(&self, t: usize) -> bool {
        self.is_inside[t]
    }

    /// The region that triangle `t` belongs to, as a position in the regions of
    /// [`Triangulation::domain_of_seeds`]; `None` if it belongs to none.
    ///
    /// # Panics
    /// If there is no triangle `t`.
    pub fn region(&self, t: usize) -> Option<usize> {
        assert!(t < self.result.len(), "there is no triangle {t}");
        let region = *self.regions.get(t)?;
        region.map(|region| region as usize)
    }

    /// Whether there are regions.
    pub fn has_regions(&self) -> bool {
        !self.regions.is_empty()
    }

    /// The triangles inside, in ascending order.
    pub fn inside(&self) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.inside.iter().copied()
    }

    /// The triangles inside in the order of [`Triangulation::canonical_triangles`].
    pub fn canonical_triangles(&self) -> Vec<[usize; 3]> {
        canonical(self.inside().map(|t| self.result.triangle(t)))
    }

    /// The sides of triangles inside that are input edges or pieces of them, each once, as pairs of vertices.
    pub fn constrained_edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let is_listed = |t: usize, side| {
            let neighbor = self.result.neighbor(t, side);
            let is_first = neighbor.is_none_or(|across| across > t || !self.is_inside[across]);
            is_first && self.result.is_constrained(t, side)
        };
        let sides = self.inside().flat_map(|t| [0, 1, 2].map(|side| (t, side)));
        let listed = sides.filter(move |&(t, side)| is_listed(t, side));
        listed.map(|(t, side)| loops::ends(self.result, t, side))
    }

    /// The closed chains of vertices around the triangles inside, which lie on the left: outer ones run
    /// counter-clockwise, those around holes clockwise. Each begins with its lowest side and does not repeat its
    /// first vertex at the end; they are sorted by that side. Where triangles meet in a vertex only, a chain
    /// passes that vertex more than once or several chains do, but no side occurs twice.
    pub fn boundary(&self) -> Vec<Vec<usize>> {
        loops::loops(self.result, |t| self.is_inside[t])
    }
}
