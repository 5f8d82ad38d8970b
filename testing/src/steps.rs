//! A run with every step of it, and whether another run takes the same steps.

use sweep_cdt::front::FrontSearch;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Trace;
use sweep_cdt::{Error, Heuristics, Triangulation, Triangulator};

/// What a run tells and what it gives.
#[derive(Clone, Debug)]
pub struct Steps {
    heuristics: Heuristics,
    /// Every step.
    pub trace: Trace,
    /// The result.
    pub result: Result<Triangulation, Error>,
}

impl Steps {
    /// Those of this input in these numbers.
    pub fn of<S: Scalar, F: FrontSearch + Clone + Default>(
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        heuristics: Heuristics,
    ) -> Steps {
        let mut trace = Trace::default();
        let result = Triangulator::new()
            .front(F::default())
            .heuristics(heuristics)
            .triangulate_observed(points, edges, |event| trace.events.push(event))
            .map(|run| run.triangulation);
        Steps {
            heuristics,
            trace,
            result,
        }
    }

    /// Panics unless the same input in other numbers or with another front takes the same steps to the
    /// same end; `name` says which.
    pub fn assert_same<S: Scalar, F: FrontSearch + Clone + Default>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        name: &str,
    ) {
        let mut expected = self.trace.events.iter();
        let result = Triangulator::new()
            .front(F::default())
            .heuristics(self.heuristics)
            .triangulate_observed(points, edges, |event| {
                assert_eq!(Some(&event), expected.next(), "{name}: a step (left)");
            })
            .map(|run| run.triangulation);
        assert_eq!(expected.next(), None, "{name}: the step after the last one");
        match (&result, &self.result) {
            (Ok(here), Ok(there)) => assert!(
                are_equal(here, there, edges.len()),
                "{name}: {here:?}, not {there:?}"
            ),
            (here, there) => assert_eq!(
                here.as_ref().err(),
                there.as_ref().err(),
                "{name}: the error (left)"
            ),
        }
    }
}

/// Whether two results with so many edges say the same everywhere, numbers of triangles included.
fn are_equal(here: &Triangulation, there: &Triangulation, edges: usize) -> bool {
    here.triangles().eq(there.triangles())
        && (0..here.len()).all(|t| here.neighbors(t) == there.neighbors(t))
        && here.constrained_edges().eq(there.constrained_edges())
        && here.hull().eq(there.hull())
        && here.duplicates().eq(there.duplicates())
        && (0..edges).all(|e| here.edge_chain(e).eq(there.edge_chain(e)))
}
