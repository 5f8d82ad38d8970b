//! The program that computes for the page: a request is its one argument, as JSON; the files of the request are its
//! standard input, the answer is its standard output. A failure is one line on standard error, and status 1.
//!
//! Each request is a process of its own, as the command is: it begins with empty memory, so no request can spoil
//! the next one, whatever happens. The results come from the same functions as the command's, and are the same bytes.
//!
//! The program is built for `wasm32-wasip1`, where standard streams, arguments and a clock are part of the platform: Rust's own
//! library does all that needs `unsafe`. `crates/page/src/page/wasi.js` is the other side of it in a browser. It runs as a
//! native program, too.

mod input;
mod output;
mod picture;
mod request;
mod settings;

use std::error::Error;
use std::io::{Read, Write};
use std::process::ExitCode;

use sweep_cdt_formats::Input;

use request::Request;
use settings::Asked;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let request = std::env::args().nth(1).ok_or("there is no request")?;
    let request: Request = serde_json::from_str(&request)?;
    let mut files = Vec::new();
    std::io::stdin().read_to_end(&mut files)?;
    let Request {
        input,
        settings,
        wanted,
    } = request;
    let settings = Asked::try_from(settings)?;
    let name = input.name();
    let mut answer = Vec::new();
    match input::read(input, files)? {
        Input::Doubles(graph) => output::write(&name, &graph, &settings, wanted, &mut answer)?,
        Input::Rationals(graph) => output::write(&name, &graph, &settings, wanted, &mut answer)?,
    }
    let mut out = std::io::stdout().lock();
    out.write_all(&answer)?;
    out.flush()?;
    Ok(())
}
