//! Raw doubles and unchecked indices: a typed error that names the offender, or a right result.

use arbitrary::{Result, Unstructured};
use sweep_cdt::Error;
use sweep_cdt_testing::tuned::triangulate;

use crate::{reached, valid};
use sweep_cdt_testing::Input;

/// As many points at most.
const POINTS: usize = 12;
/// As many edges at most.
const EDGES: usize = 24;
/// So many bytes they have, with some indices that are out of range.
pub const BYTES: usize = 1 + 16 * POINTS + 2 * EDGES + 15;

/// The property for the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let input = input(bytes);
    let Input { points, edges } = &input;
    match triangulate(points, edges) {
        Err(Error::NonFiniteCoordinate { vertex }) => {
            assert!(
                points[vertex].iter().any(|x| !x.is_finite()),
                "point {vertex} is finite"
            );
        }
        Err(Error::EdgeOutOfRange { edge, vertex }) => {
            assert!(
                edges[edge].contains(&vertex),
                "edge {edge} has no end {vertex}"
            );
            assert!(vertex >= points.len(), "there is a point {vertex}");
        }
        Ok(_) | Err(Error::CrossingEdges { .. }) => {
            reached::sample(&input);
            valid::judge_share(&input, bytes);
        }
        Err(error) => panic!("no reason for: {error}"),
    }
}

/// The input that these bytes stand for.
pub fn input(bytes: &[u8]) -> Input {
    // Reading is total but for a type that has no values.
    read(&mut Unstructured::new(bytes)).unwrap_or_default()
}

/// How many points, then 16 bytes a point, then edges: two bytes each, or 16 where the first is 255.
fn read(bytes: &mut Unstructured<'_>) -> Result<Input> {
    let mut input = Input::default();
    let n = usize::from(bytes.arbitrary::<u8>()?) % (POINTS + 1);
    while input.points.len() < n && !bytes.is_empty() {
        input.points.push([bytes.arbitrary()?, bytes.arbitrary()?]);
    }
    while input.edges.len() < EDGES && !bytes.is_empty() {
        let end: u8 = bytes.arbitrary()?;
        input.edges.push(if end == u8::MAX {
            [bytes.arbitrary()?, bytes.arbitrary()?]
        } else {
            [end, bytes.arbitrary()?].map(usize::from)
        });
    }
    Ok(input)
}

/// Bytes that stand for this input, if there are any: few points and edges.
pub fn encode(Input { points, edges }: &Input) -> Option<Vec<u8>> {
    if points.len() > POINTS || edges.len() > EDGES {
        return None;
    }
    let mut bytes = vec![u8::try_from(points.len()).ok()?];
    for x in points.iter().flatten() {
        bytes.extend(x.to_bits().to_le_bytes());
    }
    for &end in edges.iter().flatten() {
        bytes.push(u8::try_from(end).ok()?);
    }
    Some(bytes)
}
