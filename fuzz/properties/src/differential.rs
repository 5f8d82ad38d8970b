//! Other programs on the same input: where one differs from the exact oracle, it is wrong.
//!
//! What another program answers must fill the hull, have all edges and be Delaunay. Otherwise, or if that program panics
//! or refuses the input, a fault is counted. The canonical triangles need no judge. The verifier of the crate judges all
//! others. For one input in four the oracle judges everything by definition, our result first ([`Right::of`]), and the
//! verifier must come to the same verdict: so it is tested on the results of others.
//!
//! Programs get only inputs that they may be expected to accept: numbers of moderate size, no points too
//! close to each other, edges that have a length and do not cross. They run in this process, so one that
//! overflows the stack or does not return ends the campaign, which keeps the input. Of `cdt` it is known that its hull
//! goes round a bucket of points for ever. It answers on a thread of its own, and is not asked again after that.
//!
//! With the environment variable `SWEEP_CDT_PEER_FAULTS` set to a folder, each process writes there from time
//! to time how many faults of each kind it has found, and for the first inputs of each kind a row of the table
//! of cases, minimized.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, OnceLock, mpsc};
use std::thread;
use std::time::Duration;

use crate::{reached, share};
use sweep_cdt_testing::judge::{
    Asked, Claims, Fault, Numbers, Outcome, Question, Right, Wrong, ask, least,
};
use sweep_cdt_testing::oracle::lowest_first;
use sweep_cdt_testing::peers::{PROGRAMS, Program};
use sweep_cdt_testing::tuned::triangulate;
use sweep_cdt_testing::{Input, generators};

/// For one in so many inputs the oracle judges all answers.
const JUDGED: u64 = 4;

/// The property for the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let input = generators::input(bytes);
    reached::sample(&input);
    let with_oracle = share::is_chosen(bytes, JUDGED);
    let Some(right) = right(&input, with_oracle) else {
        return;
    };
    let points = &input.points;
    let has_length = |edge: &&[usize; 2]| points[edge[0]] != points[edge[1]];
    let edges: Vec<[usize; 2]> = input.edges.iter().filter(has_length).copied().collect();
    let question = Question::new(points, &edges);
    for (name, program, takes_edges) in PROGRAMS {
        if is_question(&input, takes_edges)
            && let Some(outcome) = asked(name, program, &question)
        {
            let fault = match &outcome {
                _ if with_oracle => right.fault(&question, &outcome),
                Outcome::Triangles(list) if is_same(list, &right) => None,
                _ => right.fault_by_verifier(&question, &outcome),
            };
            count(name, (program, takes_edges), &question, outcome, fault);
        }
    }
}

/// The canonical triangles; nothing, if edges cross.
fn right(Input { points, edges }: &Input, with_oracle: bool) -> Option<Right> {
    if with_oracle {
        return Right::of(&Question::new(points, edges)).ok();
    }
    let result = triangulate(points, edges).ok()?;
    Some(Right {
        inside: result.canonical_triangles(),
        outside: Vec::new(),
    })
}

/// Whether these are the right triangles, all turned the right way or all the other.
fn is_same(list: &[[usize; 3]], right: &Right) -> bool {
    let equals = |turn: fn([usize; 3]) -> [usize; 3]| {
        let mut list: Vec<[usize; 3]> = list.iter().map(|&t| lowest_first(turn(t))).collect();
        list.sort_unstable();
        list == right.inside
    };
    list.len() == right.inside.len() && (equals(|t| t) || equals(|[a, b, c]| [a, c, b]))
}

/// What a program answers; nothing, if it is one that has hung before.
fn asked(name: &str, program: Program, question: &Question) -> Option<Outcome> {
    let answer = move |question: &Question| {
        ask(question, &mut |question: &Question| {
            program(&question.points, &question.edges)
        })
    };
    if name != HANGS {
        return Some(answer(question));
    }
    static HAS_HUNG: AtomicBool = AtomicBool::new(false);
    if HAS_HUNG.load(Ordering::Relaxed) {
        return None;
    }
    let (sender, receiver) = mpsc::channel();
    let question = question.clone();
    // The thread that hangs ends with the process.
    thread::spawn(move || {
        let _ = sender.send(answer(&question));
    });
    Some(receiver.recv_timeout(PATIENCE).unwrap_or_else(|_| {
        HAS_HUNG.store(true, Ordering::Relaxed);
        let what = format!("no answer within {} s", PATIENCE.as_secs());
        Outcome::Failed(Fault::new("hang", what))
    }))
}

/// The program that may never return, and how long it is waited for.
const HANGS: &str = "cdt";
const PATIENCE: Duration = Duration::from_secs(3);

/// Whether a program may be expected to accept this.
///
/// `spade` takes magnitudes from 2^-142 to 2^201; `delaunator` and `cdt` name no limits, but compute
/// squares of squares in doubles, and `delaunator` drops points within 2^-51 of each other.
fn is_question(input: &Input, takes_edges: bool) -> bool {
    let [least, most] = sizes(takes_edges);
    let has_size = |x: &f64| *x == 0.0 || (least..=most).contains(&x.abs());
    let are_close = |p: &[f64; 2], q: &[f64; 2]| (0..2).all(|i| (p[i] - q[i]).abs() <= least);
    let mut points = input.points.iter().enumerate();
    (takes_edges || input.edges.is_empty())
        && input.points.as_flattened().iter().all(has_size)
        && (takes_edges || !points.any(|(i, p)| input.points[..i].iter().any(|q| are_close(p, q))))
}

/// The sizes of the coordinates of a question.
fn sizes(takes_edges: bool) -> [f64; 2] {
    const SPADE: [f64; 2] = [1e-42, 1e60];
    const OTHERS: [f64; 2] = [1e-9, 1e15];
    if takes_edges { SPADE } else { OTHERS }
}

/// So many inputs of a kind are written.
const SHOWN: u64 = 3;
/// So many answers pass between two writings of the counts.
const WRITE: u64 = 4096;

/// How often each program had each fault, or none.
static COUNTS: Mutex<BTreeMap<(&str, &str), u64>> = Mutex::new(BTreeMap::new());

/// Counts an answer, and shows its fault if `SWEEP_CDT_PEER_FAULTS` asks for it.
fn count(
    name: &'static str,
    (program, takes_edges): (Program, bool),
    question: &Question,
    outcome: Outcome,
    fault: Option<Fault>,
) {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder =
        FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_PEER_FAULTS").map(PathBuf::from));
    let (Some(folder), Ok(mut counts)) = (folder, COUNTS.lock()) else {
        return;
    };
    let count = counts
        .entry((name, fault.as_ref().map_or("right", |fault| fault.name)))
        .or_default();
    *count += 1;
    // A report that cannot be written must not stop a campaign.
    if let Some(fault) = fault
        && *count <= SHOWN
    {
        let name_of_fault = fault.name;
        let question = question.clone();
        let wrong = Wrong {
            question,
            outcome,
            fault,
        };
        let least = small(name, program, takes_edges, wrong);
        let _ = show(folder, name, name_of_fault, &least);
    }
    if counts.values().sum::<u64>() % WRITE == 1 {
        let rows = counts.iter();
        let text: String = rows
            .map(|((program, fault), count)| format!("{program}\t{fault}\t{count}\n"))
            .collect();
        let _ = fs::write(folder.join(format!("{}.tsv", std::process::id())), text);
    }
}

/// A small input with the same fault; of a hang the input itself.
fn small(name: &str, program: Program, takes_edges: bool, wrong: Wrong) -> Input {
    let asked_for = if takes_edges {
        Asked::Edges
    } else {
        Asked::Points
    };
    let not_asked = || Outcome::Failed(Fault::new("not asked", ""));
    let [least_size, most] = sizes(takes_edges);
    let claims = Claims::of(asked_for).with_numbers(Numbers::doubles(least_size, most));
    let Question { points, edges, .. } = least(&claims, wrong, &mut |question| {
        let Question { points, edges, .. } = question.clone();
        match is_question(&Input { points, edges }, takes_edges) {
            true => asked(name, program, question).unwrap_or_else(not_asked),
            false => not_asked(),
        }
    })
    .question;
    Input { points, edges }
}

/// Adds a row to the file of this kind.
fn show(folder: &Path, program: &str, fault: &str, least: &Input) -> std::io::Result<()> {
    let name = format!("{program}-{fault}-{}.txt", std::process::id());
    let mut file = fs::File::options()
        .append(true)
        .create(true)
        .open(folder.join(name))?;
    writeln!(file, "{least}")
}
