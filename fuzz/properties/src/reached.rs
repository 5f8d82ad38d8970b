//! Which degenerate events the executions of a campaign reach.
//!
//! With the environment variable `SWEEP_CDT_REACHED` set to a folder, every sixteenth input is triangulated
//! once more with counters and once with events, by the paper's heuristics. How many of these inputs had
//! each event, and of which kinds they are, is written there from time to time, one file a process. Without it this costs one
//! test.

use std::cell::Cell;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock};

use sweep_cdt::trace::{EdgePosition, Event, PointCase, Why};
use sweep_cdt::{Counters, Error, Heuristics, Triangulation};
use sweep_cdt_testing::asked;
use sweep_cdt_testing::judge::Question;
use sweep_cdt_testing::tuned::triangulator;
use sweep_cdt_testing::{Input, Steps};

/// Of so many inputs one is looked at.
const EVERY: u64 = 16;
/// So many inputs looked at pass between two writings of the file.
const WRITE: u64 = 16;

/// The run that an input led to.
struct Run {
    edges: usize,
    events: Vec<Event>,
    result: Result<Triangulation, Error>,
    counters: Counters,
}

/// Each thing to be reached, as it is named in the file, and whether a run has reached it.
type Reachable = (&'static str, fn(&Run) -> bool);

const REACHABLE: [Reachable; 16] = [
    ("left case", |run| {
        run.any(|event| matches!(event, Event::Point { case, .. } if *case == PointCase::Left))
    }),
    ("fill", |run| run.makes(Why::NarrowCorner)),
    ("basin", |run| run.makes(Why::Basin)),
    ("flip", |run| {
        run.any(|event| matches!(event, Event::Flip { .. }))
    }),
    ("edge already there", |run| {
        run.passes(EdgePosition::Present)
    }),
    ("edge below the front", |run| {
        run.passes(EdgePosition::BelowFront)
    }),
    ("edge by front traversal only", |run| {
        run.passes(EdgePosition::FrontOnly)
    }),
    ("edge by mixed traversal", |run| {
        run.passes(EdgePosition::Mixed)
    }),
    ("vertex on an edge", |run| {
        let is_split = |result: &Triangulation| {
            (0..run.edges).any(|edge| result.edge_chain(edge).nth(2).is_some())
        };
        run.result.as_ref().is_ok_and(is_split)
    }),
    ("upper hull", |run| run.makes(Why::Hull)),
    ("orientation by exact stage", |run| {
        run.counters.orient2d_exact() > 0
    }),
    ("in-circle by exact stage", |run| {
        run.counters.in_circle_exact() > 0
    }),
    ("canonical tie", |run| run.counters.cocircular > 0),
    ("test with an artificial vertex", |run| {
        run.counters.symbolic > 0
    }),
    ("duplicate points", |run| {
        let result = run.result.as_ref();
        result.is_ok_and(|result| result.duplicates().len() > 0)
    }),
    ("crossing edges", |run| run.result.is_err()),
];

impl Run {
    fn of(Input { points, edges }: &Input) -> Run {
        let Steps { trace, result, .. } = Steps::of(points, edges, Heuristics::PAPER);
        let run = sweep_cdt_testing::counted(&triangulator(points, edges), points, edges);
        Run {
            edges: edges.len(),
            events: trace.events,
            result,
            counters: run.map_or_else(|_| Counters::default(), |run| run.stats.counters),
        }
    }

    fn any(&self, is_asked: impl Fn(&Event) -> bool) -> bool {
        self.events.iter().any(is_asked)
    }

    /// Whether a triangle was made for this reason.
    fn makes(&self, asked: Why) -> bool {
        self.any(|event| matches!(event, Event::Triangle { why, .. } if *why == asked))
    }

    /// Whether a part of an edge was so.
    fn passes(&self, asked: EdgePosition) -> bool {
        self.any(|event| matches!(event, Event::Part { position, .. } if *position == asked))
    }
}

struct Tally {
    seen: u64,
    asked: asked::Tally,
    reached: [u64; REACHABLE.len()],
}

static TALLY: Mutex<Tally> = Mutex::new(Tally {
    seen: 0,
    asked: asked::Tally::NONE,
    reached: [0; REACHABLE.len()],
});

thread_local! {
    static COUNTED: Cell<Option<asked::Tally>> = const { Cell::new(None) };
}

/// Of which kinds the inputs are that are sampled while this work is done.
pub fn counted(work: impl FnOnce()) -> asked::Tally {
    COUNTED.set(Some(asked::Tally::NONE));
    work();
    COUNTED.take().unwrap_or(asked::Tally::NONE)
}

/// Counts what this input reaches, if the environment asks for it.
pub fn sample(input: &Input) {
    let question = || Question::new(&input.points, &input.edges);
    if let Some(mut tally) = COUNTED.get() {
        tally.add(&question());
        COUNTED.set(Some(tally));
    }
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_REACHED").map(PathBuf::from));
    if let Some(folder) = folder
        && let Ok(mut tally) = TALLY.lock()
    {
        tally.seen += 1;
        if tally.seen % EVERY == 1 {
            tally.asked.add(&question());
            let run = Run::of(input);
            for (count, (_, is_reached)) in tally.reached.iter_mut().zip(REACHABLE) {
                *count += u64::from(is_reached(&run));
            }
            if tally.asked.questions % WRITE == 1 {
                write(folder, &tally);
            }
        }
    }
}

fn write(folder: &Path, tally: &Tally) {
    let mut text = format!("inputs\t{}\n", tally.asked.questions);
    let events = REACHABLE.iter().map(|(name, _)| name).zip(tally.reached);
    let kinds = asked::KINDS.iter().map(|(name, _)| name);
    for (name, count) in events.chain(kinds.zip(tally.asked.kinds)) {
        text += &format!("{name}\t{count}\n");
    }
    // A report that cannot be written must not stop a campaign.
    let _ = fs::write(folder.join(format!("{}.tsv", std::process::id())), text);
}
