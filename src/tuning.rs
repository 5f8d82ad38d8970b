//! Thresholds, all in one place: what each decides, and what it trades. None changes the result.
//!
//! [`Tuning`] holds those that decide from what size on an input is handled as a large one. It has two sets of values:
//! with [`Tuning::SMALL`] the small inputs of tests and fuzz targets take the paths of large ones. All other thresholds
//! are constants. Error bounds, limits of a representation and angles stand where they are used, and so do the
//! thresholds of the verifier, which shares no code with the sweep.

/// The thresholds from which on an input is handled as a large one. For tests.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Tuning {
    /// Sort: the mean number of points in a bucket of y. More fit in no cache; fewer need more buckets.
    pub(crate) points_in_bucket: usize,
    /// Sort: how many points of one key are put in order by counting which come before, at most
    /// [`SHORT_RUN`]. Quadratic, but without branches.
    pub(crate) short_run: usize,
    /// Hash table: one of this many points of the sample may be far away at either end. Points farther in widen all
    /// intervals.
    pub(crate) outermost: usize,
    /// Hash table: how many points of the sample, one above the other, are a slab. Fewer tell less of the crowding in one;
    /// more mix the crowding of different heights.
    pub(crate) slab: usize,
    /// Point event: a walk along the front of more steps spends the budget. Shorter walks cost less than to count them.
    pub(crate) long_walk: usize,
    /// Budget: flips in the reserve beyond half a flip for each vertex. A small one abandons sweeps that would recover.
    pub(crate) reserve: u64,
    /// Edge event: the triangles that each part of an edge may pierce. More can make a hatch slow; beyond fewer, ordinary
    /// edges have to wait.
    pub(crate) pierced_by_part: usize,
    /// Edge event: the triangles that all edges together may pierce beyond that, for each vertex.
    pub(crate) pierced_for_vertex: u64,
    /// Edges that wait: the triangles of the first turn around each end.
    pub(crate) first_turn: usize,
    /// Pseudo-polygons: a chain of so many vertices is filled as the chains of the front are. It cannot flip much, and to
    /// draw an order costs more.
    pub(crate) short_chain: usize,
}

impl Tuning {
    /// The values that ship.
    pub const REAL: Tuning = Tuning {
        points_in_bucket: 256,
        short_run: SHORT_RUN,
        outermost: 64,
        slab: 64,
        long_walk: 32,
        reserve: 1000,
        pierced_by_part: 16,
        pierced_for_vertex: 2,
        first_turn: 8,
        short_chain: 16,
    };
    /// Small inputs are handled as if they were large.
    pub const SMALL: Tuning = Tuning {
        points_in_bucket: 8,
        short_run: 8,
        outermost: 8,
        slab: 4,
        long_walk: 2,
        reserve: 4,
        pierced_by_part: 1,
        pierced_for_vertex: 0,
        first_turn: 1,
        short_chain: 3,
    };
}

impl Default for &'static Tuning {
    fn default() -> Self {
        &Tuning::REAL
    }
}

// The points (src/sweep/vertices).

/// How many points are tested for plain coordinates at once, without branches between them.
pub(crate) const TESTED_AT_ONCE: usize = 64;
/// The most buckets of y: so many ends fit in the cache.
pub(crate) const MOST_BUCKETS: usize = 1024;
/// One of how many points is sampled to find the range of y, and how many at most.
pub(crate) const SAMPLE_OF_Y: (usize, usize) = (16, 1024);
/// Samples of y beyond the middle half of them by more than this many times its height are far outside.
pub(crate) const FAR_OUTSIDE: f64 = 8.0;
/// The most points of [`Tuning::short_run`].
pub(crate) const SHORT_RUN: usize = 20;
/// So many points of different y are sorted by comparison although there is a way without branches.
pub(crate) const VERY_SHORT_RUN: usize = 5;

// The hash table (src/front).

/// Inputs with fewer vertices have one interval, for their front is short.
pub(crate) const ONE_INTERVAL: usize = 24;
/// How many intervals are searched on either side before the node inserted last is taken.
pub(crate) const INTERVALS_SEARCHED: usize = 16;
/// How many nodes the front may have for each interval.
pub(crate) const NODES_IN_INTERVAL: usize = 8;
/// Into how many an interval is cut when the front has more nodes.
pub(crate) const PARTS_OF_INTERVAL: usize = 4;
/// How many points the sample has for each interval, and how many at most.
pub(crate) const SAMPLE_OF_X: [usize; 2] = [2, 4096];
/// Quantiles are taken if the crowding is at least this: to find them takes a search.
pub(crate) const CROWDED: usize = 4;
/// A sample of fewer slabs is not cut into slabs.
pub(crate) const FEWEST_SLABS: usize = 4;
/// How many times as many equal intervals there are at most where slabs are crowded.
pub(crate) const FINEST: usize = 8;

// The sweep (src/sweep).

/// How many point events pass between two looks at the budget.
pub(crate) const EVENTS_BETWEEN_LOOKS: u32 = 16;
/// How many point events pass between two reports of progress.
pub(crate) const EVENTS_BETWEEN_REPORTS: u32 = 4096;
/// Flips that the budget grants for each vertex swept.
pub(crate) const FLIPS_FOR_VERTEX: u64 = 8;
/// Flips that the budget grants for each corner of a chain.
pub(crate) const FLIPS_FOR_CORNER: u64 = 4;
/// Flips that the budget grants for each vertex when the hull is completed: to begin anew so late costs more.
pub(crate) const FLIPS_FOR_HULL: u64 = 2;
/// Steps along the front that cost as much as a flip.
pub(crate) const STEPS_FOR_FLIP: u64 = 8;
/// Flips for each vertex that are no excess.
pub(crate) const COMMON_FLIPS: u64 = 4;
/// The excess brings the paper's heuristics beyond the reserve divided by this: a later change helps less.
pub(crate) const RESERVE_FOR_PAPER: u64 = 8;
/// How many nodes the search for a basin may pass on its way down, and again on its way up.
pub(crate) const BASIN_REACH: usize = 32;
/// How many edges the fast path of the edge event looks for, one by one: no slower than making the triangles around the
/// upper end.
pub(crate) const EDGES_LOOKED_FOR: usize = 4;
/// Chains of at most this many vertices are closed one corner at a time: they cannot flip much.
pub(crate) const CLOSED_ONE_BY_ONE: usize = 6;
/// A flip stack of more sides does not wait for the end of the chain, so that it stays in the cache.
pub(crate) const LONG_FLIP_STACK: usize = 4096;
/// Runs of at most this many corners are inserted in one round: they are near each other in any order.
pub(crate) const IN_ONE_ROUND: usize = 4096;
/// Draws in a row that find no corner to take out, before a run is given up: half of the corners can be taken out.
pub(crate) const MOST_DRAWS: usize = 100;
/// The most artificial triangles that are sorted by comparison; to mark them needs a bit for each triangle.
pub(crate) const FEW_ARTIFICIAL: usize = 100;

// Bands (src/sweep/bands).

/// By default a band has at least so many points.
#[cfg(feature = "parallel")]
pub(crate) const LEAST_IN_BAND: usize = 50_000;
/// The greatest number of bands of any use: each band takes some memory for each chunk of points.
#[cfg(feature = "parallel")]
pub(crate) const MOST_BANDS: usize = 256;
/// How many edges from band to band, beyond one for every eight points, make bands no gain: one thread inserts them.
#[cfg(feature = "parallel")]
pub(crate) const MANY_ACROSS: usize = 10_000;
/// How many points are sampled to find bands of equal size.
#[cfg(feature = "parallel")]
pub(crate) const SAMPLE_OF_BANDS: usize = 1 << 14;
/// The step between sampled points: a prime, so that the sample finds no pattern in the order of the points.
#[cfg(feature = "parallel")]
pub(crate) const STRIDE_OF_SAMPLE: usize = 1_000_000_007;
/// How many points, or edges, a thread puts into bands at a time.
#[cfg(feature = "parallel")]
pub(crate) const CHUNK_OF_BANDS: usize = 1 << 15;
/// Triangles searched for the first vertices of a band beyond two for each vertex: some are made late.
#[cfg(feature = "parallel")]
pub(crate) const MADE_LATE: usize = 1 << 16;

// Numbers (src/scalar).

/// How many points are sampled for a lattice before all are looked at.
pub(crate) const SAMPLE_OF_LATTICE: usize = 16;
/// How many points are looked at before an axis is moved.
pub(crate) const SAMPLE_OF_AXIS: usize = 256;
/// How many near-ties, and one more for each [`VERTICES_A_TIE`] vertices, it takes to make integers of all vertices.
pub(crate) const NEAR_TIES: usize = 16;
/// See [`NEAR_TIES`].
pub(crate) const VERTICES_A_TIE: usize = 3;

// The result (src/triangulation).

/// So few triangles are looked at one by one to locate a point.
pub(crate) const LOOKED_AT_ONE_BY_ONE: usize = 6;
/// The walks that locate many points may take so many steps for each triangle and point.
pub(crate) const STEPS_TO_LOCATE: usize = 4;
/// How many triangles are put in canonical order at a time.
pub(crate) const CHUNK_OF_GROUPS: usize = 1 << 16;
/// How many groups several chunks have. Fewer would not fit in the cache; more would scatter a chunk too widely.
pub(crate) const GROUPS_OF_CHUNKS: usize = 256;
/// How many triangles are in the sample that tells how high vertices are.
pub(crate) const SAMPLE_OF_GROUPS: usize = 1 << 10;

// Crossings (src/crossings).

/// So few cells are not halved.
pub(crate) const CELLS_NOT_HALVED: usize = 4;
/// How many cells and pieces are looked at to choose a direction.
pub(crate) const SAMPLE_OF_CELLS: usize = 32;
/// How many pieces are tried as directions.
pub(crate) const DIRECTIONS_TRIED: usize = 4;
/// After so many rounds edges must not cross any more.
pub(crate) const ROUNDS_OF_SPLITTING: usize = 100;

// Memory (src/memory.rs).

/// Fewer bytes are not asked for. They seldom fail, and some allocators treat what follows a small block that was given
/// back in another way.
pub(crate) const LARGE_BLOCK: usize = 32 << 20;
