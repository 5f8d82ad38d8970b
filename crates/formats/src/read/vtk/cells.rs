//! What VTK's formats say of cells: the markers of lines and the regions of triangles.

use crate::Column;
use crate::graph_file::whole;
use crate::read::mesh::Cells;
use crate::read::remarks::Remarks;

/// Numbers for the cells of a file, and which lines and triangles each cell became.
#[derive(Default)]
pub(crate) struct CellData {
    /// How many lines and triangles there are after each cell.
    ends: Vec<[usize; 2]>,
    /// Of each cell, if the file has them.
    markers: Option<Vec<f64>>,
    regions: Option<Vec<f64>>,
}

impl CellData {
    /// The name of the regions.
    pub(crate) const REGION: &str = "region";

    /// Whether numbers of this name are read.
    pub(crate) fn is_read(name: &[u8]) -> bool {
        [Column::MARKER, CellData::REGION]
            .map(str::as_bytes)
            .contains(&name)
    }

    /// Ends a cell: it became what the lists have more than before.
    pub(crate) fn end_cell(&mut self, cells: &Cells) {
        self.ends
            .push([cells.lines.len(), cells.faces.triangles.len()]);
    }

    /// Adds the numbers of all cells under a name that is read.
    pub(crate) fn add(&mut self, name: &[u8], numbers: Vec<f64>) {
        if name == Column::MARKER.as_bytes() {
            self.markers = Some(numbers);
        } else {
            self.regions = Some(numbers);
        }
    }

    /// The lines with their markers, and the triangles with their regions. Numbers that are too few or too many, and
    /// markers that are not whole, are ignored with a remark.
    pub(crate) fn given_to(self, mut cells: Cells, remarks: &mut Remarks) -> Cells {
        let CellData {
            ends,
            markers,
            regions,
        } = self;
        let spread = |numbers: Option<Vec<f64>>, which: usize| {
            let numbers = numbers?;
            let mut list = Vec::new();
            for (ends, number) in ends.iter().zip(&numbers) {
                list.resize(ends[which], *number);
            }
            (numbers.len() == ends.len()).then_some(list)
        };
        let mut expect = |name: &str, is_there: bool, is_read: bool| {
            let lost = usize::from(is_there && !is_read);
            remarks.ignore_named(lost, ["array of cells", "arrays of cells"], name.as_bytes());
        };
        let is_there = [&markers, &regions].map(Option::is_some);
        let markers = spread(markers, 0).and_then(|list| list.into_iter().map(whole).collect());
        let regions = spread(regions, 1);
        expect(Column::MARKER, is_there[0], markers.is_some());
        expect(CellData::REGION, is_there[1], regions.is_some());
        cells.markers = markers.unwrap_or_default();
        cells.regions = regions.unwrap_or_default();
        cells
    }
}
