//! Point clouds of laser scanners, `.las` and `.laz`, read in pieces.

use std::io::BufReader;

use sweep_cdt_formats::{Cloud as Points, CoordinateSystem, ReadError, Remark};

use crate::external::input::file::InputFile;
use crate::external::input::{Choice, Input};

/// A point cloud.
pub(super) struct Cloud {
    file: InputFile,
    points: Points,
    /// The points that came last, and their heights, if they are asked for.
    places: Vec<[f64; 3]>,
    heights: Option<Vec<f64>>,
}

impl Cloud {
    pub(super) fn new(file: InputFile, choice: &Choice) -> Result<Cloud, ReadError> {
        let read = BufReader::new(file.handle()?);
        let mut points = Points::open(&file.name, read, file.length, &choice.classes)?;
        if choice.may_lack_classes {
            points = points.that_may_lack_them();
        }
        Ok(Cloud {
            points,
            file,
            places: Vec::new(),
            heights: choice.heights.then(Vec::new),
        })
    }
}

impl Input for Cloud {
    fn name(&self) -> &str {
        &self.file.name
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        self.places.clear();
        let come = self.points.next_points(&mut self.places)?;
        points.extend(self.places.iter().map(|&[x, y, _]| [x, y]));
        if let Some(heights) = &mut self.heights {
            heights.clear();
            heights.extend(self.places.iter().map(|&[.., z]| z));
        }
        match come {
            0 => self.file.check(),
            _ => Ok(()),
        }
    }

    fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    fn has_edges(&self) -> bool {
        false
    }

    fn remarks(&self) -> Vec<Remark> {
        self.points.remarks(self.heights.is_some())
    }

    fn has_heights(&self) -> bool {
        true
    }

    fn system(&self) -> Option<CoordinateSystem> {
        self.points.system()
    }

    /// The share of the points, as bytes.
    fn progress(&self) -> (u64, u64) {
        let (read, count) = self.points.progress();
        let each = self.file.length / count.max(1);
        (read * each, count * each)
    }
}
