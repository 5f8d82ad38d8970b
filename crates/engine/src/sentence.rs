//! Advice as a sentence, which is the same in all front ends but for how they write settings.

use sweep_cdt::Error;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::verify::Level;
use sweep_cdt_formats::Coordinate;

use crate::advice::{Advice, Fit, How, ROUNDING, Setting, Several};
use crate::inside::Inside;
use crate::question::Question;

/// How a front end speaks.
#[expect(missing_debug_implementations, reason = "it holds functions")]
pub struct Words<'a> {
    /// What it calls a setting.
    pub setting: &'a str,
    /// The name of the setting for the greatest depth.
    pub max_depth: &'a str,
    /// Settings as they are written.
    pub settings: &'a dyn Fn(&[Setting]) -> String,
    /// An error of the input.
    pub refused: &'a dyn Fn(Error) -> String,
    /// What judges a mesh by itself beside its input, if this is one.
    pub beside_input: Option<&'a str>,
    /// What shows where triangles are wrong, with its verb.
    pub show: &'a str,
}

impl<S: Coordinate, T: Scalar> Question<'_, S, T> {
    /// Advice after an answer to this question, in words.
    pub fn sentence(&self, advice: Advice, words: &Words<'_>) -> String {
        let and_add = |fit: Fit| match fit.settings() {
            settings if settings.is_empty() => String::new(),
            settings => format!(", and add {}", (words.settings)(&settings)),
        };
        let (setting, max_depth) = (words.setting, words.max_depth);
        let look = |why: &str| format!("{why}: {} where it is wrong", words.show);
        match advice {
            Advice::Correct { clockwise: false } => "correct: nothing to do".to_owned(),
            Advice::Correct { clockwise: true } => {
                "correct: nothing to do; the triangles run clockwise".to_owned()
            }
            Advice::Rounded => {
                format!("right but for rounding, as {max_depth} allows: nothing to do")
            }
            Advice::Refused(error) => {
                let error = (words.refused)(error);
                format!("the input has no triangulation with its edges: {error}")
            }
            Advice::Accept(fit) => self.accepted(fit, words),
            Advice::NumberFromZero(fit) => {
                let change = "corners are numbered from 1 and not from 0: subtract 1 from each";
                change.to_owned() + &and_add(fit)
            }
            Advice::TurnOver(triangles, fit) => self.turning(triangles) + &and_add(fit),
            Advice::Remove(points) => self.removal(points),
            Advice::NoTriangles => look("the result has no triangles"),
            Advice::Strangers => look(
                "corners are no vertices of the input: perhaps this is the result of another one",
            ),
            Advice::Look(name) => {
                let nothing = match words.beside_input {
                    Some(call) => format!(
                        "this is no triangulation of its own points, and with those of its input {call} judges it"
                    ),
                    None => format!("no {setting} accepts this"),
                };
                let first = name.map(|name| format!(", the first violation is {name}"));
                look(&(nothing + &first.unwrap_or_default()))
            }
        }
    }

    fn accepted(&self, fit: Fit, words: &Words<'_>) -> String {
        let settings = (words.settings)(&fit.settings());
        let place = match fit.domain {
            None => "",
            Some(Inside::HULL) => " of the hull",
            Some(_) => " of the interior",
        };
        match fit.how {
            How::Right => format!("this is a right triangulation{place}: {settings}"),
            How::Shallow { found, depth } => {
                let size = match depth.get() <= ROUNDING {
                    true => "of the size of rounding",
                    false => "of the size of rounding to single precision",
                };
                let prefix = match place {
                    "" => String::new(),
                    place => format!("as a triangulation{place} "),
                };
                match found {
                    1 => format!(
                        "{prefix}the only violation is {size} (depth {depth}): {settings} accepts it"
                    ),
                    _ => format!(
                        "{prefix}all {found} violations are {size} (deepest {depth}): {settings} accepts them"
                    ),
                }
            }
            How::Lower { level, edge } => {
                let but = match (level, edge) {
                    (Level::Delaunay, _) => "not the canonical one".to_owned(),
                    (Level::Constrained, _) => "not Delaunay".to_owned(),
                    (_, Some((edge, is_bent))) => {
                        let number = edge + self.numbering.edge;
                        let is = if is_bent { "not straight" } else { "missing" };
                        format!("without all edges of the input (edge {number} is {is})")
                    }
                    (_, None) => "with wrong attributes of regions".to_owned(),
                };
                let title = level.title();
                format!("this is {title}{place}, but {but}: {settings} accepts it")
            }
        }
    }

    fn turning(&self, Several { first, count }: Several) -> String {
        let first = first + self.first_triangle;
        match count {
            1 => format!(
                "triangle {first} runs the other way round than all others: swap two of its corners"
            ),
            count => format!(
                "{count} triangles run the other way round than the others, the first is {first}: swap two corners of each"
            ),
        }
    }

    fn removal(&self, Several { first, count }: Several) -> String {
        let number = first + self.numbering.vertex;
        let [x, y] = self.input.points[first].each_ref().map(S::text);
        match count {
            1 => format!(
                "vertex {number} of the input, at ({x}, {y}), is used by no triangle, and nothing else is wrong: remove \
                 it from the input, and run the program again"
            ),
            count => format!(
                "{count} vertices of the input are used by no triangle, the first is {number} at ({x}, {y}), and \
                 nothing else is wrong: remove them from the input, and run the program again"
            ),
        }
    }
}
