//! What a stream writes: raw numbers, or a file that says first how many triangles follow. That is known last, so the
//! beginning is written again at the end, with as many bytes as before.

use std::io::{self, Write};
use std::path::Path;

use sweep_cdt_formats::{Column, StreamCertificate, one_word};
use sweep_cdt_stream::Final;
use sweep_cdt_stream::external::Summary;

use super::beside::Beside;
use super::numbers::Width;
use super::order::Sorted;
use super::{Trouble, to_usize};
use crate::shared::failure::Failure;
use crate::shared::files::FileArgument;
use crate::shared::outputs::{Destination, Out};
use crate::shared::resources::Progress;

/// How triangles are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Numbers(Width),
    /// Triangle's `.ele`.
    Ele,
    /// Stanford's binary format, which has the points too.
    Ply,
    /// Points, edges, triangles and hints for the proved checker.
    Certificate,
}

impl Format {
    /// Of an output; standard output gets numbers of 64 bits.
    pub(super) fn of_output(file: &FileArgument) -> Result<Format, Failure> {
        let Some(path) = file.path() else {
            return Ok(Format::Numbers(Width::Eight));
        };
        let extension = path.extension().and_then(|extension| extension.to_str());
        match extension {
            Some("ele") => Ok(Format::Ele),
            Some("ply") => Ok(Format::Ply),
            Some("cert") => Ok(Format::Certificate),
            _ => Width::of_path(path).map(Format::Numbers).ok_or_else(|| {
                let name = path.display();
                let message = format!(
                    "{name} is no name for triangles of a stream: let it end in .u32, .u64, .ele, .ply or .cert"
                );
                Failure::Usage(message)
            }),
        }
    }

    /// Refuses what cannot be written so: to this place, or beside a file of vertices.
    pub(super) fn suits(
        self,
        destination: &Destination,
        has_vertices: bool,
    ) -> Result<(), Failure> {
        let message = match self {
            Format::Ply if has_vertices => {
                "a .ply has its vertices itself, as the input numbers them: let OUTPUT beside --vertices end in .u32, .u64 \
                 or .ele"
            }
            Format::Ele | Format::Ply if !destination.is_file() => {
                "a .ele or .ply begins with the number of triangles, which is known last: let OUTPUT be a file"
            }
            _ => return Ok(()),
        };
        Err(Failure::Usage(message.to_owned()))
    }

    /// Refuses numbers of points that do not fit.
    pub(super) fn holds(self, points: u64) -> Result<(), Failure> {
        match self {
            Format::Ele | Format::Certificate => Ok(()),
            Format::Ply => Width::Four.holds(points),
            Format::Numbers(width) => width.holds(points),
        }
    }

    /// The beginning of a file with so many triangles: for all counts as long.
    pub(super) fn beginning(self, points: u64, columns: &[String], triangles: u64) -> String {
        // No count has more digits.
        const DIGITS: usize = 20;
        match self {
            Format::Numbers(_) | Format::Certificate => String::new(),
            Format::Ele => format!("{triangles:<DIGITS$} 3 0\n"),
            Format::Ply => {
                let count = triangles.to_string();
                let rest = DIGITS - count.len();
                let columns = columns
                    .iter()
                    .map(|name| format!("property double {}\n", one_word(name)));
                let columns: String = columns.collect();
                format!(
                    "ply\nformat binary_little_endian 1.0\ncomment triangulated by sweep-cdt{:rest$}\nelement vertex {points}\n\
                     property double x\nproperty double y\nproperty double z\n{columns}element face {count}\n\
                     property list uchar uint vertex_indices\nend_header\n",
                    ""
                )
            }
        }
    }
}

/// Writes what stands before the triangles.
pub(super) fn begin(out: &mut Out<'_>, format: Format, sorted: &Sorted) -> Result<(), Trouble> {
    let points = sorted.order.summary().points;
    let beginning = format.beginning(points, &sorted.columns, 0);
    out.write_all(beginning.as_bytes()).map_err(Trouble::Out)?;
    match format {
        Format::Ply => each_point(sorted, |_, [x, y], height, columns| {
            let place = [x, y, height.unwrap_or(0.0)];
            let mut numbers = place.iter().chain(columns);
            numbers.try_for_each(|number| out.write_all(&number.to_le_bytes()))
        }),
        Format::Numbers(_) | Format::Ele | Format::Certificate => Ok(()),
    }
}

/// Reads all points once more, as the input has them: `write` gets the number, the place and the other columns of each, and
/// its height, NaN where that is missing, if the input has heights.
pub(super) fn each_point(
    sorted: &Sorted,
    mut write: impl FnMut(u64, [f64; 2], Option<f64>, &[f64]) -> io::Result<()>,
) -> Result<(), Trouble> {
    let points = sorted.order.summary().points;
    let mut input = sorted.points().map_err(Trouble::Order)?;
    let mut progress = Progress::new("writing points");
    let (mut some, mut done) = (Vec::new(), 0);
    let mut row = Vec::new();
    loop {
        some.clear();
        input
            .next_points(&mut some)
            .map_err(|error| Trouble::Order(error.into()))?;
        if some.is_empty() {
            break;
        }
        let heights = input.heights().unwrap_or_default();
        // The names are known since the points were sorted; a piece may lack some.
        let columns: Vec<Option<&Column>> = (sorted.columns.iter())
            .map(|name| input.columns().iter().find(|column| column.name == *name))
            .collect();
        for (at, &place) in some.iter().enumerate() {
            let height = heights.get(at).copied();
            let height = height.or(input.has_heights().then_some(f64::NAN));
            row.clear();
            row.extend(columns.iter().map(|column| {
                let value = column.and_then(|column| column.values.get(at));
                value.copied().unwrap_or(f64::NAN)
            }));
            write(done, place, height, &row).map_err(Trouble::Out)?;
            done += 1;
        }
        progress.show(to_usize(done), to_usize(points));
    }
    if done == points {
        return Ok(());
    }
    let name = input.name();
    let message = format!("{name}: had {points} points, and has {done} now");
    Err(Trouble::Out(io::Error::other(message)))
}

/// Writes triangles.
pub(super) struct Triangles<'s, 'a, 'w> {
    out: Beside<'s, 'a, 'w>,
    format: Format,
    /// The number of the first point in the file.
    first: u64,
    written: u64,
    certificate: Option<StreamCertificate>,
}

impl<'s, 'a, 'w> Triangles<'s, 'a, 'w> {
    pub(super) fn new(
        out: Beside<'s, 'a, 'w>,
        format: Format,
        first: u64,
        summary: &Summary,
    ) -> Self {
        let is_certificate = format == Format::Certificate;
        Triangles {
            out,
            format,
            first,
            written: 0,
            certificate: is_certificate.then(|| StreamCertificate::new(summary.exponent)),
        }
    }

    /// Waits until all are written, and returns how many there are; `is_whole` if no more would have come.
    pub(super) fn finish(mut self, is_whole: bool) -> io::Result<u64> {
        if let Some(certificate) = self.certificate.take()
            && is_whole
        {
            certificate.finish(&mut self.out)?;
        }
        self.out.finish().map(|()| self.written)
    }

    pub(super) fn is_certificate(&self) -> bool {
        self.certificate.is_some()
    }

    /// The next vertex that equals no other, if the format names vertices.
    pub(super) fn vertex(&mut self, point: [f64; 2]) -> io::Result<()> {
        let certificate = self.certificate.as_mut();
        certificate.map_or(Ok(()), |certificate| {
            certificate.vertex(point, &mut self.out)
        })
    }

    /// An edge from the last vertex.
    pub(super) fn edge(&mut self, upper: [f64; 2]) {
        if let Some(certificate) = &mut self.certificate {
            certificate.edge(upper);
        }
    }

    /// Writes what is final; `corners` are those of a triangle as the file numbers them.
    pub(super) fn found(&mut self, found: &Final, corners: Option<[u64; 3]>) -> io::Result<()> {
        match (&mut self.certificate, *found) {
            (None, _) => corners.map_or(Ok(()), |corners| self.write(corners)),
            (Some(certificate), Final::HullSide { ends }) => {
                certificate.hull_side(ends);
                Ok(())
            }
            (
                Some(certificate),
                Final::Triangle {
                    corners,
                    constrained,
                },
            ) => {
                certificate.triangle(corners, constrained);
                self.written += 1;
                Ok(())
            }
            (Some(_), _) => Ok(()),
        }
    }

    fn write(&mut self, corners: [u64; 3]) -> io::Result<()> {
        // Numbers that do not fit were refused.
        let narrow = |number| u32::try_from(number).unwrap_or(u32::MAX);
        let at = self.written;
        self.written += 1;
        match self.format {
            Format::Numbers(width) => width.write(corners, &mut self.out),
            Format::Ply => {
                let bytes = corners.map(|number| narrow(number).to_le_bytes());
                self.out.write_all(&[3])?;
                self.out.write_all(bytes.as_flattened())
            }
            Format::Ele => {
                let [a, b, c] = corners.map(|number| number + self.first);
                writeln!(self.out, "{} {a} {b} {c}", at + self.first)
            }
            // A certificate writes its own.
            Format::Certificate => Ok(()),
        }
    }
}

/// Refuses a name that tells no format of vertices.
pub(super) fn refuse_vertices(path: Option<&Path>) -> Result<(), Failure> {
    match path {
        Some(path) if path.extension().is_none_or(|extension| extension != "f64") => {
            let name = path.display();
            let message = format!("{name} is no name for vertices of a stream: let it end in .f64");
            Err(Failure::Usage(message))
        }
        _ => Ok(()),
    }
}
