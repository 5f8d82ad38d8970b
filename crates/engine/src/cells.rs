//! Voronoi cells within a box, a convex polygon or any domain: one for each place that has a point.
//!
//! Cost: a cell that lies in the box takes no time. Others are cut in fractions, some microseconds for each corner and
//! neighbour; and a domain is looked at whole for each cell.

use num_rational::BigRational;
use sweep_cdt::Triangulation;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
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
    /// The box around points, a tenth of its longer side larger on all sides; of equal points, by 1. Where doubles do not
    /// reach so far, it goes to the last point. `None` without points.
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
        let moved = |x: BigRational, by: BigRational| {
            let far = S::nearest(&(&x + by));
            if far.is_finite() { far } else { S::nearest(&x) }
        };
        Some(Clip::Box([
            [moved(left, -&margin), moved(low, -&margin)],
            [moved(right, margin.clone()), moved(high, margin)],
        ]))
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
        let polygons = match clip {
            Clip::Box(ends) => {
                let own = voronoi.corners(point);
                // Rounding keeps the order, so that an exact vertex lies in the box if the rounded one does.
                let is_in = |place: &[S; 2]| {
                    let [low, high] = ends;
                    (0..2).all(|i| {
                        low[i].compare(&place[i]).is_lt() && place[i].compare(&high[i]).is_lt()
                    })
                };
                if !is_open[point] && own.iter().all(is_in) {
                    alone(own)
                } else {
                    let [[left, low], [right, high]] = ends.clone();
                    let polygon = [
                        [left.clone(), low.clone()],
                        [right.clone(), low],
                        [right, high.clone()],
                        [left, high],
                    ];
                    alone(voronoi.cell_within(point, &polygon)?)
                }
            }
            Clip::Convex(polygon) => alone(voronoi.cell_within(point, polygon)?),
            Clip::Inside(inside, corners) => voronoi.cell_inside(point, inside, corners)?,
        };
        cells.push(Cell { point, polygons });
    }
    let points = voronoi.cells.len() - cells.len();
    Ok((
        cells,
        (points > 0).then_some(Remark::SharedCells { points }),
    ))
}

/// The polygon of one ring, if it has corners.
fn alone<S>(ring: Vec<[S; 2]>) -> Vec<Vec<Vec<[S; 2]>>> {
    let rings = (!ring.is_empty()).then(|| vec![ring]);
    rings.into_iter().collect()
}
