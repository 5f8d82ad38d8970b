//! The colours of triangles by height and slope: hypsometric tints with hill shading.
//!
//! A tint goes from the lowest height to the highest in an order that the eye sees: each is lighter than those below it.
//! The sun stands in the north-west, 45 degrees high: a slope that falls towards it is lighter, one that falls away from
//! it darker. Heights need not have the unit of the plane (metres over degrees), so they are stretched until the mean
//! slope is [`MEAN_SLOPE`]. A triangle has one of [`TINTS`] tints, by the mean height of its corners, and one of
//! [`SHADES`] shades; or it is grey, if a corner has no height.
//!
//! The sum behind the mean is one of whole numbers. So the colours do not depend on the order of the triangles.

use sweep_cdt::Triangulation;
use sweep_cdt::interior::Interior;
use sweep_cdt_formats::{Column, Coordinate};

use super::style::{RAMP, Rgb, UNKNOWN};

/// How many colours stand for heights.
pub(super) const TINTS: usize = 24;
/// How many shades each of them has.
const SHADES: usize = 12;
/// The mean slope after stretching, as height over length.
const MEAN_SLOPE: f64 = 0.6;
/// The height of the sun's direction, and its parts to the west and to the north.
const SUN: [f64; 2] = [std::f64::consts::FRAC_1_SQRT_2, 0.5];
/// The lightest shade: that of a slope at right angles to the sun, where level ground has 1.
const LIGHTEST: f64 = std::f64::consts::SQRT_2;
/// The light in full shadow, as a share of that on level ground.
const AMBIENT: f64 = 0.35;

/// The relief of a picture.
#[derive(Debug)]
pub(super) struct Relief {
    /// The name of the heights.
    pub(super) name: String,
    /// The lowest and the highest height of the triangles drawn, as text.
    pub(super) range: [String; 2],
    /// How many vertices have no height.
    pub(super) missing: usize,
    /// For each colour the ends of the sides around its triangles, with these on the left; sorted.
    pub(super) colours: Vec<(Rgb, Vec<[usize; 2]>)>,
}

impl Relief {
    /// The relief of the triangles of a domain; none, if all of their heights are equal. `points` are near 1 at most.
    pub(super) fn new(
        points: &[[f64; 2]],
        heights: &Column,
        interior: &Interior<'_>,
    ) -> Option<Relief> {
        let result = interior.triangulation();
        let height = |v: usize| heights.values.get(v).copied().filter(|z| z.is_finite());
        let known = |t: usize| {
            let [a, b, c] = result.triangle(t).map(height);
            Some([a?, b?, c?])
        };
        let all = || interior.inside().filter_map(known).flatten();
        let (low, high) = (
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        );
        if low >= high {
            return None;
        }
        // Halves, whose differences do not overflow.
        let share = |z: f64| (z / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0);
        let slope = |t: usize| {
            let heights = known(t)?.map(share);
            let corners = result.triangle(t).map(|v| points[v]);
            Some((heights, Slope::new(corners, heights)))
        };
        let sums = interior.inside().filter_map(slope).map(|(_, slope)| {
            let [rise, area] = [slope.rise[0].hypot(slope.rise[1]), slope.area];
            [rise, area].map(whole)
        });
        let [rises, areas] = sums.fold([0; 2], |[a, b], [c, d]| [a + c, b + d]);
        let stretch = MEAN_SLOPE * areas as f64 / (rises.max(1)) as f64;
        let colour = |t: usize| match slope(t) {
            _ if !interior.is_inside(t) => None,
            None => Some(TINTS * SHADES),
            Some((heights, slope)) => {
                let mean = (heights[0] + heights[1] + heights[2]) / 3.0;
                let shade = slope.light(stretch) / LIGHTEST;
                Some(step(mean, TINTS) * SHADES + step(shade, SHADES))
            }
        };
        let vertices = (0..points.len()).filter(|&v| result.representative(v) == v);
        Some(Relief {
            name: heights.name.clone(),
            range: [low, high].map(|z| z.text()),
            missing: vertices.filter(|&v| height(v).is_none()).count(),
            colours: borders(result, colour),
        })
    }
}

/// The slope of a triangle, as a fraction.
struct Slope {
    /// The rise to the right and upwards, times the area.
    rise: [f64; 2],
    area: f64,
}

impl Slope {
    fn new([a, b, c]: [[f64; 2]; 3], [za, zb, zc]: [f64; 3]) -> Slope {
        let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
        let [du, dv] = [zb - za, zc - za];
        Slope {
            rise: [du * v[1] - dv * u[1], dv * u[0] - du * v[0]],
            area: (u[0] * v[1] - u[1] * v[0]).max(0.0),
        }
    }

    /// The light on the slope, where heights are stretched: 0 in the shadow, 1 on level ground.
    fn light(&self, stretch: f64) -> f64 {
        let [east, north] = self.rise.map(|rise| rise * stretch);
        let length = (east * east + north * north + self.area * self.area).sqrt();
        let light = SUN[1] * (east - north) + SUN[0] * self.area;
        if length > 0.0 {
            (light / length / SUN[0]).max(0.0)
        } else {
            1.0
        }
    }
}

/// A number from 0 to 8 or so as a whole number of small units.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is neither negative nor large"
)]
fn whole(number: f64) -> u128 {
    (number * (1_u64 << 50) as f64) as u128
}

/// Which of so many equal parts of 0 to 1 a number is in.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is neither negative nor large"
)]
fn step(share: f64, steps: usize) -> usize {
    ((share * steps as f64) as usize).min(steps - 1)
}

/// The sides between triangles of different colours, by colour. A triangle that is not drawn has none.
fn borders(
    result: &Triangulation,
    colour: impl Fn(usize) -> Option<usize>,
) -> Vec<(Rgb, Vec<[usize; 2]>)> {
    let colours: Vec<Option<usize>> = (0..result.len()).map(colour).collect();
    let mut borders = vec![Vec::new(); TINTS * SHADES + 1];
    for (t, colour) in colours.iter().enumerate() {
        let Some(colour) = *colour else { continue };
        let corners = result.triangle(t);
        for side in 0..3 {
            let across = result.neighbor(t, side).and_then(|across| colours[across]);
            if across != Some(colour) {
                borders[colour].push([corners[(side + 1) % 3], corners[(side + 2) % 3]]);
            }
        }
    }
    borders.iter_mut().for_each(|sides| sides.sort_unstable());
    let coloured = borders.into_iter().enumerate();
    let coloured = coloured.map(|(colour, sides)| (rgb_of(colour), sides));
    coloured.filter(|(_, sides)| !sides.is_empty()).collect()
}

/// The colour of a tint and a shade.
fn rgb_of(colour: usize) -> Rgb {
    if colour == TINTS * SHADES {
        return UNKNOWN;
    }
    let shade = ((colour % SHADES) as f64 + 0.5) / SHADES as f64 * LIGHTEST;
    tint(colour / SHADES).map(|part| {
        let part = f64::from(part);
        rounded(if shade <= 1.0 {
            part * (AMBIENT + (1.0 - AMBIENT) * shade)
        } else {
            part + (255.0 - part) * (shade - 1.0)
        })
    })
}

/// A tint on level ground.
pub(super) fn tint(tint: usize) -> Rgb {
    let place = (tint as f64 + 0.5) / TINTS as f64 * (RAMP.len() - 1) as f64;
    let below = step(place / (RAMP.len() - 1) as f64, RAMP.len() - 1);
    let share = place - below as f64;
    [0, 1, 2].map(|part| {
        let [from, to] = [below, below + 1].map(|at| f64::from(RAMP[at][part]));
        rounded(from + share * (to - from))
    })
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is between 0 and 255"
)]
fn rounded(part: f64) -> u8 {
    part.round().clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::{SHADES, Slope, TINTS, rgb_of, tint};

    /// The lightness that the eye sees, by the weights of sRGB.
    fn lightness([r, g, b]: [u8; 3]) -> f64 {
        let linear = |part: u8| (f64::from(part) / 255.0).powf(2.2);
        0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b)
    }

    #[test]
    fn higher_is_lighter() {
        for low in 1..TINTS {
            assert!(lightness(tint(low - 1)) < lightness(tint(low)), "{low}");
        }
        for tint in 0..TINTS {
            for shade in 1..SHADES {
                let [dark, light] = [shade - 1, shade].map(|shade| rgb_of(tint * SHADES + shade));
                assert!(lightness(dark) < lightness(light), "{tint} {shade}");
            }
        }
    }

    /// Slopes of 45 degrees, by the cosine of the angle to a sun of 45 degrees over that of level ground.
    #[test]
    fn the_sun_stands_in_the_north_west() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let light = |east: f64, north: f64| Slope::new(corners, [0.0, east, north]).light(1.0);
        let diagonal = std::f64::consts::FRAC_1_SQRT_2;
        for (east, north, expected) in [
            (0.0, 0.0, 1.0),
            // Falling towards the sun, and away from it.
            (diagonal, -diagonal, std::f64::consts::SQRT_2),
            (-diagonal, diagonal, 0.0),
            // Across the way to the sun: as far from it as level ground, but turned by 45 degrees.
            (diagonal, diagonal, diagonal),
        ] {
            let found = light(east, north);
            assert!((found - expected).abs() < 1e-12, "{east} {north}: {found}");
        }
    }
}
