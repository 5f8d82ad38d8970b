//! The bands become one triangulation: their meshes one after the other, the gaps between them closed, and the
//! edges from band to band inserted.
//!
//! Why it is right: where no edges are, the merge of divide and conquer gives the one triangulation of both
//! parts. Where there are some, it zips the gap up, and legalization leads to the same from any triangulation
//! that has the edges (the canonical rule). After that an edge is inserted as into any triangulation.
//!
//! Cost: O(n) to move n triangles and vertices, O(h) for each gap between hulls of h vertices, and the flips. The
//! flips may be many, so they have a budget ([`super::super::flip_limit`]).

use super::super::divide_and_conquer::Seam;
use super::super::fabric::Fabric;
use super::super::flip_limit::FlipLimit;
use super::super::memory::Memory;
use super::super::signs::Signs;
use super::super::state::Sweep;
use super::across::Starts;
use super::band::Swept;
use crate::error::Error;
use crate::front::FrontSearch;
use crate::ids::{VertexId, narrow};
use crate::scalar::Scalar;
use crate::settings::Settings;

/// Joins the bands, of which there are at least two, into the state of a sweep whose hull is complete. `None` if
/// that takes too many flips.
pub(super) fn join<'a, S: Scalar, F: FrontSearch>(
    points: &'a [[S; 2]],
    bands: Vec<Swept>,
    across: Vec<(u32, [VertexId; 2])>,
    settings: Settings<'_>,
    search: F,
) -> Result<Option<Sweep<'a, S, F, ()>>, Error> {
    let mut bands = bands.into_iter();
    let mut whole = bands.next().expect("there are two bands");
    let mut parts = vec![whole.part];
    let mut starts = Starts::default();
    for band in bands {
        starts.add(whole.vertices.len(), whole.mesh.len());
        parts.push(band.part.moved(narrow(whole.mesh.len())));
        let before = narrow(whole.vertices.len());
        rayon::join(
            || whole.mesh.append(band.mesh, before),
            || whole.vertices.append(band.vertices),
        );
        whole.chains.append(band.chains)?;
    }
    let n = whole.vertices.len();
    whole.mesh.renew_open(n + 2);
    let mut memory = Memory {
        mesh: whole.mesh,
        front: whole.front,
        ..Memory::default()
    };
    let signs = Signs::new(points, whole.vertices);
    let mut fabric = Fabric::new(signs, true, (), &mut memory);
    let seam = if whole.chains.is_empty() {
        Seam::Carved
    } else {
        Seam::Zipped
    };
    let mut part = parts[0];
    for &upper in &parts[1..] {
        part = fabric.merge(part, upper, seam);
    }
    fabric.legalize();
    if fabric.flip_limit.is_spent() {
        return Ok(None);
    }
    fabric.flip_limit = FlipLimit::new(n, false);
    let mut sweep = Sweep::new(
        fabric,
        whole.chains,
        settings.heuristics,
        search,
        &mut memory,
    );
    sweep.hand_over(part.first);
    sweep.insert_across(across, &starts)?;
    sweep.insert_rests()?;
    Ok(Some(sweep))
}
