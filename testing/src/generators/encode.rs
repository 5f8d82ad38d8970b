//! Inputs into bytes: the way back, for seeds made of inputs that are known to be hard.

use super::edges::Pattern;
use super::input;
use super::limits::{EDGES, FAR_POINTS, POINTS};
use super::points::Shape;
use crate::Input;

/// Bytes that stand for this input, if there are any: few points, or small integers; few edges.
pub fn encode(wanted: &Input) -> Option<Vec<u8>> {
    [Shape::General, Shape::Raw].into_iter().find_map(|shape| {
        let bytes = written(shape, wanted)?;
        let found = input(&bytes);
        (found.to_string() == wanted.to_string()).then_some(bytes)
    })
}

fn written(shape: Shape, Input { points, edges }: &Input) -> Option<Vec<u8>> {
    let most = if shape == Shape::Raw {
        FAR_POINTS
    } else {
        POINTS
    };
    if points.len() > most || edges.len() > EDGES {
        return None;
    }
    let shape_byte = Shape::ALL.iter().position(|&other| other == shape)?;
    // Any two points, crossing edges kept, no disguise.
    let style = Pattern::ALL
        .iter()
        .position(|&other| other == Pattern::Pairs)?;
    let mut bytes = vec![
        u8::try_from(shape_byte).ok()?,
        u8::try_from(style).ok()?,
        u8::try_from(points.len()).ok()?,
    ];
    for x in points.iter().flatten() {
        if shape == Shape::Raw {
            bytes.extend(x.to_bits().to_le_bytes());
        } else {
            // The comparison afterwards notices what does not fit.
            bytes.extend((*x as i16).to_le_bytes());
        }
    }
    // The hub, which pairs do not use.
    bytes.push(0);
    for &end in edges.iter().flatten() {
        bytes.push(u8::try_from(end).ok()?);
    }
    Some(bytes)
}

#[test]
fn what_is_encoded_is_read_back() {
    let lattice = Input::parse("0 0, 3 0, 3 2, -5 7", "0 2, 1 3");
    let extreme = Input::parse("0 0, 1e308 5e-324, -0.1 0.30000000000000004", "2 1");
    for input in [lattice, extreme] {
        let bytes = encode(&input).expect("few points");
        assert_eq!(super::input(&bytes).to_string(), input.to_string());
    }
    assert!(encode(&Input::parse("1e9 0, 0 0, 0 1", "0 7")).is_none());
}
