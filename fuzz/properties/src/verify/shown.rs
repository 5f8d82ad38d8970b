//! A case as files to look at.

use std::panic::catch_unwind;

use sweep_cdt::Pslg;
use sweep_cdt::verify::Verifier;
use sweep_cdt_draw::ViolationsPicture;
use sweep_cdt_formats::{Format, GraphFile, Source, read_result};

use super::case::{Case, is_defined};
use crate::file::{File, json};

impl Case {
    /// The input, the triangles and, if all points are finite and all indices in range, what is wrong with them.
    pub(super) fn files(&self) -> Vec<File> {
        let input = json(&self.points, &self.edges);
        let result = format!("{{\"triangles\": {:?}}}\n", self.triangles);
        let mut files = vec![
            ("input.json".to_owned(), input.into_bytes()),
            ("result.json".to_owned(), result.clone().into_bytes()),
        ];
        let picture = catch_unwind(|| is_defined(self).then(|| self.picture(result.into_bytes())));
        let picture = picture.ok().flatten().flatten();
        files.extend(picture.map(|picture| ("violations.svg".to_owned(), picture)));
        files
    }

    fn picture(&self, result: Vec<u8>) -> Option<Vec<u8>> {
        let file = GraphFile::from(Pslg {
            points: self.points.clone(),
            edges: self.edges.clone(),
            ..Pslg::default()
        });
        let source = Source::new("result.json", result);
        let triangles = read_result(Format::Json, &source, None, &file).ok()?;
        let graph = &file.graph;
        let verdict = Verifier::new().verify(&graph.points, &graph.edges, &triangles.list);
        let violations = verdict.err().map_or_else(Vec::new, |wrong| wrong.list);
        let mut picture = Vec::new();
        let drawn = ViolationsPicture::new(&file, &triangles, &violations).write(&mut picture);
        drawn.ok().map(|()| picture)
    }
}
