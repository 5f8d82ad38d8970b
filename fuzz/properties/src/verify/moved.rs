//! Results whose vertices have moved: nothing is correct for another input than the one it was verified
//! against.

use std::fmt::Write;

use arbitrary::{Result, Unstructured};
use sweep_cdt::Pslg;
use sweep_cdt_formats::{Coordinate, Format, GraphFile, Matched, Source, read_result};
use sweep_cdt_testing::generators;
use sweep_cdt_testing::tuned::triangulate;

use crate::file::{File, json};

/// A triangulation of points that were moved or reordered, read as one of the points before, or theirs read
/// as one of the points after.
pub(super) struct Moved {
    points: Vec<[f64; 2]>,
    /// Where they are in the file.
    own: Vec<[f64; 2]>,
    triangles: Vec<[usize; 3]>,
    /// The file.
    obj: String,
}

impl Moved {
    /// The case that the bytes stand for, if there are points and all are finite.
    pub(super) fn read(bytes: &mut Unstructured<'_>) -> Result<Option<Moved>> {
        let [kind, which, how, digits]: [u8; 4] = bytes.arbitrary()?;
        let points = generators::read(bytes)?.points;
        if points.is_empty() {
            return Ok(None);
        }
        let mut own = points.clone();
        change(&mut own, kind, usize::from(which) % points.len(), how);
        if own.as_flattened().iter().any(|x| !x.is_finite()) {
            return Ok(None);
        }
        let result = triangulate(if how & 1 == 0 { &own } else { &points }, &[]);
        let triangles: Vec<[usize; 3]> = result.expect("there are no edges").triangles().collect();
        // Some are printed with few digits, and these are their coordinates.
        let mut obj = String::new();
        for point in &mut own {
            let [x, y] = point.each_mut().map(|x| {
                let text = match usize::from(digits % 32) {
                    few @ 1..=16 => format!("{x:.*e}", few - 1),
                    _ => x.text(),
                };
                *x = text.parse().expect("a number");
                text
            });
            writeln!(obj, "v {x} {y} 0").expect("strings grow");
        }
        for corners in &triangles {
            let [a, b, c] = corners.map(|v| v + 1);
            writeln!(obj, "f {a} {b} {c}").expect("strings grow");
        }
        Ok(Some(Moved {
            points,
            own,
            triangles,
            obj,
        }))
    }

    /// The points of the input, and the file.
    pub(super) fn files(self) -> Vec<File> {
        let input = json(&self.points, &[]);
        vec![
            ("input.json".to_owned(), input.into_bytes()),
            ("result.obj".to_owned(), self.obj.into_bytes()),
        ]
    }

    /// Panics unless the file is read as a result for the points only if it is one.
    pub(super) fn judge(&self) {
        let Moved {
            own,
            triangles,
            obj,
            ..
        } = self;
        let source = Source::new("file", obj.clone().into_bytes());
        let input = GraphFile::from(Pslg {
            points: self.points.clone(),
            ..Pslg::default()
        });
        let input_has = |p: &[f64; 2]| input.graph.points.contains(p);
        let pairs = || {
            own.as_flattened()
                .iter()
                .zip(input.graph.points.as_flattened())
        };
        match read_result(Format::Obj, &source, None, &input) {
            // All are there, so they can be matched.
            Err(error) => {
                assert!(!own.iter().all(input_has), "{error}: {own:?} for {input:?}");
            }
            // What is verified are the triangles of the file, by their very corners.
            Ok(result) if result.matched == Matched::Equal => {
                let read = result
                    .list
                    .as_flattened()
                    .iter()
                    .map(|&v| input.graph.points[v]);
                let written = triangles.as_flattened().iter().map(|&v| own[v]);
                assert!(read.eq(written), "{result:?} of {own:?} for {input:?}");
            }
            // Each place is another one's rounding, to six digits or six decimals.
            Ok(result)
                if matches!(
                    result.matched,
                    Matched::Printed { .. } | Matched::Single { .. }
                ) =>
            {
                let points = &input.graph.points;
                let files = triangles.as_flattened().iter().map(|&v| own[v]);
                let pairs: Vec<_> = files
                    .zip(result.list.as_flattened().iter().copied())
                    .collect();
                let is_near = |(x, y): (f64, f64)| (x - y).abs() <= 5.000_001e-6 * y.abs() + 5e-7;
                for &(place, v) in &pairs {
                    let coordinates = place.into_iter().zip(points[v]);
                    assert!(coordinates.clone().all(is_near), "{own:?} for {input:?}");
                    let others = pairs.iter().filter(|(_, w)| points[*w] == points[v]);
                    others
                        .for_each(|&(other, _)| assert_eq!(other, place, "{own:?} for {input:?}"));
                }
            }
            // No coordinate is off by more than half a unit of its sixth digit.
            Ok(result) => {
                let is_near = |(x, y): (&f64, &f64)| (x - y).abs() <= 5.000_001e-6 * y.abs();
                assert!(pairs().all(is_near), "{own:?} for {input:?}");
                let greatest = pairs().map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
                assert_eq!(
                    result.matched,
                    Matched::Rounded {
                        difference: greatest
                    }
                );
                assert_eq!(&result.list, triangles);
            }
        }
    }
}

/// Moves one point or all, or changes their order.
fn change(points: &mut [[f64; 2]], kind: u8, v: usize, how: u8) {
    let axis = usize::from(how >> 1 & 1);
    let each = |points: &mut [[f64; 2]], of: &dyn Fn(f64) -> f64| {
        points.iter_mut().for_each(|p| p[axis] = of(p[axis]));
    };
    match kind % 8 {
        0 => points.reverse(),
        1 => points.rotate_left(v),
        2 => points.iter_mut().for_each(|p| p.swap(0, 1)),
        3 => each(points, &|x| -x),
        4 => each(points, &|x| x + 7.0),
        5 => each(points, &|x| 1.5 * x),
        6 => points[v][axis] += [5000.0, 1.0, 1e-3, 1e-9][usize::from(how >> 6)],
        _ => points[v][axis] = points[v][axis].next_up(),
    }
}
