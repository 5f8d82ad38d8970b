//! How the vertices of a result were matched with those of the input.

use crate::Coordinate;

/// How the vertices of a result were matched with those of the input.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Matched {
    /// By coordinates: each vertex of the result is one of the input, exactly.
    Equal,
    /// By coordinates: each is that of a vertex of the input, rounded to single precision, and of no other one.
    Single {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By coordinates: each is that of a vertex of the input, rounded to the digits that are printed, and of no other one.
    Printed {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By coordinates: within the tolerance that was asked for, each has one vertex of the input, and no other one.
    Within {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number: the result has no coordinates.
    Unplaced,
    /// By number: each coordinate of the result is that of the input, rounded.
    Rounded {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number: no coordinate differs by more than the tolerance that was asked for.
    Near {
        /// The greatest difference of two coordinates.
        difference: f64,
    },
    /// By number, as was asked for, wherever the vertices are.
    Asked {
        /// The greatest difference of two coordinates; of a vertex that only one of the files has there is
        /// none.
        difference: f64,
    },
}

impl Matched {
    /// The rule that decided: `coordinates` or `number`.
    pub fn by(self) -> &'static str {
        match self {
            Matched::Equal
            | Matched::Single { .. }
            | Matched::Printed { .. }
            | Matched::Within { .. } => "coordinates",
            _ => "number",
        }
    }

    /// The greatest difference of a coordinate of the result from that of the input; `None` where the
    /// result has none. (At most the largest double.)
    pub fn difference(self) -> Option<f64> {
        match self {
            Matched::Equal => Some(0.0),
            Matched::Unplaced => None,
            Matched::Single { difference }
            | Matched::Printed { difference }
            | Matched::Within { difference }
            | Matched::Rounded { difference }
            | Matched::Near { difference }
            | Matched::Asked { difference } => Some(difference),
        }
    }

    /// The line of a report.
    ///
    /// ```
    /// use sweep_cdt_formats::Matched;
    ///
    /// let matched = Matched::Rounded { difference: 0.5 };
    /// let words = "vertices matched by number, because coordinates are rounded: greatest difference 0.5";
    /// assert_eq!(matched.words(), words);
    /// ```
    pub fn words(self) -> String {
        let why = match self {
            Matched::Equal => "",
            Matched::Single { .. } => ", which are of single precision",
            Matched::Printed { .. } => ", which are rounded",
            Matched::Unplaced => ": the result has no coordinates",
            Matched::Rounded { .. } => ", because coordinates are rounded",
            Matched::Near { .. } | Matched::Within { .. } => ", within the tolerance",
            Matched::Asked { .. } => ", as was asked for",
        };
        let difference = self.difference();
        let difference = difference.map(|x| format!(": greatest difference {}", x.text()));
        format!(
            "vertices matched by {}{why}{}",
            self.by(),
            difference.unwrap_or_default()
        )
    }

    /// The name of the variant, in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Matched::Equal => "equal",
            Matched::Single { .. } => "single",
            Matched::Printed { .. } => "printed",
            Matched::Within { .. } => "within",
            Matched::Unplaced => "unplaced",
            Matched::Rounded { .. } => "rounded",
            Matched::Near { .. } => "near",
            Matched::Asked { .. } => "asked",
        }
    }
}
