//! Each way to go to a step, and to look at it.

use super::{ALL, Browser, assert_quiet, events, page, scattered, wait};

/// The names of some keys in `WebDriver`.
const ARROW_LEFT: &str = "\u{E012}";
const ARROW_RIGHT: &str = "\u{E014}";
const PAGE_DOWN: &str = "\u{E00F}";
const HOME: &str = "\u{E011}";
const END: &str = "\u{E010}";

#[test]
fn every_way_to_step() {
    let Some(browser) = Browser::open([1280, 800]) else {
        return;
    };
    let graph = scattered();
    let total = events(&graph).len();
    let (_folder, page) = page(&graph, ALL);
    let position = |step: usize| format!("Step {step} of {total}");

    browser.load(&page, "");
    assert_eq!(browser.text("position"), position(0));
    assert_eq!(browser.text("sentence"), "26 vertices and 5 edges.");
    browser.click("after");
    assert_eq!(browser.text("position"), format!("Step 1–26 of {total}"));
    let sentence = browser.text("sentence");
    assert!(sentence.starts_with("The 26 vertices are put in sweep order"));
    browser.press(ARROW_RIGHT);
    assert_eq!(browser.text("position"), position(27));
    browser.press(ARROW_LEFT);
    browser.click("spread");
    assert_eq!(browser.text("position"), position(26));
    browser.press(HOME);
    browser.press(ARROW_RIGHT);
    assert_eq!(
        browser.text("sentence"),
        "Vertex 1 is the next one in sweep order."
    );
    browser.press(ARROW_RIGHT);
    browser.press(ARROW_RIGHT);
    browser.press(ARROW_LEFT);
    assert_eq!(browser.text("position"), position(2));
    wait(&browser, "location.hash === '#step=2'");
    browser.click("spread");
    assert_eq!(browser.text("position"), format!("Step 1–26 of {total}"));

    browser.press(PAGE_DOWN);
    assert_eq!(browser.text("heading"), "Initial triangle · figure 6");
    browser.press(PAGE_DOWN);
    assert!(browser.text("heading").starts_with("Point event"));
    browser.press(END);
    assert_eq!(browser.text("position"), position(total));
    assert!(
        browser
            .text("sentence")
            .starts_with("The triangulation has")
    );
    browser.press(HOME);
    assert_eq!(browser.text("position"), position(0));

    // The slider, from its left end to beyond its right one.
    let middle = |x: &str| {
        format!(
            "(r => [Math.round({x}), Math.round(r.top + r.height / 2)])(slider.getBoundingClientRect())"
        )
    };
    let place = |x: &str| {
        let place = browser.run(&format!("return {}", middle(x)));
        [0, 1].map(|axis: usize| place[axis].as_i64().expect("a number"))
    };
    browser.drag(place("r.left + 8"), place("(r.left + r.right) / 2"));
    let half = browser.run("return number").as_u64().expect("a step");
    assert!(half.abs_diff(total as u64 / 2) < 20, "{half} of {total}");
    browser.drag(place("(r.left + r.right) / 2"), place("r.right + 20"));
    assert_eq!(browser.text("position"), position(total));

    browser.run("location.hash = '#step=60'");
    wait(&browser, "number === 60");
    assert_eq!(browser.text("position"), position(60));
    browser.load(&page, "#step=99999");
    // The browser gives up a navigation when the page writes its address meanwhile.
    wait(&browser, &format!("location.hash === '#step={total}'"));

    browser.load(&page, "#step=30");
    wait(&browser, "number === 30");
    browser.run("speed.value = 60; speed.onchange()");
    browser.click("play");
    wait(&browser, "number > 40");
    browser.press(" ");
    let paused = browser.run("return number");
    std::thread::sleep(std::time::Duration::from_millis(100));
    assert_eq!(browser.run("return number"), paused);
    assert_eq!(browser.text("play"), "Play");
    assert_quiet(&browser);
}

#[test]
fn zoom_and_pan() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "#step=100");
    let look = || browser.run("return [view.scale, ...view.middle]");
    let at = || browser.run("return view.place(13)");
    let start = look();
    browser.wheel([200, 200], -300);
    assert!(look()[0].as_f64() > start[0].as_f64());
    let before = at();
    browser.drag([200, 200], [240, 230]);
    let moved = |axis: usize| at()[axis].as_f64().unwrap() - before[axis].as_f64().unwrap();
    assert!((moved(0) - 40.0).abs() < 1.0 && (moved(1) - 30.0).abs() < 1.0);
    browser.press("0");
    assert_eq!(look(), start);
    assert_quiet(&browser);
}

/// Going to a step forwards, backwards and by a jump leads to the same picture.
#[test]
fn a_step_is_the_same_from_everywhere() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "");
    let differing = browser.run(
        "isSpread = true;
         const state = () => JSON.stringify([past.trianglesAt(number), scene.front,
           scene.sweep, scene.edge, scene.pierced, scene.upper, scene.lower, scene.step]);
         const ahead = [];
         for (let step = 0; step <= LAST; step++) { show(step); ahead.push(state()); }
         const differing = [];
         for (let step = LAST; step >= 0; step--) {
           show((step * 7919) % (LAST + 1));
           if (state() !== ahead[number]) differing.push(number);
         }
         return differing",
    );
    assert_eq!(differing, serde_json::json!([]));
    assert_quiet(&browser);
}

/// The part above the list of steps has room for every sentence, so that nothing moves from step to
/// step; nothing is wider or higher than the window, the legend ends above the controls, and no vertex
/// is below a button.
#[test]
fn the_page_stands_still() {
    let (_folder, page) = page(&scattered(), ALL);
    for size in [
        [1920, 1080],
        [1280, 800],
        [800, 600],
        [480, 800],
        [390, 800],
        [320, 720],
    ] {
        let Some(browser) = Browser::open(size) else {
            return;
        };
        browser.load(&page, "");
        let found = browser.run(
            "const heights = new Set();
             for (let step = BEFORE; step <= LAST; step++) {
               show(step);
               heights.add(element('description').offsetHeight);
             }
             const { scrollWidth, scrollHeight } = document.documentElement;
             return [[...heights].length, scrollWidth - innerWidth, scrollHeight - innerHeight]",
        );
        assert_eq!(found, serde_json::json!([1, 0, 0]), "{size:?}");
        let found = browser.run(
            "element('legend').open = true;
             view.resize();
             const place = (name) => document.querySelector(name).getBoundingClientRect();
             const isCovered = (v) => {
               const [[x, y], { right, bottom }] = [view.place(v), place('#zoom')];
               return x < right + 4 && y < bottom + 4;
             };
             return [innerWidth <= 640 || place('#legend').bottom <= place('footer').top,
               [...trace.points.keys()].filter(isCovered)]",
        );
        assert_eq!(found, serde_json::json!([true, []]), "{size:?}");
        assert_quiet(&browser);
    }
}

/// The page draws a circle for each test, but for those whose sentence says that there is none.
#[test]
fn circles() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "");
    let counts = browser.run(
        "let drawn = 0; View.prototype.circle = () => { drawn += 1; };
         let [real, excused, wrong] = [0, 0, []];
         for (let step = BEFORE + 1; step <= LAST; step++) {
           drawn = 0;
           show(step);
           const sentence = element('sentence').textContent;
           const isExcused = sentence.includes('No circle is drawn');
           const isTest = ['is legal', 'is illegal'].some((words) => sentence.includes(words));
           if (drawn !== (isTest && !isExcused ? 1 : 0)) wrong.push(step);
           real += drawn;
           excused += isExcused;
         }
         return [real > 0, excused > 0, wrong]",
    );
    assert_eq!(counts, serde_json::json!([true, true, []]));
    assert_quiet(&browser);
}

#[test]
fn a_part_of_a_trace() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let graph = scattered();
    let ((_a, whole), (_b, part)) = (page(&graph, ALL), page(&graph, 150..=170));
    let state =
        "return JSON.stringify([past.trianglesAt(number).map((t) => key(past.corners[t])).sort(),
        scene.front, scene.sweep, scene.edge, scene.pierced, scene.upper, scene.lower, scene.step,
        past.tests[number - BEFORE], past.flips[number - BEFORE]])";
    browser.load(&whole, "#step=160");
    let expected = browser.run(state);
    browser.load(&part, "#step=160");
    assert_eq!(browser.run(state), expected);
    assert!(
        browser
            .text("notice")
            .starts_with("This page holds steps 150 to 170 of")
    );
    assert_quiet(&browser);
}
