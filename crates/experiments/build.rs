//! Notes the compiler's version and the target for the reports.

use std::process::Command;

fn main() {
    let compiler = std::env::var_os("RUSTC").expect("Cargo names the compiler");
    let output = Command::new(compiler).arg("--version").output();
    let version = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned());
    println!("cargo::rustc-env=COMPILER={}", version.unwrap_or_default());
    println!(
        "cargo::rustc-env=TARGET={}",
        std::env::var("TARGET").expect("Cargo names it")
    );
    println!("cargo::rerun-if-changed=build.rs");
}
