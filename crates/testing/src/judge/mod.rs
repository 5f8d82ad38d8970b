//! Is another program right? Any program: a function of this process, or a process that reads a line of JSON for each
//! question and writes one (`crates/judge`).
//!
//! | part | is |
//! |---|---|
//! | [`Claims`] | what a program says that it takes, answers and may refuse |
//! | [`Question`] | what it is asked: points, edges, polygons with holes, or points that come and go |
//! | [`question()`] | a question out of bytes, within the claims |
//! | [`Outcome`] | what comes of it: triangles, a refusal, a panic |
//! | [`Claims::fault`] | what is wrong with that, judged by the verifier and by the oracle, which must agree |
//! | [`least`] | a small question with the same fault |
//! | [`campaign()`] | many questions, and what came of them |
//! | [`json`] | questions and answers as lines |
//!
//! ```
//! use sweep_cdt_testing::judge::{Asked, Claims, Numbers, Special, campaign};
//!
//! // Joins the first vertex with all sides of the outline: right for convex polygons without holes.
//! let fan = |question: &sweep_cdt_testing::judge::Question| {
//!     let outline = &question.polygons[0][0];
//!     Ok((2..outline.len()).map(|i| [outline[0], outline[i - 1], outline[i]]).collect())
//! };
//! let claims = Claims::of(Asked::Polygons).with_numbers(Numbers::integers(20)).without(&[Special::Flat]);
//! let summary = campaign(&claims, 300, 1, fan);
//! let finding = &summary.findings[0];
//! assert!(finding.least.question.points.len() <= 8, "{summary}");
//! ```

mod campaign;
mod claims;
pub mod json;
mod made;
mod numbers;
mod outcome;
mod question;
mod right;
mod shrink;

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::Once;

pub use crate::generators::ring_sides;
pub use campaign::{Campaign, Finding, Row, Summary, campaign};
pub use claims::{Asked, Claims};
pub use made::question;
pub use numbers::Numbers;
pub use outcome::{Fault, Outcome, Reply};
pub use question::{Operation, Question, Special};
pub use right::{Hopeless, Right};
pub use shrink::{Wrong, least};

/// Asks a program of this process. A panic is a fault of this name.
pub fn ask<O: Into<Outcome>>(
    question: &Question,
    program: &mut impl FnMut(&Question) -> O,
) -> Outcome {
    let answer = quietly(|| catch_unwind(AssertUnwindSafe(|| program(question).into())));
    answer.unwrap_or_else(|panic| {
        let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let text = text.or_else(|| panic.downcast_ref::<String>().cloned());
        Outcome::Failed(Fault::new("panic", text.unwrap_or_default()))
    })
}

/// Asks the question that these bytes stand for, as the body of a fuzz target.
///
/// # Panics
/// If the program is wrong: with the question as a line, and what is wrong.
pub fn expect_right<O: Into<Outcome>>(
    claims: &Claims,
    bytes: &[u8],
    mut program: impl FnMut(&Question) -> O,
) {
    if let (_, Some(question)) = question(claims, bytes) {
        let outcome = ask(&question, &mut program);
        if let Some(Fault { name, what }) = claims.fault(&question, &outcome) {
            panic!("{name}: {what}\n{}", json::question_line(&question));
        }
    }
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
    HOOK.call_once(|| set_hook(only_others(take_hook())));
    let before = IS_QUIET.replace(true);
    let result = call();
    IS_QUIET.set(before);
    result
}

type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Sync + Send>;

/// A hook that leaves out the panics of programs that are asked.
fn only_others(loud: Hook) -> Hook {
    Box::new(move |panic| {
        if !IS_QUIET.get() {
            loud(panic);
        }
    })
}

#[test]
fn what_is_wrong_has_a_name() {
    let claims = Claims::of(Asked::Edges);
    let input = crate::Input::parse("0 0, 4 0, 4 3, 0 2", "0 2");
    let question = Question::new(&input.points, &input.edges);
    let name = |outcome: Outcome| claims.fault(&question, &outcome).map(|fault| fault.name);
    let gives = |triangles: &[[usize; 3]]| name(Outcome::Triangles(triangles.to_vec()));
    assert_eq!(gives(&[[0, 1, 2], [0, 2, 3]]), None);
    assert_eq!(gives(&[[1, 0, 2], [2, 0, 3]]), None, "clockwise");
    assert_eq!(gives(&[[0, 1, 3], [1, 2, 3]]), Some("missing-edge"));
    assert_eq!(
        gives(&[[0, 1, 2], [0, 2, 4]]),
        Some("triangle-out-of-range")
    );
    assert_eq!(
        name(ask(&question, &mut |_: &Question| -> Reply {
            panic!("a fault")
        })),
        Some("panic")
    );
    assert_eq!(name(Outcome::Refused(String::new())), Some("refused"));
    // Where edges cross, only a refusal is right, and nothing may be asked unless the program says so.
    let crossing = crate::Input::parse("0 0, 4 0, 4 3, 0 2", "0 2, 1 3");
    let crossing = Question::new(&crossing.points, &crossing.edges);
    assert!(!claims.allows(&crossing));
    let claims = claims.refusing(&[Special::CrossingEdges]);
    assert!(claims.allows(&crossing));
    let name = |outcome: Outcome| claims.fault(&crossing, &outcome).map(|fault| fault.name);
    assert_eq!(name(Outcome::Refused(String::new())), None);
    assert_eq!(
        name(Outcome::Triangles(vec![[0, 1, 2], [0, 2, 3]])),
        Some("answered")
    );
}

#[test]
fn a_fuzz_target_fails_where_a_program_is_wrong() {
    use sweep_cdt_generate::Random;
    let claims = Claims::of(Asked::Points).with_numbers(Numbers::integers(10));
    let right = |question: &Question| -> Reply {
        let result = sweep_cdt::triangulate(&question.points, &[]);
        Ok(result.expect("points alone").triangles().collect())
    };
    let mut failures = 0;
    for seed in 0..50 {
        let bytes = Random::new(seed).bytes(60);
        expect_right(&claims, &bytes, right);
        let none = |_: &Question| -> Reply { Ok(Vec::new()) };
        let panic = quietly(|| catch_unwind(|| expect_right(&claims, &bytes, none)));
        let text = panic
            .err()
            .and_then(|panic| panic.downcast::<String>().ok());
        failures += u32::from(text.is_some_and(|text| text.starts_with("no-triangles: ")));
    }
    assert!(failures > 20, "{failures}");
}

#[test]
fn only_other_panics_reach_the_hook() {
    use std::sync::Mutex;
    static HEARD: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let loud = take_hook();
    // Another test may have set the hook before, so it is set here again.
    set_hook(only_others(Box::new(move |panic| {
        match panic.payload().downcast_ref::<&str>() {
            Some(text @ (&"before" | &"expected" | &"after")) => {
                HEARD.lock().expect("no panic holds it").push(text);
            }
            _ => loud(panic),
        }
    })));
    assert!(catch_unwind(|| panic!("before")).is_err());
    assert!(quietly(|| catch_unwind(|| panic!("expected"))).is_err());
    assert!(catch_unwind(|| panic!("after")).is_err());
    assert_eq!(
        *HEARD.lock().expect("no panic holds it"),
        ["before", "after"]
    );
}
