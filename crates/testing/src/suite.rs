//! The suite of conformance: small inputs, each with its one right answer, for every program (`tests/conformance`).
//!
//! An answer is made by the oracle, by definition, and must be this crate's too. In the files it stands by itself: a
//! program is judged by what the file says.

use std::collections::BTreeMap;
use std::fs;

use serde_json::{Value, json};
use sweep_cdt::crossings::crossings;
use sweep_cdt::{Error, triangulate};

use crate::data::path;
use crate::judge::{Asked, Claims, Hopeless, Outcome, Question, Right, json as lines};
use crate::judge::{Fault, Special};
use crate::oracle::{Domain, verdict};

/// The version of the suite: a new one where a case or an answer changes.
pub const VERSION: &str = "1.3.0";

/// An input of the suite, and its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The name: the kind, and a number or a word.
    pub name: String,
    /// What is special about it, in a word.
    pub kind: String,
    /// The question about the hull.
    pub question: Question,
    /// The answer.
    pub answer: Answer,
    /// Where the input is from.
    pub source: String,
    /// The licence of the input.
    pub licence: String,
}

/// What is right.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// The canonical triangles of the hull, and which of them are inside, by domains.
    Triangles {
        /// Counter-clockwise, each with its lowest vertex first; sorted.
        triangles: Vec<[usize; 3]>,
        /// The vertices on the hull, counter-clockwise from the leftmost, upper one.
        hull: Vec<usize>,
        /// For each domain but the hull that the input has the triangles inside, as positions in `triangles`.
        domains: BTreeMap<&'static str, Vec<usize>>,
    },
    /// None: these pairs of edges cross at points that are none of the input.
    Crossings(Vec<[usize; 2]>),
}

impl Case {
    /// An input with its answer, by definition.
    ///
    /// # Panics
    /// If this crate has another answer.
    pub fn new(name: String, question: Question, source: String, licence: String) -> Case {
        Case {
            kind: name.split('/').next().unwrap_or_default().to_owned(),
            name,
            answer: Answer::of(&question),
            question,
            source,
            licence,
        }
    }

    /// The question to a program with these claims; nothing, if the case is none for it.
    pub fn question_within(&self, claims: &Claims) -> Option<Question> {
        let mut question = self.question.clone();
        match claims.asked {
            // For a program that knows no polygons the sides of rings are edges.
            Asked::Edges => {
                question.edges = question.all_edges();
                question.polygons.clear();
            }
            Asked::Polygons | Asked::Lines if question.polygons.is_empty() => return None,
            _ => {}
        }
        question.domain = claims.domain;
        question.level = claims.level;
        let is_asked = claims.allows(&question)
            && match &self.answer {
                Answer::Crossings(_) => true,
                Answer::Triangles { domains, .. } => {
                    claims.domain == Domain::Hull || domains.contains_key(claims.domain.name())
                }
            };
        is_asked.then_some(question)
    }

    /// What is wrong with a program's answer to [`Case::question_within`], by what the case says.
    pub fn fault(&self, claims: &Claims, question: &Question, outcome: &Outcome) -> Option<Fault> {
        if matches!(outcome, Outcome::Refused(_)) && claims.may_refuse(question) {
            return None;
        }
        match (&self.answer, outcome) {
            (Answer::Crossings(_), Outcome::Refused(_)) => None,
            (Answer::Crossings(_), Outcome::Failed(fault)) => Some(fault.clone()),
            (Answer::Crossings(pairs), _) => {
                let what = Hopeless::Crossing(pairs[0]).to_string();
                Some(Fault::new("answered", what))
            }
            (
                Answer::Triangles {
                    triangles, domains, ..
                },
                _,
            ) => {
                let is_inside = |t: &usize| match domains.get(question.domain.name()) {
                    Some(inside) => inside.contains(t),
                    None => true,
                };
                let (inside, outside): (Vec<usize>, Vec<usize>) =
                    (0..triangles.len()).partition(is_inside);
                let list = |places: Vec<usize>| places.into_iter().map(|t| triangles[t]).collect();
                let (inside, outside) = (list(inside), list(outside));
                Right { inside, outside }.fault(question, outcome)
            }
        }
    }

    /// The case as a line.
    pub fn line(&self) -> String {
        let question = lines::members(&self.question);
        let mut members = vec![("name", json!(self.name)), ("kind", json!(self.kind))];
        members.extend(question.into_iter().take(3));
        match &self.answer {
            Answer::Triangles {
                triangles,
                hull,
                domains,
            } => members.extend([
                ("triangles", json!(triangles)),
                ("hull", json!(hull)),
                ("domains", json!(domains)),
            ]),
            Answer::Crossings(pairs) => members.extend([
                ("refused", json!(Special::CrossingEdges.name())),
                ("crossings", json!(pairs)),
            ]),
        }
        members.extend([
            ("source", json!(self.source)),
            ("licence", json!(self.licence)),
        ]);
        lines::object(&members)
    }

    /// Reads the case of a line.
    ///
    /// # Errors
    /// What is wrong with the line.
    pub fn read(line: &str) -> Result<Case, String> {
        let value: Value = serde_json::from_str(line).map_err(|error| error.to_string())?;
        let question = lines::read_question(&value)?;
        let wrong = |error: serde_json::Error| error.to_string();
        let member = |name: &str| value[name].clone();
        let text = |name: &str| {
            value[name]
                .as_str()
                .map(str::to_owned)
                .ok_or(format!("no `{name}`"))
        };
        let answer = match value.get("refused") {
            Some(_) => {
                Answer::Crossings(serde_json::from_value(member("crossings")).map_err(wrong)?)
            }
            None => {
                let mut domains = BTreeMap::new();
                for (_, name) in Domain::ALL {
                    if let Some(inside) = value["domains"].get(name) {
                        domains
                            .insert(name, serde_json::from_value(inside.clone()).map_err(wrong)?);
                    }
                }
                Answer::Triangles {
                    triangles: serde_json::from_value(member("triangles")).map_err(wrong)?,
                    hull: serde_json::from_value(member("hull")).map_err(wrong)?,
                    domains,
                }
            }
        };
        let [name, kind] = [text("name")?, text("kind")?];
        let [source, licence] = [text("source")?, text("licence")?];
        Ok(Case {
            name,
            kind,
            question,
            answer,
            source,
            licence,
        })
    }
}

impl Answer {
    /// The answer by definition.
    ///
    /// # Panics
    /// If this crate has another one.
    pub fn of(question: &Question) -> Answer {
        let (points, edges) = (&question.points, question.all_edges());
        let own = Answer::of_this_crate(question);
        match verdict(points, &edges) {
            Err(mut pairs) => {
                pairs.sort_unstable();
                assert_eq!(own, Answer::Crossings(pairs.clone()), "{question:?}");
                Answer::Crossings(pairs)
            }
            Ok(answer) => {
                let mut domains = BTreeMap::new();
                for (domain, name) in Domain::ALL {
                    let asked = Question {
                        domain,
                        ..question.clone()
                    };
                    // Rays and this crate agree, or this panics.
                    let Ok(right) = Right::of(&asked) else {
                        continue;
                    };
                    if has_domain(question, domain) {
                        let inside = (0..answer.triangles.len())
                            .filter(|&t| right.inside.binary_search(&answer.triangles[t]).is_ok());
                        domains.insert(name, inside.collect());
                    }
                }
                let (triangles, hull) = (answer.triangles, answer.hull);
                let answer = Answer::Triangles {
                    triangles,
                    hull,
                    domains,
                };
                assert_eq!(own, answer, "{question:?}");
                answer
            }
        }
    }

    /// The answer of this crate, without the oracle.
    ///
    /// # Panics
    /// If it refuses the input for another reason than edges that cross.
    pub fn of_this_crate(question: &Question) -> Answer {
        let edges = question.all_edges();
        match triangulate(&question.points, &edges) {
            Ok(result) => {
                let triangles = result.canonical_triangles();
                let mut domains = BTreeMap::new();
                for (domain, name) in Domain::ALL {
                    let asked = Question {
                        domain,
                        ..question.clone()
                    };
                    if let (true, Ok(interior)) =
                        (has_domain(question, domain), asked.interior(&result))
                    {
                        let inside = interior.canonical_triangles();
                        let places = (0..triangles.len())
                            .filter(|&t| inside.binary_search(&triangles[t]).is_ok());
                        domains.insert(name, places.collect());
                    }
                }
                let hull = result.hull().collect();
                Answer::Triangles {
                    triangles,
                    hull,
                    domains,
                }
            }
            Err(Error::CrossingEdges { edges: pair }) => {
                let all = crossings(&question.points, &edges).expect("few edges");
                let mut pairs: Vec<[usize; 2]> =
                    all.iter().map(|crossing| crossing.edges).collect();
                pairs.sort_unstable();
                assert!(pairs.contains(&pair), "{pair:?} is none of {pairs:?}");
                Answer::Crossings(pairs)
            }
            Err(error) => panic!("{error}: {question:?}"),
        }
    }
}

/// Whether a domain says something about an input.
fn has_domain(question: &Question, domain: Domain) -> bool {
    match domain {
        Domain::Hull => false,
        Domain::Polygons => !question.polygons.is_empty(),
        Domain::EvenOdd | Domain::NonZero => !question.all_edges().is_empty(),
    }
}

/// The first line of the suite.
pub fn header(cases: usize) -> String {
    format!(
        r#"{{"suite":"sweep-cdt-conformance","version":"{VERSION}","cases":{cases},"schema":"schema.json","doi":null}}"#
    )
}

/// The cases of a text, whose first line is the header.
///
/// # Errors
/// What is wrong, with the number of the line.
pub fn read(text: &str) -> Result<Vec<Case>, String> {
    let mut lines = (1..).zip(text.lines());
    let first = lines.next().map(|(_, line)| line).unwrap_or_default();
    let cases: Vec<Case> = lines
        .map(|(number, line)| Case::read(line).map_err(|error| format!("line {number}: {error}")))
        .collect::<Result<_, _>>()?;
    match first == header(cases.len()) {
        true => Ok(cases),
        false => Err(format!("line 1 is not: {}", header(cases.len()))),
    }
}

/// The suite of this repository.
///
/// # Panics
/// If it cannot be read.
pub fn own() -> Vec<Case> {
    let file = path("tests/conformance/cases.jsonl");
    let text = fs::read_to_string(file).expect("a readable file");
    read(&text).unwrap_or_else(|error| panic!("{error}"))
}
