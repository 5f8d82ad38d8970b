//! Points and edges in the order of the sweep, sorted in external memory: for inputs that do not fit in memory.
//!
//! A sweep needs the points by y, then x, and at each point the edges that begin there. This module reads an [`Input`]
//! once from front to back, in pieces, and sorts it with a stated memory and temporary files. What comes out is a
//! [`SweepOrder`], one vertex after the other.
//!
//! ```
//! use sweep_cdt_stream::external::{Format, Sorting, open};
//!
//! # let folder = tempfile::tempdir()?;
//! # let path = folder.path().join("points.xy");
//! let points = [[0.0_f64, 2.0], [1.0, 1.0], [0.0, 1.0]];
//! std::fs::write(&path, points.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<_>>())?;
//!
//! let mut input = open(&path, Format::F64, None)?;
//! let mut order = Sorting::new(256 << 20, folder.path()).sort(&mut *input)?;
//! let mut numbers = Vec::new();
//! while let Some(vertex) = order.next_vertex()? {
//!     numbers.push(vertex.number);
//! }
//! assert_eq!(numbers, [2, 1, 0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Points.** As many points as some quarter of the memory holds are sorted as a run (`in_memory.rs`) and written to a temporary
//! file, while the next ones are read. All runs are merged in the background while the order is taken (`runs.rs`). Where
//! all points are one run, nothing is written. Equal points come one after the other, that with the lowest number first.
//!
//! **Edges.** An edge names its ends by number, and is needed at its lower end by place (`edges.rs`). The runs are loaded
//! once more, one after the other: each holds the points of an interval of numbers. An edge waits for the run of one end,
//! takes its place along to the run of the other, and is then sorted by the place of its lower end, as points are.
//!
//! **Why it is right.** Coordinates are finite doubles, -0.0 is 0.0, and the number decides between equal places: so there
//! is one order, and it depends neither on the memory nor on the threads.
//!
//! **Cost.** A point takes 20 bytes of disk, 28 with a height, and is written and read once; where there are edges it is read twice. An edge
//! takes up to 96. Time is linear, for points that are spread over the plane, also in clusters and in rows. The memory is a
//! bound for what is sorted and buffered (`memory.rs`), half of which is free while the order is taken. What is needed grows
//! with the square root of the input: 64 MB suffice for 10^10 points or 10^9 edges, 256 MB for 16 times as many. More
//! memory makes fewer and longer runs. The edges of one vertex are in memory together, whatever the bound.
//!
//! **Tiles.** [`chained`] makes one input of several, whose points are numbered on through all of them.
//!
//! **Bands.** For many machines [`Bands`] cuts the order.
//!
//! **What can fail.** Every fault of the input and of the disk is an [`Error`]. Temporary files have no names, so nothing
//! of them is left, however the process ends.

mod bands;
mod batch;
mod edges;
mod error;
mod in_memory;
mod input;
mod memory;
mod order;
mod points;
mod prepare;
mod record;
mod runs;
mod sorter;
mod summary;
mod temporary;

pub use bands::{Band, Bands};
pub use error::Error;
pub use input::{Choice, FORMATS, Input, Part, chained, open, open_chosen, read_chosen};
pub use order::{SweepOrder, Vertex};
pub use prepare::Sorting;
pub use summary::{Statistics, Summary};
pub use sweep_cdt_formats::Format;
