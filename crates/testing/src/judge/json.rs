//! Questions and answers as lines of JSON: `docs/judging.md` has the form.
//!
//! Each coordinate is written as the shortest decimal that reads back as the same double, with a point or an exponent,
//! so that no reader takes one for an integer of its own.

use serde_json::{Value, json};

use super::outcome::{Fault, Outcome};
use super::question::{Operation, Question};
use crate::names;
use crate::oracle::Domain;

/// A question as a line, without its end.
pub fn question_line(question: &Question) -> String {
    object(&members(question))
}

/// An object as a line, with its members in this order.
pub fn object(members: &[(&str, Value)]) -> String {
    let members = members.iter();
    let members: Vec<String> = members
        .map(|(name, value)| format!("\"{name}\":{value}"))
        .collect();
    format!("{{{}}}", members.join(","))
}

/// The members of a question, in the order in which they are written.
pub fn members(question: &Question) -> Vec<(&'static str, Value)> {
    let step = |operation: &Operation| match operation {
        Operation::Insert(v) => json!(["insert", v]),
        Operation::Remove(v) => json!(["remove", v]),
    };
    vec![
        ("points", json!(question.points)),
        ("edges", json!(question.edges)),
        ("polygons", json!(question.polygons)),
        ("operations", question.operations.iter().map(step).collect()),
        ("domain", question.domain.name().into()),
        ("level", question.level.name().into()),
    ]
}

/// Reads a question. What is missing is empty, the domain the hull, the level Delaunay.
///
/// # Errors
/// What is wrong with it.
pub fn read_question(value: &Value) -> Result<Question, String> {
    // A member, or what stands for it where it is missing.
    let member = |name: &str, missing: Value| value.get(name).cloned().unwrap_or(missing);
    let wrong = |name: &'static str| move |error| format!("`{name}`: {error}");
    let steps: Vec<(String, usize)> =
        serde_json::from_value(member("operations", json!([]))).map_err(wrong("operations"))?;
    let step = |(what, v): &(String, usize)| match what.as_str() {
        "insert" => Ok(Operation::Insert(*v)),
        "remove" => Ok(Operation::Remove(*v)),
        other => Err(format!("`operations`: there is no `{other}`")),
    };
    let level = member("level", json!("delaunay"));
    let level = names::level(level.as_str().unwrap_or_default());
    let domain = member("domain", json!("hull"));
    let question = Question {
        points: serde_json::from_value(member("points", Value::Null)).map_err(wrong("points"))?,
        edges: serde_json::from_value(member("edges", json!([]))).map_err(wrong("edges"))?,
        polygons: serde_json::from_value(member("polygons", json!([])))
            .map_err(wrong("polygons"))?,
        operations: steps.iter().map(step).collect::<Result<_, _>>()?,
        domain: domain.as_str().unwrap_or_default().parse::<Domain>()?,
        level: level.map_err(|error| format!("`level`: {error}"))?,
    };
    match question.is_sound() {
        true => Ok(question),
        false => Err("a number is none of a point, or an operation cannot be done".to_owned()),
    }
}

/// Reads an answer: `triangles`, `after` or `refused`. A corner that is no whole number from 0 on is the corner of no
/// point.
pub fn read_answer(line: &str) -> Outcome {
    let unreadable = |what: String| Outcome::Failed(Fault::new("unreadable", what));
    let value: Value = match serde_json::from_str(line) {
        Ok(value) => value,
        Err(error) => return unreadable(format!("{error}: {}", beginning(line))),
    };
    let corner = |v: &Value| {
        v.is_number().then(|| {
            v.as_u64()
                .and_then(|v| usize::try_from(v).ok())
                .unwrap_or(usize::MAX)
        })
    };
    let triangle = |t: &Value| match t.as_array()?.as_slice() {
        [a, b, c] => Some([corner(a)?, corner(b)?, corner(c)?]),
        _ => None,
    };
    let triangles = |list: &Value| -> Option<Vec<[usize; 3]>> {
        list.as_array()?.iter().map(triangle).collect()
    };
    let after = |list: &Value| -> Option<Vec<Vec<[usize; 3]>>> {
        list.as_array()?.iter().map(triangles).collect()
    };
    let read = match (
        value.get("refused"),
        value.get("after"),
        value.get("triangles"),
    ) {
        (Some(reason), ..) => reason
            .as_str()
            .map(|reason| Outcome::Refused(reason.to_owned())),
        (None, Some(list), _) => after(list).map(Outcome::After),
        (None, None, list) => list.and_then(triangles).map(Outcome::Triangles),
    };
    read.unwrap_or_else(|| {
        unreadable(format!(
            "no triangles, after or refused of the right form: {}",
            beginning(line)
        ))
    })
}

/// An answer as a line; of one that did not come, the fault.
pub fn answer_line(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Triangles(triangles) => json!({ "triangles": triangles }),
        Outcome::After(states) => json!({ "after": states }),
        Outcome::Refused(reason) => json!({ "refused": reason }),
        Outcome::Failed(fault) => json!({ "failed": fault.name, "what": fault.what }),
    }
    .to_string()
}

/// The first characters of a line.
fn beginning(line: &str) -> String {
    let mut text: String = line.chars().take(100).collect();
    if text.len() < line.trim_end().len() {
        text += " ...";
    }
    text
}

#[test]
fn lines_are_read_as_they_are_written() {
    let mut question = Question::new(
        &[
            [0.1, -0.0],
            [1e300, 9_007_199_254_740_993.0],
            [5e-324, 3.0],
            [1.0, 2.0],
        ],
        &[[0, 3]],
    );
    question.polygons = vec![vec![vec![0, 1, 2]]];
    question.domain = Domain::NonZero;
    question.level = sweep_cdt::verify::Level::Tiling;
    question.operations = vec![Operation::Insert(0), Operation::Remove(0)];
    let line = question_line(&question);
    assert!(
        line.starts_with(r#"{"points":[[0.1,-0.0],[1e+300,9007199254740992.0],[5e-324,3.0]"#),
        "{line}"
    );
    let value: Value = serde_json::from_str(&line).expect("JSON");
    assert_eq!(read_question(&value), Ok(question));
    for (text, error) in [
        ("{}", "`points`"),
        (r#"{"points":[[0,0]],"edges":[[0,1]]}"#, "a number is none"),
        (r#"{"points":[[0,0]],"level":"best"}"#, "`level`"),
        (r#"{"points":[[0,0]],"domain":"all"}"#, "`all` is none"),
        (
            r#"{"points":[[0,0]],"operations":[["move",0]]}"#,
            "`operations`",
        ),
        (
            r#"{"points":[[0,0]],"operations":[["remove",0]]}"#,
            "a number is none",
        ),
    ] {
        let read = read_question(&serde_json::from_str(text).expect("JSON"));
        assert!(read.is_err_and(|found| found.contains(error)), "{text}");
    }
}

#[test]
fn answers_are_read() {
    for outcome in [
        Outcome::Triangles(vec![[0, 1, 2]]),
        Outcome::After(vec![Vec::new(), vec![[2, 1, 0]]]),
        Outcome::Refused("too hot".to_owned()),
    ] {
        assert_eq!(read_answer(&answer_line(&outcome)), outcome);
    }
    let corners = r#"{"triangles": [[0, -1, 1.5]], "program": "x 1.0"}"#;
    let none = Outcome::Triangles(vec![[0, usize::MAX, usize::MAX]]);
    assert_eq!(read_answer(corners), none);
    for line in [
        "",
        "Traceback",
        "{}",
        r#"{"triangles": [[0, 1]]}"#,
        r#"{"after": [[0]]}"#,
        r#"{"refused": 1}"#,
    ] {
        let read = read_answer(line);
        assert!(
            matches!(read, Outcome::Failed(fault) if fault.name == "unreadable"),
            "{line}"
        );
    }
}
