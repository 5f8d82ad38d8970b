//! Drawing: labels, triangles with artificial points, a view that follows, many vertices in time.

use serde_json::json;

use super::{ALL, Browser, assert_quiet, many, page, scattered};

/// No number covers another one, and the vertices of the step have theirs if they are in sight.
#[test]
fn numbers_do_not_overlap() {
    let pages = [
        page(&scattered(), ALL),
        page(&many(100), ALL),
        page(&many(1500), ALL),
    ];
    for width in [320, 1280] {
        let Some(browser) = Browser::open([width, 720]) else {
            return;
        };
        for (_folder, page) in &pages {
            browser.load(page, "");
            let found = browser.run(
                "const wrong = [];
                 let most = 0;
                 for (let step = SORTED; step <= LAST; step += 1 + Math.floor(LAST / 300)) {
                   show(step);
                   const covers = ([, l, t, r, b], [, left, top, right, bottom]) =>
                     l < right && left < r && t < bottom && top < b;
                   const { labels } = view;
                   most = Math.max(most, labels.length);
                   labels.forEach((one, at) => labels.slice(0, at).some((other) => covers(one, other)) && wrong.push(step));
                   for (const v of verticesOf(scene.step)) {
                     if (view.sees([view.place(v)]) && !labels.some(([named]) => named === v)) wrong.push([step, v]);
                   }
                 }
                 return [wrong, most > 1]",
            );
            assert_eq!(found, json!([[], true]), "{width}");
        }
        assert_quiet(&browser);
    }
}

/// Triangles with P-1 or P-2 reach to the edge of the picture, wherever one looks.
#[test]
fn artificial_triangles_reach_to_the_edge() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "");
    let found = browser.run(
        "const wrong = [];
         let drawn = 0;
         for (let step = SORTED + 1; step < LAST; step++) {
           show(step);
           if (step % 50 === 0) view.showStep(scene.step);
           for (const triangle of past.artificial.filter((t) => past.isThere(t, step))) {
             const corners = past.corners[triangle];
             const xs = view.reaching(corners).map(([x]) => x);
             drawn += 1;
             if (corners.includes(LEFT) && Math.min(...xs) > 0) wrong.push(step);
             if (corners.includes(RIGHT) && Math.max(...xs) < view.width) wrong.push(step);
           }
         }
         return [wrong, drawn > 100]",
    );
    assert_eq!(found, json!([[], true]));
    assert_quiet(&browser);
}

/// Near a step, the view goes where the next steps are; but not if it is told not to.
#[test]
fn the_view_follows() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&many(100), ALL);
    browser.load(&page, "#step=300");
    browser.click("near-step");
    let lost = "const lost = [];
        for (let step = 300; step < 700; step++) {
          show(step);
          if (!view.sees(view.placesOf(scene.step))) lost.push(step);
        }
        return lost.length";
    assert_eq!(browser.run(lost), 0);
    browser.run("show(300)");
    browser.click("near-step");
    browser.click("follow");
    let look = || browser.run("return [view.scale, ...view.middle]");
    let before = look();
    assert!(browser.run(lost).as_u64() > Some(0));
    assert_eq!(look(), before);
    assert_quiet(&browser);
}

/// A picture changed by a step is the picture drawn anew. (Pixels where two lines meet may differ a
/// little.)
#[test]
fn a_part_drawn_anew_fits_the_rest() {
    let Some(browser) = Browser::open([800, 600]) else {
        return;
    };
    let (_folder, page) = page(&scattered(), ALL);
    browser.load(&page, "");
    let worst = browser.run(
        "const pixels = () => view.context.getImageData(0, 0, view.canvas.width, view.canvas.height).data;
         let worst = 0;
         for (let step = SORTED; step < LAST; step++) {
           show(step);
           if (step % 25) continue;
           const parts = pixels();
           view.ground.look = '';
           view.draw(scene);
           const whole = pixels();
           worst = Math.max(worst, parts.reduce((sum, value, at) => sum + (Math.abs(value - whole[at]) > 60), 0));
         }
         return worst",
    );
    assert!(worst.as_u64() < Some(40), "{worst} values differ");
}

/// Tells the median and the slowest of 60 steps forwards and backwards with 25,000 vertices, drawn to the end. No time
/// fails the test: a machine has other work, too.
#[test]
fn steps_with_many_vertices_are_timed() {
    let Some(browser) = Browser::open([1280, 800]) else {
        return;
    };
    let (_folder, page) = page(&many(25_000), ALL);
    browser.load(&page, "");
    for step in ["SORTED + 2000", "(SORTED + LAST) >> 1", "LAST - 500"] {
        let times = browser.run(&format!(
            "show({step});
             const times = [];
             for (let i = 0; i < 60; i++) {{
               const start = performance.now();
               move(i < 40 ? 1 : -1);
               view.context.getImageData(0, 0, 1, 1);
               times.push(performance.now() - start);
             }}
             times.sort((a, b) => a - b);
             return [times[30], times[59]]"
        ));
        eprintln!("{step}: median and slowest {times} ms");
        assert!(times[0].as_f64() > Some(0.0), "{step}: {times} ms");
    }
}
