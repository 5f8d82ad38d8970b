//! `docs/judging.md` names what the command knows.

use std::fs;

use sweep_cdt::verify::Level;
use sweep_cdt_testing::judge::{Asked, Special};
use sweep_cdt_testing::oracle::Domain;

use crate::{judge, path, text};

#[test]
fn the_document_has_all_words() {
    let document = fs::read_to_string(path("docs/judging.md")).expect("a readable file");
    let specials = Special::ALL.iter().map(|(_, name)| *name);
    let asked = Asked::ALL.iter().map(|(_, name)| *name);
    let levels = Level::ALL.iter().map(|level| level.name());
    let domains = Domain::ALL.iter().map(|(_, name)| *name);
    for word in specials.chain(asked).chain(levels).chain(domains) {
        let is_there =
            document.contains(&format!("`{word}`")) || document.contains(&format!("`\"{word}\"`"));
        assert!(is_there, "{word}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let help = text(&judge(folder.path(), &["campaign", "--help"]).stdout);
    for option in [
        "--asked",
        "--domain",
        "--level",
        "--numbers",
        "--most",
        "--refuses",
        "--never",
        "--answers",
        "--mixed",
        "--timeout",
        "--output",
    ] {
        assert!(
            help.contains(option) && document.contains(option),
            "{option}"
        );
    }
}
