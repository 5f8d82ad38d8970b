//! Point clouds of laser scanners, `.las` and `.laz`, with the crate `las`: x and y of each point.
//!
//! A file holds whole numbers of 32 bits, and for each axis a scale and an offset. A coordinate is the double that the
//! crate makes of them.

use std::io::BufReader;
use std::path::Path;

use las::{PointData, PointDataBuilder, Reader};
use sweep_cdt_formats::ReadError;

use crate::input::Input;
use crate::input::file::InputFile;

/// How many points are read at once: a few chunks of a `.laz`, which are unpacked on all cores.
const POINTS: u64 = 1 << 18;

/// A point cloud.
pub(super) struct Cloud {
    file: InputFile,
    reader: Reader,
    points: PointData,
    read: u64,
    count: u64,
}

impl Cloud {
    pub(super) fn open(path: &Path) -> Result<Cloud, ReadError> {
        let file = InputFile::open(path)?;
        let reader = Reader::new(BufReader::new(file.handle()?));
        let reader = reader.map_err(|error| file.error(error.to_string()))?;
        let header = reader.header();
        let (points, count) = (
            PointDataBuilder::new().for_header(header).build(),
            header.number_of_points(),
        );
        Ok(Cloud {
            file,
            reader,
            points,
            read: 0,
            count,
        })
    }
}

impl Input for Cloud {
    fn name(&self) -> &str {
        &self.file.name
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let most = POINTS.min(self.count - self.read);
        if most == 0 {
            return self.file.check();
        }
        let read = self.reader.fill_points(most, &mut self.points);
        let fault = |why: String| {
            let (read, count) = (self.read, self.count);
            self.file
                .error(format!("after point {read} of {count}: {why}"))
        };
        match read {
            Ok(read) if read == most => {}
            Ok(_) => return Err(fault("the file ends".to_owned())),
            Err(error) => return Err(fault(error.to_string())),
        }
        self.read += most;
        let pairs = self.points.x().zip(self.points.y());
        points.extend(pairs.map(|(x, y)| [x, y]));
        Ok(())
    }

    fn next_edges(&mut self, _edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        Ok(())
    }

    /// The share of the points, as bytes.
    fn progress(&self) -> (u64, u64) {
        let each = self.file.length / self.count.max(1);
        (self.read * each, self.count * each)
    }
}
