//! `.ply` in forms that the crate does not write.

use std::io::Write;

use super::meant::Meant;
use super::numbers::{Form, Kind, Order};

/// Files are written to memory, which takes all of them.
const GROWS: &str = "memory takes it";

/// Stanford's format: x, y and z in any order, other properties between them, lists of any types.
pub(super) fn write(meant: &Meant, style: u8, number: u8) -> Vec<u8> {
    let (order, encoding) = match style % 4 {
        0 => (Order::Text, "ascii"),
        1 => (Order::LeastSignificantFirst, "binary_little_endian"),
        _ => (Order::MostSignificantFirst, "binary_big_endian"),
    };
    let form = |kind| Form { kind, order };
    let place = form(Kind::holding(number, meant.points.as_flattened()));
    let height = form(Kind::holding(number >> 3, &meant.heights));
    let other = form(Kind::U16);
    let index = form([Kind::I32, Kind::U32, Kind::U16, Kind::U8][usize::from(style >> 2 & 3)]);
    let length = form([Kind::U8, Kind::I32][usize::from(style >> 4 & 1)]);
    // The axes in the order of the file; `o` is something else.
    let axes = ["xyz", "yxoz", "zoxy", "oxzy"][usize::from(style >> 5 & 3)];
    let has_heights = !meant.heights.is_empty();
    let axes = axes.chars().filter(|&axis| axis != 'z' || has_heights);
    let axes: Vec<char> = axes.collect();

    let mut file = Vec::new();
    writeln!(file, "ply\nformat {encoding} 1.0\ncomment of nobody").expect(GROWS);
    writeln!(file, "element vertex {}", meant.points.len()).expect(GROWS);
    for axis in &axes {
        let form = match axis {
            'x' | 'y' => place,
            'z' => height,
            _ => other,
        };
        writeln!(file, "property {} {axis}", name_of(form.kind)).expect(GROWS);
    }
    let index_name = name_of(index.kind);
    writeln!(file, "element edge {}", meant.edges.len()).expect(GROWS);
    writeln!(file, "property {index_name} vertex2\nproperty uchar o").expect(GROWS);
    writeln!(file, "property {index_name} vertex1").expect(GROWS);
    writeln!(file, "element face {}", meant.triangles.len()).expect(GROWS);
    let list = ["vertex_index", "vertex_indices"][usize::from(style >> 7)];
    let length_name = name_of(length.kind);
    writeln!(file, "property list {length_name} {index_name} {list}").expect(GROWS);
    writeln!(file, "end_header").expect(GROWS);
    for (v, [x, y]) in meant.points.iter().enumerate() {
        for axis in &axes {
            match axis {
                'x' => place.put(*x, &mut file),
                'y' => place.put(*y, &mut file),
                'z' => height.put(meant.heights[v], &mut file),
                _ => other.put_indices(&[300 + v], &mut file),
            }
        }
        place.end(&mut file);
    }
    for &[a, b] in &meant.edges {
        index.put_indices(&[b], &mut file);
        form(Kind::U8).put_indices(&[7], &mut file);
        index.put_indices(&[a], &mut file);
        index.end(&mut file);
    }
    for corners in &meant.triangles {
        length.put_indices(&[3], &mut file);
        index.put_indices(corners, &mut file);
        index.end(&mut file);
    }
    file
}

fn name_of(kind: Kind) -> &'static str {
    match kind {
        Kind::I8 => "char",
        Kind::U8 => "uint8",
        Kind::I16 => "short",
        Kind::U16 => "ushort",
        Kind::I32 => "int32",
        Kind::U32 => "uint",
        Kind::F32 => "float",
        Kind::F64 | Kind::I64 => "double",
    }
}
