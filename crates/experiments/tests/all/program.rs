//! The program: counts that never change, runs that were interrupted, cells that run one by one.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use sweep_cdt::front::{Front, FrontInput, FrontNode, FrontSearch};
use sweep_cdt_experiments::fronts::Structure;
use sweep_cdt_experiments::{Contestant, run};
use sweep_cdt_formats::{Format, write_graph};
use sweep_cdt_generate::Kind;

const PROGRAM: &str = env!("CARGO_BIN_EXE_sweep-cdt-experiments");
/// Few and small cells.
const CELLS: [&str; 4] = ["--data", "uniform,fans", "--sizes", "100,300"];

fn output(arguments: &[&str], out: &Path) -> Output {
    let mut command = Command::new(PROGRAM);
    command.args(arguments).arg("--out").arg(out);
    command.output().expect("the program runs")
}

fn succeed(arguments: &[&str], out: &Path) {
    let output = output(arguments, out);
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {error}");
}

/// The rows of a CSV file.
fn counts(file: &Path) -> Vec<BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(file).expect("a CSV file");
    let rows = reader.deserialize();
    rows.map(|row| row.expect("a row")).collect()
}

/// Every experiment twice: the same columns but for the times, and plots that are not empty.
#[test]
fn counts_are_the_same_in_every_run() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, data) in [
        ("fronts", "uniform,fans"),
        ("heuristics", "uniform,parcels"),
        ("scalars", "integers,lattice"),
        ("scaling", "clusters,contours"),
        ("adversaries", "alternating,outliers"),
        ("table1", "parcels"),
        ("table2", "parcels"),
    ] {
        let outs = ["first", "second"].map(|turn| folder.path().join(format!("{name}-{turn}")));
        for out in &outs {
            let arguments = [
                name,
                "--data",
                data,
                "--sizes",
                "100,300",
                "--repetitions",
                "1",
            ];
            succeed(&arguments, out);
        }
        let [first, second] = outs
            .each_ref()
            .map(|out| counts(&out.join(format!("{name}.csv"))));
        assert!(
            first.len() >= 2 && first[0].len() > 30,
            "{name}: rows and columns"
        );
        assert_eq!(first, second, "{name}");
        let report = fs::read_to_string(outs[0].join("report.md")).expect("a report");
        let plots: Vec<&str> = report
            .lines()
            .filter_map(|line| {
                line.strip_prefix("![")?
                    .split_once("](")?
                    .1
                    .strip_suffix(')')
            })
            .collect();
        assert!(!plots.is_empty(), "{name} has plots");
        for plot in plots {
            let svg = fs::read_to_string(outs[0].join(plot)).expect("a plot");
            assert!(
                svg.ends_with("</svg>\n") && svg.len() > 1000,
                "{name}: {plot}"
            );
        }
    }
}

#[test]
fn without_repetitions_there_are_counts_and_no_times() {
    let folder = tempfile::tempdir().expect("a folder");
    let [timed, counted] = ["timed", "counted"].map(|name| folder.path().join(name));
    for (out, repetitions) in [(&timed, "1"), (&counted, "0")] {
        let more = ["--repetitions", repetitions];
        succeed(&[&["fronts"], &CELLS[..], &more].concat(), out);
    }
    let [with, without] = [&timed, &counted].map(|out| counts(&out.join("fronts.csv")));
    assert_eq!(with, without);
    let turns = |out: &Path| counts(&out.join("fronts-turns.csv"));
    assert_eq!(
        [turns(&timed).len(), turns(&counted).len()],
        [with.len(), 0]
    );
    let (mut turns, rows) = (turns(&timed), with.iter());
    for (turn, row) in turns.iter_mut().zip(rows) {
        turn.retain(|column, _| ["data", "size", "seed", "variant"].contains(&column.as_str()));
        assert!(
            turn.iter().all(|(column, value)| row[column] == *value),
            "{turn:?}"
        );
    }
    let text = |out: &Path| fs::read_to_string(out.join("report.md")).expect("a report");
    let title = "Time of the whole triangulation";
    assert!(text(&timed).contains(title) && timed.join("time-100.svg").exists());
    assert!(!text(&counted).contains(title) && !counted.join("time-100.svg").exists());
    assert!(text(&counted).contains("No time was measured"));
    assert!(counted.join("work-100.svg").exists());
}

#[test]
fn an_interrupted_run_goes_on_with_what_is_missing() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path();
    let arguments = [&["fronts"], &CELLS[..]].concat();
    succeed(&[&arguments[..], &["--cell", "2"]].concat(), out);
    assert!(
        !out.join("report.md").exists(),
        "a cell alone makes no report"
    );
    let kept = fs::read_to_string(out.join("cells/0002.csv")).expect("a cell");
    succeed(&arguments, out);
    let now = fs::read_to_string(out.join("cells/0002.csv")).expect("a cell");
    assert_eq!(now, kept, "it did not run again");
    assert!(counts(&out.join("fronts.csv")).len() >= 4 * 10);

    let other = output(&[&arguments[..], &["--seed", "2"]].concat(), out);
    assert!(!other.status.success());
    let error = String::from_utf8_lossy(&other.stderr);
    assert!(
        error.contains("another plan (now: cell uniform 100 seed 2)"),
        "{error}"
    );
}

/// Each cell as a task of the Slurm script, in no order, as on several machines.
#[cfg(unix)]
#[test]
fn cells_run_one_by_one_give_the_same_as_all_together() {
    let folder = tempfile::tempdir().expect("a folder");
    let [together, apart] = ["together", "apart"].map(|name| folder.path().join(name));
    let arguments = [&["fronts"], &CELLS[..]].concat();
    succeed(&arguments, &together);

    let listed = output(&[&arguments[..], &["--cells"]].concat(), &apart);
    let listed = String::from_utf8(listed.stdout).expect("text");
    assert_eq!(
        listed,
        "0 uniform 100 seed 1\n1 fans 100 seed 1\n2 uniform 300 seed 1\n3 fans 300 seed 1\n"
    );
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("slurm/array.sh");
    for cell in ["3", "1", "0"] {
        let mut task = Command::new("sh");
        task.arg(&script).arg(PROGRAM).args(&arguments);
        task.arg("--out")
            .arg(&apart)
            .env("SLURM_ARRAY_TASK_ID", cell);
        assert!(task.status().expect("sh").success());
    }
    let merge = [&arguments[..], &["--merge"]].concat();
    let early = output(&merge, &apart);
    let error = String::from_utf8_lossy(&early.stderr);
    assert!(error.contains("cells that have not run: 2"), "{error}");
    succeed(&[&arguments[..], &["--cell", "2"]].concat(), &apart);
    succeed(&merge, &apart);
    let [together, apart] = [together, apart].map(|out| counts(&out.join("fronts.csv")));
    assert_eq!(together, apart);
}

/// Starts at the right end.
#[derive(Clone)]
struct RightEnd;

impl FrontSearch for RightEnd {
    fn begin(&mut self, _: FrontInput<'_>) {}

    fn locate(&mut self, _: f64, front: &Front) -> FrontNode {
        front.right_end()
    }
}

impl Structure for RightEnd {}

#[test]
fn a_structure_of_ones_own_is_in_all_results() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("a path in UTF-8");
    let arguments = [&["program", "scaling", "--out", out], &CELLS[..]].concat();
    let own = || Contestant::new("from the right end", RightEnd);
    run([own()], &arguments).expect("it runs");
    for file in ["scaling.csv", "report.md", "time.svg"] {
        let text = fs::read_to_string(folder.path().join(file)).expect("a file");
        assert!(text.contains("from the right end"), "{file}");
    }
    let error = run([own(), own()], &arguments).expect_err("two of one name");
    assert!(error.to_string().contains("from the right end"));
}

#[test]
fn what_cannot_be_done_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    for (arguments, expected) in [
        (&["nothing"][..], "no experiment nothing"),
        (
            &["fronts", "--data", "nothing", "--sizes", "9"],
            "no kind of data nothing",
        ),
        (&["fronts", "--file", "nothing.poly"], "nothing.poly"),
        (&["fronts", "--cell", "10000"], "there is no cell 10000"),
        (&["holdout"], "holdout needs --file"),
        (&["fronts", "--sizes", "7"], "no such input"),
        (&["paper"], "fronts.csv: "),
    ] {
        let output = output(arguments, folder.path());
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(
            error.starts_with("error: ") && error.contains(expected),
            "{error}"
        );
    }
}

#[test]
fn seeds_are_rows_of_their_own_and_counts_are_compared() {
    let folder = tempfile::tempdir().expect("a folder");
    let [first, second] = ["first", "second"].map(|name| folder.path().join(name));
    let arguments = [
        &["fronts"],
        &CELLS[..],
        &["--repetitions", "1", "--seeds", "2"],
    ]
    .concat();
    succeed(&arguments, &first);
    let kept = first.join("fronts.csv");
    let rows = counts(&kept);
    let of = |seed: &str| {
        rows.iter()
            .filter(|row| row["seed"] == seed)
            .collect::<Vec<_>>()
    };
    assert_eq!(of("1").len(), of("2").len());
    assert_ne!(of("1")[0]["result"], of("2")[0]["result"]);

    // A part of the rows, without times, has the same counts; others have not.
    let part = [
        "fronts",
        "--data",
        "fans",
        "--sizes",
        "100",
        "--seed",
        "2",
        "--repetitions",
        "0",
    ];
    let with = [&part[..], &["--compare", kept.to_str().expect("UTF-8")]].concat();
    succeed(&with, &second);
    let text = fs::read_to_string(&kept).expect("a file");
    for (from, to, expected) in [
        (
            "fans,100,2,skip list,false,",
            "fans,100,2,skip list,false,1",
            "skip list on fans 100, seed 2, has other counts",
        ),
        (
            "fans,100,2,treap,",
            "fans,100,2,other,",
            "treap on fans 100, seed 2, is not there",
        ),
    ] {
        fs::write(&kept, text.replace(from, to)).expect("a file");
        let turns = first.join("fronts-turns.csv");
        let kept = fs::read_to_string(&turns).expect("a file");
        fs::write(&turns, kept.replace(from, to)).expect("a file");
        let wrong = output(&with, &second);
        let error = String::from_utf8_lossy(&wrong.stderr);
        assert!(
            !wrong.status.success() && error.contains(expected),
            "{error}"
        );
        fs::write(&turns, kept).expect("a file");
    }
}

/// Of another order of the points, and the same triangles.
#[test]
fn a_file_has_eight_images() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("turned.poly");
    fs::write(&file, "4 2 0 0\n0 0 0\n1 9 1\n2 8 5\n3 1 7\n0 0\n0\n").expect("a file");
    let path = file.to_str().expect("UTF-8");
    let arguments = [
        "holdout",
        "--file",
        path,
        "--seeds",
        "8",
        "--repetitions",
        "0",
    ];
    let out = folder.path().join("out");
    succeed(&arguments, &out);
    let rows = counts(&out.join("holdout.csv"));
    let first = |seed: usize| {
        rows.iter()
            .find(|row| row["seed"] == seed.to_string())
            .expect("a row")
    };
    let counted: Vec<[&str; 2]> = (1..=8)
        .map(|seed| [&*first(seed)["triangles"], &*first(seed)["points"]])
        .collect();
    assert_eq!(counted, [["2", "4"]; 8]);
    let results: std::collections::BTreeSet<&str> =
        (1..=8).map(|seed| &*first(seed)["result"]).collect();
    assert_eq!(results.len(), 2, "as it is and mirrored");
}

/// Where Valgrind is not installed, the program says so.
#[test]
fn a_turn_under_cachegrind_is_counted() {
    let folder = tempfile::tempdir().expect("a folder");
    let arguments = [
        "fronts",
        "--data",
        "uniform",
        "--sizes",
        "300",
        "--repetitions",
        "0",
        "--cachegrind",
    ];
    let output = output(&arguments, folder.path());
    if Command::new("valgrind").arg("--version").output().is_err() {
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(error.starts_with("error: valgrind: "), "{error}");
        return;
    }
    assert!(output.status.success(), "{output:?}");
    for row in counts(&folder.path().join("fronts.csv")) {
        let count = |column: &str| row[column].parse::<u64>().expect("a count");
        let a_point = count("instructions") / 300;
        assert!((200..20_000).contains(&a_point), "{row:?}");
        assert!(count("first_misses") >= count("second_misses"), "{row:?}");
        assert!(row["built"].starts_with("rustc "), "{row:?}");
    }
}

#[test]
fn a_file_of_ones_own_is_a_cell() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("mine.poly");
    let segments = Kind::named("segments")
        .expect("a kind")
        .graph(200, 5)
        .into();
    let mut text = Vec::new();
    write_graph::<f64>(Format::Poly, &segments, &mut text).expect("memory takes all");
    fs::write(&file, text).expect("a file");
    let out = folder.path().join("out");
    let arguments = [
        &["fronts"],
        &CELLS[..],
        &["--file", file.to_str().expect("UTF-8")],
    ]
    .concat();
    succeed(&arguments, &out);
    let rows = counts(&out.join("fronts.csv"));
    let mine = rows.iter().filter(|row| row["data"] == "mine");
    assert!(mine.clone().count() > 10 && mine.clone().all(|row| row["points"] == "200"));
}

/// A program that prints Triangle's times and writes the triangle that it is given.
#[cfg(unix)]
fn pretended(folder: &Path, triangle: &str) -> PathBuf {
    use std::os::unix::fs::PermissionsExt;

    let program = folder.join("triangle");
    let script = format!(
        "#!/bin/sh\necho 'Delaunay milliseconds:  27'\necho 'Segment milliseconds:  5'\n\
         printf '1 3 0\\n0 {triangle}\\n' > \"${{2%.poly}}.1.ele\"\n"
    );
    fs::write(&program, script).expect("a file");
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).expect("a program");
    program
}

#[cfg(unix)]
#[test]
fn triangle_is_timed_and_verified() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("three.poly");
    fs::write(&file, "3 2 0 0\n0 0 0\n1 2 0\n2 0 2\n0 0\n0\n").expect("a file");
    let run = |experiment, triangle| {
        let program = pretended(folder.path(), triangle);
        let paths = [&file, &program].map(|path| path.to_str().expect("UTF-8"));
        let arguments = [experiment, "--quick", "--cell", "3", "--file", paths[0]];
        let out = folder.path().join(triangle);
        let output = output(&[&arguments[..], &["--triangle", paths[1]]].concat(), &out);
        (output, out)
    };
    let (right, out) = run("table1", "0 1 2");
    assert!(right.status.success(), "{right:?}");
    let turns = counts(&out.join("cells/0003-turns.csv"));
    let turn = turns.iter().find(|turn| turn["variant"] == "Triangle");
    assert!(
        turn.is_some_and(|turn| turn["clock_ms"] == "32.0"),
        "{turns:?}"
    );
    for (experiment, triangle, expected) in [
        ("table1", "0 2 1", "runs the wrong way round"),
        ("table2", "0 1 2", "only table1 takes --triangle"),
    ] {
        let (wrong, _) = run(experiment, triangle);
        assert!(!wrong.status.success());
        let error = String::from_utf8_lossy(&wrong.stderr);
        assert!(error.contains(expected), "{error}");
    }
}
