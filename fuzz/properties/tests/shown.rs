//! What the bytes of a finding stand for, as files.

use std::collections::BTreeMap;
use std::fs;

use sweep_cdt_properties::named;
use sweep_cdt_testing::Input;

fn files_of(name: &str, bytes: &[u8]) -> BTreeMap<String, String> {
    let folder = std::env::temp_dir().join(format!("shown-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let target = named(name).expect("a target");
    target.show(bytes, &folder).expect("a folder");
    let entries = fs::read_dir(&folder).expect("a folder");
    let files = entries.map(|entry| {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy();
        let text = fs::read(&path).expect("a file");
        (
            name.into_owned(),
            String::from_utf8_lossy(&text).into_owned(),
        )
    });
    let files = files.collect();
    fs::remove_dir_all(folder).expect("a folder");
    files
}

fn seeds_of(name: &str, points: &str, edges: &str) -> Vec<Vec<u8>> {
    let target = named(name).expect("a target");
    target.seeds(&Input::parse(points, edges))
}

#[test]
fn edges_that_cross_have_a_picture_and_the_steps_up_to_there() {
    let bytes = seeds_of("valid", "0 0, 4 4, 0 4, 4 0, 2 9", "0 1, 2 3");
    let files = files_of("valid", &bytes[0]);
    assert!(files["outcome.txt"].starts_with("error: "), "{files:?}");
    assert!(files["trace.txt"].contains("\npoint "), "{files:?}");
    assert!(files["picture.svg"].starts_with("<svg "), "{files:?}");
    assert!(files["row.txt"].contains("\"0 1, 2 3\""), "{files:?}");
}

#[test]
fn numbers_without_a_place_have_a_row_and_an_outcome() {
    let bits = f64::NAN.to_bits().to_le_bytes();
    let bytes = [&[1][..], &bits, &bits, &[0, 200]].concat();
    let files = files_of("bits", &bytes);
    assert!(files["row.txt"].contains("NaN NaN"), "{files:?}");
    assert!(files["outcome.txt"].starts_with("error: "), "{files:?}");
    assert!(!files.contains_key("picture.svg"), "{files:?}");
}

#[test]
fn what_is_no_geometry_has_files_of_its_own() {
    let square = |name| seeds_of(name, "0 0, 4 0, 4 3, 0 2", "0 2");
    let replay = files_of("replay", &square("replay")[0]);
    assert_ne!(replay["written.txt"], replay["damaged.txt"]);
    assert!(replay["damage.txt"].contains("line"));
    let verify = files_of("verify", &square("verify")[0]);
    assert!(verify["input.json"].contains("[4.0, 3.0]"), "{verify:?}");
    assert!(verify["result.json"].contains("triangles"), "{verify:?}");
    assert!(verify["violations.svg"].starts_with("<svg "), "{verify:?}");
    let written = files_of("formats", &square("formats")[0]);
    assert!(
        written["written.json"].contains("[4.0, 3.0]"),
        "{written:?}"
    );
    assert!(
        written.keys().any(|name| name.starts_with("file.")),
        "{written:?}"
    );
    let file = files_of("formats", b"\x011 2 0 0\n1 0 0\n0 0\n\x001 2 0 0\n");
    assert_eq!(file["file.poly"], "1 2 0 0\n1 0 0\n0 0\n");
    assert_eq!(file["beside.node"], "1 2 0 0\n");
    let front = files_of("fronts", &[1, 0, 0, 0, 0, 0, 0, 0, 2, 4, 8, 2, 0]);
    assert!(front["front.txt"].contains("Remove"), "{front:?}");
}
