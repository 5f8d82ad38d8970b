//! The part of the hull that is inside, as `--inside` says.

use std::str::FromStr;

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_engine::Inside;
use sweep_cdt_formats::{Coordinate, GraphFile};

use super::failure::Failure;
use super::places::located_interior;

/// Arguments that choose the rule.
#[derive(clap::Args)]
pub(crate) struct InsideArgs {
    /// Which triangles are inside; no others are written [default: holes for a file with holes, polygons for one with
    /// polygons, otherwise hull]
    ///
    /// hull: all of the convex hull.
    ///
    /// polygons: what the outlines of polygons cover, each without its own holes, whichever way rings run. Lines bound
    /// nothing. For .geojson and .wkt, and for meshes with --faces.
    ///
    /// even-odd: what a path from outside enters by crossing an odd number of edges; one given twice is crossed twice.
    ///
    /// nonzero: what the edges go round, more often in one direction than in the other. positive: more often
    /// counter-clockwise. negative: more often clockwise. at-least-K: at least K times, in one direction. Each edge
    /// runs from its first vertex to its second. For these rules and for even-odd, the edges must be closed rings.
    ///
    /// holes: what is not reached without crossing an edge, neither from outside nor from the seed of a hole.
    ///
    /// hull-without-holes: what is not reached from the seed of a hole (-c of Triangle). By this rule and by holes,
    /// triangles have the attributes of the file's regions.
    #[arg(long, value_name = "RULE", value_parser = Inside::from_str)]
    inside: Option<Inside>,
}

/// The rule for a file where none is asked for.
pub(crate) fn default_of<S>(file: &GraphFile<S>) -> Inside {
    let has_seeds = !file.graph.holes.is_empty() || !file.region_areas.is_empty();
    Inside::default_of(has_seeds, !file.polygons.is_empty())
}

/// Refuses a rule that a file says nothing about; `name` is what messages call it.
pub(crate) fn expect_suits<S>(
    rule: Inside,
    name: &str,
    file: &GraphFile<S>,
) -> Result<(), Failure> {
    if rule == Inside::Polygons && file.polygons.is_empty() {
        return Err(Failure::Error(format!(
            "{name}: there are no polygons, which .geojson and .wkt have, and meshes with --faces; the rule even-odd \
             takes edges that are closed rings"
        )));
    }
    Ok(())
}

impl InsideArgs {
    /// The rule for a file, and why it is this one, in words.
    pub(crate) fn rule<S>(&self, file: &GraphFile<S>) -> (Inside, String) {
        let count = |number: usize, one: &str, many: &str| match number {
            1 => format!("1 {one}"),
            number => format!("{number} {many}"),
        };
        let (holes, polygons) = (file.graph.holes.len(), file.polygons.features.len());
        match (self.inside, default_of(file)) {
            (Some(rule), _) => (rule, "as --inside says".to_owned()),
            (None, Inside::Holes) => {
                let holes = count(holes, "hole", "holes");
                let why = format!("as the input has {holes}; --inside hull keeps all");
                (Inside::Holes, why)
            }
            (None, Inside::Polygons) => {
                let polygons = count(polygons, "polygon", "polygons");
                let why = format!("as the input has {polygons}; --inside hull keeps all");
                (Inside::Polygons, why)
            }
            (None, rule) => {
                let why = "as the input has no holes and no polygons; --inside holes keeps what edges enclose";
                (rule, why.to_owned())
            }
        }
    }

    /// The domain, unless it is the hull. `name` is what messages call the input.
    pub(crate) fn domain<'a, S: Coordinate>(
        &self,
        name: &str,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Result<Option<Interior<'a>>, Failure> {
        let (rule, _) = self.rule(file);
        expect_suits(rule, name, file)?;
        if rule == Inside::HULL {
            return Ok(None);
        }
        let domain = rule.interior(&file.into(), result);
        let refused = |error| {
            let way_out = match self.inside {
                None => " (--inside hull keeps all triangles)",
                Some(_) => "",
            };
            let error = located_interior(file, error);
            Failure::Error(format!("{name}: {error}{way_out}"))
        };
        domain.map(Some).map_err(refused)
    }
}
