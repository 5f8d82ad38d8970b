//! A number that means that there is none, in heights and columns.

use sweep_cdt_formats::{Column, CoordinateSystem, ReadError, Remark};

use crate::external::input::{Input, Part};

/// An input in which a number means that there is none. Markers keep theirs.
pub(super) struct NoValue {
    input: Box<dyn Input>,
    value: f64,
    /// The heights and columns of the points that came last.
    heights: Option<Vec<f64>>,
    columns: Vec<Column>,
    /// How many numbers were that, in heights, and in each column that has come.
    in_heights: usize,
    in_columns: Vec<(String, usize)>,
    is_over: bool,
}

impl NoValue {
    pub(super) fn new(input: Box<dyn Input>, value: f64) -> NoValue {
        NoValue {
            heights: input.heights().map(<[f64]>::to_vec),
            columns: input.columns().to_vec(),
            input,
            value,
            in_heights: 0,
            in_columns: Vec::new(),
            is_over: false,
        }
    }
}

/// Takes this value out of numbers, and returns how many were that.
fn take_out(value: f64, numbers: &mut [f64]) -> usize {
    let are = numbers
        .iter_mut()
        .filter(|number| (**number - value).abs() == 0.0);
    are.map(|number| *number = f64::NAN).count()
}

impl Input for NoValue {
    fn name(&self) -> &str {
        self.input.name()
    }

    fn part(&self) -> Part {
        self.input.part()
    }

    fn edge(&self, number: u64) -> (String, u64) {
        self.input.edge(number)
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        let before = points.len();
        self.input.next_points(points)?;
        self.is_over = points.len() == before;
        self.heights = self.input.heights().map(<[f64]>::to_vec);
        if let Some(heights) = &mut self.heights {
            self.in_heights += take_out(self.value, heights);
        }
        self.columns = self.input.columns().to_vec();
        for column in &mut self.columns {
            if column.name == Column::MARKER {
                continue;
            }
            let count = take_out(self.value, &mut column.values);
            let mut counts = self.in_columns.iter_mut();
            match counts.find(|(name, _)| *name == column.name) {
                Some((_, all)) => *all += count,
                None => self.in_columns.push((column.name.clone(), count)),
            }
        }
        Ok(())
    }

    fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    fn columns(&self) -> &[Column] {
        &self.columns
    }

    fn has_edges(&self) -> bool {
        self.input.has_edges()
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        self.input.next_edges(edges)
    }

    fn remarks(&self) -> Vec<Remark> {
        let mut remarks = self.input.remarks();
        // A column of which some piece holds text is none.
        let names = || self.columns.iter().map(|column| &column.name);
        let counts = self.in_columns.iter();
        let in_columns = counts.filter(|(name, _)| names().any(|column| column == name));
        if self.is_over && (self.heights.is_some() || !self.columns.is_empty()) {
            remarks.push(Remark::NoValue {
                value: self.value,
                count: self.in_heights + in_columns.map(|(_, count)| count).sum::<usize>(),
            });
        }
        remarks
    }

    fn has_heights(&self) -> bool {
        self.input.has_heights()
    }

    fn system(&self) -> Option<CoordinateSystem> {
        self.input.system()
    }

    fn progress(&self) -> (u64, u64) {
        self.input.progress()
    }
}
