//! The page that shows the steps of a trace, in a real browser. Where there is no Chromium these tests
//! print so and pass; in continuous integration, where `CI` is `true`, they fail.
#![cfg(feature = "formats")]

mod browser;
mod controls;
mod inputs;
mod pictures;
mod script;
mod sheet;

use std::fs;
use std::ops::RangeInclusive;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use sweep_cdt::Triangulator;
use sweep_cdt::draw::StepsPage;
use sweep_cdt::formats::Graph;
use sweep_cdt::trace::Event;
use tempfile::TempDir;

use browser::Browser;

const ALL: RangeInclusive<usize> = 1..=usize::MAX;

fn events(graph: &Graph<f64>) -> Vec<Event> {
    let mut events = Vec::new();
    Triangulator::new()
        .triangulate_observed(&graph.points, &graph.edges, |event| events.push(event))
        .expect("a correct input");
    events
}

/// A page in a folder, which must be kept while it is shown.
fn page(graph: &Graph<f64>, steps: RangeInclusive<usize>) -> (TempDir, PathBuf) {
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
