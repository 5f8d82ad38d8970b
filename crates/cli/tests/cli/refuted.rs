//! Results that are wrong, or no results at all: in which words, and what is left behind.

use std::fs;

use crate::verify::{RIGHT, first_line, refuted, verify, with_square};
use crate::{assert_fails, names};

/// Wrong results of the square: the file and what is said about it.
pub(crate) const WRONG: &[(&str, &str, &str)] = &[
    (
        "a.json",
        r#"{"triangles": [[0,1,4],[1,3,4],[1,2,3],[3,0,4]]}"#,
        // The circle around (2, 2) with the squared radius 8: 7/8.
        "depths of violations\n\
         1e-1 to 1e0                          1\n\
         the deepest                     8.8e-1\n\n\
         not-delaunay: side 4-2 of triangles 2 and 1 is not Delaunay: the circle of one holds \
         vertex 3 or 5 of the other\n  4 (0, 4), 2 (4, 0), 3 (4, 4), 5 (2, 1)\n  by 8.8e-1 of the squared radius\n",
    ),
    (
        "a.ele",
        "4 3\n1 1 2 5\n2 2 5 3\n3 3 4 5\n4 4 1 5\n",
        "reversed-triangle: triangle 2 runs the wrong way round\n  2 (4, 0), 5 (2, 1), 3 (4, 4)\n",
    ),
    (
        "a.ele",
        "4 3\n0 0 1 4\n1 1 2 4\n2 2 3 4\n3 3 0 0\n",
        "flat-triangle: triangle 3 has its corners on one line\n  4 (0, 4), 1 (0, 0)\n",
    ),
    (
        "a.ele",
        "4 3\n1 1 2 5\n2 2 3 5\n3 3 0 5\n4 4 1 5\n",
        "triangle-out-of-range: triangle 3 has vertex 0, which does not exist\n  \
         3 (4, 4), 5 (2, 1)\n",
    ),
    (
        "a.obj",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 1 0\n\
         f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 6\n",
        "triangle-out-of-range: triangle 4 has vertex 6, which does not exist\n  \
         4 (0, 4), 1 (0, 0)\n",
    ),
    (
        "a.json",
        r#"{"triangles": [18446744073709551615,0,1, 1,2,4, 2,3,4, 3,0,4]}"#,
        "triangle-out-of-range: triangle 0 has vertex 18446744073709551615, which does not exist\n  \
         1 (0, 0), 2 (4, 0)\n\n\
         missing-edge: edge 1 is missing: no side leads along it from vertex 1\n  \
         1 (0, 0), 2 (4, 0)\n",
    ),
    (
        "a.json",
        r#"{"triangles": []}"#,
        "no-triangles: there are no triangles, but vertices 1, 2, 3 are not on a line\n  \
         1 (0, 0), 2 (4, 0), 3 (4, 4)\n",
    ),
    (
        "a.json",
        r#"{"triangles": [[1,2,4],[2,3,4],[3,0,4]]}"#,
        // A turn by 1 over a width of 4.
        "depths of violations\n\
         1e-1 to 1e0                          1\n\
         not measured                         1\n\
         the deepest                     2.5e-1\n\n\
         concave-boundary: the boundary does not turn left at vertex 5, between 1 and 2\n  \
         1 (0, 0), 5 (2, 1), 2 (4, 0)\n  by 2.5e-1 of the distance of the vertices beside it\n\n\
         missing-edge: edge 1 is missing: no side leads along it from vertex 1\n  \
         1 (0, 0), 2 (4, 0)\n",
    ),
];

#[test]
fn wrong_results_are_refuted_with_numbers_and_coordinates() {
    for (name, contents, expected) in WRONG {
        let folder = with_square(&[(name, contents)]);
        let output = verify(&folder, &format!("a.poly {name}"));
        let report = refuted(&output);
        let found = expected.split("\n\n").count() - usize::from(expected.starts_with("depths"));
        let plural = if found == 1 { "" } else { "s" };
        let line = format!(
            "wrong: {name} is not a constrained Delaunay triangulation of a.poly: {found} \
             violation{plural}"
        );
        assert_eq!(first_line(report), line);
        let (_, violations) = report.rsplit_once("%\n\n").expect("counts, violations");
        let (violations, _) = violations.rsplit_once("\n\n").expect("the last line");
        assert_eq!(format!("{violations}\n"), *expected, "{contents}");
    }
}

#[test]
fn the_limit_cuts_the_list_and_not_the_count() {
    let folder = with_square(&[("a.json", r#"{"triangles": [[0,1,9]]}"#)]);
    let output = verify(&folder, "a.poly a.json --limit 2");
    let report = refuted(&output);
    assert!(first_line(report).ends_with(": 7 violations"));
    assert!(
        report.contains("unused-point: vertex 1 is in no triangle\n  1 (0, 0)\n\nand 5 more\n\n")
    );
    let output = verify(&folder, "a.poly a.json --limit 0");
    assert!(refuted(&output).contains(" %\n\n7 violations are not listed\n\n"));
}

/// Results that cannot be read, and the error.
const UNREADABLE: &[(&str, &str, &str)] = &[
    (
        "r.ele",
        "",
        "r.ele:1: the file ends where the number of triangles should follow",
    ),
    (
        "r.ele",
        "\0\u{ff}",
        "r.ele:1: `\\0\u{ff}` is not a number of triangles",
    ),
    (
        "r.ele",
        "1 6\n",
        "r.ele:1: the triangles have 6 nodes each, and only those of 3 are read: write them without \
         Triangle's option -o2",
    ),
    (
        "r.ele",
        "1 3\n",
        "r.ele:1: the file ends where triangle 1 of 1 should follow",
    ),
    (
        "r.ele",
        "1 3\n1 1 2\n",
        "r.ele:2: the line ends where a vertex's number should follow",
    ),
    (
        "r.ele",
        "1 3\n1 1 2 -3\n",
        "r.ele:2: `-3` is not a vertex's number",
    ),
    (
        "r.ele",
        "1 3\n7 1 2 3\n",
        "r.ele:2: the first number is 7, not 0 or 1",
    ),
    (
        "r.ele",
        "1 3\n1 1 2 3\n2 1 2 3\n",
        "r.ele:3: the first line announces only 1 triangles",
    ),
    (
        "r.ele",
        "1 4\n1 1 2 3 4\n",
        "r.ele:1: the cells have 4 corners, and only triangles are read: split them",
    ),
    (
        "r.ele",
        "1 5\n",
        "r.ele:1: `5` is not 3, the number of corners",
    ),
    ("r.json", "", "r.json:1: the file is empty"),
    ("r.json", "{}", "r.json:1:1: the object has no `triangles`"),
    (
        "r.json",
        "{\"triangles\": [[0, 1, 2, 3]]}",
        "r.json:1:16: a triangle has 3 corners, and this one 4: split it into triangles",
    ),
    (
        "r.json",
        "{\"triangles\": [0, 1,\n2, 3]}",
        "r.json:2:4: the 4 corners in one list do not make triangles",
    ),
    (
        "r.json",
        "{\"triangles\": [], \"points\": [[1, 2, 3, 4]]}",
        "r.json:1:30: a point has 2 coordinates, and this one 4: leave out all but x, y and z",
    ),
    (
        "r.json",
        "{\"triangles\": [0, 1, 2], \"points\": [[1, 2], 3]}",
        "r.json:1:45: `3` is not a point, a list of 2 coordinates",
    ),
    (
        "r.json",
        "{\"triangles\": [[0, 1, 2]], \"points\": [[1]]}",
        "r.json:1:39: a point has 2 coordinates, and this one 1",
    ),
    (
        "r.json",
        "{\"triangles\":\n [[0, 1]]}",
        "r.json:2:3: a triangle has 3 corners, and this one 2",
    ),
    (
        "r.json",
        "{\"triangles\": [[0, 1, -2]]}",
        "r.json:1:23: `-2` is not a vertex's number",
    ),
    (
        "r.obj",
        "v 0 0\nf 1 1 1 1\n",
        "r.obj:2: the face has 4 corners, and only triangles are read: split it, for example by the \
         option `triangulate` of the program that wrote it",
    ),
    (
        "r.obj",
        "v 0 0\nf 1 1\n",
        "r.obj:2: the line ends where a vertex's number should follow",
    ),
    (
        "r.obj",
        "v 0 0\nf 1 1 -2\n",
        "r.obj:2: `-2` is not a vertex's number",
    ),
    ("r.obj", "v 0 x\n", "r.obj:1: `x` is not a coordinate"),
    (
        "r.obj",
        "v 0 1/2\n",
        "r.obj: has fractions, and the input is read as doubles (--scalar rational reads both exactly)",
    ),
    (
        "r.obj",
        "f /1 2 3\n",
        "r.obj:1: `/1` is not a vertex's number",
    ),
];

#[test]
fn unreadable_results_are_errors_with_their_line() {
    for &(name, contents, error) in UNREADABLE {
        let folder = with_square(&[(name, contents)]);
        let output = verify(
            &folder,
            &format!("a.poly {name} --svg a.svg --record c.json"),
        );
        assert_fails(&output, error);
        assert_eq!(names(folder.path()), ["a.poly", name]);
    }
    let folder = with_square(&[("r.ele", RIGHT), ("r.node", "1 2\n1 0\n")]);
    let error = "r.node:2: the line ends where a y coordinate should follow";
    assert_fails(&verify(&folder, "a.poly r.ele"), error);
    assert_fails(
        &verify(&folder, "a.poly x.ele"),
        "x.ele: no such file or directory",
    );
    fs::write(folder.path().join("nan.node"), "2\n1 0 0\n2 nan 0\n").expect("a file");
    for scalar in ["f64", "rational"] {
        let output = verify(&folder, &format!("nan.node r.ele --scalar {scalar}"));
        assert_fails(
            &output,
            "nan.node: vertex 2 has a coordinate that is not finite",
        );
    }
}
