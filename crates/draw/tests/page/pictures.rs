//! Pictures of single steps, and pictures of the page to look at.

use std::fs;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use sweep_cdt::Pslg;
use sweep_cdt::trace::{Event, Outcome, Vertex};
use sweep_cdt_draw::StepsSheet;

use super::{ALL, Browser, assert_quiet, events, many, page, scattered};

fn sheet(graph: &Pslg<f64>, steps: RangeInclusive<usize>) -> String {
    let mut sheet = Vec::new();
    StepsSheet::new(graph, &events(graph))
        .steps(steps)
        .write(&mut sheet)
        .expect("memory takes all");
    String::from_utf8(sheet).expect("text")
}

fn panels(sheet: &str) -> usize {
    sheet.matches("class=\"frame\"").count()
}

#[test]
fn one_step() {
    let sheet = sheet(&scattered(), 1..=1);
    assert_eq!(panels(&sheet), 1);
    assert!(sheet.contains("Vertex 1 is the next one in sweep order."));
}

#[test]
fn several_steps() {
    let graph = scattered();
    let last = events(&graph).len();
    let sheet = sheet(&graph, last - 4..=last + 10);
    assert_eq!(panels(&sheet), 5);
    assert!(!sheet.contains("The first"));
}

#[test]
fn too_many_steps() {
    let sheet = sheet(&many(400), ALL);
    assert_eq!(panels(&sheet), 60);
    assert!(sheet.contains("The first 60 of "));
}

/// Of the steps of a test, those with an artificial point say why they show no circle.
#[test]
fn circles() {
    let graph = scattered();
    let (mut real, mut artificial) = (0, 0);
    for (step, event) in (1..).zip(events(&graph)) {
        let Event::Test {
            side: [a, b],
            opposite: [p, q],
            outcome,
        } = event
        else {
            continue;
        };
        let sheet = sheet(&graph, step..=step);
        let has_circle = ["legal", "illegal"]
            .iter()
            .any(|class| sheet.contains(&format!("<circle class=\"{class}\"")));
        let is_excused = sheet.contains("No circle is drawn");
        let is_real = [a, b, p, q].iter().all(|v| matches!(v, Vertex::Input(_)));
        if outcome == Outcome::Fixed {
            assert!(!has_circle && !is_excused, "{event}");
        } else {
            assert_eq!([has_circle, is_excused], [is_real, !is_real], "{event}");
            *(if is_real { &mut real } else { &mut artificial }) += 1;
        }
    }
    assert!(real > 0 && artificial > 0);
}

/// Whatever the coordinates, all numbers in the file are finite.
#[test]
fn extreme_inputs() {
    for points in [
        vec![],
        vec![[1.0, 1.0]],
        vec![[0.0, 0.0], [0.0, 1.0], [0.0, 2.0]],
        vec![[-1e308, -1e308], [1e308, -1e308], [0.0, 1e308]],
        vec![[0.0, 0.0], [5e-324, 0.0], [0.0, 5e-324]],
    ] {
        let graph = Pslg {
            points,
            ..Pslg::default()
        };
        let sheet = sheet(&graph, ALL);
        assert!(
            !sheet.contains("NaN") && !sheet.contains("inf"),
            "{:?}",
            graph.points
        );
    }
}

/// The last step with a change of that name, and the last one with these words.
const FIND: &str = "const lastWith = (wanted) => SORTED + 1 + trace.steps.findLastIndex(
    (_, at) => changesOf(SORTED + 1 + at).some(([name]) => name === wanted));
  const lastWords = (words) => SORTED + 1 + trace.steps.findLastIndex(
    (_, at) => textOf(SORTED + 1 + at)[1].includes(words));";

/// Written to the folder that `SWEEP_CDT_SCREENSHOTS` names.
#[test]
fn screenshots() {
    let Some(folder) = std::env::var_os("SWEEP_CDT_SCREENSHOTS").map(PathBuf::from) else {
        eprintln!("skipped: SWEEP_CDT_SCREENSHOTS names no folder");
        return;
    };
    fs::create_dir_all(&folder).expect("a folder");
    let graph = scattered();
    let mut sheet = Vec::new();
    StepsSheet::new(&graph, &events(&graph))
        .steps(222..=233)
        .write(&mut sheet)
        .expect("memory takes all");
    fs::write(folder.join("sheet.svg"), sheet).expect("a file");

    let (small, large) = (page(&graph, ALL), page(&many(1500), ALL));
    let part = page(&graph, 150..=170);
    let [ten, hundred, most] = [10, 100, 25_000].map(|count| page(&many(count), ALL));
    let sizes = [[1920, 1080], [1280, 800], [390, 800], [320, 640]];
    for (size, is_dark) in sizes
        .into_iter()
        .flat_map(|size| [(size, false), (size, true)])
    {
        let Some(browser) = Browser::open(size) else {
            return;
        };
        if is_dark {
            browser.darken();
        }
        for (name, (_, page), script) in [
            ("input", &small, "show(0)"),
            ("illegal", &small, "show(lastWith('illegal'))"),
            (
                "artificial",
                &small,
                "show(lastWords('No circle is drawn'))",
            ),
            ("swap", &small, "show(lastWith('gone'))"),
            ("pierced", &small, "show(lastWith('pierce'))"),
            ("polygons", &small, "show(225)"),
            ("end", &small, "show(LAST)"),
            ("legend", &part, "element('legend').open = true"),
            ("large", &large, "show(9000)"),
            ("ten", &ten, "show(40)"),
            ("hundred", &hundred, "show(600)"),
            ("most", &most, "show(150000)"),
            ("near", &large, "show(9000); element('near-step').click()"),
        ] {
            browser.load(page, "");
            browser.run(&format!("{FIND} {script}"));
            assert_quiet(&browser);
            let scheme = if is_dark { "-dark" } else { "" };
            let file = format!("{name}-{}{scheme}.png", size[0]);
            fs::write(folder.join(file), browser.picture()).expect("a file");
        }
    }
}
