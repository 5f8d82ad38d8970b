//! Pictures to look at, written to the folder that `SWEEP_CDT_SCREENSHOTS` names.

use std::fs;
use std::path::PathBuf;

use sweep_cdt::draw::StepsSheet;

use super::inputs::{many, scattered};
use super::{ALL, Browser, assert_quiet, events, page};

/// The last step with a change of that name, and the last one with these words.
const FIND: &str = "const lastWith = (wanted) => trace.first + trace.steps.findLastIndex(
    (step) => step[2].some(([name]) => name === wanted));
  const lastWords = (words) => trace.first + trace.steps.findLastIndex(
    (step) => step[1].includes(words));";

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
    for size in [[1280, 800], [800, 600], [480, 800], [390, 800]] {
        let Some(browser) = Browser::open(size) else {
            return;
        };
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
            ("near", &large, "show(9000); element('near-step').click()"),
        ] {
            browser.load(page, "");
            browser.run(&format!("{FIND} {script}"));
            assert_quiet(&browser);
            let file = format!("{name}-{}x{}.png", size[0], size[1]);
            fs::write(folder.join(file), browser.picture()).expect("a file");
        }
    }
}
