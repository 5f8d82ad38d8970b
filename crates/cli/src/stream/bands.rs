//! `sweep-cdt stream --band`: the sorted vertices cut into bands, a file for each.
//!
//! Each file is in its place before the next one is begun, and a run that is repeated writes the same files again. Bands
//! say which vertices they have of how many. So nobody takes some of them for all, and bands of another cut do not fit.

use std::fs;
use std::io::Write;
use std::path::Path;

use sweep_cdt_stream::Rest;
use sweep_cdt_stream::external::Bands;

use super::{StreamCommand, to_usize};
use crate::shared::failure::Failure;
use crate::shared::files::FileArgument;
use crate::shared::outputs::{Destination, Outputs, refuse_read};
use crate::shared::resources::Progress;

impl StreamCommand {
    /// Cuts the input into bands of so many vertices.
    pub(super) fn cut(&self, size: u64) -> Result<(), Failure> {
        let Some(folder) = self.output.as_ref().and_then(FileArgument::path) else {
            let message = "bands are files: let OUTPUT be the folder for them";
            return Err(Failure::Usage(message.to_owned()));
        };
        let read = self.sort.files(&self.inputs, self.strict);
        let mut sorted = self
            .sort
            .sorted(&self.inputs, self.choice(false), |name, remarks| {
                read.say(name, remarks)
            })?;
        fs::create_dir_all(folder).map_err(|error| Failure::of_file(folder, &error))?;
        let bands = Bands::new(&mut sorted.order, size);
        let mut bands = bands.map_err(|error| self.sort.failure(&error))?;
        let most = bands.most();
        // As many digits as the last one has, so that their names are sorted as they are.
        let digits = most.to_string().len();
        refuse_others(folder, digits, most)?;
        let mut progress = Progress::new("writing bands");
        for number in 1.. {
            let band = bands.next_band();
            let Some(band) = band.map_err(|error| self.sort.failure(&error))? else {
                break;
            };
            let path = folder.join(format!("{number:0digits$}.rest"));
            let destination = Destination::of_path(path)?;
            refuse_read(&read, [&destination])?;
            let mut outputs = Outputs::default();
            let rest = Rest::from(band).to_bytes();
            outputs.add(destination, move |out| out.write_all(&rest))?;
            outputs.finish()?;
            progress.show(number, to_usize(most));
        }
        Ok(())
    }
}

/// Refuses a folder with bands that this cut does not write again: nobody could tell them from its own.
fn refuse_others(folder: &Path, digits: usize, most: u64) -> Result<(), Failure> {
    let failure = |error| Failure::of_file(folder, &error);
    for entry in fs::read_dir(folder).map_err(failure)? {
        let name = entry.map_err(failure)?.file_name();
        let Some(number) = name.to_str().and_then(|name| name.strip_suffix(".rest")) else {
            continue;
        };
        let is_written = |number: u64| (1..=most).contains(&number);
        if number.len() != digits || !number.parse().is_ok_and(is_written) {
            return Err(Failure::Error(format!(
                "{} is there, and no band of this cut: remove it, or let OUTPUT be another folder",
                folder.join(&name).display()
            )));
        }
    }
    Ok(())
}
