//! What a program claims: what it can be asked, in which numbers, what it answers, and what it may refuse.
//!
//! Questions are made within the claims, so that a refusal of something else is a fault of the program.

use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

use sweep_cdt::verify::Level;

use super::numbers::Numbers;
use super::outcome::{Fault, Outcome};
use super::question::{Operation, Question, Special};
use super::right;
use crate::names::{name_of, value_of};
use crate::oracle::{Domain, turns_left};
use crate::with_integers;

/// The claims of a program.
#[derive(Clone, Debug)]
pub struct Claims {
    /// What it is asked.
    pub asked: Asked,
    /// What its triangles fill.
    pub domain: Domain,
    /// What its triangles promise.
    pub level: Level,
    /// The coordinates that it takes.
    pub numbers: Numbers,
    /// The number of points that it is asked at most; up to 64.
    pub most: usize,
    /// What it may refuse.
    pub refuses: Vec<Special>,
    /// What it is never asked.
    pub never: Vec<Special>,
    /// Whether some of its triangles may run clockwise and others counter-clockwise.
    pub is_mixed: bool,
}

/// What a program is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// Points.
    Points,
    /// Points and edges.
    Edges,
    /// Polygons with holes, whose vertices are the only points.
    Polygons,
    /// Polygons with holes, and points and edges besides.
    Lines,
    /// Points that are inserted and removed.
    Operations,
}

impl Asked {
    /// All of them, and their names.
    pub const ALL: [(Asked, &str); 5] = [
        (Asked::Points, "points"),
        (Asked::Edges, "edges"),
        (Asked::Polygons, "polygons"),
        (Asked::Lines, "lines"),
        (Asked::Operations, "operations"),
    ];

    /// The name.
    pub fn name(self) -> &'static str {
        name_of(&Asked::ALL, &self)
    }

    /// Whether a question is of this kind.
    fn suits(self, question: &Question) -> bool {
        let Question {
            points,
            edges,
            polygons,
            operations,
            ..
        } = question;
        let on_rings = || question.rings().flatten().collect::<BTreeSet<_>>().len();
        let is_plain = edges.is_empty() && polygons.is_empty();
        match self {
            Asked::Points => is_plain && operations.is_empty(),
            Asked::Edges => polygons.is_empty() && operations.is_empty(),
            Asked::Polygons => {
                edges.is_empty() && operations.is_empty() && on_rings() == points.len()
            }
            Asked::Lines => operations.is_empty(),
            Asked::Operations => is_plain && !operations.is_empty(),
        }
    }
}

impl FromStr for Asked {
    type Err = String;

    fn from_str(name: &str) -> Result<Asked, String> {
        value_of(&Asked::ALL, name)
    }
}

impl Claims {
    /// A program that is asked this: any finite doubles; of polygons a constrained triangulation of what they cover,
    /// else a Delaunay triangulation of the hull. What is unusual is never asked.
    pub fn of(asked: Asked) -> Claims {
        let (domain, level) = match asked {
            Asked::Polygons | Asked::Lines => (Domain::Polygons, Level::Constrained),
            Asked::Points | Asked::Edges | Asked::Operations => (Domain::Hull, Level::Delaunay),
        };
        Claims {
            asked,
            domain,
            level,
            numbers: Numbers::DOUBLES,
            most: 64,
            refuses: Vec::new(),
            never: Special::UNUSUAL.to_vec(),
            is_mixed: false,
        }
    }

    /// The simplest question: a triangle.
    pub fn simplest(&self) -> Question {
        let mut question = Question {
            domain: self.domain,
            level: self.level,
            ..Question::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], &[])
        };
        match self.asked {
            Asked::Points | Asked::Edges => {}
            Asked::Polygons | Asked::Lines => question.polygons = vec![vec![vec![0, 1, 2]]],
            Asked::Operations => question.operations = (0..3).map(Operation::Insert).collect(),
        }
        question
    }

    /// The claims in other numbers.
    #[must_use]
    pub fn with_numbers(self, numbers: Numbers) -> Claims {
        Claims { numbers, ..self }
    }

    /// The claims with questions that are special in these ways, which the program must answer.
    #[must_use]
    pub fn answering(mut self, specials: &[Special]) -> Claims {
        self.never.retain(|special| !specials.contains(special));
        self
    }

    /// The claims with questions that are special in these ways, which the program may refuse.
    #[must_use]
    pub fn refusing(self, specials: &[Special]) -> Claims {
        let mut claims = self.answering(specials);
        claims.refuses.extend(specials);
        claims
    }

    /// The claims without questions that are special in these ways.
    #[must_use]
    pub fn without(mut self, specials: &[Special]) -> Claims {
        self.never.extend(specials);
        self
    }

    /// Whether these questions may be asked.
    pub fn allows(&self, question: &Question) -> bool {
        question.is_sound()
            && self.asked.suits(question)
            && question.points.len() <= self.most
            && question
                .points
                .as_flattened()
                .iter()
                .all(|&x| self.numbers.has(x))
            && {
                let specials = specials(question);
                !self.never.iter().any(|special| specials.contains(special))
            }
    }

    /// Whether the program may refuse a question.
    pub fn may_refuse(&self, question: &Question) -> bool {
        let specials = specials(question);
        self.refuses
            .iter()
            .any(|special| specials.contains(special))
    }

    /// What is wrong with the answer to a question that may be asked, if anything is.
    ///
    /// # Panics
    /// If two judges disagree.
    pub fn fault(&self, question: &Question, outcome: &Outcome) -> Option<Fault> {
        match outcome {
            Outcome::Refused(_) if self.may_refuse(question) => None,
            _ if self.is_mixed => right::fault(question, &turned(question, outcome)),
            _ => right::fault(question, outcome),
        }
    }
}

/// An answer whose triangles all run counter-clockwise, but for those without an area.
fn turned(question: &Question, outcome: &Outcome) -> Outcome {
    let turned = |triangles: &[[usize; 3]]| {
        with_integers!(&question.points, |exact| {
            let turned = |&[a, b, c]: &[usize; 3]| {
                let corners: Option<Vec<_>> = [a, b, c].map(|v| exact.get(v)).into_iter().collect();
                match corners.and_then(|corners| turns_left(&corners)) {
                    Some(false) => [a, c, b],
                    _ => [a, b, c],
                }
            };
            triangles.iter().map(turned).collect()
        })
    };
    match outcome {
        Outcome::Triangles(triangles) => Outcome::Triangles(turned(triangles)),
        Outcome::After(states) => Outcome::After(states.iter().map(|list| turned(list)).collect()),
        Outcome::Refused(_) | Outcome::Failed(_) => outcome.clone(),
    }
}

/// What is special about a question, or about the points that are there after some operation. That they are few on the
/// way is nothing special.
fn specials(question: &Question) -> BTreeSet<Special> {
    let all = question.operations.len();
    let on_the_way = (1..all).flat_map(|steps| question.after(steps).specials());
    let on_the_way = on_the_way.filter(|special| *special != Special::Flat);
    let at_the_end = match all {
        0 => question.specials(),
        _ => question.after(all).specials(),
    };
    on_the_way.chain(at_the_end).collect()
}

/// In the words of the command.
impl fmt::Display for Claims {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Claims {
            asked,
            domain,
            level,
            numbers,
            most,
            is_mixed,
            ..
        } = self;
        let (asked, domain, level) = (asked.name(), domain.name(), level.name());
        write!(
            f,
            "--asked {asked} --domain {domain} --level {level} --numbers {numbers} --most {most}"
        )?;
        if *is_mixed {
            f.write_str(" --mixed")?;
        }
        let names = |list: &[Special]| {
            let names: Vec<&str> = list.iter().map(|special| special.name()).collect();
            names.join(",")
        };
        let unusual = |special: &&Special| Special::UNUSUAL.contains(special);
        let is_asked =
            |special: &&Special| !self.never.contains(special) && !self.refuses.contains(special);
        let answers: Vec<Special> = Special::UNUSUAL.iter().filter(is_asked).copied().collect();
        let never: Vec<Special> = self.never.iter().filter(|s| !unusual(s)).copied().collect();
        for (option, list) in [
            ("refuses", &self.refuses),
            ("answers", &answers),
            ("never", &never),
        ] {
            if !list.is_empty() {
                write!(f, " --{option} {}", names(list))?;
            }
        }
        Ok(())
    }
}
