//! Joining the bands: their meshes are put together, the gaps closed, and the edges from band to band inserted.
//!
//! Why it is right: without edges, the merge of divide and conquer gives the one triangulation of both bands. With
//! edges, it stitches the gap, and legalization leads to the one triangulation from any other that has the edges (the
//! canonical rule). Then an edge is inserted as into any triangulation. Cost: O(n) to move n triangles and vertices,
//! O(h) for each gap between hulls of h vertices, and flips up to a budget ([`super::super::flip_limit`]).

use super::super::Sweep;
use super::super::divide_and_conquer::MergeMode;
use super::super::flip_limit::FlipLimit;
use super::super::state::{Arrays, Scratch};
use super::band::Swept;
use super::partition::Edge;
use crate::front::{Front, HashTable, Search};
use crate::ids::narrow;
use crate::observe::probe::Probe;
use crate::observe::recorder::Recorder;
use crate::scalar::ExactPoints;
use crate::settings::Settings;
use alloc::vec;
use alloc::vec::Vec;

/// Joins two bands or more into a sweep whose hull is complete. `None` after too many flips, or where an edge is wrong.
pub(super) fn join<'a, P: Probe>(
    points: &'a dyn ExactPoints,
    bands: Vec<Swept>,
    crossing: Vec<Edge>,
    settings: Settings,
    mut probe: P,
    scratch: &'a mut Scratch,
) -> Option<Sweep<'a, P>> {
    let mut bands = bands.into_iter();
    let lowest = bands.next().expect("there are two bands");
    let (mut mesh, mut vertices, mut chains) = (lowest.mesh, lowest.vertices, lowest.chains);
    let (mut n, mut triangles) = (vertices.len(), mesh.len());
    add_counts(&mut probe, lowest.counts, 0);
    let mut parts = vec![lowest.part];
    let (mut starts, mut meshes, mut others) = (Vec::new(), Vec::new(), Vec::new());
    for band in bands {
        starts.push((n, triangles));
        parts.push(band.part.moved(narrow(triangles)));
        chains.append(band.chains).ok()?;
        add_counts(&mut probe, band.counts, triangles);
        n += band.vertices.len();
        triangles += band.mesh.len();
        meshes.push(band.mesh);
        others.push(band.vertices);
    }
    let (_, front) = rayon::join(
        || {
            mesh.reset_borders(n + 2);
            for (other, &(before, _)) in meshes.into_iter().zip(&starts) {
                mesh.append(&other, narrow(before));
            }
        },
        || {
            for other in others {
                vertices.append(other);
            }
            Front::new(n)
        },
    );
    scratch.arrays = Arrays {
        vertices,
        mesh,
        front: Some(front),
        chains,
        ..Arrays::default()
    };
    // The front is at its end: nothing is searched any more.
    let search = Search::with(None, HashTable::default());
    let mut sweep = Sweep::new(points, settings, search, probe, scratch);
    let delaunay = &mut sweep.delaunay;
    // Whatever the algorithm, joining is given up where it flips too much.
    delaunay.flip_limit = FlipLimit::new(n, Some(settings.tuning.reserve));
    let mode = if sweep.chains.is_empty() {
        MergeMode::Delete
    } else {
        MergeMode::Stitch
    };
    let mut part = parts[0];
    for &upper in &parts[1..] {
        part = delaunay.merge(part, upper, mode);
    }
    delaunay.legalize();
    if delaunay.flip_limit.is_spent() {
        return None;
    }
    delaunay.flip_limit = FlipLimit::new(n, None);
    sweep.hand_over(part.first);
    sweep.insert_across(crossing, &starts).ok()?;
    sweep.insert_waiting().ok()?;
    Some(sweep)
}

/// Adds the counts of a band whose triangles come after the first `triangles` of all bands.
fn add_counts(probe: &mut impl Probe, counts: Option<Recorder>, triangles: usize) {
    if let Some(counts) = counts {
        probe.record(|recorder| recorder.add_band(counts, triangles));
    }
}
