//! What comes of a question: triangles, a refusal, or a failure; and faults, each with its name.

use sweep_cdt::verify::Violation;

/// What a program of this process returns: triangles, or the message with which the question is refused.
pub type Reply = Result<Vec<[usize; 3]>, String>;

/// What comes of a question.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Triangles, by the numbers of the points, all counter-clockwise or all clockwise.
    Triangles(Vec<[usize; 3]>),
    /// The triangles after each operation.
    After(Vec<Vec<[usize; 3]>>),
    /// The program refuses, for a reason that it names.
    Refused(String),
    /// There is no answer: a panic, a crash, a hang, or words that cannot be read.
    Failed(Fault),
}

impl From<Reply> for Outcome {
    fn from(reply: Reply) -> Outcome {
        match reply {
            Ok(triangles) => Outcome::Triangles(triangles),
            Err(reason) => Outcome::Refused(reason),
        }
    }
}

/// What is wrong with an answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The name: that of a [`Violation`], or `panic`, `crash`, `hang`, `unreadable`, `refused`, `answered`, `outside`.
    pub name: &'static str,
    /// What is wrong, and where.
    pub what: String,
}

impl Fault {
    /// A fault of this name.
    pub fn new(name: &'static str, what: impl Into<String>) -> Fault {
        let what = what.into();
        Fault { name, what }
    }

    /// A violation, with the coordinates of the vertices that it names, and its depth if it has one.
    pub fn of(violation: &Violation, points: &[[f64; 2]]) -> Fault {
        let named = violation.offenders().vertices.into_iter();
        let places: Vec<String> = named
            .filter_map(|v| points.get(v).map(|[x, y]| format!("{v} at ({x:?}, {y:?})")))
            .collect();
        let mut what = violation.to_string();
        if !places.is_empty() {
            what += &format!("; {}", places.join(", "));
        }
        if let Some(depth) = violation.depth() {
            what += &format!("; depth {depth}");
        }
        Fault::new(violation.name(), what)
    }
}
