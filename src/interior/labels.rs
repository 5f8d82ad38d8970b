//! The interior: what a rule says of every triangle, and the boundary of the triangles inside.

use crate::Triangulation;
use crate::triangulation::canonical::canonical;
use alloc::vec;
use alloc::vec::Vec;

/// The triangles of a triangulation that are inside, and the depth of each. Methods panic if there is no triangle `t`.
///
/// ```
/// use sweep_cdt::interior::FillRule;
///
/// // A square with a square hole, and twice its area.
/// let points = [[0, 0], [9, 0], [9, 9], [0, 9], [3, 3], [6, 3], [6, 6], [3, 6]];
/// let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
/// let result = sweep_cdt::triangulate(&points, &edges)?;
/// let domain = result.interior(FillRule::EvenOdd)?;
/// let area = |[a, b, c]: [usize; 3]| {
///     let [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
///     (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
/// };
/// assert_eq!(domain.triangles().map(area).sum::<i32>(), 2 * (9 * 9 - 3 * 3));
/// assert_eq!(domain.boundary(), [vec![0, 1, 2, 3], vec![4, 7, 6, 5]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Interior<'a> {
    result: &'a Triangulation,
    depths: Vec<i32>,
    inside: Vec<usize>,
    is_inside: Vec<bool>,
    /// For each triangle its region; empty if there are no regions.
    regions: Vec<Option<usize>>,
    /// Whether the regions are polygons.
    is_of_polygons: bool,
}

impl<'a> Interior<'a> {
    pub(super) fn new(
        result: &'a Triangulation,
        depths: Vec<i32>,
        is_inside: impl Fn(i32) -> bool,
    ) -> Interior<'a> {
        let is_inside: Vec<bool> = depths.iter().map(|&depth| is_inside(depth)).collect();
        let inside = (0..result.len()).filter(|&t| is_inside[t]).collect();
        Interior {
            result,
            depths,
            inside,
            is_inside,
            regions: Vec::new(),
            is_of_polygons: false,
        }
    }

    pub(super) fn with_regions(self, regions: Vec<Option<usize>>) -> Interior<'a> {
        Interior { regions, ..self }
    }

    /// The interior whose regions are polygons.
    pub(super) fn with_polygons(self, polygons: Vec<Option<usize>>) -> Interior<'a> {
        Interior {
            is_of_polygons: true,
            ..self.with_regions(polygons)
        }
    }

    /// The interior that is the whole hull of a triangulation.
    pub fn whole(result: &'a Triangulation) -> Interior<'a> {
        Interior::new(result, vec![1; result.len()], |_| true)
    }

    /// The interior of a finer triangulation, where `label` says of each triangle by its number whether it is inside, and
    /// then which of the regions of this interior it has. The depth inside is 1.
    ///
    /// ```
    /// use sweep_cdt::interior::Interior;
    ///
    /// let triangle = [[0, 0], [8, 0], [0, 8], [2, 2]];
    /// let coarse = sweep_cdt::triangulate(&triangle[..3], &[])?;
    /// let fine = sweep_cdt::triangulate(&triangle, &[])?;
    /// let carried = Interior::whole(&coarse).carried(&fine, |t| (t > 0).then_some(None));
    /// assert_eq!(carried.inside().collect::<Vec<_>>(), [1, 2]);
    /// # Ok::<(), sweep_cdt::Error>(())
    /// ```
    #[must_use]
    pub fn carried<'b>(
        &self,
        result: &'b Triangulation,
        label: impl Fn(usize) -> Option<Option<usize>>,
    ) -> Interior<'b> {
        let labels: Vec<Option<Option<usize>>> = (0..result.len()).map(label).collect();
        let depths = labels.iter().map(|label| i32::from(label.is_some()));
        let interior = Interior::new(result, depths.collect(), |depth| depth == 1);
        let regions = labels.iter().map(|label| label.flatten());
        Interior {
            is_of_polygons: self.is_of_polygons,
            regions: regions.filter(|_| self.has_regions()).collect(),
            ..interior
        }
    }

    /// The triangulation of the whole hull.
    pub fn triangulation(&self) -> &'a Triangulation {
        self.result
    }

    /// How deep triangle `t` lies. For [`EvenOdd`](super::FillRule::EvenOdd) this is the least number of sides with an
    /// odd number of edges on them that a path from outside the hull to the triangle crosses. For
    /// [`NonZero`](super::FillRule::NonZero) and the rules below it the depth is the winding number: how often the edges
    /// go round the triangle counter-clockwise, less than 0 where they go clockwise. For
    /// [`interior_of_polygons`](Triangulation::interior_of_polygons) it is the number of polygons that cover the
    /// triangle. Otherwise it is 1 inside and 0 outside.
    pub fn depth(&self, t: usize) -> i32 {
        self.depths[t]
    }

    /// Whether triangle `t` is inside.
    pub fn is_inside(&self, t: usize) -> bool {
        self.is_inside[t]
    }

    /// The region that triangle `t` belongs to, as a position in the regions of
    /// [`WithPoints::interior_of_seeds`](crate::WithPoints::interior_of_seeds), or as the number of a
    /// [`Ring`](super::Ring)'s polygon; `None` if it belongs to none.
    pub fn region(&self, t: usize) -> Option<usize> {
        assert!(t < self.result.len(), "there is no triangle {t}");
        *self.regions.get(t)?
    }

    /// Whether there are regions.
    pub fn has_regions(&self) -> bool {
        !self.regions.is_empty()
    }

    /// Whether the regions are numbers of polygons, of
    /// [`Triangulation::interior_of_polygons`].
    pub fn is_of_polygons(&self) -> bool {
        self.is_of_polygons
    }

    /// The triangles inside, as their vertices, in ascending order of their numbers.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [usize; 3]> + Clone + '_ {
        self.inside().map(|t| self.result.triangle(t))
    }

    /// The numbers of the triangles inside, in ascending order.
    pub fn inside(&self) -> impl ExactSizeIterator<Item = usize> + Clone + '_ {
        self.inside.iter().copied()
    }

    /// The triangles inside in the order of [`Triangulation::canonical_triangles`].
    pub fn canonical_triangles(&self) -> Vec<[usize; 3]> {
        let corners = |i: usize| self.result.corners(&self.result.triangles[self.inside[i]]);
        canonical(self.inside.len(), corners)
    }

    /// The sides of triangles inside that are input edges or pieces of them, each once, as pairs of vertices.
    pub fn constrained_sides(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let is_listed = |t: usize, side| {
            let neighbor = self.result.neighbor(t, side);
            let is_first = neighbor.is_none_or(|across| across > t || !self.is_inside[across]);
            is_first && self.result.is_constrained(t, side)
        };
        let sides = self.inside().flat_map(|t| [0, 1, 2].map(|side| (t, side)));
        let listed = sides.filter(move |&(t, side)| is_listed(t, side));
        listed.map(|(t, side)| self.result.side(t, side))
    }

    /// The closed chains of vertices around the triangles inside, which lie on the left: outer chains run
    /// counter-clockwise, those around holes clockwise. Each begins with its lowest side, by which they are sorted, and
    /// does not repeat its first vertex. Where triangles meet in a vertex only, chains pass it again, but no side
    /// twice.
    pub fn boundary(&self) -> Vec<Vec<usize>> {
        loops(self.result, |t| self.is_inside[t])
    }
}

/// The closed chains around the triangles that are inside. From the end of a side the chain goes on along the next side
/// of the triangle. If the triangle across it is in the set, its next side is tried, and so on around the vertex.
///
/// ```text
///           \  t2 /
///       next \   / t1        From side a-v of t0 around v, through t1 and t2, which are in the set: the
///             \ /            chain goes on along the last side of t2.
///      ------- v -------
///             /  t0
///            a
/// ```
///
/// Where the set meets itself in a vertex only, the chain stays with the triangles that are connected: it may pass a
/// vertex more than once, but no side. The set alone decides: each chain begins with its lowest side, by which they are
/// sorted. Cost: O(b log b) for b sides, the scan of all triangles, and of those around boundary vertices.
fn loops(result: &Triangulation, is_inside: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
    let is_beyond = |t: usize, side| result.neighbor(t, side).is_none_or(|t| !is_inside(t));
    let mut borders: Vec<([usize; 2], usize)> = (0..result.len())
        .filter(|&t| is_inside(t))
        .flat_map(|t| [0, 1, 2].map(|side| (t, side)))
        .filter(|&(t, side)| is_beyond(t, side))
        .map(|(t, side)| (result.side(t, side), t))
        .collect();
    borders.sort_unstable();

    let mut is_passed = vec![false; borders.len()];
    let mut loops = Vec::new();
    for first in 0..borders.len() {
        let (mut at, mut chain) = (first, Vec::new());
        while !is_passed[at] {
            is_passed[at] = true;
            let ([from, vertex], mut t) = borders[at];
            chain.push(from);
            let mut side = leaving(result, t, vertex);
            while !is_beyond(t, side) {
                t = result.neighbor(t, side).expect("it is inside");
                side = leaving(result, t, vertex);
            }
            let next = borders.binary_search(&(result.side(t, side), t));
            at = next.expect("all sides of the boundary are listed");
        }
        if !chain.is_empty() {
            loops.push(chain);
        }
    }
    loops
}

/// The side of a triangle that starts at `vertex`.
fn leaving(result: &Triangulation, t: usize, vertex: usize) -> usize {
    let corner = result.triangle(t).iter().position(|&v| v == vertex);
    (corner.expect("the triangle has the vertex") + 2) % 3
}
