//! Heights, columns, markers, seeds and coordinate systems with gaps, through every pair of formats that hold a graph: none
//! is invented, and none is lost that both hold.

use sweep_cdt::{Pslg, Region};
use sweep_cdt_formats::{
    Column, CoordinateSystem, Format, GraphFile, Input, Source, read, write_graph,
};
use sweep_cdt_testing::Random;

/// What a format holds of a graph.
#[derive(Clone, Copy, Debug, Default)]
struct Holds {
    edges: bool,
    heights: bool,
    /// Columns, with their names.
    columns: bool,
    vertex_markers: bool,
    edge_markers: bool,
    seeds: bool,
    system: bool,
}

impl Holds {
    /// As `docs/formats.md` says.
    fn of(format: Format) -> Option<Holds> {
        let nothing = Holds::default();
        let mesh = Holds {
            edges: true,
            heights: true,
            ..nothing
        };
        Some(match format {
            Format::Node => Holds {
                heights: true,
                vertex_markers: true,
                ..nothing
            },
            Format::Poly => Holds {
                vertex_markers: true,
                edge_markers: true,
                seeds: true,
                ..mesh
            },
            Format::Json => Holds {
                columns: true,
                vertex_markers: true,
                edge_markers: true,
                seeds: true,
                system: true,
                ..mesh
            },
            Format::Obj | Format::Off => mesh,
            Format::Ply | Format::Vtk | Format::Vtu | Format::Vtp => Holds {
                columns: true,
                vertex_markers: true,
                edge_markers: true,
                ..mesh
            },
            Format::Msh => Holds {
                vertex_markers: true,
                edge_markers: true,
                ..mesh
            },
            Format::Geojson | Format::Wkt => Holds {
                system: true,
                ..mesh
            },
            Format::Csv => Holds {
                heights: true,
                columns: true,
                vertex_markers: true,
                ..nothing
            },
            // What these hold is tested with their readers.
            _ => return None,
        })
    }

    /// What both hold.
    fn and(self, other: Holds) -> Holds {
        Holds {
            edges: self.edges && other.edges,
            heights: self.heights && other.heights,
            columns: self.columns && other.columns,
            vertex_markers: self.vertex_markers && other.vertex_markers,
            edge_markers: self.edge_markers && other.edge_markers,
            seeds: self.seeds && other.seeds,
            system: self.system && other.system,
        }
    }
}

/// A graph whose points are all different and all ends of edges, so that every format keeps their order.
fn file(random: &mut Random) -> GraphFile<f64> {
    let n = 3 + random.below(6);
    let points: Vec<[f64; 2]> = (0..n)
        .map(|i| [i as f64 + 0.25, (i * i % 7) as f64])
        .collect();
    let mut numbers = |gaps: usize| -> Vec<f64> {
        let number = |_| match random.one_in(gaps) {
            true => f64::NAN,
            false => 1.0 + random.below(1000) as f64 / 8.0,
        };
        // A column that says nothing is none.
        let mut numbers: Vec<f64> = (0..n).map(number).collect();
        numbers[0] = 3.5;
        numbers
    };
    let column = |name: &str, values: Vec<f64>| Column {
        name: name.to_owned(),
        values,
    };
    let heights = column(Column::HEIGHT, numbers(3));
    let wind = column("wind", numbers(4));
    let mut marker = |gaps: usize| {
        if random.one_in(gaps) {
            0
        } else {
            random.below(90) as i64 - 40
        }
    };
    let mut markers: Vec<i64> = (0..n).map(|_| marker(3)).collect();
    markers[n - 1] = 7;
    let mut edge_markers: Vec<i64> = (1..n).map(|_| marker(2)).collect();
    edge_markers[0] = -3;
    let markers = column(
        Column::MARKER,
        markers.into_iter().map(|marker| marker as f64).collect(),
    );
    let region = Region {
        seed: [1.5, 0.5],
        attribute: 2.25,
    };
    GraphFile {
        columns: vec![heights, wind, markers],
        edge_markers,
        system: Some(CoordinateSystem::of_srid(25832)),
        ..GraphFile::from(Pslg {
            points,
            edges: (1..n).map(|v| [v - 1, v]).collect(),
            holes: vec![[0.75, 0.5]],
            regions: vec![region],
        })
    }
}

/// A file that is written in a format and read again.
fn passed(format: Format, file: &GraphFile<f64>) -> GraphFile<f64> {
    let mut bytes = Vec::new();
    write_graph(format, file, &mut bytes).expect("memory takes it");
    match read(format, &Source::new("file", bytes.clone()), None) {
        Ok(Input::Doubles(file)) => file,
        other => panic!("{format:?}: {other:?}\n{}", String::from_utf8_lossy(&bytes)),
    }
}

fn column(file: &GraphFile<f64>, name: &str) -> Option<Vec<Option<f64>>> {
    let column = file.columns.iter().find(|column| column.name == name)?;
    let number = |&value: &f64| (!value.is_nan()).then_some(value);
    Some(column.values.iter().map(number).collect())
}

fn marked(file: &GraphFile<f64>) -> Option<Vec<i64>> {
    file.vertex_markers()
        .filter(|markers| markers.iter().any(|&marker| marker != 0))
}

#[test]
fn no_number_is_invented_and_none_is_lost() {
    let formats = Format::GRAPHS
        .iter()
        .filter_map(|&format| Some((format, Holds::of(format)?)));
    let formats: Vec<(Format, Holds)> = formats.collect();
    assert!(formats.len() >= 6);
    for seed in 0..40 {
        let mut random = Random::new(seed);
        let file = file(&mut random);
        for &(one, first) in &formats {
            let between = passed(one, &file);
            for &(other, second) in &formats {
                let what = format!("seed {seed}, {one:?} to {other:?}");
                let last = passed(other, &between);
                let holds = first.and(second);
                assert_eq!(last.graph.points, file.graph.points, "{what}");
                let edges = if holds.edges {
                    &file.graph.edges[..]
                } else {
                    &[]
                };
                assert_eq!(last.graph.edges, edges, "{what}");
                let heights = holds
                    .heights
                    .then(|| column(&file, Column::HEIGHT))
                    .flatten();
                assert_eq!(column(&last, Column::HEIGHT), heights, "{what}");
                let wind = holds.columns.then(|| column(&file, "wind")).flatten();
                assert_eq!(column(&last, "wind"), wind, "{what}");
                let markers = holds.vertex_markers.then(|| marked(&file)).flatten();
                assert_eq!(marked(&last), markers, "{what}");
                let markers = if holds.edge_markers {
                    &file.edge_markers[..]
                } else {
                    &[]
                };
                assert_eq!(last.edge_markers, markers, "{what}");
                let (holes, regions) = match holds.seeds {
                    true => (&file.graph.holes[..], &file.graph.regions[..]),
                    false => (&[][..], &[][..]),
                };
                assert_eq!(last.graph.holes, holes, "{what}");
                assert_eq!(last.graph.regions, regions, "{what}");
                let srid = holds.system.then_some(25832);
                assert_eq!(last.system.and_then(|system| system.srid()), srid, "{what}");
            }
        }
    }
}
