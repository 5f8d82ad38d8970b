//! Unpacks the seeds of the fuzz targets, so that each begins with them: `seeds/TARGET.hex` has one a line in
//! hexadecimal, `corpus/TARGET` gets a file for each. It runs where the seeds have changed or the corpus is gone.

use std::fs::{self, File};
use std::io::Result;
use std::path::Path;
use std::time::SystemTime;

/// Says that the seeds are there.
const UNPACKED: &str = "corpus/unpacked";

fn main() -> Result<()> {
    println!("cargo::rerun-if-changed=seeds");
    println!("cargo::rerun-if-changed={UNPACKED}");
    for file in fs::read_dir("seeds")? {
        let file = file?.path();
        let target = file.file_stem().expect("a name");
        let folder = Path::new("corpus").join(target);
        fs::create_dir_all(&folder)?;
        for (number, line) in (1..).zip(fs::read_to_string(&file)?.lines()) {
            let digits = line.split('#').next().unwrap_or_default().trim();
            let byte = |at| u8::from_str_radix(&digits[at..at + 2], 16);
            let bytes: std::result::Result<Vec<u8>, _> =
                (0..digits.len()).step_by(2).map(byte).collect();
            let bytes =
                bytes.unwrap_or_else(|error| panic!("{}:{number}: {error}", file.display()));
            fs::write(folder.join(format!("seed_{number:04}")), bytes)?;
        }
    }
    // Cargo runs this again where the file is newer than the run before.
    File::create(UNPACKED)?.set_modified(SystemTime::UNIX_EPOCH)
}
