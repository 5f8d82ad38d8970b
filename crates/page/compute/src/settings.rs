//! The triangulation of a request: with its front, its algorithm and its heuristics, and what of it is inside.

use std::borrow::Cow;

use sweep_cdt::crossings::{Exact, SplitError, crossings};
use sweep_cdt::interior::{Interior, InteriorError};
use sweep_cdt::trace::Event;
use sweep_cdt::{Algorithm, Error, Pslg, Stats, Triangulation, Watch};
use sweep_cdt_engine::{Inside, Settings, UnknownName};
use sweep_cdt_formats::{Coordinate, GraphFile};

use super::request;

/// What a request asks for.
pub(crate) struct Asked {
    settings: Settings,
    /// Nothing for the rule that an input has by itself.
    inside: Option<Inside>,
    pub(crate) split: bool,
}

impl TryFrom<request::Settings> for Asked {
    type Error = UnknownName;

    fn try_from(asked: request::Settings) -> Result<Asked, UnknownName> {
        let inside = (asked.inside != "default").then(|| asked.inside.parse());
        Ok(Asked {
            settings: Settings::named(&asked.method, &asked.front, &asked.heuristics)?,
            inside: inside.transpose()?,
            split: asked.split,
        })
    }
}

impl Asked {
    /// The graph that is triangulated: that of the file, or its edges split, if they are to be split and any cross.
    pub(crate) fn pieces<'a, S: Coordinate + Exact>(
        &self,
        file: &'a GraphFile<S>,
    ) -> Result<Cow<'a, GraphFile<S>>, SplitError> {
        let graph = &file.graph;
        if !self.split || crossings(&graph.points, &graph.edges)?.is_empty() {
            return Ok(Cow::Borrowed(file));
        }
        Ok(Cow::Owned(file.split_crossings()?.0))
    }

    /// Triangulates; where steps are wanted, by the sweep.
    pub(crate) fn triangulate<S: Coordinate>(
        &self,
        Pslg { points, edges, .. }: &Pslg<S>,
        steps: Option<&mut Vec<Event>>,
    ) -> Result<(Triangulation, Stats), Error> {
        let mut stats = Stats::default();
        let mut watch = Watch::new().stats(&mut stats);
        let mut settings = self.settings;
        let mut push;
        if let Some(steps) = steps {
            settings.algorithm = Algorithm::Paper;
            push = |event| steps.push(event);
            watch = watch.events(&mut push);
        }
        let result = settings.run(points, edges, watch)?;
        Ok((result, stats))
    }

    /// The interior; nothing, if that is the whole hull.
    pub(crate) fn domain<'a, S: Coordinate>(
        &self,
        file: &'a GraphFile<S>,
        result: &'a Triangulation,
    ) -> Option<Result<Interior<'a>, InteriorError>> {
        let default =
            || Inside::default_of(!file.graph.holes.is_empty(), !file.polygons.is_empty());
        let rule = self.inside.unwrap_or_else(default);
        (rule != Inside::HULL).then(|| rule.interior(&file.into(), result))
    }
}
