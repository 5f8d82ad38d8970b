//! Words of the page: counters, sections of the paper, the text searched for, missing parts.

use serde_json::json;
use sweep_cdt::Error;
use sweep_cdt::trace::Event;
use sweep_cdt_draw::StepsPage;
use tempfile::TempDir;

use super::{ALL, Browser, assert_quiet, events, many, page, scattered};

/// The counters after every step are those of the events up to it.
#[test]
fn counters() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (graph, mut counts) = (scattered(), [1_i64, 0, 0]);
    let mut expected = vec![counts];
    for event in events(&graph) {
        counts = match event {
            Event::FrontInsert { .. } => [counts[0] + 1, counts[1], counts[2]],
            Event::FrontRemove { .. } => [counts[0] - 1, counts[1], counts[2]],
            Event::Test { .. } => [counts[0], counts[1] + 1, counts[2]],
            Event::Flip { .. } => [counts[0], counts[1], counts[2] + 1],
            Event::Finished { .. } => [0, counts[1], counts[2]],
            _ => counts,
        };
        expected.push(counts);
    }
    for steps in [ALL, 150..=170] {
        let (_folder, page) = page(&graph, steps.clone());
        browser.load(&page, "");
        let found = browser.run(
            "isSpread = true;
             const found = [];
             for (let step = BEFORE; step <= LAST; step++) {
               show(step);
               found.push(['front', 'tests', 'flips'].map((id) => parseInt(element(id).textContent)));
             }
             return found",
        );
        let last = expected.len().min(steps.end().saturating_add(1));
        assert_eq!(found, json!(expected[steps.start() - 1..last]));
    }
    assert_quiet(&browser);
}

#[test]
fn search_and_sections() {
    let Some(browser) = Browser::open([1280, 800]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "");
    let found = |words: &str| {
        browser.run(&format!(
            "element('search').value = '{words}'; element('searching').requestSubmit()"
        ));
        (browser.text("sentence"), browser.text("found"))
    };
    for words in ["17", "vertex 17", " V17 "] {
        let (sentence, note) = found(words);
        assert!(
            sentence.starts_with("The sweep line meets vertex 17."),
            "{words}: {sentence}"
        );
        assert_eq!(note, "");
    }
    let (sentence, _) = found("edge 3");
    assert!(
        sentence.starts_with("Input edge 3 is inserted"),
        "{sentence}"
    );
    assert_eq!(found("edge 77").1, "No event on this page is of edge 77.");
    assert!(found("nonsense").1.starts_with("Type a vertex"));
    found("step 100");
    assert_eq!(browser.run("return number"), 100);

    // The event leads to its section, and the section to its events.
    let current = "return document.querySelector('#sections [aria-current]')?.textContent";
    browser.run("show(0)");
    assert_eq!(browser.run(current), json!(null));
    for (section, start) in [
        (0, "2 Legalization"),
        (3, "3.4.1 (i) Narrow corners"),
        (6, "3.5 Finalization"),
    ] {
        let script = format!("document.querySelectorAll('#sections button')[{section}].click()");
        browser.run(&script);
        let named = browser.run(current);
        assert!(
            named.as_str().is_some_and(|named| named.starts_with(start)),
            "{named}"
        );
        browser.run("document.querySelector('#heading button').click()");
        let focused = "return [element('sections').open, document.activeElement.textContent]";
        assert_eq!(browser.run(focused), json!([true, named]));
        let step = browser.run("return number").as_u64();
        browser.run(&script);
        assert!(browser.run("return number").as_u64() > step);
    }
    browser.press("/");
    assert_eq!(browser.run("return document.activeElement.id"), "search");
    assert_quiet(&browser);
}

/// A page too small for its steps and vertices keeps those around a step, and says what it lacks.
#[test]
fn what_a_page_lacks() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let graph = many(3000);
    let events = events(&graph);
    let is_late = |event: &&Event| matches!(event, Event::Point { .. });
    let late = events.iter().filter(is_late).nth(2000).expect("a step");
    let step = 1 + events
        .iter()
        .position(|event| event == late)
        .expect("a step");
    let error = Error::CrossingEdges { edges: [3, 4] };
    let small = StepsPage::new(&graph, &events)
        .around(step)
        .most_bytes(100_000)
        .refused(&error);
    let shown = small.shown();
    assert!(shown.contains(&step) && shown.end() - shown.start() > 500);
    let mut bytes = Vec::new();
    small.write(&mut bytes).expect("memory takes all");
    let folder = TempDir::new().expect("a temporary folder");
    let path = folder.path().join("page.html");
    std::fs::write(&path, bytes).expect("a file");
    browser.load(&path, "");
    assert_eq!(browser.run("return number"), step);
    let notice = browser.text("notice");
    let (first, last, total) = (shown.start(), shown.end(), events.len());
    assert!(notice.starts_with(&format!(
        "This page holds steps {first} to {last} of {total}."
    )));
    assert!(notice.contains(" of 3000 vertices") && notice.contains("edges 3 and 4 cross"));
    // Every step has the vertices that it names.
    let lacking = browser.run(
        "const lacking = [];
         for (let step = LAST; step > BEFORE; step--) {
           show(step);
           if (verticesOf(scene.step).some((v) => !trace.points[v])) lacking.push(step);
         }
         return [lacking, Object.keys(trace.points).length < 3000]",
    );
    assert_eq!(lacking, json!([[], true]));
    assert_quiet(&browser);
}
