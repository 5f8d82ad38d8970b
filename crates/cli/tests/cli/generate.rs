//! `sweep-cdt generate`: the same bytes everywhere, in every format; what the other subcommands make of them; what is
//! refused.

use std::fs;

use hmac_sha256::Hash;
use sweep_cdt_generate::KINDS;

use crate::outputs::{assert_refused, read};
use crate::{assert_fails, feed, folder, names, printed, run, sweep_cdt, text};

fn generated(arguments: &str) -> String {
    let folder = folder(&[]);
    let output = sweep_cdt(&folder, &format!("generate {arguments}")).output();
    printed(&output.expect("the command starts")).to_owned()
}

fn hash(text: &str) -> String {
    let digits = Hash::hash(text.as_bytes());
    digits[..8]
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// Each kind with the first digits of the hash (SHA-256) of its file.
const HASHES: [&str; KINDS.len()] = [
    "uniform 562f19d99d08b1bf",
    "integers d8eb021426189364",
    "clusters 2348f871d4709d1c",
    "power-law c55cec1242e4fe32",
    "lattice 7727816285de142b",
    "lattice-in-order fc043af913d47f74",
    "rows 85c43c8f146cff8b",
    "columns 3fa94df4fc2e243d",
    "circle 11a912b790372770",
    "parabola-up 4d0131a920ab4192",
    "parabola-right fafc75c6fbb02b66",
    "comb 32453e869a573885",
    "fans 921e64f822787425",
    "asterisk d4a5a4d71f8aed61",
    "segments 21cc4e48e7b56440",
    "outlines 1b3038a922dae185",
    "parcels 791c97f349877696",
    "contours 077daec6725941d0",
    "alternating cc0821da6c263c19",
    "above-a-row 075a354bcd595ed5",
    "outliers 9b5432e40d0b0fb2",
    "towers 7c6bbeb423729338",
    "leftwards b835ccb13f2ea22c",
];

#[test]
fn the_bytes_are_the_same_on_every_platform() {
    let line = |name| {
        format!(
            "{name} {}",
            hash(&generated(&format!("{name} 1000 --seed 2")))
        )
    };
    let found: Vec<String> = KINDS.iter().map(|kind| line(kind.name)).collect();
    assert_eq!(found, HASHES);
}

#[test]
fn a_file_holds_points_and_edges_as_its_format_has_them() {
    let poly =
        "5 2 0 0\n0 0 5\n1 1 5\n2 2 0.4\n3 3 0.6\n4 4 5\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 4\n0\n";
    assert_eq!(generated("comb 5"), poly);
    assert_eq!(generated("comb 1 -o -"), "1 2 0 0\n0 0 1\n0 0\n0\n");
    let json = "{\n\"points\": [\n[0,2],\n[1,2]],\n\"edges\": [\n[0,1]]\n}\n";
    assert_eq!(generated("comb 2 --output-format json"), json);
    let folder = folder(&[("a.poly", "old")]);
    for (arguments, name, expected) in [
        ("comb 5 -o a.poly", "a.poly", poly),
        ("comb 2 -o a.json", "a.json", json),
        ("comb 2 -o a.node", "a.node", "2 2 0 0\n0 0 2\n1 1 2\n"),
        ("comb 2 -o a.dat --output-format json", "a.dat", json),
        ("comb 2 -o a.csv", "a.csv", "x,y\n0,2\n1,2\n"),
    ] {
        let output = sweep_cdt(&folder, &format!("generate {arguments}")).output();
        assert_eq!(printed(&output.expect("the command starts")), "");
        assert_eq!(read(&folder, name), expected, "{arguments}");
    }
}

#[test]
fn many_points_are_made_and_triangulated() {
    let folder = folder(&[]);
    let output = sweep_cdt(&folder, "generate contours 200000 -o a.poly").output();
    assert_eq!(printed(&output.expect("the command starts")), "");
    let summary = run(&folder, "a.poly --verify");
    assert!(printed(&summary).starts_with("a.poly: points 199998, duplicates 0, edges 199699, "));

    let poly = generated("parcels 2000 --seed 7");
    let arguments = "triangulate - --input-format poly --verify";
    let summary = feed(&mut sweep_cdt(&folder, arguments), poly.as_bytes());
    assert!(
        printed(&summary).contains("points 1711"),
        "{}",
        text(&summary.stdout)
    );
}

#[test]
fn what_cannot_be_generated_is_refused() {
    let folder = folder(&[]);
    for (arguments, message) in [
        (
            "uniform 0",
            "invalid value '0' for '<N>': 0 is not in 1..=100000000",
        ),
        (
            "uniform 100000001",
            "invalid value '100000001' for '<N>': 100000001 is not in 1..=100000000",
        ),
        (
            "uniform many",
            "invalid value 'many' for '<N>': invalid digit found in string",
        ),
        ("unifrom 5", "invalid value 'unifrom' for '<KIND>'"),
        ("uniform 5 --seed -1", "unexpected argument '-1' found"),
        (
            "uniform 5 -o a.svg",
            "the format of a.svg is not known: add --output-format with one of node, poly, json, obj, off, csv, xyz, txt, ply, vtk, vtu, vtp, msh, geojson, wkt, npy, npz",
        ),
        (
            "uniform 5 -o a",
            "the format of a is not known: add --output-format with one of node, poly, json, obj, off, csv, xyz, txt, ply, vtk, vtu, vtp, msh, geojson, wkt, npy, npz",
        ),
    ] {
        assert_refused(&folder, &format!("generate {arguments}"), message);
    }
    let output = sweep_cdt(&folder, "generate uniform 5 -o missing/a.poly").output();
    let output = output.expect("the command starts");
    assert_fails(&output, "missing/a.poly: no such file or directory");
    assert!(names(folder.path()).is_empty());
    fs::create_dir(folder.path().join("a.poly")).expect("a folder");
    let output = sweep_cdt(&folder, "generate uniform 5 -o a.poly").output();
    assert_fails(
        &output.expect("the command starts"),
        "a.poly: is a directory",
    );
}

#[test]
fn the_help_lists_all_kinds() {
    let help = generated("--help");
    for kind in KINDS {
        let line = |line: &str| line.contains(kind.name) && line.ends_with(kind.about);
        assert!(help.lines().any(line), "{}: {help}", kind.name);
    }
}
