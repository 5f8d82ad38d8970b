//! Voronoi cells within a box, a convex polygon or any domain: one for each place that has a point.
//!
//! Cost: a cell that lies in the box takes no time. Others are cut in fractions, some microseconds for each corner and
//! neighbour; and a domain is looked at whole for each cell.

use num_rational::BigRational;
use sweep_cdt::Triangulation;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt::scalar::orient2d;
use sweep_cdt_edit::{Voronoi, VoronoiError};
use sweep_cdt_formats::{Cell, Remark};

/// What cells are cut to.
#[derive(Clone, Debug)]
pub enum Clip<'a, S> {
    /// An upright box, by its lower left and its upper right corner.
    Box([[S; 2]; 2]),
    /// A convex polygon, counter-clockwise.
    Convex(Vec<[S; 2]>),
    /// An interior, and the points of its triangulation.
    Inside(&'a Interior<'a>, &'a [[S; 2]]),
}

impl<S: Exact> Clip<'_, S> {
    /// The box around points, a tenth of its longer side larger on all sides; of equal points, by 1. `None` without points.
    ///
    /// ```
    /// use sweep_cdt_engine::Clip;
    ///
    /// let Some(Clip::Box(corners)) = Clip::around(&[[0.0, 0.0], [10.0, 5.0]]) else {
    ///     unreachable!("there are points")
    /// };
    /// assert_eq!(corners, [[-1.0, -1.0], [11.0, 6.0]]);
    /// ```
    pub fn around(points: &[[S; 2]]) -> Option<Self> {
        let limits = |axis: usize| {
            let values = points.iter().map(|point| &point[axis]);
            let least = values.clone().min_by(|x, y| x.compare(y))?;
            let most = values.max_by(|x, y| x.compare(y))?;
            Some([least.to_fraction(), most.to_fraction()])
        };
        let [[left, right], [low, high]] = [limits(0)?, limits(1)?];
        let longer = (&right - &left).max(&high - &low);
        let fraction = |n: i64| BigRational::from_integer(n.into());
        let margin = match longer == fraction(0) {
            true => fraction(1),
            false => longer / fraction(10),
        };
        let corners = [
            [left - &margin, low - &margin],
            [right + &margin, high + &margin],
        ];
        Some(Clip::Box(
            corners
                .each_ref()
                .map(|corner| corner.each_ref().map(S::nearest)),
        ))
    }
}

/// The cells of the points of a diagram of `result` within this, and the remark on points that share one.
///
/// ```
/// use sweep_cdt_edit::Voronoi;
/// use sweep_cdt_engine::{Clip, cells};
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 0.0]];
/// let result = sweep_cdt::triangulate(&points, &[])?;
/// let voronoi = Voronoi::new(&result, &points)?;
/// let (cells, shared) = cells(&voronoi, &result, &Clip::Box([[-2.0, -1.0], [6.0, 1.0]]))?;
/// assert_eq!(cells[1].polygons, [[[[2.0, -1.0], [6.0, -1.0], [6.0, 1.0], [2.0, 1.0]]]]);
/// assert_eq!(shared.unwrap().to_string(), "1 point equals another one, and shares its cell");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`VoronoiError::NonFiniteCorner`].
pub fn cells<S: Exact>(
    voronoi: &Voronoi<'_, S>,
    result: &Triangulation,
    clip: &Clip<'_, S>,
) -> Result<(Vec<Cell<S>>, Option<Remark>), VoronoiError> {
    let mut is_open = vec![result.is_empty(); voronoi.cells.len()];
    for ridge in &voronoi.ridges {
        if ridge.ends[1].is_none() {
            ridge.points.iter().for_each(|&v| is_open[v] = true);
        }
    }
    let mut cells = Vec::new();
    for point in (0..voronoi.cells.len()).filter(|&v| result.representative(v) == v) {
        let rings = match clip {
            Clip::Box(corners) => {
                let own = &voronoi.cells[point];
                let own: Vec<[S; 2]> = own.iter().map(|&v| voronoi.vertices[v].clone()).collect();
                // Rounding keeps the order, so that an exact vertex lies in the box if the rounded one does.
                let is_in = |place: &[S; 2]| {
                    let [low, high] = corners;
                    (0..2).all(|i| {
                        low[i].compare(&place[i]).is_lt() && place[i].compare(&high[i]).is_lt()
                    })
                };
                if !is_open[point] && own.iter().all(is_in) {
                    vec![own]
                } else {
                    let [[left, low], [right, high]] = corners.clone();
                    let polygon = [
                        [left.clone(), low.clone()],
                        [right.clone(), low],
                        [right, high.clone()],
                        [left, high],
                    ];
                    vec![voronoi.cell_within(point, &polygon)?]
                }
            }
            Clip::Convex(polygon) => vec![voronoi.cell_within(point, polygon)?],
            Clip::Inside(inside, corners) => voronoi.cell_inside(point, inside, corners)?,
        };
        let polygons = polygons(rings);
        cells.push(Cell { point, polygons });
    }
    let points = voronoi.cells.len() - cells.len();
    Ok((
        cells,
        (points > 0).then_some(Remark::SharedCells { points }),
    ))
}

/// Rings as polygons: outlines run counter-clockwise, and each is followed by the holes in it, which run clockwise.
fn polygons<S: Exact>(rings: Vec<Vec<[S; 2]>>) -> Vec<Vec<Vec<[S; 2]>>> {
    let lowest = |ring: &[[S; 2]]| {
        let order = |&i: &usize, &j: &usize| {
            let ([x, y], [z, w]) = (&ring[i], &ring[j]);
            y.compare(w).then_with(|| x.compare(z))
        };
        (0..ring.len()).min_by(order)
    };
    let is_outline = |ring: &Vec<[S; 2]>| {
        lowest(ring).is_some_and(|at| {
            let [before, at, after] =
                [at + ring.len() - 1, at, at + 1].map(|i| &ring[i % ring.len()]);
            orient2d(before, at, after).is_gt()
        })
    };
    let rings = rings.into_iter().filter(|ring| !ring.is_empty());
    let (outlines, holes): (Vec<_>, Vec<_>) = rings.partition(is_outline);
    let mut polygons: Vec<Vec<Vec<[S; 2]>>> = outlines.into_iter().map(|ring| vec![ring]).collect();
    for hole in holes {
        let holds =
            |polygon: &Vec<Vec<[S; 2]>>| hole.iter().any(|place| is_inside(&polygon[0], place));
        // A hole whose corners all touch the outline is in the only one that is left.
        let place = polygons.iter().position(holds).unwrap_or(0);
        if let Some(polygon) = polygons.get_mut(place) {
            polygon.push(hole);
        }
    }
    polygons
}

/// Whether a place lies in a ring and not on it.
fn is_inside<S: Exact>(ring: &[[S; 2]], place: &[S; 2]) -> bool {
    let mut crossed = 0;
    for (i, a) in ring.iter().enumerate() {
        let b = &ring[(i + 1) % ring.len()];
        let is_up = a[1].compare(&b[1]).is_lt();
        let [low, high] = if is_up { [a, b] } else { [b, a] };
        let is_beside = low[1].compare(&place[1]).is_le() && place[1].compare(&high[1]).is_lt();
        match orient2d(low, high, place) {
            std::cmp::Ordering::Greater if is_beside => crossed += 1,
            std::cmp::Ordering::Equal if is_beside => return false,
            _ => {}
        }
    }
    crossed % 2 == 1
}
