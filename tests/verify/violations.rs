//! Every violation: its name, its sentence and what it names.

use sweep_cdt::verify::Violation;

/// A violation, its name, its sentence, and the vertices, edges and triangles in it.
type Row = (Violation, &'static str, &'static str, [&'static [usize]; 3]);

const VIOLATIONS: [Row; 20] = [
    (
        Violation::TooLarge { given: 7, limit: 5 },
        "too-large",
        "7 points or corners are more than the 5 that fit",
        [&[], &[], &[]],
    ),
    (
        Violation::NonFiniteCoordinate { vertex: 1 },
        "non-finite-coordinate",
        "vertex 1 has a coordinate that is not finite",
        [&[1], &[], &[]],
    ),
    (
        Violation::EdgeOutOfRange { edge: 1, vertex: 2 },
        "edge-out-of-range",
        "edge 1 ends at vertex 2, which does not exist",
        [&[2], &[1], &[]],
    ),
    (
        Violation::TriangleOutOfRange {
            triangle: 1,
            vertex: 2,
        },
        "triangle-out-of-range",
        "triangle 1 has vertex 2, which does not exist",
        [&[2], &[], &[1]],
    ),
    (
        Violation::FlatTriangle { triangle: 1 },
        "flat-triangle",
        "triangle 1 has its corners on one line",
        [&[], &[], &[1]],
    ),
    (
        Violation::ReversedTriangle { triangle: 1 },
        "reversed-triangle",
        "triangle 1 runs the wrong way round",
        [&[], &[], &[1]],
    ),
    (
        Violation::RepeatedSide {
            side: [1, 2],
            triangles: [3, 4],
        },
        "repeated-side",
        "triangles 3 and 4 both lie to the left of side 1-2",
        [&[1, 2], &[], &[3, 4]],
    ),
    (
        Violation::NoTriangles {
            vertices: [1, 2, 3],
        },
        "no-triangles",
        "there are no triangles, but vertices 1, 2, 3 are not on a line",
        [&[1, 2, 3], &[], &[]],
    ),
    (
        Violation::PinchedBoundary { vertex: 1 },
        "pinched-boundary",
        "the boundary meets itself at vertex 1",
        [&[1], &[], &[]],
    ),
    (
        Violation::ExtraBoundary {
            side: [1, 2],
            sides: 3,
        },
        "extra-boundary",
        "side 1-2 is on a boundary of 3 sides that is not the hull",
        [&[1, 2], &[], &[]],
    ),
    (
        Violation::ConcaveBoundary {
            vertices: [1, 2, 3],
            depth: None,
        },
        "concave-boundary",
        "the boundary does not turn left at vertex 2, between 1 and 3",
        [&[1, 2, 3], &[], &[]],
    ),
    (
        Violation::WindingBoundary { times: 2 },
        "winding-boundary",
        "the boundary goes round 2 times",
        [&[], &[], &[]],
    ),
    (
        Violation::UndeclaredBoundary {
            side: [1, 2],
            triangle: 3,
        },
        "undeclared-boundary",
        "side 1-2 of triangle 3 is on no given boundary",
        [&[1, 2], &[], &[3]],
    ),
    (
        Violation::MissingBoundary { side: [1, 2] },
        "missing-boundary",
        "side 1-2 of a given boundary bounds no triangle",
        [&[1, 2], &[], &[]],
    ),
    (
        Violation::TangledBoundary { side: [1, 2] },
        "tangled-boundary",
        "the given boundary crosses or covers itself at side 1-2",
        [&[1, 2], &[], &[]],
    ),
    (
        Violation::UnusedPoint { vertex: 1 },
        "unused-point",
        "vertex 1 is in no triangle",
        [&[1], &[], &[]],
    ),
    (
        Violation::AddedOutside { vertex: 1 },
        "added-outside",
        "vertex 1 was added outside of the hull",
        [&[1], &[], &[]],
    ),
    (
        Violation::WrongCount {
            triangles: 7,
            expected: 8,
        },
        "wrong-count",
        "there are 7 triangles, not 8",
        [&[], &[], &[]],
    ),
    (
        Violation::MissingEdge { edge: 1, after: 2 },
        "missing-edge",
        "edge 1 is missing: no side leads along it from vertex 2",
        [&[2], &[1], &[]],
    ),
    (
        Violation::NotDelaunay {
            side: [1, 2],
            triangles: [3, 4],
            opposite: [5, 1],
            depth: None,
        },
        "not-delaunay",
        "side 1-2 of triangles 3 and 4 is not Delaunay: the circle of one holds vertex 5 or 1 of \
         the other",
        [&[1, 2, 5], &[], &[3, 4]],
    ),
];

#[test]
fn names_sentences_and_offenders() {
    for (violation, name, sentence, [vertices, edges, triangles]) in VIOLATIONS {
        assert_eq!(violation.name(), name);
        assert_eq!(violation.to_string(), sentence);
        let offenders = violation.offenders();
        assert_eq!(offenders.vertices, vertices, "{name}");
        assert_eq!(offenders.edges, edges, "{name}");
        assert_eq!(offenders.triangles, triangles, "{name}");
    }
}

#[test]
fn other_numbers_stand_where_the_old_ones_stood() {
    for (violation, name, ..) in VIOLATIONS {
        let other = violation.renumbered(|v| v + 10, |e| e + 20, |t| t + 30);
        let [old, new] = [violation, other].map(Violation::offenders);
        let plus = |list: Vec<usize>, by: usize| -> Vec<usize> {
            list.into_iter().map(|index| index + by).collect()
        };
        assert_eq!(new.vertices, plus(old.vertices, 10), "{name}");
        assert_eq!(new.edges, plus(old.edges, 20), "{name}");
        assert_eq!(new.triangles, plus(old.triangles, 30), "{name}");
        let back = other.renumbered(|v| v - 10, |e| e - 20, |t| t - 30);
        assert_eq!(back, violation);
    }
}
