//! Runs properties on files, shows what bytes stand for, packs and unpacks seeds.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use sweep_cdt_properties::{TARGETS, Target, seeds, shown};
use sweep_cdt_testing::Random;
use sweep_cdt_testing::data::Hard;

#[derive(Parser)]
#[command(about = "Runs the fuzz targets of sweep-cdt on files, without a fuzzer")]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Prints the name of every property, and of how many bytes a fuzzer makes its inputs at most.
    Targets,
    /// Tests a property on files, or on all files of folders; panics where it does not hold.
    Run {
        /// The property.
        target: String,
        /// Files and folders.
        paths: Vec<PathBuf>,
    },
    /// Writes new seeds into a folder: the hard inputs of the tests, as far as bytes can stand for them, and
    /// random ones for every shape of points with every pattern of edges.
    Seeds {
        /// The property.
        target: String,
        /// The folder.
        folder: PathBuf,
    },
    /// Writes the seeds of every property into a folder: for each a folder, in it a file for each seed.
    Unpack {
        /// The folder.
        folder: PathBuf,
    },
    /// Adds the files of a folder to the seeds of a property, `fuzz/seeds/TARGET.hex`.
    Pack {
        /// The property.
        target: String,
        /// The folder.
        folder: PathBuf,
    },
    /// Writes what a file stands for into a folder: points and edges as `row.txt`, a row for the table of cases,
    /// and as `input.json` for the command, with the steps and a picture; or a trace, a file or a result.
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
        Verb::Targets => {
            for Target { name, max_len, .. } in TARGETS {
                println!("{name} {max_len}");
            }
            Ok(())
        }
        Verb::Run { target, paths } => run(named(&target)?, &paths),
        Verb::Seeds { target, folder } => make_seeds(named(&target)?, &folder),
        Verb::Unpack { folder } => {
            for target in TARGETS {
                seeds::unpack(&seeds::path(target.name), &folder.join(target.name))?;
            }
            Ok(())
        }
        Verb::Pack { target, folder } => {
            let file = seeds::path(named(&target)?.name);
            let count = seeds::pack(&folder, &file)?;
            println!("{}: {count} new seeds", file.display());
            Ok(())
        }
        Verb::Show {
            target,
            file,
            folder,
        } => Ok(shown::show(named(&target)?, &fs::read(file)?, &folder)?),
    }
}

fn run(target: &Target, paths: &[PathBuf]) -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for path in paths {
        for file in files(path)? {
            (target.test)(&fs::read(file)?);
            count += 1;
        }
    }
    println!("{}: {count} files", target.name);
    Ok(())
}

fn make_seeds(target: &Target, folder: &Path) -> Result<(), Box<dyn Error>> {
    for Hard { name, input, .. } in [Hard::own(), Hard::further()].concat() {
        // Points that are not finite, or are too many, have no bytes.
        write(folder, &name, target.seeds(&input))?;
    }
    let mut random = Random::new(1);
    for kind in 0..=u8::MAX {
        // One of 16 shapes, one of 8 patterns, no edges that cross and no disguise, 6 to 24 points.
        let mut bytes = vec![kind % 16, (kind / 16 % 8) | 8, 6 + kind % 19];
        bytes.extend(random.bytes(48));
        let seeds = target.after_leads(&bytes);
        write(folder, &format!("shape_{kind}"), seeds)?;
    }
    Ok(())
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
