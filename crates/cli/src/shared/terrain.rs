//! Terrain: an input with heights, triangulated, and its part that is inside.

use sweep_cdt::crossings::Exact;
use sweep_cdt::interior::Interior;
use sweep_cdt::{Bands, Triangulator};
use sweep_cdt_engine::{Inside, Remark, remarks};
use sweep_cdt_formats::{Coordinate, GraphFile, Input};
use sweep_cdt_terrain::Surface;

use super::failure::Failure;
use super::files::{FilesRead, ReadingArgs};
use super::inside::InsideArgs;
use super::layers::LayersArgs;
use super::missing::MissingArgs;
use super::places::located;
use super::splitting::SplitArgs;

/// Arguments that name a terrain.
#[derive(clap::Args)]
pub(crate) struct TerrainArgs {
    #[command(flatten)]
    layers: LayersArgs,

    #[command(flatten)]
    reading: ReadingArgs,

    #[command(flatten)]
    inside: InsideArgs,

    #[command(flatten)]
    missing: MissingArgs,

    #[command(flatten)]
    split: SplitArgs,
}

/// Work on a surface over points of this type.
pub(crate) trait Work<S> {
    /// What it comes to.
    type Done;

    /// Does it.
    fn run(self, surface: &Surface<'_, S>) -> Result<Self::Done, Failure>;
}

/// The refusal of an input without heights, or without points.
pub(crate) fn no_heights(name: &str, has_points: bool) -> Failure {
    Failure::Error(match has_points {
        true => format!(
            "{name}: the vertices have no heights: a third coordinate, the column z, the first attribute of a .node or .poly, or the property of a .geojson or column of a .csv that --height-property names"
        ),
        false => format!("{name}: there are no points"),
    })
}

impl TerrainArgs {
    /// The name of the input in messages.
    pub(crate) fn name(&self) -> String {
        self.layers.name()
    }

    /// The rule for what of a file is inside.
    pub(crate) fn rule<S>(&self, file: &GraphFile<S>) -> Inside {
        self.inside.rule(file).0
    }

    /// No files; the input is the first that is read.
    pub(crate) fn files(&self) -> FilesRead {
        self.reading.files()
    }

    /// Reads the input.
    pub(crate) fn read(&self, files: &mut FilesRead) -> Result<Input, Failure> {
        let mut input = self.layers.read(files)?;
        if self.split.is_asked() {
            input = self.split.apply(&self.name(), input)?.0;
        }
        self.missing.apply(&self.name(), input, files)
    }

    /// Triangulates a file, and works on the surface. What is to say about both is said.
    pub(crate) fn surface<S: Coordinate + Exact, W: Work<S>>(
        &self,
        file: &GraphFile<S>,
        files: &FilesRead,
        work: W,
    ) -> Result<W::Done, Failure> {
        let name = self.name();
        if file.heights().is_none() {
            return Err(no_heights(&name, !file.graph.points.is_empty()));
        }
        self.triangulated(file, files, |file, domain| {
            let heights = file.heights().map_or(&[][..], |column| &column.values);
            let surface = Surface::new(&file.graph.points, &domain, heights);
            let done = work.run(&surface)?;
            let (missing, triangles) = (surface.missing(), domain.inside().len());
            let open = (missing > 0).then_some(Remark::OpenTriangles { missing, triangles });
            files.say(&name, open.as_slice())?;
            Ok(done)
        })
    }

    /// Triangulates a file, and works on what is inside. What is to say about the result is said.
    pub(crate) fn triangulated<S: Coordinate, R>(
        &self,
        file: &GraphFile<S>,
        files: &FilesRead,
        work: impl FnOnce(&GraphFile<S>, Interior<'_>) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        let name = self.name();
        let graph = &file.graph;
        let result =
            Triangulator::new().triangulate_parallel(&graph.points, &graph.edges, Bands::new());
        let result = result.map_err(|error| {
            let advice = SplitArgs::advice(&error);
            Failure::Error(format!("{name}: {}{advice}", located(file, error)))
        })?;
        let duplicates: Vec<[usize; 2]> = result.duplicates().collect();
        let shared = file.sharing(&duplicates);
        let file = shared.as_ref().unwrap_or(file);
        files.say_of(&name, file)?;
        let domain = self.inside.domain(&name, file, &result)?;
        files.say(&name, &remarks(file, &result, domain.as_ref()))?;
        work(file, domain.unwrap_or_else(|| Interior::whole(&result)))
    }
}
