//! Refinement of a file: a mesh within bounds, and what the file says of its vertices and edges, on the mesh.
//!
//! Vertices of the file keep their numbers, and new ones follow. The edges are the parts of the edges of the file, in their
//! order, and then the parts of the sides of the hull that bound the inside: rounding may put new vertices beside the
//! hull. A part has the marker, ring and feature of its edge. A new vertex has numbers in columns as they are on the
//! triangles of the file: in proportion along an edge, linear in a triangle. Markers of new vertices are missing.

use std::collections::BTreeMap;

use sweep_cdt::Triangulation;
use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt_edit::{Bounds, Left, RefineError, Refined, Refinement};
use sweep_cdt_formats::{Column, Coordinate, GraphFile, Remark};
use sweep_cdt_terrain::{Places, Surface};

use crate::inside::Inside;
use crate::settings::UnknownName;

/// A file that was refined.
///
/// ```
/// use sweep_cdt::{Pslg, interior::Interior};
/// use sweep_cdt_edit::{Bounds, Refinement};
/// use sweep_cdt_engine::RefinedFile;
/// use sweep_cdt_formats::GraphFile;
///
/// let points = vec![[0.0, 0.0], [8.0, 0.0], [8.0, 1.0]];
/// let file = GraphFile::from(Pslg { points, edges: vec![[0, 1]], ..Pslg::default() });
/// let result = sweep_cdt::triangulate(&file.graph.points, &file.graph.edges)?;
/// let whole = Interior::whole(&result);
/// let how = Refinement::new(Bounds { greatest_area: Some(1.0), ..Bounds::default() });
/// let refined = RefinedFile::new(&file, &whole, &how)?;
/// assert!(refined.left.is_empty());
/// assert_eq!(refined.interior(&whole).triangles().len(), refined.result.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct RefinedFile<S> {
    /// The file with all vertices, and with the parts of its edges.
    pub file: GraphFile<S>,
    /// The triangulation of the vertices and parts.
    pub result: Triangulation,
    /// The triangles inside, each from its lowest vertex, sorted.
    pub triangles: Vec<[usize; 3]>,
    /// For each triangle inside its region.
    pub regions: Vec<Option<usize>>,
    /// The triangles that break a bound still.
    pub left: Vec<Left>,
    /// How many heights of new vertices come from the triangles of the file.
    heights: usize,
}

impl<S: Coordinate> RefinedFile<S> {
    /// Refines what is inside; `inside` is an interior of the triangulation of the file.
    ///
    /// # Errors
    /// [`RefineError`], before anything is done.
    ///
    /// # Panics
    /// The mesh is not the triangulation of its vertices and edges: a bug.
    pub fn new(
        file: &GraphFile<S>,
        inside: &Interior<'_>,
        how: &Refinement<'_>,
    ) -> Result<RefinedFile<S>, RefineError> {
        let graph = &file.graph;
        let mesh = how.run(&graph.points, &graph.edges, inside)?;
        let columns = columns(file, inside, &mesh);
        let new = graph.points.len()..mesh.points.len();
        let known = |column: &Column| new.filter(|&v| !column.values[v].is_nan()).count();
        let mut heights = columns
            .iter()
            .filter(|column| column.name == Column::HEIGHT);
        let heights = heights.next().map_or(0, known);
        let Refined {
            points,
            edges,
            edge_of,
            triangles,
            regions,
            left,
            ..
        } = mesh;
        // Each edge of the file has a part, if only one without a length.
        let mut parts = edges.into_iter().zip(edge_of).peekable();
        let (mut edges, mut pieces_of) = (Vec::new(), Vec::new());
        for (edge, &ends) in graph.edges.iter().enumerate() {
            let before = edges.len();
            while let Some((part, _)) = parts.next_if(|&(_, of)| of == Some(edge)) {
                edges.push(part);
            }
            if edges.len() == before {
                edges.push(ends);
            }
            pieces_of.resize(edges.len(), edge);
        }
        edges.extend(parts.map(|(part, _)| part));
        let result = sweep_cdt::triangulate(&points, &edges);
        let result = result.expect("the mesh is a triangulation of its vertices and edges");
        let file = GraphFile {
            columns,
            ..file.with_pieces(points, edges, &pieces_of)
        };
        Ok(RefinedFile {
            file,
            result,
            triangles,
            regions,
            left,
            heights,
        })
    }

    /// The triangles inside, with the regions of `before`, the interior that was refined.
    pub fn interior(&self, before: &Interior<'_>) -> Interior<'_> {
        before.carried(&self.result, |t| {
            let [a, b, c] = self.result.triangle(t);
            let turned = [[a, b, c], [b, c, a], [c, a, b]].into_iter().min();
            let place = self.triangles.binary_search(&turned?).ok()?;
            Some(self.regions[place])
        })
    }

    /// The remarks: how many triangles break a bound still, for each reason, and where heights come from.
    pub fn remarks(&self) -> Vec<Remark> {
        let mut counts = BTreeMap::new();
        for left in &self.left {
            *counts.entry(left.reason).or_insert(0) += 1;
        }
        let unrefined = counts.into_iter().map(|(reason, triangles)| {
            let reason = reason.to_string();
            Remark::Unrefined { triangles, reason }
        });
        let (heights, outside) = (self.heights, 0);
        let interpolated = Remark::Interpolated { heights, outside };
        unrefined
            .chain((heights > 0).then_some(interpolated))
            .collect()
    }
}

/// The columns of a file with the numbers of the new vertices of a mesh.
fn columns<S: Coordinate>(
    file: &GraphFile<S>,
    inside: &Interior<'_>,
    mesh: &Refined<S>,
) -> Vec<Column> {
    let points = &file.graph.points;
    // The vertices along each side of the triangulation that was split.
    let mut chains: Vec<Vec<usize>> = Vec::new();
    for &[a, b] in &mesh.edges {
        match chains.last_mut() {
            Some(chain) if a >= points.len() => chain.push(b),
            _ => chains.push(vec![a, b]),
        }
    }
    let chains = || {
        chains
            .iter()
            .map(|chain| ([chain[0], chain[chain.len() - 1]], &chain[..]))
    };
    let result = inside.triangulation();
    let new = &mesh.points[points.len()..];
    let whole = Interior::whole(result);
    let asks = file
        .columns
        .iter()
        .any(|column| column.name != Column::MARKER);
    let places = Places::new(points, &whole, if asks { new } else { &[] }, None);
    let column = |column: &Column| {
        let (mut extended, _) = column.extended(&mesh.points, chains());
        if column.name != Column::MARKER {
            let found = Surface::new(points, &whole, &column.values).heights_of(&places);
            for (value, found) in extended.values[points.len()..].iter_mut().zip(found) {
                if value.is_nan() {
                    *value = found.unwrap_or(f64::NAN);
                }
            }
        }
        extended
    };
    file.columns.iter().map(column).collect()
}

/// The bounds of a refinement: those that were asked for, or a least angle of 20 degrees where nothing bounds
/// triangles.
pub fn bounds_or_default(given: Bounds, has_areas: bool) -> Bounds {
    let has_none = given == Bounds::default() && !has_areas;
    Bounds {
        least_angle: given.least_angle.or(has_none.then_some(20.0)),
        ..given
    }
}

/// The greatest area in each region of an interior: that of the file, or another one that is given for its number in the
/// file. Regions of polygons have the number of their feature. A remark tells that the rule has no use for areas of the
/// file.
///
/// # Errors
/// There is no region of such a number.
pub fn region_areas<S: Exact>(
    file: &GraphFile<S>,
    rule: Inside,
    inside: &Interior<'_>,
    given: &[(usize, f64)],
) -> Result<(Vec<f64>, Option<Remark>), UnknownName> {
    let numbers: Vec<usize> = if inside.is_of_polygons() {
        file.polygons.features.clone()
    } else if inside.has_regions() {
        (0..file.graph.regions.len())
            .map(|region| region + file.numbering.region)
            .collect()
    } else {
        Vec::new()
    };
    if let Some((unknown, _)) = given.iter().find(|(number, _)| !numbers.contains(number)) {
        let known: Vec<String> = numbers.iter().map(usize::to_string).collect();
        let known = known.iter().map(String::as_str);
        return Err(UnknownName::new("region", &unknown.to_string(), known));
    }
    let own = match rule.has_regions() {
        true => &file.region_areas[..],
        false => &[],
    };
    let area = |(region, number): (usize, &usize)| {
        let given = given.iter().rev().find(|(other, _)| other == number);
        given
            .map(|(_, area)| *area)
            .or_else(|| own.get(region).copied())
            .unwrap_or(f64::INFINITY)
    };
    let areas = numbers.iter().enumerate().map(area).collect();
    let finite = file.region_areas.iter().filter(|area| area.is_finite());
    let unused = Remark::UnusedAreas {
        areas: finite.count(),
        rule: rule.to_string(),
    };
    let is_unused = own.is_empty() && !file.region_areas.is_empty();
    Ok((areas, is_unused.then_some(unused)))
}
