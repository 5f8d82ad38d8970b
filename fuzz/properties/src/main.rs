//! Runs properties on files, and shows what bytes stand for.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use sweep_cdt_properties::{Input, TARGETS, Target};

#[derive(Parser)]
#[command(about = "Runs the fuzz targets of sweep-cdt on files, without a fuzzer")]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Tests a property on files, or on all files of folders; panics where it does not hold.
    Run {
        /// The property.
        target: String,
        /// Files and folders.
        paths: Vec<PathBuf>,
    },
    /// Writes seeds into a folder: for each input file (JSON: `points`, `edges`) that bytes can stand for, and
    /// chance ones for every shape of points with every pattern of edges.
    Seeds {
        /// The property.
        target: String,
        /// The folder.
        folder: PathBuf,
        /// Input files and folders of them.
        paths: Vec<PathBuf>,
    },
    /// Writes the input that a file stands for into a folder: `row.txt`, a row for the table of cases, and
    /// `input.json` for the command.
    Show {
        /// The property that the file is for.
        target: String,
        /// The file.
        file: PathBuf,
        /// The folder.
        folder: PathBuf,
    },
}

fn main() -> Result<(), Box<dyn Error>> {
    match Arguments::parse().verb {
        Verb::Run { target, paths } => {
            let target = named(&target)?;
            let mut count = 0;
            for path in paths {
                for file in files(&path)? {
                    (target.test)(&fs::read(file)?);
                    count += 1;
                }
            }
            println!("{}: {count} files", target.name);
        }
        Verb::Seeds {
            target,
            folder,
            paths,
        } => {
            let target = named(&target)?;
            for path in paths {
                for file in files(&path)? {
                    let text = fs::read_to_string(&file)?;
                    let name = file.file_stem().unwrap_or_default();
                    // What is no input of finite numbers is left to the readers' own seeds.
                    if let Ok(Parsed { points, edges }) = serde_json::from_str(&text) {
                        let seeds = target.seeds(&Input { points, edges });
                        write(&folder, &name.to_string_lossy(), seeds)?;
                    }
                }
            }
            for kind in 0..=u8::MAX {
                let mut bytes = vec![kind % 16, (kind / 16 % 8) | 8, 6 + kind % 19];
                bytes.extend((0..48_u32).map(|i| {
                    let mixed = (i + 1 + 64 * u32::from(kind)).wrapping_mul(0x9e37_79b9);
                    (mixed >> 24) as u8
                }));
                write(
                    &folder,
                    &format!("shape_{kind}"),
                    target.after_choices(&bytes),
                )?;
            }
        }
        Verb::Show {
            target,
            file,
            folder,
        } => {
            let bytes = fs::read(file)?;
            let Some(input) = (named(&target)?.input)(&bytes) else {
                fs::write(folder.join("row.txt"), format!("{bytes:?}\n"))?;
                return Ok(());
            };
            println!("{input}");
            fs::write(folder.join("row.txt"), format!("{input}\n"))?;
            let json = format!(
                "{{\"points\": {:?}, \"edges\": {:?}}}\n",
                input.points, input.edges
            );
            fs::write(folder.join("input.json"), json)?;
        }
    }
    Ok(())
}

/// An input as the files have it.
#[derive(serde::Deserialize)]
struct Parsed {
    points: Vec<[f64; 2]>,
    edges: Vec<[usize; 2]>,
}

fn write(folder: &Path, name: &str, seeds: Vec<Vec<u8>>) -> std::io::Result<()> {
    for (i, seed) in seeds.into_iter().enumerate() {
        fs::write(folder.join(format!("{name}_{i}")), seed)?;
    }
    Ok(())
}

fn named(name: &str) -> Result<&'static Target, String> {
    let found = TARGETS.iter().find(|target| target.name == name);
    found.ok_or_else(|| format!("there is no property {name}"))
}

fn files(path: &Path) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    if path.is_file() {
        return Ok(vec![path.to_owned()]);
    }
    let mut files = Vec::new();
    for entry in fs::read_dir(path)? {
        files.push(entry?.path());
    }
    files.sort();
    Ok(files)
}
