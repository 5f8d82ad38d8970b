//! Points as text: tables as spreadsheets, instruments and programs write them, what is refused and where, and random
//! tables in many spellings.

use num_rational::BigRational;
use sweep_cdt_formats::{
    Column, Coordinate, Format, GraphFile, Input, Remark, Source, read, write_graph,
};
use sweep_cdt_testing::Random;

fn input(bytes: &[u8]) -> Result<Input, String> {
    read(Format::Csv, &Source::new("file", bytes), None).map_err(|error| error.to_string())
}

#[track_caller]
fn file(text: &str) -> GraphFile<f64> {
    match input(text.as_bytes()) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{text}: {other:?}"),
    }
}

/// The points, and each column as text, in which NaN equals itself.
#[track_caller]
fn table(text: &str) -> (Vec<[f64; 2]>, String) {
    let GraphFile { graph, columns, .. } = file(text);
    let column = |Column { name, values }: &Column| format!("{name}{values:?}");
    let columns: Vec<String> = columns.iter().map(column).collect();
    (graph.points, columns.join(" "))
}

#[track_caller]
fn assert_refused(text: &str, why: &str) {
    assert_eq!(input(text.as_bytes()), Err(why.to_owned()), "{text}");
}

const TWO: [[f64; 2]; 2] = [[1.5, 2.0], [-3.0, 4e2]];

#[test]
fn separators_are_found() {
    for text in [
        "1.5,2\n-3,4e2\n",
        "1.5;2\n-3;4e2",
        "1.5\t2\r\n-3\t4e2\r\n",
        "  1.5   2  \r-3 \t 4e2",
        "1.5 , 2\n\n -3,4e2,\n,,,\n",
        "\u{feff}x,y\n1.5,2\n-3,4e2",
        "x;y;\n1.5;2;\n-3;4e2;\n",
        "sep=;\r\nx;y\r\n1.5;2\r\n-3;4e2\r\n",
        "sep=\t\n1.5\t2\n-3\t4e2",
        "X Y\n1.5 2\n-3 4e2 # the last one\n",
        "# made by hand\n#\nx\ty\n1.5\t2\n# and then\n-3\t4e2",
        "\"x\",\"y\"\n\"1.5\",\"2\"\n\"-3\" ,\t\"4e2\"",
        "1.5 2\n\"-3\" \"4e2\" ",
    ] {
        assert_eq!(table(text), (TWO.to_vec(), String::new()), "{text}");
    }
}

#[test]
fn columns_are_found_by_their_names() {
    for names in [
        "x,y,z",
        "X,Y,Elevation",
        "Easting (m),Northing (m),H [m]",
        "Rechtswert,Hochwert,H\u{f6}he",
        "este,norte,cota",
        "Est [m],Nord [m],QUOTA",
        "% x,y,z",
        "!x,y,z",
        "; x,y,z",
        "lon,lat,ele",
        "Longitude,latitude,Altitude",
        "e,n,h",
        "POINT_X,POINT_Y,POINT_Z",
        "//X,Y,Z",
        "# x,y,z",
        "#easting,northing,height",
    ] {
        let text = format!("{names}\n1.5,2,7\n-3,4e2,8\n");
        let expected = (TWO.to_vec(), "z[7.0, 8.0]".to_owned());
        assert_eq!(table(&text), expected, "{names}");
    }
    // In any order, beside others, and the better names first.
    let text = "n;lat;rain;y;label;elev;x;h\n9;52;0.5;2;\"a;b\";7;1.5;70\n9;52;;400;\"\"\"c\"\"\n\";8;-3;NA\n";
    let others = "z[7.0, 8.0] n[9.0, 9.0] lat[52.0, 52.0] rain[0.5, NaN] h[70.0, NaN]";
    assert_eq!(table(text), (TWO.to_vec(), others.to_owned()));
    // A comment that names no x and y is none of names, nor is one of other columns.
    for comment in ["# lat is the third", "# y x and others", "# \"y\" \"x"] {
        assert_eq!(table(&format!("{comment}\n1.5 2\n-3 4e2")).0, TWO);
    }
    assert_eq!(table("# y x\n2 1.5\n4e2 -3").0, TWO);
}

/// Latin-1, as spreadsheets of old write it.
#[test]
fn a_name_that_is_no_utf_8_is_latin_1() {
    let Ok(Input::Doubles(file)) = input(b"x,y,H\xf6he,gr\xfcn\n1.5,2,7,1\n-3,4e2,8,1\n") else {
        panic!("doubles")
    };
    let names: Vec<&str> = file.columns.iter().map(|column| &column.name[..]).collect();
    assert_eq!(names, ["z", "gr\u{fc}n"]);
}

/// R's `write.table` has no name above the names of rows.
#[test]
fn a_table_with_one_name_too_few_is_refused() {
    let beyond = "file: line 1 has 4 names, and all rows have 5 fields or more: name the first or the last column, too";
    let rows = "\"1\" 1.5 2 7 \"oak\"\n\"2\" -3 4e2 8 \"elm\"\n";
    assert_refused(&format!("\"x\" \"y\" \"z\" \"code\"\n{rows}"), beyond);
    assert_eq!(table(&format!("n x y z code\n{rows}")).0, TWO);
    // Some rows may have a word more, and all may end with a separator.
    for rows in ["1.5,2,7\n-3,4e2,8,oak\n", "1.5,2,7,\n-3,4e2,8,\n"] {
        assert_eq!(table(&format!("x,y,z\n{rows}")).0, TWO, "{rows}");
    }
}

#[test]
fn columns_without_names_are_x_y_z_and_others() {
    let expected = "z[7.0, NaN] column5[0.0, 1.0]".to_owned();
    assert_eq!(
        table("1.5 2 7 oak 0\n-3 4e2 - elm 1"),
        (TWO.to_vec(), expected)
    );
    // What describes a point may be several words, and may be missing.
    let words = "1.5 2 7\n-3 4e2 8 a big tree";
    assert_eq!(table(words), (TWO.to_vec(), "z[7.0, 8.0]".to_owned()));
    let label = "1.5,2,oak\n-3,4e2";
    assert_eq!(table(label), (TWO.to_vec(), String::new()));
    // An index without a name, and names that repeat.
    let text = ",x,y,a,A,a\n0,1.5,2,1,2,3\n1,-3,4e2,1,2,3";
    let expected = "column1[0.0, 1.0] a[1.0, 1.0] A[2.0, 2.0] a_2[3.0, 3.0]";
    assert_eq!(table(text), (TWO.to_vec(), expected.to_owned()));
    // The last column without a name, and a separator at the end of each row.
    let text = "x,y,\"\"\n1.5,2,7\n-3,4e2,8";
    let expected = "column3[7.0, 8.0]";
    assert_eq!(table(text), (TWO.to_vec(), expected.to_owned()));
    assert_eq!(table("x,y,\n1.5,2,\n-3,4e2"), (TWO.to_vec(), String::new()));
}

/// A surveyor's list: the first column has the numbers of the points.
#[test]
fn a_column_that_counts_the_rows_is_no_x() {
    let three = file("1,10,20\n2,11,20\n3,10,21\n");
    let (places, count) = (vec![1, 2, 3], 3);
    assert_eq!(three.remarks, [Remark::Columns { places, count }]);
    assert_eq!(file("1,10,20\n2,11,20\n4,10,21\n").remarks, []);
    let survey = "1,10,20,5\n2,11,20,6\n3,10,21,7\n";
    let refused = input(survey.as_bytes()).expect_err("the first column counts");
    assert!(refused.contains("the first counts the rows"), "{refused}");
    let source = Source::new("file", survey);
    let chosen = source.columns(["2", "3", "4"].map(str::to_owned).to_vec());
    let Ok(Input::Doubles(file)) = read(Format::Csv, &chosen, None) else {
        panic!("doubles")
    };
    assert_eq!(
        file.graph.points,
        [[10.0, 20.0], [11.0, 20.0], [10.0, 21.0]]
    );
    for grid in [
        "1,10,20,5\n2,11,20,6\n",
        "1,10,20,5\n2,11,20,6\n4,10,21,7\n",
        "x,y,z,t\n1,10,20,5\n2,11,20,6\n3,10,21,7\n",
    ] {
        assert!(input(grid.as_bytes()).is_ok(), "{grid}");
    }
}

#[test]
fn what_is_ignored_has_the_place_of_its_column() {
    let Ok(Input::Doubles(file)) = input(b"1.5 2 7 oak\n-3 4e2 8 elm") else {
        panic!("doubles")
    };
    let ignored = Remark::ignored(1, "column `4`", "columns `4`");
    assert!(file.remarks.contains(&ignored), "{:?}", file.remarks);
}

#[test]
fn missing_numbers_are_missing() {
    for words in ["#N/A,\\N,--", "nodata,NoData,-"] {
        let (_, columns) = table(&format!("x,y,z,a,b\n0,0,{words}\n1,0,1,2,3"));
        assert_eq!(columns, "z[NaN, 1.0] a[NaN, 2.0] b[NaN, 3.0]", "{words}");
    }
    let text = "x,y,z,a,b\n0,0,nan,NA,-\n1,0,NULL,n/a,none\n0,1,,5\n1,1,0,6,\n";
    let (points, columns) = table(text);
    assert_eq!(points.len(), 4);
    assert_eq!(columns, "z[NaN, NaN, NaN, 0.0] a[NaN, NaN, 5.0, 6.0]");
}

#[test]
fn fractions_are_exact() {
    let text = b"x y z\n1/3 0.1 0.5\n-2/6 1 -\n";
    let Ok(Input::Rationals(file)) = input(text) else {
        panic!("there is a fraction")
    };
    let points: Vec<String> = (file.graph.points.as_flattened().iter())
        .map(Coordinate::text)
        .collect();
    assert_eq!(points, ["1/3", "1/10", "-1/3", "1"]);
    let mut written = Vec::new();
    write_graph(Format::Txt, &file, &mut written).expect("memory takes it");
    assert_eq!(written, b"x y z\n1/3 1/10 0.5\n-1/3 1 NaN\n");
    assert_eq!(input(&written), Ok(Input::Rationals(file)));
}

#[test]
fn wrong_rows_are_named() {
    assert_refused("", "file: the file is empty");
    assert_refused("# x y\n\n;;\n", "file: the file is empty");
    assert_refused(
        "1;2\n-0,5;3\n",
        "file:2: `-0,5` is not a coordinate: commas in numbers are not read, only points, as in 0.5",
    );
    assert_refused("x,y\n1,2\n\n3,\n", "file:4: y is missing");
    assert_refused("x,y\n1,2\n3\n", "file:3: y is missing");
    assert_refused("sep=,\nx,y\n1,2\n3\n", "file:4: y is missing");
    assert_refused("1,2\n# no\nNaN,3", "file:3: x is missing");
    assert_refused("x,y\n1,2\n1,two\n", "file:3: `two` is not a coordinate");
    assert_refused(
        "P1,5,2\nP2,1,7\n",
        "file:1: the columns `P1`, `5`, `2` have no names, and the first is no number: put names in the first row, x and \
         y among them",
    );
    assert_refused(
        "x,y\n1,1e999\n",
        "file:2: `1e999` is too large for a double",
    );
    assert_refused(
        "x,y,z\n1,2,high\n",
        "file:2: `high` is not an attribute, a number",
    );
    assert_refused(
        "x;y;z\n1;2;0,5\n",
        "file:2: `0,5` is not an attribute, a number: commas in numbers are not read, only points, as in 0.5",
    );
    assert_refused(
        "Survey of 2024\nx,y,z\n1,2,3\n",
        "file:1: of the columns `Survey`, `of`, `2024` none are called x and y, or easting and northing, or longitude and \
         latitude: rename two of them, or put `#` before what is no row",
    );
    for shapes in [
        "1,POINT (0 0)\n",
        "\"SRID=2056;POINT(1 2)\"\n",
        "id,wkt_geom\n1,x\n",
        "id,Shape\n1,x\n",
    ] {
        let refused = input(shapes.as_bytes()).expect_err("shapes");
        assert!(
            refused.contains("holds shapes: they are read from a .wkt"),
            "{refused}"
        );
    }
    assert_refused(
        "x,y,a\n1,2,5\n1,3,1e999\n",
        "file:3: `1e999` is not an attribute, a number",
    );
    let one = "file:1: the first row has one field: x and y must stand in two, with a comma, a semicolon, a tab or blanks \
               between them";
    assert_refused("points\n1 2\n", one);
    assert_refused("7.5\n1 2\n", one);
    assert_refused("\nx\n1\n2\n", &one.replace(":1:", ":2:"));
    assert_refused(
        "id,name,x\n1,oak,3\n",
        "file:1: of the columns `id`, `name`, `x` none are called x and y, or easting and northing, or longitude and \
         latitude: rename two of them, or put `#` before what is no row",
    );
    assert_refused(
        "x,y,X\n1,2,3\n",
        "file:1: the columns `x` and `X` may both be x: rename one",
    );
    assert_refused(
        "x,y,h,h\n1,2,3,4\n",
        "file:1: the columns `h` and `h` may both be the height: rename one",
    );
    assert_refused(
        "1,2\n3,4,5\n",
        "file:2: the row has 3 fields, and that of line 1 has 2",
    );
    assert_refused(
        "x,y\n1,\"2\n3,4\n",
        "file:2: a quote is opened and not closed",
    );
    assert_refused(
        "x,y\n\"1\n\"2,3\n",
        "file:2: `2,3` follows a quote that is closed",
    );
    let comma = "is not a coordinate: commas in numbers are not read, only points, as in 0.5";
    for text in ["x;y\n1,5;2,5\n", "x\ty\n1,5\t2,5\n", "x y\n1,5 2,5\n"] {
        assert_refused(text, &format!("file:2: `1,5` {comma}"));
    }
    assert_refused("1,5;2,5\n", &format!("file:1: `1,5` {comma}"));
    assert_refused("1,5 2,5\n", &format!("file:1: `5 2` {comma}"));
    assert_eq!(
        input(b"\xff\xfex\0,\0"),
        Err("file: the text is UTF-16; save it as UTF-8".to_owned())
    );
}

#[test]
fn heights_are_in_the_column_that_is_asked_for() {
    let columns = |asked: Option<&str>| {
        let source = Source::new("file", "x,y,ground_m,Roof_m,elev_ft\n1,2,3,4,5\n");
        let source = match asked {
            Some(name) => source.height_property(name),
            None => source,
        };
        let Ok(Input::Doubles(file)) = read(Format::Csv, &source, None) else {
            panic!("doubles");
        };
        let column = |Column { name, values }: &Column| format!("{name} {}", values[0]);
        let columns: Vec<String> = file.columns.iter().map(column).collect();
        (columns.join(", "), file.remarks)
    };
    let found = ("z 5, ground_m 3, Roof_m 4".to_owned(), Vec::new());
    assert_eq!(columns(None), found);
    let asked = ("z 3, Roof_m 4, elev_ft 5".to_owned(), Vec::new());
    assert_eq!(columns(Some("ground_m")), asked);
    // What is not there, or is x, is said.
    for name in ["Ground_m", "x"] {
        let (there, remarks) = columns(Some(name));
        assert_eq!(there, "ground_m 3, Roof_m 4, elev_ft 5");
        let name = name.to_owned();
        assert_eq!(remarks, [Remark::HeightProperty { name, count: 0 }]);
    }
}

/// A column without a unit is x, y or the height, whatever columns with units stand beside it; of two with units none is.
#[test]
fn names_with_units_stand_beside_names_without() {
    let both = "x_ft,x,y,y_ft,elev_m,z\n9,1,2,8,7,3\n";
    let (points, columns) = table(both);
    assert_eq!(points, [[1.0, 2.0]]);
    assert_eq!(columns, "z[3.0] x_ft[9.0] y_ft[8.0] elev_m[7.0]");
    let two = "x,y,elev_m,elev_ft\n1,2,3,9\n";
    assert_refused(
        two,
        "file:1: the columns `elev_m` and `elev_ft` may both be the height: rename one",
    );
    let source = Source::new("file", two).height_property("elev_ft");
    let Ok(Input::Doubles(file)) = read(Format::Csv, &source, None) else {
        panic!("doubles");
    };
    let names: Vec<&str> = file.columns.iter().map(|column| &column.name[..]).collect();
    assert_eq!(names, ["z", "elev_m"]);
    assert_eq!(file.columns[0].values, [9.0]);
}

/// Short rows of a wide table would take the square of the file's size.
#[test]
fn short_rows_take_no_more_than_the_file() {
    let wide = format!("{}\n{}", "1,".repeat(2999) + "1", "1,2\n".repeat(3000));
    let error = input(wide.as_bytes()).expect_err("too many fields are missing");
    assert_eq!(
        error,
        "file:8: the row has 2 fields, and that of line 1 has 3000"
    );
    let names = format!("x,y,{}\n1,2\n", "a,".repeat(100_000));
    assert_eq!(file(&names).columns, []);
    let blank = format!("x,y\n{}1,2\n", "\n".repeat(1_000_000));
    assert_eq!(file(&blank).graph.points, [[1.0, 2.0]]);
}

/// Tables written here in many spellings are read as what they mean.
#[test]
fn random_tables_are_read_as_they_are_meant() {
    let mut dice = Random::new(5);
    for _ in 0..500 {
        let rows = 1 + dice.below(5);
        let mut number = || -> f64 {
            match dice.below(3) {
                0 => 0.0,
                1 => (dice.unit() * 1e4).round() / 8.0,
                _ => (dice.unit() - 0.5) * 1e-3,
            }
        };
        let points: Vec<[f64; 2]> = (0..rows).map(|_| [number(), number()]).collect();
        let mut heights: Vec<f64> = (0..rows).map(|_| number()).collect();
        let rain: Vec<f64> = (0..rows).map(|_| number()).collect();
        heights
            .iter_mut()
            .for_each(|z| *z = if dice.below(3) == 0 { f64::NAN } else { *z });

        // The columns in any order: 0 is x, 1 is y, 2 is z, 3 the rain, 4 a text.
        let mut order: Vec<usize> = (0..5).collect();
        (0..5).for_each(|at| order.swap(at, dice.below(5)));
        let separator = [",", ";", "\t", " ", "   ", " \t"][dice.below(6)];
        let is_blank = separator.trim().is_empty() && separator != "\t";
        let end = ["\n", "\r\n", "\r"][dice.below(3)];
        let mut text = if dice.below(2) == 0 { "\u{feff}" } else { "" }.to_owned();
        let line = |fields: [String; 5], dice: &mut Random| {
            let mut line = Vec::new();
            for &at in &order {
                let field = &fields[at];
                let must = is_blank && (field.contains(' ') || field.is_empty());
                let quote = if must || dice.below(4) == 0 { "\"" } else { "" };
                line.push(format!("{quote}{field}{quote}"));
            }
            line.join(separator) + end
        };
        let names = ["x", "Y (m)", "elev", "rain fall", "a note"].map(str::to_owned);
        text += &line(names, &mut dice);
        for row in 0..rows {
            let spelled = |value: f64, dice: &mut Random| match dice.below(3) {
                _ if value.is_nan() => ["", "NaN", "na", "-", "NULL"][dice.below(5)].to_owned(),
                0 => format!("{value:e}"),
                1 => format!("{value:?}"),
                _ => format!("{value}"),
            };
            let fields = [points[row][0], points[row][1], heights[row], rain[row]];
            let [x, y, z, rain] = fields.map(|value| spelled(value, &mut dice));
            let note = ["oak", "two words", ""][dice.below(3)].to_owned();
            text += &line([x, y, z, rain, note], &mut dice);
            if dice.below(4) == 0 {
                text += &format!("# a comment, 1;2{end}{end}");
            }
        }
        let read = file(&text);
        assert_eq!(read.graph.points, points, "{text}");
        let column = |name: &str, values: Vec<f64>| Column {
            name: name.to_owned(),
            values,
        };
        let mut expected = vec![column("rain fall", rain.clone())];
        if heights.iter().any(|z| !z.is_nan()) {
            expected.insert(0, column("z", heights.clone()));
        }
        assert_eq!(read.columns, expected, "{text}");
        for format in [Format::Csv, Format::Xyz] {
            let mut written = Vec::new();
            write_graph(format, &read, &mut written).expect("memory takes it");
            let again = file(&String::from_utf8(written).expect("a text"));
            assert_eq!(again.graph.points, points);
            assert_eq!(again.columns, read.columns);
        }
    }
}

/// No bytes make the reader panic, and what it reads has a coordinate for every point.
#[test]
fn random_bytes_are_read_or_refused() {
    let mut dice = Random::new(6);
    let words: [&[u8]; 20] = [
        b"x", b"y", b",", b";", b"\t", b" ", b"\n", b"\r", b"\"", b"#", b"1", b"2.5", b"-", b"nan",
        b"1/3", b"z", b"\xff", b"e", b"n", b"//",
    ];
    let (mut read, mut refused) = (0, 0);
    for _ in 0..100_000 {
        let count = dice.below(20);
        let begin: [&[u8]; 4] = [b"", b"x,y,z\n1,2,3\n", b"1 2 3\n", b"y;x\n"];
        let mut text = begin[dice.below(4)].to_vec();
        (0..count).for_each(|_| text.extend_from_slice(words[dice.below(words.len())]));
        match input(&text) {
            Ok(Input::Doubles(file)) => check(&file),
            Ok(Input::Rationals(file)) => check::<BigRational>(&file),
            Err(error) => {
                assert!(error.starts_with("file:"));
                refused += 1;
                continue;
            }
        }
        read += 1;
    }
    assert!(read > 1000 && refused > 1000, "{read} {refused}");
}

fn check<S: Coordinate>(file: &GraphFile<S>) {
    let count = file.graph.points.len();
    assert!(
        file.columns
            .iter()
            .all(|column| column.values.len() == count)
    );
}
