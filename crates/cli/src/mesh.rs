//! `sweep-cdt verify` of a mesh by itself, of which only bounds are asked. Its own vertices are those that an input without
//! any lacks.

use std::io::Write;

use serde::Serialize;
use sweep_cdt_edit::Bounds;
use sweep_cdt_engine::{Verdict, of_mesh};
use sweep_cdt_formats::{Coordinate, GraphFile, Input, Matching, ResultError, added_points};

use crate::bounded::{self, Bounded};
use crate::record::Fingerprint;
use crate::shared::arguments::{ResultArgs, ResultFiles};
use crate::shared::arithmetic::ScalarArgs;
use crate::shared::failure::Failure;
use crate::shared::files::{FileArgument, FilesRead};
use crate::shared::outputs::print;

/// The record of a mesh by itself.
#[derive(Serialize)]
struct Document<'a> {
    program: &'static str,
    version: &'static str,
    verdict: &'static str,
    result: &'a [Fingerprint],
    triangles: usize,
    bounds: bounded::Record,
}

/// A mesh whose bounds are asked, and how.
pub(crate) struct Mesh<'a> {
    pub(crate) input: &'a FileArgument,
    pub(crate) result: &'a ResultArgs,
    pub(crate) scalar: &'a ScalarArgs,
    pub(crate) bounds: Option<Bounds>,
    pub(crate) limit: usize,
    pub(crate) is_json: bool,
}

impl Mesh<'_> {
    /// Prints the verdict on all triangles of the mesh.
    pub(crate) fn verify(
        &self,
        mut read: FilesRead,
        refused: impl Fn(&ResultError) -> Failure,
    ) -> Result<(), Failure> {
        let bounds = self.bounds.ok_or_else(|| {
            let name = self.input.input_name();
            Failure::Usage(format!(
                "RESULT is missing: of a mesh by itself only --min-angle, --max-area and --max-side are asked; \
                 `sweep-cdt verify {name} {name}` asks whether it is a Delaunay triangulation of its points"
            ))
        })?;
        let mut prints = Vec::new();
        let files = self.result.load(self.input, &mut read, |source| {
            prints.extend(self.is_json.then(|| Fingerprint::of(source)));
        })?;
        // The vertices are read in the type of an input without any.
        let empty = Input::Doubles(GraphFile::default());
        match self.scalar.convert(&self.input.input_name(), empty)? {
            Input::Doubles(file) => self.verify_as(bounds, file, &files, &prints, refused),
            Input::Rationals(file) => self.verify_as(bounds, file, &files, &prints, refused),
        }
    }

    fn verify_as<S: Coordinate>(
        &self,
        bounds: Bounds,
        mut file: GraphFile<S>,
        ResultFiles {
            format,
            source,
            node,
        }: &ResultFiles,
        prints: &[Fingerprint],
        refused: impl Fn(&ResultError) -> Failure,
    ) -> Result<(), Failure> {
        let name = self.input.input_name();
        let points = added_points(*format, source, node.as_ref(), &file);
        file.graph.points = points.map_err(|error| refused(&error))?;
        let triangles = Matching::new().read(*format, source, node.as_ref(), &file);
        let triangles = triangles.map_err(|error| refused(&error))?;
        let points = &file.graph.points;
        if points.is_empty() && !triangles.list.is_empty() {
            let message =
                "the triangles have no coordinates: give the INPUT with the vertices first";
            return Err(Failure::Error(format!("{}: {message}", name)));
        }
        let bounded = Bounded::new(bounds, points, &triangles, self.limit)?;
        let verdict = Verdict::Correct.with_bounds(&bounded.violators);
        let count = triangles.list.len();
        print(|out| {
            if self.is_json {
                let document = Document {
                    program: env!("CARGO_BIN_NAME"),
                    version: env!("CARGO_PKG_VERSION"),
                    verdict: verdict.name(),
                    result: prints,
                    triangles: count,
                    bounds: bounded.record(),
                };
                serde_json::to_writer_pretty(&mut *out, &document)?;
                return writeln!(out);
            }
            writeln!(out, "{}", bounded.headline(&of_mesh(&name, count)))?;
            bounded.write(out)
        })?;
        match verdict {
            Verdict::Wrong => Err(Failure::Wrong),
            _ => Ok(()),
        }
    }
}
