//! The command `sweep-cdt`: see [`cli`].

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
