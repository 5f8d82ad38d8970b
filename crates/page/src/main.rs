//! Makes the page: `cargo run --release -p sweep-cdt-page`, and then it is `target/page/index.html`. Another file may
//! be named.

use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/page");
    let file = match std::env::args_os().nth(1) {
        Some(file) => PathBuf::from(file),
        None => folder.join("index.html"),
    };
    let page = sweep_cdt_page::page(&sweep_cdt_page::build_program(&folder)?)?;
    std::fs::write(&file, &page)?;
    println!("{}: {} kB", file.display(), page.len() / 1000);
    Ok(())
}
