//! Bounds on the triangles of a mesh.

use sweep_cdt_edit::Bounds;

/// Arguments that give them.
#[derive(clap::Args)]
pub(crate) struct BoundsArgs {
    /// Least angle of a triangle, in degrees below 60
    ///
    /// Angles are compared by their squared cosines, exactly: with the double nearest to that of this angle.
    #[arg(long, value_name = "DEGREES")]
    min_angle: Option<f64>,

    /// Greatest area of a triangle
    #[arg(long, value_name = "AREA")]
    max_area: Option<f64>,

    /// Greatest length of a side
    #[arg(long, value_name = "LENGTH")]
    max_side: Option<f64>,
}

impl BoundsArgs {
    /// The bounds, if there are any.
    pub(crate) fn given(&self) -> Option<Bounds> {
        let bounds = Bounds {
            least_angle: self.min_angle,
            greatest_area: self.max_area,
            greatest_side: self.max_side,
        };
        (bounds != Bounds::default()).then_some(bounds)
    }
}
