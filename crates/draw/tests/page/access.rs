//! The page for those who do not see it, or use no mouse: what axe-core finds. `.ci/nightly` installs it. Where it is
//! missing, this test says so and passes, except in continuous integration.

use std::path::Path;

use serde_json::json;

use super::{ALL, Browser, assert_quiet, many, page, scattered};

/// Where `npm install --prefix target/axe axe-core@4.14.1` puts it.
const AXE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../target/axe/node_modules/axe-core/axe.min.js"
);

#[test]
fn axe_finds_nothing() {
    let Ok(axe) = std::fs::read_to_string(Path::new(AXE)) else {
        let is_ci = std::env::var_os("CI").is_some_and(|value| value == "true");
        assert!(!is_ci, "axe-core is not installed");
        eprintln!("skipped: {AXE} is missing");
        return;
    };
    let pages = [page(&scattered(), ALL), page(&many(100), ALL)];
    for (width, is_dark) in [(1920, true), (1280, false), (390, true), (320, false)] {
        let Some(browser) = Browser::open([width, 800]) else {
            return;
        };
        if is_dark {
            browser.darken();
        }
        for (_folder, page) in &pages {
            browser.load(page, "#step=60");
            // The second time with all that can be opened, and a search that found nothing.
            for script in [
                "",
                "document.querySelectorAll('details').forEach((d) => (d.open = true)); search('x');",
            ] {
                browser.run(script);
                browser.run(&axe);
                let found = browser.run_async(
                    "axe.run(document).then(({ violations }) => done(violations.map(
                       ({ id, nodes }) => [id, ...nodes.map(({ target }) => String(target))])))",
                );
                assert_eq!(found, json!([]), "{width} {is_dark} {script}");
            }
        }
        assert_quiet(&browser);
    }
}
