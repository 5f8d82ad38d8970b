//! Formats: what files of odd but correct content mean.

use num_bigint::BigInt;
use num_rational::BigRational;
use sweep_cdt::Error;
use sweep_cdt::formats::{
    Coordinate, Graph, Matched, ResultFormat, Source, Triangles, read_result,
};

fn source(text: &str) -> Source {
    Source {
        name: "file".to_owned(),
        bytes: text.as_bytes().to_vec(),
    }
}

/// The input has two points at the origin, and one more.
fn graph() -> Graph<f64> {
    Graph {
        points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 1.0]],
        ..Graph::default()
    }
}

fn read(format: ResultFormat, text: &str) -> Result<Triangles, String> {
    read_result(format, &source(text), None, &graph()).map_err(|error| error.to_string())
}

#[test]
fn of_equal_vertices_the_first_is_matched() {
    let triangles = read(ResultFormat::Obj, "v 1 0 0\nv 0 1 0\nv 0 0 0\nf 3 1 2\n");
    let triangles = triangles.expect("a result");
    assert_eq!(triangles.matched, Matched::Equal);
    assert_eq!(triangles.list, [[0, 1, 3]]);
}

#[test]
fn a_vertex_counted_back_beyond_the_first_is_refused() {
    let text = |back: &str| format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 {back}\n");
    assert!(read(ResultFormat::Obj, &text("-3")).is_ok());
    for back in ["-4", "-5", "-0"] {
        let error = read(ResultFormat::Obj, &text(back)).expect_err("no vertex");
        assert_eq!(error, format!("file:4: `{back}` is not a vertex's number"));
    }
}

#[test]
fn corners_in_one_list_come_in_threes() {
    let flat = |list: &str| read(ResultFormat::Json, &format!("{{\"triangles\": [{list}]}}"));
    assert_eq!(flat("0, 1, 3").expect("a triangle").list, [[0, 1, 3]]);
    assert!(flat("0, 1, 3, 2").is_err());
}

#[test]
fn without_a_node_vertices_are_numbered_as_triangles_are() {
    let corners = |text| read(ResultFormat::Ele, text).expect("a triangle").list;
    assert_eq!(corners("1 3 0\n0 0 1 3\n"), [[0, 1, 3]]);
    assert_eq!(corners("1 3 0\n1 1 2 4\n"), [[0, 1, 3]]);
}

#[test]
fn errors_have_the_numbers_of_the_file() {
    let graph = Graph {
        first_vertex: 1,
        ..graph()
    };
    let number = |error| graph.as_numbered(error).to_string();
    let [own, file] = [(7, 4), (7, 5)].map(|(edge, vertex)| Error::EdgeOutOfRange { edge, vertex });
    assert_eq!(number(own), file.to_string());
    let [own, file] = [4, 5].map(|vertex| Error::NonFiniteCoordinate { vertex });
    assert_eq!(number(own), file.to_string());
}

#[test]
fn whole_numbers_beyond_doubles_stay_rationals() {
    let number = BigRational::from(BigInt::from((1_i64 << 53) + 1));
    assert_eq!(number.text(), "9007199254740993/1");
    assert_eq!(BigRational::from_text(&number.text()), Ok(number));
}

#[test]
fn a_denominator_of_too_many_digits_is_refused() {
    let fraction = |digits| BigRational::from_text(&format!("1/{}", "3".repeat(digits)));
    assert!(fraction(10_000).is_ok() && fraction(10_001).is_err());
}
