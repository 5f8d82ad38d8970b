//! A stream passes on the result in memory, whatever the window, the front and the scalar. Bands do so, in whatever order
//! they are joined. And the verifier of streams says of each list of triangles what the verifier in memory says, in any
//! order and at each level.

use num_rational::BigRational;
use sweep_cdt::verify::Level;
use sweep_cdt_testing::oracle::{Answer, crosses, found};
use sweep_cdt_testing::runs::Sample;
use sweep_cdt_testing::streams::{
    Altered, Feeding, Rest, Streaming, banded, settled, streamed, written_and_read,
};
use sweep_cdt_testing::tuned::triangulate;
use sweep_cdt_testing::{AnyFront, Input, Random, generators};

use crate::{reached, share};

/// One in so many inputs has the right triangles judged too. Altered ones may be right as well.
const RIGHT: u64 = 4;

/// The property for the choices and the input that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (choices, input) = generators::input_with_choices(bytes);
    reached::sample(&input);
    let [scalar, window, front, ..] = choices.to_le_bytes();
    let fronts = AnyFront::all();
    let way = Streaming {
        window: [1, 2, 7, 1000][usize::from(window) % 4],
        is_range_known: window & 4 != 0,
        front: fronts[usize::from(front) % fronts.len()].clone(),
    };
    let bands = (window & 8 != 0).then_some(choices >> 24);
    let outcome = match scalar % 4 {
        0 => passed_on::<BigRational>(&input, &way, bands, |rest| rest),
        1 => passed_on::<i64>(&input, &way, bands, |rest| rest)
            .or_else(|| passed_on::<f32>(&input, &way, bands, |rest| rest)),
        _ => None,
    };
    let outcome = outcome.or_else(|| passed_on::<f64>(&input, &way, bands, written_and_read));
    let outcome = outcome.expect("doubles hold all finite coordinates");
    let Input { points, edges } = &input;
    match (triangulate(points, edges), outcome) {
        (Ok(result), Ok(answer)) => {
            assert_eq!(
                answer,
                found(&result, points.len(), edges.len()),
                "{way:?}, bands: {bands:?}"
            );
            let random = &mut Random::new(choices >> 24);
            let altered = Altered::wrong(points, edges, &result, random);
            let right = share::is_chosen(bytes, RIGHT);
            let right = right.then(|| Altered::right(points, edges, &result));
            for mut list in right.into_iter().chain([altered]) {
                if random.below(4) > 0 {
                    list = list.shuffled(random);
                }
                let (level, feeding) = (random.pick(&Level::ALL), random.pick(&Feeding::ALL));
                list.assert_verdict(level, feeding);
            }
        }
        (Err(_), Err(sweep_cdt::Error::CrossingEdges { edges: pair })) => {
            assert!(
                crosses(points, edges, pair),
                "{pair:?} do not cross: {way:?}, bands: {bands:?}"
            );
        }
        (memory, stream) => {
            panic!("{memory:?}, but as a stream {stream:?}: {way:?}, bands: {bands:?}")
        }
    }
}

/// The outcome of a stream, or of bands as high as its windows, joined in an order that a number chooses, each carried so;
/// or for one number of four settled together.
fn passed_on<S: Sample + Clone + Send>(
    input: &Input,
    way: &Streaming,
    bands: Option<u64>,
    carried: fn(Rest<S>) -> Rest<S>,
) -> Option<Result<Answer, sweep_cdt::Error>> {
    match bands {
        None => streamed::<S>(input, way),
        Some(seed) if seed.is_multiple_of(4) => {
            settled::<S>(input, way.window, &mut Random::new(seed))
        }
        Some(seed) => banded::<S>(input, way.window, &mut Random::new(seed), carried),
    }
}
