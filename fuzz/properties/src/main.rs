//! Runs properties on files, shows what bytes stand for, packs seeds, counts what is asked.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use clap::{Parser, Subcommand};
use sweep_cdt_properties::bytes::Source;
use sweep_cdt_properties::{TARGETS, Target, named, reached, seeds};
use sweep_cdt_testing::Random;
use sweep_cdt_testing::asked::{KINDS, Tally};
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::generators::RINGED;
use sweep_cdt_testing::judge::{Asked, Campaign, Claims};
use sweep_cdt_testing::suite;

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
    /// Writes new seeds into a folder: the hard inputs of the tests, as far as bytes can stand for them, and
    /// random ones for every shape of points with every pattern of edges, and for polygons.
    Seeds {
        /// The property.
        target: String,
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
    /// Counts of which kinds the questions are: of each property, of campaigns against other programs, and of the
    /// suite of conformance. Prints a table in Markdown, of shares in per cent.
    Asked {
        /// So many executions of each.
        executions: u64,
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
        Verb::Run { target, paths } => run(named(&target)?, &paths),
        Verb::Seeds { target, folder } => make_seeds(named(&target)?, &folder),
        Verb::Pack { target, folder } => {
            let file = seeds::path(named(&target)?.name);
            let count = seeds::pack(&folder, &file)?;
            println!("{}: {count} new seeds", file.display());
            Ok(())
        }
        Verb::Asked { executions } => asked(executions),
        Verb::Show {
            target,
            file,
            folder,
        } => Ok(named(&target)?.show(&fs::read(file)?, &folder)?),
    }
}

/// The table of what is asked.
fn asked(executions: u64) -> Result<(), Box<dyn Error>> {
    let mut columns = Vec::new();
    for target in TARGETS {
        let mut source = Source::new(&seeds::path(target.name), 1)?;
        let tally =
            reached::counted(|| (0..executions).for_each(|_| (target.test)(&source.more())));
        columns.push((target.name.to_owned(), tally));
    }
    for (asked, name) in Asked::ALL {
        let campaign = Campaign {
            claims: Claims::of(asked),
            executions,
            seed: 1,
            kept: 0,
        };
        let mut tally = Tally::NONE;
        let questions = (0..executions).filter_map(|at| campaign.question(at).1);
        questions.for_each(|question| tally.add(&question));
        columns.push((format!("judge: {name}"), tally));
    }
    let mut tally = Tally::NONE;
    suite::own()
        .iter()
        .for_each(|case| tally.add(&case.question));
    columns.push(("suite".to_owned(), tally));
    let row = |first: &str, cells: Vec<String>| println!("| {first} | {} |", cells.join(" | "));
    row(
        "kind",
        columns.iter().map(|(name, _)| name.clone()).collect(),
    );
    println!("|---|{}", "---:|".repeat(columns.len()));
    let questions = columns.iter().map(|(_, tally)| tally.questions.to_string());
    row("questions", questions.collect());
    for (at, (name, _)) in KINDS.iter().enumerate() {
        let share = |tally: &Tally| {
            let tenths = (1000 * tally.kinds[at] + tally.questions / 2) / tally.questions.max(1);
            format!("{}.{}", tenths / 10, tenths % 10)
        };
        row(
            name,
            columns.iter().map(|(_, tally)| share(tally)).collect(),
        );
    }
    Ok(())
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
    for kind in RINGED..=u8::MAX {
        // Rings of a shape alone, of up to 64 points.
        let mut bytes = vec![kind, 0, u8::MAX];
        bytes.extend(random.bytes(64));
        write(folder, &format!("rings_{kind}"), target.after_leads(&bytes))?;
    }
    Ok(())
}

fn write(folder: &Path, name: &str, seeds: Vec<Vec<u8>>) -> std::io::Result<()> {
    for (i, seed) in seeds.into_iter().enumerate() {
        fs::write(folder.join(format!("{name}_{i}")), seed)?;
    }
    Ok(())
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
