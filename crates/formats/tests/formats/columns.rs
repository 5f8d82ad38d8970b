//! Which columns of a table are x, y and z: with names in any order, without names by places, and where a name is a
//! number. The rows themselves tell what is right.

use sweep_cdt_formats::{Format, GraphFile, Input, ReadErrorKind, Remark, Source, read};

/// The columns of two points, with the names of a table.
const NAMES: [&str; 4] = ["id", "x", "y", "z"];
const ROWS: [[&str; 4]; 2] = [["7", "1.5", "2.5", "30"], ["8", "4.5", "5.5", "60"]];

fn file(source: &Source) -> GraphFile<f64> {
    match read(Format::Csv, source, None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{other:?}"),
    }
}

/// All orders of four columns.
fn orders() -> Vec<[usize; 4]> {
    let numbers = (0..256).map(|number| [0, 2, 4, 6].map(|shift| number >> shift & 3));
    let orders = numbers.filter(|order: &[usize; 4]| (0..4).all(|at| order.contains(&at)));
    orders.collect()
}

/// A table with the columns in this order, and perhaps their names in a row that begins with this sign.
fn table(order: [usize; 4], sign: Option<&str>, separator: &str) -> String {
    let row = |fields: [&str; 4]| order.map(|at| fields[at]).join(separator) + "\n";
    let head = sign.map(|sign| sign.to_owned() + &row(NAMES));
    head.unwrap_or_default() + &ROWS.map(row).concat()
}

#[track_caller]
fn assert_read(file: &GraphFile<f64>, table: &str) {
    assert_eq!(file.graph.points, [[1.5, 2.5], [4.5, 5.5]], "{table}");
    let heights = file.heights().expect("a column z");
    assert_eq!(heights.values, [30.0, 60.0], "{table}");
}

#[test]
fn names_in_any_order_and_places_choose_the_same() {
    assert_eq!(orders().len(), 24);
    for order in orders() {
        for separator in [",", ";", "\t", " "] {
            for sign in ["", "# ", "// "] {
                let text = table(order, Some(sign), separator);
                let file = file(&Source::new("a", text.as_bytes()));
                assert_read(&file, &text);
                assert_eq!(file.remarks, [], "{text}");
            }
            let text = table(order, None, separator);
            let of = |column: usize| {
                order
                    .iter()
                    .position(|&at| at == column)
                    .expect("it is there")
                    + 1
            };
            let places = [of(1), of(2), of(3)].map(|place| place.to_string());
            for named in [None, Some("")] {
                let text = table(order, named, separator);
                let source = Source::new("a", text.as_bytes()).columns(&places);
                assert_read(&file(&source), &text);
            }
            // Without a choice the order counts, and is said.
            let remarks = file(&Source::new("a", text.as_bytes())).remarks;
            let (places, count) = (vec![1, 2, 3], 4);
            assert_eq!(remarks, [Remark::Columns { places, count }], "{text}");
        }
    }
}

/// The first row of a table without names may have the number of a column in it.
#[test]
fn a_place_is_no_number_of_the_first_row() {
    let text = "0,0,1\n4,0,1\n0,4,2\n";
    let points = |text: &str, columns: [&str; 2]| {
        let source = Source::new("a", text).columns(columns);
        file(&source).graph.points
    };
    assert_eq!(
        points(text, ["1", "2"]),
        [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]
    );
    assert_eq!(
        points(text, ["3", "1"]),
        [[1.0, 0.0], [1.0, 4.0], [2.0, 0.0]]
    );
}

#[test]
fn names_are_chosen_in_any_case() {
    let source = Source::new("a", "X,x,Y\n1,2,3\n").columns(["x", "y"]);
    assert_eq!(file(&source).graph.points, [[2.0, 3.0]]);
    let source = Source::new("a", "1,2,3\n").columns(["x", "y"]);
    let error = read(Format::Csv, &source, None).expect_err("no names");
    let message = "there is no column `x`: it is a name, or a place from 1 to 3";
    assert_eq!(error.message, message);
}

/// Numbers that rasters and netCDF write where there is no height, and those that are heights.
#[test]
fn what_is_no_height_is_said() {
    for (heights, said) in [
        ("-9999 -32768 7", vec![(-9999.0, 1), (-32768.0, 1)]),
        ("1e20 1e20 -32767", vec![(1e20, 2), (-32767.0, 1)]),
        (
            "-3.4e38 -3.40282346638529e+38 7",
            vec![(-3.4e38, 1), (-3.40282346638529e38, 1)],
        ),
        ("9999 -999 32767", vec![]),
    ] {
        let rows = heights.split(' ').map(|z| format!("0 {z} {z}\n"));
        let file = file(&Source::new("a", rows.collect::<String>())).with_voids_said();
        let voids = said
            .into_iter()
            .map(|(value, count)| Remark::Void { value, count });
        assert_eq!(file.remarks, voids.collect::<Vec<_>>(), "{heights}");
    }
    // One that is named leaves the others.
    let file = file(&Source::new("a", "0 0 -9999\n1 0 1e30\n"));
    let said = file.without_value(-9999.0).with_voids_said().remarks;
    let (value, count) = (1e30, 1);
    assert_eq!(said[1..], [Remark::Void { value, count }]);
    assert_eq!(
        said[1].to_string(),
        "1 height is 1e30, which often means that there is none"
    );
}

#[test]
fn a_number_that_means_none_is_none() {
    for value in ["-9999", "-9999.0", "-9.999e3"] {
        let text = format!("x,y,z,w,marker\n0,0,{value},1,-9999\n4,0,2,{value},1\n0,4,3,3,2\n");
        let file = file(&Source::new("a", text)).without_value(-9999.0);
        assert_eq!(file.heights().expect("z").missing(), 1, "{value}");
        assert_eq!(file.columns[1].missing(), 1, "{value}");
        assert_eq!(file.vertex_markers(), Some(vec![-9999, 1, 2]));
        let (value, count) = (-9999.0, 2);
        assert_eq!(file.remarks, [Remark::NoValue { value, count }]);
    }
}

#[test]
fn columns_that_are_not_there_are_refused() {
    for (chosen, message) in [
        (&["1"][..], "1 columns are chosen: two are, or three with z"),
        (&["x", "2"], "column 2 is chosen twice"),
        (
            &["1", "5"],
            "there is no column `5`: it is a name of `id`, `x`, `y`, `z`, or a place from 1 to 4",
        ),
        (
            &["0", "1"],
            "there is no column `0`: it is a name of `id`, `x`, `y`, `z`, or a place from 1 to 4",
        ),
        (
            &["x", "q"],
            "there is no column `q`: it is a name of `id`, `x`, `y`, `z`, or a place from 1 to 4",
        ),
    ] {
        let text = table([0, 1, 2, 3], Some(""), ",");
        let source = Source::new("a", text).columns(chosen.iter().copied());
        let error = read(Format::Csv, &source, None).expect_err("no column");
        assert_eq!(error.message, message);
        assert_eq!(error.kind, ReadErrorKind::Content);
    }
}
