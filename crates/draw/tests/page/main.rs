//! The page that shows the steps of a trace, in a real browser. Where there is no Chromium these tests
//! print so and pass; in continuous integration, where `CI` is `true`, they fail.

mod access;
mod browser;
mod controls;
mod drawing;
mod pictures;
mod words;

use std::fs;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Pslg, Triangulator, Watch};
use sweep_cdt_draw::StepsPage;
use tempfile::TempDir;

use browser::Browser;

const ALL: RangeInclusive<usize> = 1..=usize::MAX;

fn events(graph: &Pslg<f64>) -> Vec<Event> {
    let mut events = Vec::new();
    let mut push = |event| events.push(event);
    let watch = Watch::new().events(&mut push);
    let triangulator = Triangulator::new().algorithm(Algorithm::Paper);
    let result = triangulator.run(&graph.points, &graph.edges, watch);
    result.expect("a correct input");
    events
}

/// A page in a folder, which must be kept while it is shown.
fn page(graph: &Pslg<f64>, steps: RangeInclusive<usize>) -> (TempDir, PathBuf) {
    let mut page = Vec::new();
    StepsPage::new(graph, &events(graph))
        .steps(steps)
        .write(&mut page)
        .expect("memory takes all");
    let folder = TempDir::new().expect("a temporary folder");
    let path = folder.path().join("page.html");
    fs::write(&path, page).expect("a file");
    (folder, path)
}

/// Waits until a script returns true.
#[track_caller]
fn wait(browser: &Browser, condition: &str) {
    let start = Instant::now();
    while browser.run(&format!("return {condition}")) != true {
        assert!(start.elapsed() < Duration::from_secs(10), "{condition}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[track_caller]
fn assert_quiet(browser: &Browser) {
    assert_eq!(browser.console(), Vec::<serde_json::Value>::new());
}

/// Scattered points and a few edges among them, one of which pierces many triangles and one of which
/// crosses the front.
fn scattered() -> Pslg<f64> {
    let points = vec![
        [1.0, 0.6],
        [4.1, 0.0],
        [7.6, 0.9],
        [10.4, 0.3],
        [13.2, 1.2],
        [2.6, 2.0],
        [5.8, 2.3],
        [8.9, 2.6],
        [11.7, 2.9],
        [0.3, 3.3],
        [3.9, 3.7],
        [6.9, 4.1],
        [14.1, 3.8],
        [9.8, 4.7],
        [1.9, 5.0],
        [5.1, 5.6],
        [12.4, 5.5],
        [7.8, 6.2],
        [3.3, 6.9],
        [10.6, 7.0],
        [0.8, 7.3],
        [13.6, 7.5],
        [6.0, 7.9],
        [8.8, 8.4],
        [2.3, 8.7],
        [11.9, 8.9],
    ];
    let edges = vec![[20, 4], [24, 23], [9, 2], [21, 16], [25, 17]];
    Pslg {
        points,
        edges,
        ..Pslg::default()
    }
}

/// Many points, at places that look random and always are the same.
fn many(count: u32) -> Pslg<f64> {
    let at = |i: u32, step: f64| (f64::from(i) * step).fract();
    let point = |i| [at(i, 0.618_033_988_749_895), at(i, 0.754_877_666_246_693)];
    Pslg {
        points: (1..=count).map(point).collect(),
        ..Pslg::default()
    }
}

/// The script of the page, without a browser: `node --check` parses it. Where there is no `node`: the reason is printed; in continuous
/// integration, where `CI` is `true`, a failure.
#[test]
fn the_script_parses() {
    let (folder, page) = page(&scattered(), ALL);
    let page = fs::read_to_string(page).expect("a page");
    let (_, script) = page.split_once("<script>").expect("a script");
    let (script, _) = script.split_once("</script>").expect("its end");
    let path = folder.path().join("script.js");
    fs::write(&path, script).expect("a file");
    match Command::new("node").arg("--check").arg(&path).output() {
        Ok(output) => assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        ),
        Err(error) => {
            let is_ci = std::env::var_os("CI").is_some_and(|value| value == "true");
            assert!(!is_ci, "node: {error}");
            eprintln!("skipped: node: {error}");
        }
    }
}
