//! Measuring: a cell, which is an input on which all variants run, and the rows that they give.

mod cachegrind;
mod row;
mod triangle;
mod variant;
mod watched;

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::thread::available_parallelism;

use sweep_cdt_generate::Kind;
use sweep_cdt_testing::{Input, Random, data};

pub(crate) use row::{Row, Turn, median};
pub(crate) use triangle::TRIANGLE;
pub(crate) use variant::Variant;

/// Where the points come from.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    Kind(Kind),
    /// A `.poly` file.
    File(PathBuf),
}

/// An input, before it is made.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    pub(crate) source: Source,
    /// Points asked for; 0 for a file, which has as many as it has.
    pub(crate) size: usize,
    /// Of the random numbers of a kind. A file has eight: its images under the symmetries of the square, whose sweeps
    /// meet the points in other orders; the first is the file as it is.
    pub(crate) seed: u64,
}

/// A variant whose time grows with the length of the front is left out where points times the mean length
/// exceed this.
const LONGEST: f64 = 1e9;

impl Cell {
    /// The name of the data.
    pub(crate) fn data(&self) -> String {
        match &self.source {
            Source::Kind(kind) => kind.name.to_owned(),
            Source::File(path) => {
                let stem = path.file_stem().unwrap_or_default();
                stem.to_string_lossy().into_owned()
            }
        }
    }

    /// The input.
    pub(crate) fn input(&self) -> Input {
        match &self.source {
            Source::Kind(kind) => kind.graph(self.size, self.seed).into(),
            Source::File(path) => {
                let mut input = data::poly(path);
                let image = self.seed.wrapping_sub(1);
                let sign = |bit: u64| if image & bit == 0 { 1.0 } else { -1.0 };
                for [x, y] in &mut input.points {
                    (*x, *y) = (sign(2) * *x, sign(4) * *y);
                    if image & 1 != 0 {
                        (*x, *y) = (*y, *x);
                    }
                }
                input
            }
        }
    }

    /// Runs all variants once, to count, and as often as asked for in a random order for the time.
    ///
    /// # Errors
    /// If a variant cannot triangulate the input, or two differ in the result.
    pub(crate) fn run(
        &self,
        variants: &[Variant],
        repetitions: usize,
        commit: &str,
    ) -> Result<Vec<Row>, Box<dyn Error>> {
        let input = self.input();
        let mut rows: Vec<Row> = Vec::new();
        for variant in variants {
            let row = self.count(variant, &input, &rows)?;
            rows.push(row);
        }
        let processor = processor();
        for turn in 0..repetitions {
            // In another order each time: what ran before leaves caches and memory behind.
            let mut order: Vec<usize> = (0..variants.len()).collect();
            Random::new(self.seed << 32 | turn as u64).shuffle(&mut order);
            for i in order {
                let row = &mut rows[i];
                if !row.is_left_out {
                    row.turns.push(Turn {
                        data: row.data.clone(),
                        size: row.size,
                        seed: row.seed,
                        variant: row.variant.clone(),
                        turn,
                        commit: commit.to_owned(),
                        processor: processor.clone(),
                        ..variants[i].time(&input)?
                    });
                }
            }
        }
        Ok(rows)
    }

    /// The row of a variant without its times; `before` are those of others on the same input.
    fn count(
        &self,
        variant: &Variant,
        input: &Input,
        before: &[Row],
    ) -> Result<Row, Box<dyn Error>> {
        let mut row = Row {
            data: self.data(),
            size: self.size,
            seed: self.seed,
            variant: variant.name.clone(),
            points: input.points.len(),
            edges: input.edges.len(),
            ..Row::default()
        };
        let counted = before.iter().find(|row| !row.is_left_out);
        let longest = counted.map_or(0.0, |row| row.points as f64 * row.front_mean);
        if variant.is_linear && longest > LONGEST {
            row.is_left_out = true;
            return Ok(row);
        }
        variant.count(input, &mut row)?;
        // What another program answers is verified instead.
        let differs = |other: &&Row| !row.result.is_empty() && other.result != row.result;
        if let Some(other) = counted.filter(differs) {
            let (here, there) = (&row.variant, &other.variant);
            return Err(format!("{}: {here} and {there} differ in the result", row.data).into());
        }
        Ok(row)
    }
}

/// The processor, as far as it can be told.
pub(crate) fn processor() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = info.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_owned())
    });
    let cores = available_parallelism().map_or(1, usize::from);
    let model = model.unwrap_or_else(|| "an unknown processor".to_owned());
    format!("{model}, {cores} cores")
}

#[cfg(test)]
mod tests {
    use super::{Cell, Source, Variant};
    use sweep_cdt_generate::KINDS;

    const CELL: Cell = Cell {
        source: Source::Kind(KINDS[0]),
        size: 10,
        seed: 1,
    };

    #[test]
    fn variants_that_differ_in_the_result_are_an_error() {
        let [one, two] = ["one", "two"].map(|result| Variant::pretended(result, 9.0, false));
        let error = CELL.run(&[one, two], 1, "").expect_err("they differ");
        assert_eq!(
            error.to_string(),
            "uniform: two and one differ in the result"
        );
    }

    #[test]
    fn what_would_take_very_long_is_left_out() {
        for (front_mean, expected) in [(999.0, [false, false]), (1001.0, [false, true])] {
            let variants =
                [false, true].map(|linear| Variant::pretended("same", front_mean, linear));
            let rows = CELL.run(&variants, 3, "").expect("they agree");
            assert_eq!([0, 1].map(|i| rows[i].is_left_out), expected);
            let repetitions = expected.map(|is_left_out| if is_left_out { 0 } else { 3 });
            assert_eq!([0, 1].map(|i| rows[i].turns.len()), repetitions);
            // What was not run knows its input, which has ten points.
            assert_eq!(rows[1].points == 10, expected[1]);
        }
    }
}
