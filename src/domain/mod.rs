//! Domains: what of the hull is inside.
//!
//! The triangles of a [`Triangulation`] cover the convex hull of the points. A polygon with holes, or a map of
//! regions, is a part of it: a [`Domain`]. Since the edges are chains of sides, each triangle lies wholly inside
//! or wholly outside. So a rule is a matter of counting which sides a path from outside crosses; no coordinate is
//! looked at. Only seeds of holes are, and they are found by exact signs.
//!
//! | | inside is | file |
//! |---|---|---|
//! | [`Rule::Hull`] | everything | `mod.rs` |
//! | [`Rule::EvenOdd`] | what a path from outside enters by an odd number of edges | `flow`, `spread` |
//! | [`Rule::NonZero`] | what the edges go round | `flow`, `spread` |
//! | [`Triangulation::domain_of_seeds`] | what no hole and no gap of the edges opens | `holes`, `faces`, `locate` |
//!
//! Why that is right: each file says it of its part. `flow` counts the edges on each side and shows that all paths
//! to a triangle agree; `spread` follows one of them; `faces` joins what no edge parts, and `holes` asks in which
//! face a seed is; `loops` collects the boundary.
//!
//! Cost: O(n + m log m) for n triangles and chains of m sides together, and 13 bytes a triangle.
//!
//! Differs from the paper: it ends with the hull.

mod error;
mod faces;
mod flow;
mod holes;
mod labels;
mod locate;
mod loops;
mod rule;
mod seed;
mod spread;

pub use error::DomainError;
pub use labels::Domain;
pub use rule::Rule;
pub use seed::Seed;

use crate::Triangulation;
use flow::Flow;

impl Triangulation {
    /// What of the hull is inside, by a [`Rule`].
    ///
    /// # Errors
    /// [`DomainError`], if the edges form no closed chains, or are not those of the triangulation.
    ///
    /// ```
    /// use sweep_cdt::domain::Rule;
    ///
    /// // An arrowhead: its notch is in the hull, but not inside.
    /// let points = [[0.0, 0.0], [4.0, 3.0], [0.0, 6.0], [1.0, 3.0]];
    /// let result = sweep_cdt::triangulate(&points, &[[0, 1], [1, 2], [2, 3], [3, 0]])?;
    /// let domain = result.domain(Rule::EvenOdd)?;
    /// assert_eq!((result.len(), domain.inside().len()), (3, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn domain(&self, rule: Rule<'_>) -> Result<Domain<'_>, DomainError> {
        let flow_in = |flow: &Flow, t, side| match self.is_constrained(t, side) {
            true => flow.of_side(loops::ends(self, t, side)),
            false => 0,
        };
        let is_odd = |number: i32| number % 2 != 0;
        match rule {
            Rule::Hull => Ok(Domain::whole(self)),
            Rule::EvenOdd => {
                let flow = Flow::downwards(self);
                flow.expect_closed(is_odd)?;
                let depths = spread::layers(self, |t, side| is_odd(flow_in(&flow, t, side)));
                Ok(Domain::new(self, depths, is_odd))
            }
            Rule::NonZero(edges) => {
                let flow = Flow::along(self, edges)?;
                flow.expect_closed(|flow| flow != 0)?;
                let depths = spread::sums(self, |t, side| flow_in(&flow, t, side));
                Ok(Domain::new(self, depths, |winding| winding != 0))
            }
        }
    }
}
