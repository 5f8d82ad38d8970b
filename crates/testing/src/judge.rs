//! Is another program right about an input?
//!
//! The oracle's [`check`] passes this crate's result first. Then the sides that no choice among cocircular triangles can
//! change must be those of the other program too, or it is wrong. The verifier of the crate must come to the same
//! verdict, so that each answer is judged twice.
//!
//! ```
//! use sweep_cdt_testing::Input;
//! use sweep_cdt_testing::judge::{ask, least};
//!
//! // Joins the first point with all sides of the polygon that the points are taken for.
//! let fan = |points: &[[f64; 2]], _: &[[usize; 2]]| {
//!     Ok((2..points.len()).map(|i| [0, i - 1, i]).collect())
//! };
//! assert_eq!(ask(&Input::parse("0 0, 2 0, 2 2, 0 2", ""), fan), None);
//! let input = Input::parse("0 0, 4 -1, 8 1, 7 5, 1 3", "");
//! assert_eq!(ask(&input, fan), Some("not-delaunay"));
//! let least = least(&input, "not-delaunay", &|input| ask(input, fan));
//! assert_eq!(least.points.len(), 4);
//! ```

use std::cell::Cell;
use std::cmp::Ordering::{Greater, Less};
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use sweep_cdt::triangulate;
use sweep_cdt::verify::Verifier;

use crate::minimize::minimize;
use crate::oracle::{Answer, Graph, Number, Point, check, firm_sides};
use crate::{Input, with_integers};

/// Triangles, or the message with which the input is refused.
pub type Reply = Result<Vec<[usize; 3]>, String>;

/// The fault of a program's answer to this input, whose coordinates are finite: see [`fault`]. Nothing where edges
/// cross.
pub fn ask(
    input: &Input,
    program: impl Fn(&[[f64; 2]], &[[usize; 2]]) -> Reply,
) -> Option<&'static str> {
    fault(input, &right_answer(input)?, program)
}

/// The right answer, or none where edges cross: that is no question for a program that refuses them.
///
/// # Panics
/// If the oracle finds this crate wrong.
pub fn right_answer(input: &Input) -> Option<Answer> {
    let Input { points, edges } = input;
    let result = triangulate(points, edges).ok()?;
    Some(check(points, edges, &result))
}

/// The fault of a program's answer, where the right one is given: the name of the first violation, `refused`
/// where there is no answer, or `panic`. Triangles may all be clockwise.
///
/// # Panics
/// If the verifier and the oracle disagree.
pub fn fault(
    input: &Input,
    answer: &Answer,
    program: impl Fn(&[[f64; 2]], &[[usize; 2]]) -> Reply,
) -> Option<&'static str> {
    let Input { points, edges } = input;
    let has_length = |(e, _): &(usize, &[usize; 2])| answer.chains[*e].len() > 1;
    let numbered = edges.iter().enumerate();
    let edges: Vec<[usize; 2]> = numbered.filter(has_length).map(|(_, &e)| e).collect();
    match quietly(|| catch_unwind(AssertUnwindSafe(|| program(points, &edges)))) {
        Err(_) => Some("panic"),
        // Without triangles there is nothing to answer.
        Ok(Err(_)) => (!answer.triangles.is_empty()).then_some("refused"),
        Ok(Ok(triangles)) => {
            let verifier = Verifier::new().accept_clockwise(true);
            let verdict = verifier.verify(points, &edges, &triangles);
            let is_right = triangles.as_flattened().iter().all(|&v| v < points.len())
                && with_integers!(points, |exact| agrees(&exact, points, answer, &triangles));
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
/// The sides that one triangle alone has are then the hull's, so the triangles cover it once.
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

/// A small input with the same fault, by dropping points and edges.
pub fn least(input: &Input, fault: &str, again: &dyn Fn(&Input) -> Option<&'static str>) -> Input {
    let is_other = |input: &Input| assert_ne!(again(input), Some(fault));
    quietly(|| minimize(&is_other, input))
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
pub fn quietly<T>(call: impl FnOnce() -> T) -> T {
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
fn what_is_wrong_has_a_name() {
    let input = Input::parse("0 0, 4 0, 4 3, 0 2", "0 2, 1 1");
    let gives = |triangles: &[[usize; 3]]| ask(&input, |_, _| Ok(triangles.to_vec()));
    assert_eq!(gives(&[[0, 1, 2], [0, 2, 3]]), None);
    assert_eq!(gives(&[[1, 0, 2], [2, 0, 3]]), None, "clockwise");
    assert_eq!(gives(&[[0, 1, 3], [1, 2, 3]]), Some("missing-edge"));
    assert_eq!(
        gives(&[[0, 1, 2], [0, 2, 4]]),
        Some("triangle-out-of-range")
    );
    assert_eq!(ask(&input, |_, _| panic!("a fault")), Some("panic"));
    assert_eq!(ask(&input, |_, _| Err(String::new())), Some("refused"));
    let edges = |_: &[[f64; 2]], edges: &[[usize; 2]]| {
        assert_eq!(edges, [[0, 2]], "no edges without length");
        Ok(Vec::new())
    };
    assert!(ask(&input, edges).is_some_and(|fault| fault != "panic"));
    let crossing = Input::parse("0 0, 4 0, 4 3, 0 2", "0 2, 1 3");
    assert_eq!(ask(&crossing, |_, _| panic!("is not asked")), None);
}

#[test]
fn only_other_panics_reach_the_hook() {
    use std::sync::Mutex;
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
