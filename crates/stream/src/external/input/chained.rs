//! Inputs that follow each other as one, as tiles of a terrain do.
//!
//! Points are numbered on through all of them, and so are edges, which each input numbers by itself. Heights and columns
//! go by their names: where an input lacks one that another has, its points have no number there.
//!
//! An input without edges is let go when its points are over, so that one alone has its buffers in memory.

use std::path::Path;

use sweep_cdt_formats::{Column, CoordinateSystem, ReadError, Remark, quoted};

use crate::external::input::{Input, Part, with_edges};

/// Makes one input of several: points are numbered on through all of them in their order, and each may have edges between
/// its own points. Or a file has the edges of them all, as pairs of whole numbers of 64 bits, little-endian: the numbers of
/// both ends through all inputs, from 0.
///
/// ```
/// use sweep_cdt_stream::external::{Format, Sorting, chained, open};
///
/// # let folder = tempfile::tempdir()?;
/// let tiles = ["1 0 0\n2 1 0\n", "1 2 0\n"].iter().zip(["a.node", "b.node"]).map(|(text, name)| {
///     let path = folder.path().join(name);
///     let count = text.lines().count();
///     std::fs::write(&path, format!("{count} 2 0 0\n{text}")).expect("a folder that is there");
///     open(&path, Format::Node, None)
/// });
/// let mut input = chained(tiles.collect::<Result<_, _>>()?, None)?;
/// let order = Sorting::new(64 << 20, folder.path()).sort(&mut *input)?;
/// assert_eq!(order.summary().points, 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// There is no input, or two have different coordinate systems. There are edges in an input, and the file of edges cannot
/// add any, or it cannot be opened. While points come: a column holds text in some rows of an input, and numbers in
/// another input.
pub fn chained(
    mut inputs: Vec<Box<dyn Input>>,
    edges: Option<&Path>,
) -> Result<Box<dyn Input>, ReadError> {
    if inputs.len() == 1 {
        return with_edges(inputs.remove(0), edges);
    }
    if inputs.is_empty() {
        return Err(ReadError::of_file("", "there is no input"));
    }
    let systems = inputs.iter().map(|input| (input.name(), input.system()));
    let chained = Chained {
        system: CoordinateSystem::of_all(systems)?,
        has_heights: inputs.iter().any(|input| input.has_heights()),
        reads_heights: inputs.iter().any(|input| input.heights().is_some()),
        begins: vec![[0, 0]],
        at: 0,
        are_points_read: false,
        come: [0, 0],
        missing: Vec::new(),
        columns: Vec::new(),
        lost: Vec::new(),
        seen: Vec::new(),
        inputs,
    };
    with_edges(Box::new(chained), edges)
}

struct Chained {
    inputs: Vec<Box<dyn Input>>,
    /// The numbers of the first point and the first edge of each input that is begun.
    begins: Vec<[u64; 2]>,
    /// The input that is read.
    at: usize,
    are_points_read: bool,
    /// How many points and edges have come.
    come: [u64; 2],
    system: Option<CoordinateSystem>,
    has_heights: bool,
    reads_heights: bool,
    /// Heights of the points that came last, where their input has none.
    missing: Vec<f64>,
    /// The columns of the inputs that are over, without values.
    columns: Vec<Column>,
    /// Columns that held numbers in some rows of an input, and text in others, each with the place of the input.
    lost: Vec<(String, usize)>,
    /// Columns that held numbers in some rows of the input that is read.
    seen: Vec<String>,
}

impl Chained {
    fn input(&self) -> &dyn Input {
        // Behind the last input the last one is named.
        &*self.inputs[self.at.min(self.inputs.len() - 1)]
    }

    /// Goes on behind an input whose points are over.
    fn end_points(&mut self) -> Result<(), ReadError> {
        let input = &self.inputs[self.at];
        let names = input.columns().iter().map(|column| &column.name);
        let names: Vec<String> = names.cloned().collect();
        let lost = self.seen.drain(..).filter(|name| !names.contains(name));
        self.lost.extend(lost.map(|name| (name, self.at)));
        for name in names {
            let is_new = self.columns.iter().all(|column| column.name != name);
            self.columns.extend(is_new.then_some(Column {
                name,
                values: Vec::new(),
            }));
        }
        // Markers are the last column where a format has them.
        let columns = &mut self.columns;
        columns.sort_by_key(|column| column.name == Column::MARKER);
        if let Some((name, at)) = self.lost.iter().find(|(name, _)| has(columns, name)) {
            let message = format!(
                "the column {} has text in some rows, and numbers in another input",
                quoted(name.as_bytes())
            );
            return Err(ReadError::of_file(self.inputs[*at].name(), message));
        }
        if !input.has_edges() {
            self.inputs[self.at] = Box::new(Over::of(&**input));
        }
        self.at += 1;
        if self.at < self.inputs.len() {
            self.begins.push([self.come[0], 0]);
        }
        Ok(())
    }
}

fn has(columns: &[Column], name: &str) -> bool {
    columns.iter().any(|column| column.name == name)
}

impl Input for Chained {
    /// The file that is read now.
    fn name(&self) -> &str {
        self.input().name()
    }

    fn part(&self) -> Part {
        let Part {
            points,
            edges,
            first,
        } = self.input().part();
        let at = self.at.min(self.begins.len() - 1);
        let [begin, first_edge] = self.begins[at];
        let end = match self.begins.get(at + 1) {
            Some(&[next, _]) => next,
            None if self.are_points_read => self.come[0],
            None => u64::MAX,
        };
        Part {
            points: begin + points.start..end.min(begin.saturating_add(points.end)),
            edges: first_edge + edges,
            first,
        }
    }

    fn edge(&self, number: u64) -> (String, u64) {
        let mut begins = self.begins.iter().take(self.at + 1).zip(&self.inputs);
        let of = begins.rfind(|([_, first], _)| *first <= number);
        match of {
            Some((&[_, first], input)) => input.edge(number - first),
            None => (self.name().to_owned(), number),
        }
    }

    fn inputs(&self) -> &[Box<dyn Input>] {
        &self.inputs
    }

    fn next_points(&mut self, points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        while let Some(input) = self.inputs.get_mut(self.at) {
            let before = points.len();
            input.next_points(points)?;
            let come = points.len() - before;
            if come > 0 {
                self.come[0] += come as u64;
                for column in input.columns() {
                    if !self.seen.contains(&column.name) {
                        self.seen.push(column.name.clone());
                    }
                }
                self.missing.clear();
                if self.reads_heights && input.heights().is_none() {
                    self.missing.resize(come, f64::NAN);
                }
                return Ok(());
            }
            self.end_points()?;
        }
        Ok(())
    }

    fn heights(&self) -> Option<&[f64]> {
        let heights = self.input().heights();
        heights.or(self.reads_heights.then_some(&self.missing))
    }

    fn columns(&self) -> &[Column] {
        match self.inputs.get(self.at) {
            Some(input) if !self.are_points_read => input.columns(),
            _ => &self.columns,
        }
    }

    fn has_edges(&self) -> bool {
        self.inputs.iter().any(|input| input.has_edges())
    }

    fn next_edges(&mut self, edges: &mut Vec<[u64; 2]>) -> Result<(), ReadError> {
        if !self.are_points_read {
            (self.at, self.are_points_read) = (0, true);
        }
        while let Some(input) = self.inputs.get_mut(self.at) {
            let before = edges.len();
            input.next_edges(edges)?;
            let begin = self.begins[self.at][0];
            for end in edges[before..].as_flattened_mut() {
                *end = end.saturating_add(begin);
            }
            let come = edges.len() - before;
            if come > 0 {
                self.come[1] += come as u64;
                return Ok(());
            }
            self.at += 1;
            if let Some([_, first_edge]) = self.begins.get_mut(self.at) {
                *first_edge = self.come[1];
            }
        }
        Ok(())
    }

    fn remarks(&self) -> Vec<Remark> {
        self.inputs
            .iter()
            .flat_map(|input| input.remarks())
            .collect()
    }

    fn has_heights(&self) -> bool {
        self.has_heights
    }

    fn system(&self) -> Option<CoordinateSystem> {
        self.system.clone()
    }

    fn progress(&self) -> (u64, u64) {
        let all = self.inputs.iter().map(|input| input.progress());
        all.fold((0, 0), |sum, one| (sum.0 + one.0, sum.1 + one.1))
    }
}

/// The knowledge of an input that is over, for messages.
struct Over {
    name: String,
    part: Part,
    remarks: Vec<Remark>,
    progress: (u64, u64),
}

impl Over {
    fn of(input: &dyn Input) -> Over {
        Over {
            name: input.name().to_owned(),
            part: input.part(),
            remarks: input.remarks(),
            progress: input.progress(),
        }
    }
}

impl Input for Over {
    fn name(&self) -> &str {
        &self.name
    }

    fn part(&self) -> Part {
        self.part.clone()
    }

    fn next_points(&mut self, _points: &mut Vec<[f64; 2]>) -> Result<(), ReadError> {
        Ok(())
    }

    fn has_edges(&self) -> bool {
        false
    }

    fn remarks(&self) -> Vec<Remark> {
        self.remarks.clone()
    }

    fn progress(&self) -> (u64, u64) {
        self.progress
    }
}
