//! Acts of a visitor of the page, in headless Chromium.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::json;

use super::command;
use super::visit::{
    assert_quiet, choose, draw_a_cross, drop_file, enter, said, saved, visit, wait,
};

#[test]
fn points_and_edges_are_drawn_moved_erased_and_undone() {
    let Some((browser, _folder)) = visit([1280, 800]) else {
        return;
    };
    draw_a_cross(&browser);
    let [summary, crossings, notice] = said(&browser);
    assert_eq!(summary, "4 points, 2 edges: 4 triangles.");
    assert!(
        crossings.starts_with("1 pair of edges crosses. The triangulation is that of their pieces")
    );
    assert_eq!(notice, "");
    let is_there = browser.run(
        "const { left, top } = element('canvas').getBoundingClientRect();
         const [x, y] = view.pixel(...answer.crossings);
         return Math.hypot(x + left - 450, y + top - 450) < 2",
    );
    assert_eq!(is_there, true, "the crossing is drawn elsewhere");

    // Unless they are split they are shown without a triangulation, which is no failure.
    browser.run("document.querySelector('[name=split]').click()");
    let [summary, crossings, notice] = said(&browser);
    assert_eq!(summary, "4 points, 2 edges.");
    assert!(crossings.ends_with("They have no triangulation, unless they are split."));
    assert_eq!(notice, "");

    choose(&browser, "tool", "move");
    browser.drag([600, 300], [500, 650]);
    let moved = said(&browser);
    assert_eq!(moved, ["4 points, 2 edges: 2 triangles.", "", ""]);
    choose(&browser, "tool", "erase");
    browser.drag([300, 300], [300, 300]);
    assert_eq!(said(&browser)[0], "3 points, 1 edge: 1 triangle.");
    browser.click("undo");
    assert_eq!(said(&browser), moved);
    browser.click("undo");
    assert_eq!(said(&browser)[0], summary);
    browser.run("document.querySelector('#show-steps').click()");
    wait(&browser, "!element('steps-notice').hidden");
    assert!(
        browser
            .text("steps-notice")
            .contains("up to the first edges")
    );
    assert_quiet(&browser);
}

#[test]
fn files_are_dropped() {
    let Some((browser, _folder)) = visit([1280, 800]) else {
        return;
    };
    let square = "4 points, 4 edges: 2 triangles.";
    let files = [
        (
            "map.geojson",
            r#"{"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]}"#,
            square,
            "",
        ),
        // What is wrong is said, and the input before it stays.
        (
            "a.node",
            "2 2 0 0\n0 0 0\n1 nan 1\n",
            square,
            "a.node: vertex 1 has a coordinate that is not finite",
        ),
        ("a.poly", "4 2 0 0\n0 0 0\n", square, "a.poly:"),
        ("a.foo", "?", square, "there is no format `foo`"),
        (
            "twice.node",
            "4 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 1 0\n",
            "4 points, 0 edges (1 duplicate): 1 triangle.",
            "",
        ),
        (
            "one.node",
            "1 2 0 0\n0 5 5\n",
            "1 point, 0 edges: 0 triangles.",
            "",
        ),
        (
            "none.node",
            "0 2 0 0\n",
            "0 points, 0 edges: 0 triangles.",
            "",
        ),
        (
            "far.json",
            r#"{"points": [[-1.7e308,-1.7e308],[1.7e308,-1.7e308],[0,1.7e308]]}"#,
            "3 points, 0 edges: 1 triangle.",
            "",
        ),
        (
            "near.json",
            r#"{"points": [[0,0],[5e-324,0],[0,5e-324]]}"#,
            "3 points, 0 edges: 1 triangle.",
            "",
        ),
        (
            "thirds.json",
            r#"{"points": [["1/3",0],[1,0],[0,1]]}"#,
            "3 points, 0 edges: 1 triangle.",
            "",
        ),
    ];
    for (name, text, summary, notice) in files {
        drop_file(&browser, name, text);
        let [found, _, refused] = said(&browser);
        assert_eq!(found, summary, "{name}");
        assert!(
            refused.starts_with(notice) && refused.is_empty() == notice.is_empty(),
            "{name}: {refused}"
        );
        let is_kept = browser.run("return input.points !== null");
        assert_eq!(is_kept, true, "nothing can be drawn after {name}");
        let places = browser.run("return [...view.at].every(Number.isFinite)");
        assert_eq!(places, true, "{name} is drawn nowhere");
    }
    assert_quiet(&browser);
}

#[test]
fn remarks_are_said() {
    let Some((browser, _folder)) = visit([1280, 800]) else {
        return;
    };
    let remarks = |name, text| {
        drop_file(&browser, name, text);
        said(&browser);
        let found = browser.run(
            "return [...document.querySelectorAll('#remarks li')].map((item) => item.textContent)",
        );
        let found = found.as_array().expect("a list").clone();
        found
            .iter()
            .map(|text| text.as_str().expect("a text").to_owned())
            .collect::<Vec<_>>()
    };
    let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    assert_eq!(remarks("one.obj", mesh), ["ignored: 1 line of `vt`"]);
    let nothing = remarks("none.node", "0 2 0 0\n");
    assert!(
        matches!(&nothing[..], [why] if why.starts_with("no triangles")),
        "{nothing:?}"
    );
    assert_eq!(
        remarks("three.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n"),
        [""; 0]
    );
    assert_quiet(&browser);
}

/// The steps of the input that is drawn, in the page that the command makes of it.
#[test]
fn the_sweep_of_a_drawing_plays() {
    let Some((browser, folder)) = visit([1280, 800]) else {
        return;
    };
    draw_a_cross(&browser);
    choose(&browser, "tool", "erase");
    browser.drag([400, 400], [400, 400]);
    assert_eq!(said(&browser)[0], "4 points, 1 edge: 2 triangles.");
    let drawing = browser.run("return new TextDecoder().decode(input.files)");
    fs::write(
        folder.path().join("drawing.json"),
        drawing.as_str().expect("a text"),
    )
    .expect("a file");
    let steps = String::from_utf8(command(folder.path(), "trace drawing.json")).expect("a text");

    browser.click("show-steps");
    wait(&browser, "element('player').src.startsWith('blob:')");
    enter(&browser, Some("player"));
    wait(&browser, "document.getElementById('play')");
    // The first line of a trace is its version.
    assert_eq!(browser.run("return trace.total"), steps.lines().count() - 1);
    browser.click("last");
    let text = browser.text("sentence");
    assert!(
        text.starts_with("The triangulation has 2 triangles"),
        "{text}"
    );
    enter(&browser, None);
    assert_quiet(&browser);
}

/// The time is printed; no test fails by the clock.
#[test]
fn a_hundred_thousand_points() {
    let Some((browser, folder)) = visit([1280, 800]) else {
        return;
    };
    browser.run(
        "element('kind').value = 'uniform';
         element('count').value = 100000;
         window.start = performance.now();
         element('generate').requestSubmit();
         const look = () => isBusy ? setTimeout(look) : (window.took = performance.now() - start);
         look()",
    );
    assert_eq!(
        said(&browser)[0],
        "100,000 points, 0 edges: 199,972 triangles."
    );
    wait(&browser, "window.took");
    eprintln!(
        "100,000 uniform points: {}, drawn after {} ms",
        browser.text("doing"),
        browser.run("return Math.round(took)")
    );
    let generate = "generate uniform 100000 -o uniform.poly";
    command(folder.path(), generate);
    let triangulate = "triangulate uniform.poly -o - --output-format";
    assert!(saved(&browser, "result ele") == command(folder.path(), &format!("{triangulate} ele")));
    let poly = fs::read(folder.path().join("uniform.poly")).expect("a file");
    assert!(saved(&browser, "graph poly") == poly);
    // Too many for steps, which is said.
    browser.click("show-steps");
    wait(&browser, "!element('steps-notice').hidden");
    let notice = browser.text("steps-notice");
    assert!(notice.contains("steps are shown of up to"), "{notice}");
    assert_quiet(&browser);
}

/// A linear front takes its time; the page can be used meanwhile, and after it is stopped.
#[test]
fn a_long_computation_is_stopped() {
    let Some((browser, _folder)) = visit([800, 600]) else {
        return;
    };
    browser.run(
        "document.querySelector('[name=front]').value = 'linear';
         document.querySelector('[name=method]').value = 'sweep';
         element('kind').value = 'uniform';
         element('count').value = 1000000;
         element('generate').requestSubmit()",
    );
    wait(&browser, "!element('stop').hidden");
    let summary = browser.run("return element('summary').textContent");
    browser.click("stop");
    let [same, _, notice] = said(&browser);
    assert_eq!((json!(same), notice.as_str()), (summary, "Stopped."));
    browser.run("document.querySelector('[name=front]').value = 'hash'");
    drop_file(&browser, "one.node", "1 2 0 0\n0 5 5\n");
    assert_eq!(said(&browser), ["1 point, 0 edges: 0 triangles.", "", ""]);
    assert_quiet(&browser);
}

/// Nothing is loaded, nothing is wider than the window, and every control has a name.
#[test]
fn the_page_fits_and_loads_nothing() {
    for size in [[1920, 1080], [1280, 800], [390, 800], [320, 640]] {
        let Some((browser, _folder)) = visit(size) else {
            return;
        };
        let found = browser.run(
            "const { scrollWidth } = document.documentElement;
             const isOut = (item) => item.getBoundingClientRect().right > innerWidth + 1;
             const controls = [...document.querySelectorAll('button, select, input, textarea')];
             const isNamed = (item) => item.textContent && item.tagName === 'BUTTON'
               || item.labels?.length || item.ariaLabel;
             const loaded = performance.getEntriesByType('resource').map(({ name }) => name);
             return [scrollWidth - innerWidth, controls.filter(isOut).map(({ id }) => id),
               controls.filter((item) => !isNamed(item)).map(({ id }) => id),
               loaded.filter((name) => !/^(blob|data):/.test(name))]",
        );
        assert_eq!(found, json!([0, [], [], []]), "{size:?}");
        assert_quiet(&browser);
    }
}

/// Pictures of the page to look at, written to the folder that `SWEEP_CDT_SCREENSHOTS` names.
#[test]
fn screenshots() {
    let Some(folder) = std::env::var_os("SWEEP_CDT_SCREENSHOTS").map(PathBuf::from) else {
        eprintln!("skipped: SWEEP_CDT_SCREENSHOTS names no folder");
        return;
    };
    fs::create_dir_all(&folder).expect("a folder");
    for size in [[1280, 800], [390, 800]] {
        let Some((browser, _page)) = visit(size) else {
            return;
        };
        let shoot = |name: &str| {
            let file: &Path = &folder.join(format!("computes-{name}-{}.png", size[0]));
            fs::write(file, browser.picture()).expect("a file");
        };
        shoot("example");
        drop_file(
            &browser,
            "cross.json",
            r#"{"points": [[0,0],[4,3],[0,3],[4,0],[2,4]], "edges": [[0,1],[2,3]]}"#,
        );
        said(&browser);
        shoot("cross");
        browser.click("show-steps");
        wait(&browser, "element('player').src.startsWith('blob:')");
        std::thread::sleep(Duration::from_millis(500));
        shoot("steps");
    }
}
