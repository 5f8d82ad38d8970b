//! A run with settings that are chosen when the program runs; one with every step of it, and whether another run
//! takes the same steps.

#[cfg(feature = "parallel")]
use sweep_cdt::Bands;
use sweep_cdt::front::FrontSearch;
use sweep_cdt::scalar::Scalar;
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Heuristics, Triangulation, Triangulator, Watch};
use sweep_cdt_trace::Trace;

use crate::any_front::AnyFront;
use crate::tuned::tuning;

/// The choices of a run, beside the scalar.
#[derive(Clone, Debug)]
pub struct Choice {
    /// The front.
    pub front: AnyFront,
    /// The heuristics.
    pub heuristics: Heuristics,
    /// The algorithm.
    pub algorithm: Algorithm,
    /// How many bands are swept at the same time, if there is more than one.
    #[cfg(feature = "parallel")]
    pub bands: usize,
    /// New vertices of a window, if the run is a stream.
    pub window: usize,
}

impl Default for Choice {
    fn default() -> Choice {
        Choice {
            front: AnyFront::default(),
            heuristics: Heuristics::FAST,
            algorithm: Algorithm::Sweep,
            #[cfg(feature = "parallel")]
            bands: 1,
            window: 1,
        }
    }
}

impl Choice {
    /// The triangulator with these choices; front and bands belong to a call.
    pub fn triangulator(&self) -> Triangulator {
        Triangulator::new()
            .heuristics(self.heuristics)
            .algorithm(self.algorithm)
    }
}

/// Triangulates as chosen, with the [thresholds](crate::tuned) for the input.
///
/// # Errors
/// As [`Triangulator::triangulate`].
pub fn triangulate<S: Scalar + Sync>(
    points: &[[S; 2]],
    edges: &[[usize; 2]],
    choice: &Choice,
) -> Result<Triangulation, Error> {
    let triangulator = choice.triangulator().tuning(tuning(points, edges));
    #[cfg(feature = "parallel")]
    if choice.bands > 1 {
        let mut fronts = vec![choice.front.clone(); choice.bands];
        let bands = Bands::new().count(choice.bands);
        let bands = match choice.front {
            AnyFront::HashTable(_) => bands,
            _ => bands.fronts(&mut fronts),
        };
        return triangulator.triangulate_parallel(points, edges, bands);
    }
    triangulator.run(points, edges, choice.front.clone().watch())
}

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
    /// The steps of this input in these numbers, with the default front.
    pub fn of<S: Scalar>(points: &[[S; 2]], edges: &[[usize; 2]], heuristics: Heuristics) -> Steps {
        let mut trace = Trace::default();
        let mut observer = |event| trace.events.push(event);
        let watch = Watch::new().events(&mut observer);
        let result = paper(heuristics).run(points, edges, watch);
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
        front: &mut dyn FrontSearch,
        name: &str,
    ) {
        self.compare(edges.len(), name, |observer| {
            let watch = Watch::new().front(front).events(observer);
            paper(self.heuristics).run(points, edges, watch)
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

/// The sweep whose steps can be replayed.
fn paper(heuristics: Heuristics) -> Triangulator {
    Triangulator::new()
        .algorithm(Algorithm::Paper)
        .heuristics(heuristics)
}

/// Whether two results of an input with this many edges are equal in everything, numbers of triangles too.
fn are_equal(here: &Triangulation, there: &Triangulation, edges: usize) -> bool {
    here.triangles().eq(there.triangles())
        && (0..here.len()).all(|t| here.neighbors(t) == there.neighbors(t))
        && here.constrained_sides().eq(there.constrained_sides())
        && here.hull().eq(there.hull())
        && here.duplicates().eq(there.duplicates())
        && (0..edges).all(|e| here.edge_chain(e).eq(there.edge_chain(e)))
}
