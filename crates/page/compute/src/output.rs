//! The answer to a request, written.

use std::error::Error;

use sweep_cdt::Error as Refusal;
use sweep_cdt::crossings::Exact;
use sweep_cdt_draw::{StepsPage, write as write_result, write_interior};
use sweep_cdt_formats::{Coordinate, Format, GraphFile, write_graph};
use sweep_cdt_trace::write_trace;

use super::input::named;
use super::picture::Picture;
use super::request::{Trace, Wanted};
use super::settings::Asked;

/// So many points and edges may have their steps shown: a browser bears the page, and the memory of a process the steps.
const MOST_WITH_STEPS: usize = 50_000;

/// Writes what is wanted of the input called `name`.
pub(crate) fn write<S: Coordinate + Exact>(
    name: &str,
    file: &GraphFile<S>,
    settings: &Asked,
    wanted: Wanted,
    out: &mut Vec<u8>,
) -> Result<(), Box<dyn Error>> {
    let refused = |file: &GraphFile<S>, error| format!("{name}: {}", file.split_as_numbered(error));
    if let Wanted::Picture = wanted {
        let picture = Picture::new(file, settings);
        let picture = picture.map_err(|error| refused(file, error))?;
        return Ok(picture.write(out)?);
    }
    if let Wanted::Graph(format) = wanted {
        return Ok(write_graph(named(&format, Format::GRAPHS)?, file, out)?);
    }
    let pieces = settings.pieces(file);
    let file = pieces.map_err(|error| refused(file, error))?;
    let file = file.as_ref();
    match wanted {
        Wanted::Trace(format) => write_steps(name, file, settings, format, out),
        Wanted::Result(format) => {
            let format = named(&format, Format::OUTPUTS)?;
            let result = settings.triangulate(&file.graph, None);
            let (result, _) = result.map_err(|error| refused(file, error.into()))?;
            match settings.domain(file, &result) {
                None => write_result(format, file, &result, out)?,
                Some(domain) => {
                    let domain = domain.map_err(|error| file.interior_as_numbered(error));
                    let domain = domain.map_err(|error| format!("{name}: {error}"))?;
                    write_interior(format, file, &domain, out)?;
                }
            }
            Ok(())
        }
        Wanted::Picture | Wanted::Graph(_) => Ok(()),
    }
}

/// Writes the steps; of edges that cross, those up to the first crossing that the sweep meets.
fn write_steps<S: Coordinate>(
    name: &str,
    file: &GraphFile<S>,
    settings: &Asked,
    format: Trace,
    out: &mut Vec<u8>,
) -> Result<(), Box<dyn Error>> {
    let graph = &file.graph;
    let size = graph.points.len() + graph.edges.len();
    if size > MOST_WITH_STEPS {
        let message = format!(
            "{name}: steps are shown of up to {MOST_WITH_STEPS} points and edges, and these are {size}"
        );
        return Err(message.into());
    }
    let mut events = Vec::new();
    let refused = match settings.triangulate(graph, Some(&mut events)) {
        Ok(_) => None,
        Err(error @ Refusal::CrossingEdges { .. }) => Some(error),
        Err(error) => return Err(format!("{name}: {}", file.as_numbered(error)).into()),
    };
    match format {
        Trace::Html => {
            let page = StepsPage::new(graph, &events);
            match &refused {
                Some(error) => page.refused(error).write(out)?,
                None => page.write(out)?,
            }
        }
        Trace::Txt => sweep_cdt_trace::Trace { skipped: 0, events }.write_text(out)?,
        Trace::Jsonl => write_trace(&sweep_cdt_trace::Trace { skipped: 0, events }, out)?,
    }
    Ok(())
}
