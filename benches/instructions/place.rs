//! What the counts depend on beside the code.

use std::process::Command;

/// A line each for the compiler, the machine, the system's library and valgrind; none without valgrind.
pub(crate) fn place() -> Option<String> {
    let valgrind = first_line("valgrind", "--version")?;
    let compiler = first_line("rustc", "--version").unwrap_or_default();
    let library = first_line("ldd", "--version").unwrap_or_default();
    let machine = std::env::consts::ARCH;
    Some(format!(
        "# {compiler}\n# {machine}{}\n# {library}\n# {valgrind}\n",
        extensions()
    ))
}

/// The extensions that the libraries choose their code by, as far as valgrind has them.
fn extensions() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        return " with avx2";
    }
    ""
}

/// The first line that a command prints, if there is such a command.
fn first_line(command: &str, argument: &str) -> Option<String> {
    let output = Command::new(command).arg(argument).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().next().map(str::to_owned)
}
