//! Several inputs are one: their points and edges in their order.

use std::cell::Cell;
use std::rc::Rc;

use sweep_cdt_formats::ReadError;
use sweep_cdt_stream::external::{Error, Input, Sorting, chained};

use crate::{Made, Random, expected, take};

/// Points at few places, and edges between those of each input, as inputs and as one list of each.
fn cut(random: &mut Random, inputs: u64) -> (Vec<Made>, Vec<[f64; 2]>, Vec<[u64; 2]>) {
    let (mut made, mut points, mut edges) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..inputs {
        let before = points.len() as u64;
        let count = match random.below(3) {
            0 => 0,
            1 => 1,
            _ => 30_000,
        };
        let own: Vec<[f64; 2]> = (0..count)
            .map(|_| [random.below(300), random.below(300)].map(|x| x as f64))
            .collect();
        let own_edges = 0..if count == 0 { 0 } else { random.below(2_000) };
        let own_edges: Vec<[u64; 2]> = own_edges
            .map(|_| [random.below(count), random.below(count)])
            .collect();
        edges.extend(own_edges.iter().map(|edge| edge.map(|end| end + before)));
        points.extend(&own);
        made.push(Made::new(own, own_edges));
    }
    (made, points, edges)
}

fn boxed(made: Vec<Made>) -> Vec<Box<dyn Input>> {
    made.into_iter()
        .map(|made| Box::new(made) as Box<dyn Input>)
        .collect()
}

#[test]
fn inputs_come_in_the_order_of_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut random = Random(17);
    let mut all = 0;
    for at in 0..12 {
        let (made, points, edges) = cut(&mut random, 1 + at % 5);
        all = all.max(points.len());
        for memory in [1_000_000, 100_000_000] {
            let mut inputs = boxed(made.clone());
            if inputs.len() > 2 {
                // A chain is an input, too.
                let rest = inputs.split_off(1);
                inputs.push(chained(rest, None).expect("inputs"));
            }
            let mut input = chained(inputs, None).expect("inputs");
            let order = Sorting::new(memory, folder.path()).sort(&mut *input);
            let vertices = take(order.expect("no fault")).expect("no fault");
            assert!(vertices == expected(&points, &edges).0, "{at} {memory}");
        }
    }
    assert!(all > 60_000);
}

#[test]
fn numbers_in_errors_are_those_of_each_input() {
    let folder = tempfile::tempdir().expect("a folder");
    let sort = |made: Vec<Made>| {
        let mut input = chained(boxed(made), None).expect("inputs");
        let order = Sorting::new(3_000_000, folder.path()).sort(&mut *input);
        order.map(|_| ()).expect_err("it is wrong")
    };
    let right = || Made::new(vec![[0.0, 0.0], [1.0, 1.0]], vec![[0, 1]]);
    let beyond = || Made::new(vec![[5.0, 5.0]; 3], vec![[0, 1], [2, 3]]);
    for made in [
        vec![beyond(), right()],
        vec![right(), beyond()],
        vec![right(), beyond(), right()],
    ] {
        let error = sort(made);
        let Error::NoPoint {
            edge: 1,
            point: 3,
            first: 0,
            points: 3,
            ..
        } = error
        else {
            panic!("{error:?}")
        };
    }
    let endless = Made::new(vec![[0.0, 0.0]], vec![[0, u64::MAX]]);
    let error = sort(vec![right(), endless]);
    assert!(
        matches!(
            error,
            Error::NoPoint {
                edge: 0,
                points: 1,
                ..
            }
        ),
        "{error:?}"
    );
    let wrong = Made::new(vec![[5.0, 5.0], [5.0, f64::NAN]], Vec::new());
    let error = sort(vec![right(), wrong, right()]);
    assert!(
        matches!(error, Error::NonFinite { point: 1, .. }),
        "{error:?}"
    );
    let error = chained(Vec::new(), None).err().expect("there is none");
    assert_eq!(error.message, "there is no input");
}

/// Points that are counted while they are there.
struct Open {
    made: Made,
    open: Rc<Cell<usize>>,
    /// How many were there when this one was read.
    beside: Rc<Cell<usize>>,
}

impl Drop for Open {
    fn drop(&mut self) {
        self.open.set(self.open.get() - 1);
    }
}

impl Input for Open {
    fn name(&self) -> &str {
        "open"
    }

    fn has_edges(&self) -> bool {
        false
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        self.beside.set(self.open.get());
        self.made.next_points(points)
    }
}

#[test]
fn an_input_is_let_go_when_it_is_over() {
    let folder = tempfile::tempdir().expect("a folder");
    let open = Rc::new(Cell::new(3));
    let beside = [0, 1, 2].map(|_| Rc::new(Cell::new(0)));
    let inputs = beside.each_ref().map(|beside| -> Box<dyn Input> {
        Box::new(Open {
            made: Made::new(vec![[1.0, 2.0]; 500], Vec::new()),
            open: Rc::clone(&open),
            beside: Rc::clone(beside),
        })
    });
    let mut input = chained(inputs.into(), None).expect("inputs");
    let order = Sorting::new(3_000_000, folder.path()).sort(&mut *input);
    assert_eq!(order.expect("no fault").summary().points, 1500);
    assert_eq!(beside.map(|beside| beside.get()), [3, 2, 1]);
    assert_eq!(open.get(), 0);
}
