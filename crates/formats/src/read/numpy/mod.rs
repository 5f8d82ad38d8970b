//! Arrays of NumPy: one in a `.npy`, or several with names in a `.npz`, which is an archive of `.npy`.
//!
//! | array | in `.npz` called | shape |
//! |---|---|---|
//! | points; in a `.npy` as input | `points` or `vertices` | (n, 2); a third column is z, others are columns |
//! | edges | `edges` or `segments` | (m, 2), numbered from 0 |
//! | triangles; in a `.npy` as result | `triangles`, `simplices` or `faces` | (t, 3), or (3t,) |
//! | seeds of holes | `holes` | (h, 2) |
//! | seeds of regions | `regions` | (r, 3): the third column is the attribute; (r, 4): the fourth the greatest area, which only refinement takes |
//!
//! Other arrays are ignored with a remark. What is packed in an archive is unpacked behind a copy of the file, within the limit that
//! [`Source::unpacked_limit`] sets, and the sums of the archive are checked.

mod npy;

use std::borrow::Cow;
use std::io::{self, Read};
use std::ops::Range;

use miniz_oxide::inflate::decompress_to_vec_with_limit;
use rawzip::{CompressionMethod, ZipArchive, ZipArchiveEntryWayfinder};

use crate::Column;
use crate::read::content::{Corners, Edges, Field, Labels, Vertices};
use crate::read::mesh::{Cells, Mesh};
use crate::read::numpy::npy::Array;
use crate::read::remarks::Remarks;
use crate::read::source::{ReadError, ReadErrorKind, Source, quoted};

const POINTS: &[&str] = &["points", "vertices"];
const EDGES: &[&str] = &["edges", "segments"];
const TRIANGLES: &[&str] = &["triangles", "simplices", "faces"];
const HOLES: &[&str] = &["holes"];
const REGIONS: &[&str] = &["regions"];

/// The arrays of a file that are read, by name.
pub(super) struct Arrays<'a> {
    source: Cow<'a, Source>,
    list: Vec<(String, Array)>,
    /// The names of members that are not read.
    others: Vec<String>,
}

impl<'a> Arrays<'a> {
    /// The points of a `.npy`.
    pub(super) fn of_points(source: &'a Source) -> Result<Arrays<'a>, ReadError> {
        Arrays::of_one(source, POINTS[0])
    }

    /// The triangles of a `.npy`.
    pub(super) fn of_triangles(source: &'a Source) -> Result<Arrays<'a>, ReadError> {
        Arrays::of_one(source, TRIANGLES[0])
    }

    fn of_one(source: &'a Source, name: &str) -> Result<Arrays<'a>, ReadError> {
        if source.bytes.starts_with(b"PK") {
            let message = "it is an archive of arrays: call it .npz";
            return Err(ReadError::of_file(&source.name, message));
        }
        let array = Array::of(&source.bytes, 0..source.bytes.len());
        let array = array.map_err(|what| ReadError::of_file(&source.name, what))?;
        Ok(Arrays {
            source: Cow::Borrowed(source),
            list: vec![(name.to_owned(), array)],
            others: Vec::new(),
        })
    }

    /// The arrays of a `.npz` that have any of the names above.
    pub(super) fn of_archive(source: &'a Source) -> Result<Arrays<'a>, ReadError> {
        let error = |what: &dyn std::fmt::Display| {
            ReadError::of_file(&source.name, format!("the archive is not read: {what}"))
        };
        let archive = ZipArchive::from_slice(&source.bytes).map_err(|e| error(&e))?;
        let known = [POINTS, EDGES, TRIANGLES, HOLES, REGIONS].concat();
        let (mut members, mut others) = (Vec::new(), Vec::new());
        let mut entries = archive.entries();
        while let Some(entry) = entries.next_entry().map_err(|e| error(&e))? {
            let path = entry.file_path();
            let name = path.as_bytes().strip_suffix(b".npy");
            let name = String::from_utf8_lossy(name.unwrap_or_default()).into_owned();
            if known.contains(&name.as_str()) {
                let method = entry.compression_method();
                members.push((name, method, entry.wayfinder()));
            } else {
                others.push(String::from_utf8_lossy(path.as_bytes()).into_owned());
            }
        }
        if members.is_empty() {
            let message = format!(
                "there is no array `points`, `edges` or `triangles`, only {}: name them, as in \
                 numpy.savez(file, points=a, edges=b)",
                others
                    .iter()
                    .take(8)
                    .map(|name| quoted(name.as_bytes()))
                    .collect::<Vec<_>>()
                    .join(", ")
            );
            return Err(ReadError::of_file(&source.name, message));
        }
        let mut arrays = Arrays {
            source: Cow::Borrowed(source),
            list: Vec::new(),
            others,
        };
        for (name, method, place) in members {
            let entry = archive.get_entry(place).map_err(|e| error(&e))?;
            let packed = entry.data();
            let range = match method {
                CompressionMethod::STORE => {
                    let begin = packed.as_ptr().addr() - source.bytes.as_ptr().addr();
                    begin..begin + packed.len()
                }
                CompressionMethod::DEFLATE => arrays.unpack(source, &name, place, packed)?,
                other => {
                    let message = format!("`{name}` is packed by method {}", other.as_u16());
                    return Err(error(&message));
                }
            };
            let unpacked = &arrays.source.bytes[range.clone()];
            let mut sums = entry.verifying_reader(unpacked);
            io::copy(&mut sums.by_ref(), &mut io::sink())
                .map_err(|e| error(&format!("`{name}`: {e}")))?;
            let array = Array::of(&arrays.source.bytes, range);
            let array = array.map_err(|what| of_array(source, &name, &what))?;
            arrays.list.push((name, array));
        }
        Ok(arrays)
    }

    /// Unpacks a member behind the copy of the file; returns its place.
    fn unpack(
        &mut self,
        source: &Source,
        name: &str,
        place: ZipArchiveEntryWayfinder,
        packed: &[u8],
    ) -> Result<Range<usize>, ReadError> {
        let begin = self.source.bytes.len();
        let limit = source.most_unpacked();
        let room = limit.saturating_sub((begin - source.bytes.len()) as u64);
        let size = place.uncompressed_size_hint();
        if size > room {
            return Err(ReadError {
                kind: ReadErrorKind::UnpackedLimit { limit },
                ..of_array(
                    source,
                    name,
                    &format!(
                        "with its {size} bytes the file would unpack to more than the limit of {limit} bytes"
                    ),
                )
            });
        }
        let wrong = || {
            let what = format!("it does not unpack to the {size} bytes that the archive says");
            of_array(source, name, &what)
        };
        let size = usize::try_from(size).map_err(|_| wrong())?;
        let unpacked = decompress_to_vec_with_limit(packed, size).map_err(|_| wrong())?;
        let bytes = &mut self.source.to_mut().bytes;
        bytes.extend(unpacked);
        Ok(begin..bytes.len())
    }

    /// The points and the edges.
    pub(super) fn graph(&self) -> Result<Edges<'_>, ReadError> {
        let points = self.array(POINTS)?;
        let (name, points) = points.ok_or_else(|| {
            let message =
                "there is no array `points`, and the names of others say nothing of points";
            ReadError::of_file(&self.source.name, message)
        })?;
        let vertices = self.vertices(name, points, "(n, 2), or (n, 3) with z")?;
        let mut cells = Cells::default();
        if let Some((name, edges)) = self.array(EDGES)? {
            cells.lines = self.corners(name, edges, "(m, 2)")?;
        }
        if let Some((name, triangles)) = self.array(TRIANGLES)? {
            cells.faces.triangles = self.corners(name, triangles, "(t, 3)")?;
        }
        let mut remarks = Remarks::default();
        for name in &self.others {
            remarks.ignore_named(1, ["array", "arrays"], name.as_bytes());
        }
        let mesh = Mesh {
            vertices,
            cells,
            first: 0,
            remarks,
        };
        let mut graph = mesh.into_graph()?;
        if let Some((name, holes)) = self.array(HOLES)? {
            graph.holes = self.vertices(name, holes, "(h, 2)")?;
        }
        if let Some((name, regions)) = self.array(REGIONS)? {
            graph.regions = self.vertices(name, regions, "(r, 3)")?;
            let columns = graph.regions.columns()?;
            let mut columns = columns.into_iter().map(|column| column.values);
            graph.attributes = columns.next().unwrap_or_default();
            graph.areas = columns.next().unwrap_or_default();
            if graph.attributes.len() != graph.regions.coordinates.len() {
                return Err(self.shape(name, regions, "(r, 3)"));
            }
        }
        Ok(graph)
    }

    /// The triangles, and the points if there are any.
    pub(super) fn triangles(&self) -> Result<Corners<'_>, ReadError> {
        let (name, array) = self.array(TRIANGLES)?.ok_or_else(|| {
            let message = "there is no array `triangles`, `simplices` or `faces`";
            ReadError::of_file(&self.source.name, message)
        })?;
        let triangles = self.corners(name, array, "(t, 3)")?;
        let vertices = match self.array(POINTS)? {
            Some((name, points)) => Some(self.vertices(name, points, "(n, 2) or (n, 3)")?),
            None => None,
        };
        Ok(Corners {
            triangles,
            first: 0,
            first_vertex: 0,
            vertices,
            is_soup: false,
            labels: Labels::Nothing,
        })
    }

    /// The array that has one of these names.
    fn array(&self, names: &[&str]) -> Result<Option<(&str, &Array)>, ReadError> {
        let is_it = |(name, _): &&(String, Array)| names.contains(&name.as_str());
        let mut found = self.list.iter().filter(is_it);
        let first = found.next();
        match (first, found.next()) {
            (Some((one, _)), Some((other, _))) => {
                let message = format!("both `{one}` and `{other}` are there, which mean the same");
                Err(ReadError::of_file(&self.source.name, message))
            }
            _ => Ok(first.map(|(name, array)| (name.as_str(), array))),
        }
    }

    /// Points with their further columns.
    fn vertices(&self, name: &str, array: &Array, shape: &str) -> Result<Vertices<'_>, ReadError> {
        let bytes = &self.source.bytes;
        let size = array.matrix().filter(|[_, columns]| *columns >= 2);
        let size = size.ok_or_else(|| self.shape(name, array, shape))?;
        let [rows, columns] = size;
        let exact = array.expect_doubles(bytes);
        exact.map_err(|what| of_array(&self.source, name, &what))?;
        let piece = |row, column| array.piece(bytes, size, row, column);
        let fields = (2..columns).map(|column| Field {
            name: match column {
                2 => Column::HEIGHT.to_owned(),
                _ => format!("column{}", column + 1),
            },
            syntax: array.syntax(),
            pieces: (0..rows).map(|row| piece(row, column)).collect(),
        });
        let coordinates = (0..rows).map(|row| [piece(row, 0), piece(row, 1)]);
        Ok(Vertices {
            syntax: array.syntax(),
            // A row without numbers takes no bytes, so that there may be any number of columns.
            fields: if rows == 0 {
                Vec::new()
            } else {
                fields.collect()
            },
            ..Vertices::plain(&self.source, coordinates.collect(), 0)
        })
    }

    /// The numbers of vertices in an array of so many columns.
    fn corners<const N: usize>(
        &self,
        name: &str,
        array: &Array,
        shape: &str,
    ) -> Result<Vec<[usize; N]>, ReadError> {
        let of_matrix = array
            .matrix()
            .filter(|&[rows, columns]| columns == N || rows == 0);
        let of_list = || array.list().filter(|count| N == 3 && count % N == 0);
        let size = of_matrix.or_else(|| Some([of_list()? / N, N]));
        let size = size.ok_or_else(|| self.shape(name, array, shape))?;
        let [rows, _] = size;
        let mut list = Vec::with_capacity(rows);
        for row in 0..rows {
            let mut corners = [0; N];
            for (column, corner) in corners.iter_mut().enumerate() {
                let piece = array.piece(&self.source.bytes, size, row, column);
                *corner = array.syntax().index(piece).ok_or_else(|| {
                    let text = array.syntax().text(piece);
                    let what = format!("{text} in row {row} is not a vertex's number");
                    of_array(&self.source, name, &what)
                })?;
            }
            list.push(corners);
        }
        Ok(list)
    }

    /// The fault of an array with another shape than this.
    fn shape(&self, name: &str, array: &Array, shape: &str) -> ReadError {
        let what = format!("the shape is {}, and {shape} is read", array.shape());
        of_array(&self.source, name, &what)
    }
}

fn of_array(source: &Source, name: &str, what: &str) -> ReadError {
    ReadError::of_file(&source.name, format!("the array `{name}`: {what}"))
}
