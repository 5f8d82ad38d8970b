//! The suite of conformance: this crate has the answer that each case says.

use sweep_cdt_testing::suite::{Answer, own};

/// Triangles, hull, what is inside by each rule, and all edges that cross are those of the file.
#[test]
fn every_case_has_its_answer() {
    let cases = own();
    assert!(cases.len() > 2000, "only {} cases", cases.len());
    for case in &cases {
        let found = Answer::of_this_crate(&case.question);
        assert_eq!(found, case.answer, "{}", case.name);
    }
}
