//! Geometries of the crate `geo-types`: points, lines and polygons in, triangles out.
//!
//! As in files of maps, the sides of lines and rings are edges, and equal points one vertex, the first of them.
//! Collections may stand in collections to any depth, and nothing recurses.

use geo_types::{
    Coord, Geometry, Line, LineString, MultiLineString, MultiPolygon, Polygon, Rect, Triangle,
};

use crate::Coordinate;
use crate::read::merged;
use sweep_cdt::Pslg;
use sweep_cdt::interior::Interior;

/// All points of a geometry, and the sides of its lines and rings.
///
/// ```
/// use geo_types::{Geometry, polygon};
/// use sweep_cdt::interior::FillRule;
/// use sweep_cdt_formats::{geo_graph, geo_triangles};
///
/// let arrowhead = polygon![(x: 0., y: 0.), (x: 4., y: 3.), (x: 0., y: 6.), (x: 1., y: 3.)];
/// let graph = geo_graph(&Geometry::from(arrowhead));
/// let result = sweep_cdt::triangulate(&graph.points, &graph.edges)?;
/// let triangles = geo_triangles(&graph, &result.interior(FillRule::EvenOdd)?);
/// assert_eq!(triangles.len(), 2);
/// assert_eq!(triangles[0].v3(), geo_types::coord! { x: 1., y: 3. });
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn geo_graph(geometry: &Geometry<f64>) -> Pslg<f64> {
    let mut graph = Pslg::default();
    // What is still to be taken, the next one last.
    let mut waiting = vec![geometry];
    while let Some(geometry) = waiting.pop() {
        match geometry {
            Geometry::Point(point) => add(&mut graph, [point.0]),
            Geometry::MultiPoint(points) => {
                points.iter().for_each(|point| add(&mut graph, [point.0]));
            }
            Geometry::Line(Line { start, end }) => add(&mut graph, [*start, *end]),
            Geometry::LineString(LineString(line)) => add(&mut graph, line.iter().copied()),
            Geometry::MultiLineString(MultiLineString(lines)) => {
                for LineString(line) in lines {
                    add(&mut graph, line.iter().copied());
                }
            }
            Geometry::Polygon(polygon) => add_polygon(&mut graph, polygon),
            Geometry::MultiPolygon(MultiPolygon(polygons)) => {
                polygons
                    .iter()
                    .for_each(|polygon| add_polygon(&mut graph, polygon));
            }
            Geometry::Rect(rect) => add_polygon(&mut graph, &Rect::to_polygon(*rect)),
            Geometry::Triangle(triangle) => {
                add_polygon(&mut graph, &Triangle::to_polygon(*triangle));
            }
            Geometry::GeometryCollection(collection) => {
                waiting.extend(collection.0.iter().rev());
            }
        }
    }
    merged(graph.into()).graph
}

/// The triangles inside, in canonical order, their corners counter-clockwise. Rationals are rounded to doubles.
pub fn geo_triangles<S: Coordinate>(
    graph: &Pslg<S>,
    interior: &Interior<'_>,
) -> Vec<Triangle<f64>> {
    let corner = |vertex: usize| {
        let [x, y] = graph.points[vertex].each_ref().map(S::approx);
        Coord { x, y }
    };
    let triangles = interior.canonical_triangles().into_iter();
    triangles
        .map(|[a, b, c]| Triangle(corner(a), corner(b), corner(c)))
        .collect()
}

/// Adds the rings, which are closed.
fn add_polygon(graph: &mut Pslg<f64>, polygon: &Polygon<f64>) {
    let rings = std::iter::once(polygon.exterior()).chain(polygon.interiors());
    rings.for_each(|LineString(ring)| add(graph, ring.iter().copied()));
}

/// Adds points with edges from each to the next.
fn add(graph: &mut Pslg<f64>, line: impl IntoIterator<Item = Coord<f64>>) {
    let first = graph.points.len();
    graph
        .points
        .extend(line.into_iter().map(|Coord { x, y }| [x, y]));
    let seconds = first + 1..graph.points.len();
    graph.edges.extend(seconds.map(|v| [v - 1, v]));
}
