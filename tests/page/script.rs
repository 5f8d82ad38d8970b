//! The script of the page, without a browser.

use std::fs;
use std::process::Command;

use super::inputs::scattered;
use super::{ALL, page};

/// `node --check` parses the script. Where there is no `node`: the reason is printed; in continuous
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
