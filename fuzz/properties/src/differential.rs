//! Other programs on the same input: where one differs from the exact oracle, it is wrong.
//!
//! The oracle's [`check`] passes our result first, or the property fails. Then the sides that no choice
//! among cocircular triangles can change must be those of the other program too. Otherwise, or if it panics
//! or refuses the input, a fault of that program is counted. The verifier of the crate must come to the same
//! verdict: this also tests the verifier on the results of others.
//!
//! Programs get only inputs that they may be expected to accept: numbers of moderate size, no points too
//! close to each other, edges that have a length and do not cross. They run in this process, so one that
//! overflows the stack or does not return ends the campaign, which keeps the input.
//!
//! With the environment variable `SWEEP_CDT_PEER_FAULTS` set to a folder, each process writes there from time
//! to time how many faults of each kind it has found, and for the first inputs of each kind a row of the table
//! of cases, minimized.

use std::cell::Cell;
use std::cmp::Ordering::{Greater, Less};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Write;
use std::panic::{catch_unwind, set_hook, take_hook};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, Once, OnceLock};

use sweep_cdt::triangulate;
use sweep_cdt::verify::Verifier;

use crate::reached;
use sweep_cdt_testing::minimize::minimize;
use sweep_cdt_testing::oracle::{Answer, Graph, Number, Point, check, firm_sides};
use sweep_cdt_testing::peers::{PROGRAMS, Program};
use sweep_cdt_testing::{Input, generators, with_integers};

/// The property for the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let input = generators::input(bytes);
    reached::sample(&input);
    let Some(answer) = right_answer(&input) else {
        return;
    };
    for (name, program, takes_edges) in PROGRAMS {
        if is_question(&input, takes_edges) {
            let fault = fault(&input, &answer, program);
            count(&input, name, fault, &|input| {
                let answer = right_answer(input).filter(|_| is_question(input, takes_edges))?;
                self::fault(input, &answer, program)
            });
        }
    }
}

/// Our result, passed by the oracle, unless edges cross.
fn right_answer(input: &Input) -> Option<Answer> {
    let Input { points, edges } = input;
    let result = triangulate(points, edges).ok()?;
    Some(check(points, edges, &result))
}

/// Whether a program may be expected to accept this.
///
/// `spade` takes magnitudes from 2^-142 to 2^201; `delaunator` and `cdt` name no limits, but compute
/// squares of squares in doubles, and `delaunator` drops points within 2^-51 of each other.
fn is_question(input: &Input, takes_edges: bool) -> bool {
    const SPADE: [f64; 2] = [1e-42, 1e60];
    const OTHERS: [f64; 2] = [1e-9, 1e15];
    let [least, most] = if takes_edges { SPADE } else { OTHERS };
    let has_size = |x: &f64| *x == 0.0 || (least..=most).contains(&x.abs());
    let are_close = |p: &[f64; 2], q: &[f64; 2]| (0..2).all(|i| (p[i] - q[i]).abs() <= least);
    let mut points = input.points.iter().enumerate();
    (takes_edges || input.edges.is_empty())
        && input.points.as_flattened().iter().all(has_size)
        && (takes_edges || !points.any(|(i, p)| input.points[..i].iter().any(|q| are_close(p, q))))
}

/// What is wrong with a program's answer: the name of the first violation, that there is none, or that
/// it panics.
fn fault(input: &Input, answer: &Answer, program: Program) -> Option<&'static str> {
    let Input { points, edges } = input;
    let has_length = |(e, _): &(usize, &[usize; 2])| answer.chains[*e].len() > 1;
    let numbered = edges.iter().enumerate();
    let edges: Vec<[usize; 2]> = numbered.filter(has_length).map(|(_, &e)| e).collect();
    match quietly(|| catch_unwind(|| program(points, &edges))) {
        Err(_) => Some("panic"),
        // Without triangles there is nothing to answer.
        Ok(Err(_)) => (!answer.triangles.is_empty()).then_some("refused"),
        Ok(Ok(triangles)) => {
            let verifier = Verifier::new().accept_clockwise(true);
            let verdict = verifier.verify(points, &edges, &triangles);
            let is_right =
                with_integers!(points, |exact| agrees(&exact, points, answer, &triangles));
            assert_eq!(
                verdict.is_ok(),
                is_right,
                "{verdict:?} of {triangles:?} for\n{input}"
            );
            verdict.err().map(|violations| violations.list[0].name())
        }
    }
}

/// Whether triangles, all of one orientation, are the right ones but for choices among cocircular ones.
///
/// Their sides with a triangle on one side only are then the hull's, so they cover it once.
fn agrees<N: Number>(
    exact: &[Point<N>],
    points: &[[f64; 2]],
    answer: &Answer,
    triangles: &[[usize; 3]],
) -> bool {
    let graph = Graph::new(exact, &[]);
    let turn = |&[a, b, c]: &[usize; 3]| graph.orient(a, b, c);
    let is_clockwise = triangles.first().is_some_and(|t| turn(t) == Less);
    let named = |&[a, b, c]: &[usize; 3]| {
        let corners = if is_clockwise { [b, a, c] } else { [a, b, c] };
        corners.map(|v| answer.representatives[v])
    };
    let triangles: Vec<[usize; 3]> = triangles.iter().map(named).collect();
    let mut sides = BTreeSet::new();
    let is_new = |&[a, b, c]: &[usize; 3]| {
        [[a, b], [b, c], [c, a]]
            .into_iter()
            .all(|side| sides.insert(side))
    };
    triangles.len() == answer.triangles.len()
        && triangles.iter().all(|t| turn(t) == Greater)
        && triangles.iter().all(is_new)
        && {
            let theirs = Answer {
                triangles,
                ..answer.clone()
            };
            firm_sides(points, &theirs) == firm_sides(points, answer)
        }
}

/// So many inputs of a kind are written.
const SHOWN: u64 = 3;
/// So many answers pass between two writings of the counts.
const WRITE: u64 = 4096;

/// How often each program had each fault, or none.
static COUNTS: Mutex<BTreeMap<(&str, &str), u64>> = Mutex::new(BTreeMap::new());

/// Counts an answer, and shows its fault if `SWEEP_CDT_PEER_FAULTS` asks for it; `again` finds the fault
/// of smaller inputs.
fn count(
    input: &Input,
    program: &'static str,
    fault: Option<&'static str>,
    again: &dyn Fn(&Input) -> Option<&'static str>,
) {
    static FOLDER: OnceLock<Option<PathBuf>> = OnceLock::new();
    let folder =
        FOLDER.get_or_init(|| std::env::var_os("SWEEP_CDT_PEER_FAULTS").map(PathBuf::from));
    let (Some(folder), Ok(mut counts)) = (folder, COUNTS.lock()) else {
        return;
    };
    let count = counts
        .entry((program, fault.unwrap_or("right")))
        .or_default();
    *count += 1;
    // A report that cannot be written must not stop a campaign.
    if let Some(fault) = fault
        && *count <= SHOWN
    {
        let is_other = |input: &Input| assert_ne!(again(input), Some(fault));
        let least = quietly(|| minimize(&is_other, input));
        let _ = show(folder, program, fault, &least);
    }
    if counts.values().sum::<u64>() % WRITE == 1 {
        let rows = counts.iter();
        let text: String = rows
            .map(|((program, fault), count)| format!("{program}\t{fault}\t{count}\n"))
            .collect();
        let _ = fs::write(folder.join(format!("{}.tsv", std::process::id())), text);
    }
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

thread_local! {
    static IS_QUIET: Cell<bool> = const { Cell::new(false) };
}

/// Calls a function that catches its own panics, which are expected: without the hook, so that they are
/// neither printed nor end the process.
///
/// A fuzz target's process has a panic hook that aborts. One hook around it, set once, that does nothing
/// on a thread which is asking another program, costs nothing per call, and leaves all other panics as
/// they are.
fn quietly<T>(call: impl FnOnce() -> T) -> T {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let loud = take_hook();
        set_hook(Box::new(move |panic| {
            if !IS_QUIET.get() {
                loud(panic);
            }
        }));
    });
    let before = IS_QUIET.replace(true);
    let result = call();
    IS_QUIET.set(before);
    result
}

#[test]
fn only_other_panics_reach_the_hook() {
    static HEARD: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let loud = take_hook();
    set_hook(Box::new(move |panic| {
        match panic.payload().downcast_ref::<&str>() {
            Some(text @ (&"before" | &"expected" | &"after")) => {
                HEARD.lock().expect("no panic holds it").push(text);
            }
            _ => loud(panic),
        }
    }));
    assert!(catch_unwind(|| panic!("before")).is_err());
    assert!(quietly(|| catch_unwind(|| panic!("expected"))).is_err());
    assert!(catch_unwind(|| panic!("after")).is_err());
    assert_eq!(
        *HEARD.lock().expect("no panic holds it"),
        ["before", "after"]
    );
}
