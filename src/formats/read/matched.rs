//! How the vertices of a result were matched with those of the input.

/// How the vertices of a result were matched with those of the input.
#[derive(Clone, Copy, Debug, PartialEq, strum::IntoStaticStr)]
#[strum(serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Matched {
    /// By coordinates: each vertex of the result is one of the input, exactly.
    Equal,
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
    /// What decided: `coordinates` or `number`.
    pub fn by(self) -> &'static str {
        match self {
            Matched::Equal => "coordinates",
            _ => "number",
        }
    }

    /// The greatest difference of a coordinate of the result from that of the input; `None` where the
    /// result has none. (At most the largest double.)
    pub fn difference(self) -> Option<f64> {
        match self {
            Matched::Equal => Some(0.0),
            Matched::Unplaced => None,
            Matched::Rounded { difference }
            | Matched::Near { difference }
            | Matched::Asked { difference } => Some(difference),
        }
    }

    /// Its name: the variant in lower case with hyphens.
    pub fn name(self) -> &'static str {
        self.into()
    }
}
