//! A run with every step of it, and whether another run takes the same steps.

use sweep_cdt::front::FrontSearch;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::{Event, Trace};
use sweep_cdt::{Error, Heuristics, Triangulation};

use crate::fronts::{FrontKind, observe, observe_with};

/// The steps of a run and its result.
#[derive(Clone, Debug)]
pub struct Steps {
    heuristics: Heuristics,
    /// Every step.
    pub trace: Trace,
    /// The result.
    pub result: Result<Triangulation, Error>,
}

impl Steps {
    /// Those of this input in these numbers, with the default front.
    pub fn of<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]], heuristics: Heuristics) -> Steps {
        let mut trace = Trace::default();
        let mut observer = |event| trace.events.push(event);
        let result = observe(
            points,
            edges,
            FrontKind::HashTable,
            heuristics,
            &mut observer,
        );
        Steps {
            heuristics,
            trace,
            result,
        }
    }

    /// Panics unless the same input in other numbers or with another front takes the same steps to the
    /// same end; `name` says which.
    pub fn assert_same<S: Scalar>(
        &self,
        points: &[[S; 2]],
        edges: &[[usize; 2]],
        front: FrontKind,
        name: &str,
    ) {
        self.compare(edges.len(), name, |observer| {
            observe(points, edges, front, self.heuristics, observer)
        });
    }

    /// The same with a front of any type.
    pub fn assert_same_with(
        &self,
        points: &[[f64; 2]],
        edges: &[[usize; 2]],
        front: impl FrontSearch + Clone,
        name: &str,
    ) {
        self.compare(edges.len(), name, |observer| {
            observe_with(points, edges, front, self.heuristics, observer)
        });
    }

    /// Compares the steps of a run, and what it returns, with these.
    fn compare(
        &self,
        edges: usize,
        name: &str,
        run: impl FnOnce(&mut dyn FnMut(Event)) -> Result<Triangulation, Error>,
    ) {
        let mut expected = self.trace.events.iter();
        let result = run(&mut |event| {
            assert_eq!(Some(&event), expected.next(), "{name}: a step (left)");
        });
        assert_eq!(expected.next(), None, "{name}: the step after the last one");
        match (&result, &self.result) {
            (Ok(here), Ok(there)) => assert!(
                are_equal(here, there, edges),
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

/// Whether two results of an input with this many edges are equal in everything, numbers of triangles too.
fn are_equal(here: &Triangulation, there: &Triangulation, edges: usize) -> bool {
    here.triangles().eq(there.triangles())
        && (0..here.len()).all(|t| here.neighbors(t) == there.neighbors(t))
        && here.constrained_edges().eq(there.constrained_edges())
        && here.hull().eq(there.hull())
        && here.duplicates().eq(there.duplicates())
        && (0..edges).all(|e| here.edge_chain(e).eq(there.edge_chain(e)))
}
