//! Acts of the tests on the page, in headless Chromium.

use std::fs;
use std::time::{Duration, Instant};

use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::{Value, json};
use tempfile::TempDir;

use super::browser::Browser;
use super::program;

/// The page, opened in a window of that size; nothing where it cannot be. The folder must be kept while it is shown.
pub(super) fn visit(size: [u32; 2]) -> Option<(Browser, TempDir)> {
    let program = program()?;
    let browser = Browser::open(size)?;
    let folder = TempDir::new().expect("a temporary folder");
    let path = folder.path().join("page.html");
    fs::write(&path, sweep_cdt_page::page(program).expect("a page")).expect("a file");
    browser.load(&path, "");
    wait(&browser, "answer && !isBusy");
    Some((browser, folder))
}

/// Waits until a script returns true.
#[track_caller]
pub(super) fn wait(browser: &Browser, condition: &str) {
    let start = Instant::now();
    while browser.run(&format!("return !!({condition})")) != true {
        assert!(start.elapsed() < Duration::from_secs(50), "{condition}");
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[track_caller]
pub(super) fn assert_quiet(browser: &Browser) {
    assert_eq!(browser.console(), Vec::<Value>::new());
}

/// The words of the page for the input, for edges that cross, and for faults.
#[track_caller]
pub(super) fn said(browser: &Browser) -> [String; 3] {
    wait(browser, "!isBusy");
    ["summary", "crossings", "notice"].map(|id| {
        let text = browser.run(&format!("return element('{id}').textContent"));
        text.as_str().expect("a text").to_owned()
    })
}

/// Drops a file on the page, and waits until it is asked about.
pub(super) fn drop_file(browser: &Browser, name: &str, text: &str) {
    browser.run(&format!(
        "const files = new DataTransfer();
         files.items.add(new File([{}], {}));
         const options = {{ dataTransfer: files, bubbles: true, cancelable: true }};
         window.askedBefore = computer.last;
         document.dispatchEvent(new DragEvent('drop', options))",
        json!(text),
        json!(name)
    ));
    wait(browser, "computer.last !== askedBefore");
}

/// Turns to the page in the frame with this id, which scripts and clicks are for from now on; without an id, back to
/// the page itself.
pub(super) fn enter(browser: &Browser, frame: Option<&str>) {
    let frame = frame.map(|id| browser.found(id));
    browser.send("/frame", &json!({ "id": frame }));
}

pub(super) fn choose(browser: &Browser, name: &str, value: &str) {
    browser.run(&format!(
        "document.querySelector('[name={name}][value={value}]').click()"
    ));
}

/// Four corners, and two edges that cross.
pub(super) fn draw_a_cross(browser: &Browser) {
    browser.click("clear");
    let corners = [[300, 300], [600, 600], [300, 600], [600, 300]];
    for corner in corners {
        browser.drag(corner, corner);
    }
    browser.drag(corners[0], corners[1]);
    assert_eq!(said(browser)[0], "4 points, 1 edge: 2 triangles.");
    browser.drag(corners[2], corners[3]);
}

/// The files that the page saves, from the button's own function.
pub(super) fn saved(browser: &Browser, file: &str) -> Vec<u8> {
    let bytes = browser.run(&format!(
        "element('format').value = {};
         return chosenFile().then(async ([, {{ output }}]) => {{
           const reader = new FileReader();
           const done = new Promise((resolve) => (reader.onload = resolve));
           reader.readAsDataURL(new Blob([output]));
           await done;
           return reader.result.split(',')[1];
         }})",
        json!(file)
    ));
    let bytes = BASE64_STANDARD.decode(bytes.as_str().expect("a text"));
    bytes.expect("base64")
}
