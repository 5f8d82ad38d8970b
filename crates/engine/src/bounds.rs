//! Triangles that break bounds, with the numbers by which they do.
//!
//! [`Bounds`] decide by exact signs. The numbers are doubles near the exact ones, and decide nothing.

use sweep_cdt::crossings::Exact;
use sweep_cdt_edit::{Bounds, BoundsError, Broken};
use sweep_cdt_formats::Coordinate;

/// Advice where nothing but bounds is wrong.
pub const OUT_OF_BOUNDS: &str =
    "only bounds are broken: refine the input with them, or ask for less";

/// The verdict on a mesh by itself in words, before its bounds are asked; `result` is what it is called.
pub fn of_mesh(result: &str, triangles: usize) -> String {
    let plural = if triangles == 1 { "" } else { "s" };
    format!("correct: {result} is a mesh of {triangles} triangle{plural}")
}

/// A triangle that breaks a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violator {
    /// The triangle, by position.
    pub triangle: usize,
    /// The bound.
    pub bound: Broken,
    /// What the triangle has: its least angle in degrees, its area, or the length of its longest side.
    pub size: f64,
    /// What the bound allows.
    pub limit: f64,
}

impl Violator {
    /// The name of the kind, which stays as it is.
    pub fn name(&self) -> &'static str {
        match self.bound {
            Broken::Angle => "small-angle",
            Broken::Area => "large-area",
            _ => "long-side",
        }
    }

    /// What is wrong in words; `number` is that of the triangle in its file.
    ///
    /// ```
    /// use sweep_cdt_edit::Broken;
    /// use sweep_cdt_engine::Violator;
    ///
    /// let violator = Violator { triangle: 0, bound: Broken::Area, size: 4.5, limit: 2.0 };
    /// assert_eq!(violator.words(1), "triangle 1 has an area of 4.5, more than 2");
    /// ```
    pub fn words(&self, number: usize) -> String {
        let Violator { size, limit, .. } = self;
        let has = size_in_words(self.bound, *size);
        let than = match self.bound {
            Broken::Angle => "less than",
            _ => "more than",
        };
        format!("triangle {number} has {has}, {than} {}", limit.text())
    }
}

/// A size of a triangle in words.
pub fn size_in_words(bound: Broken, size: f64) -> String {
    match bound {
        Broken::Angle => format!("an angle of {} degrees", size.text()),
        Broken::Area => format!("an area of {}", size.text()),
        _ => format!("a side of length {}", size.text()),
    }
}

/// The size of a triangle that a bound is compared with, nearly.
pub fn size<S: Exact>(bound: Broken, corners: [&[S; 2]; 3]) -> f64 {
    let corners = corners.map(|corner| corner.each_ref().map(S::approx));
    let to = |from: usize, to: usize| [0, 1].map(|i| corners[to % 3][i] - corners[from % 3][i]);
    let cross = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a * d - b * c).abs();
    let at = 0..3;
    match bound {
        Broken::Angle => {
            // Far from 1, products of lengths are no numbers, and differences of great numbers neither.
            let is_great = corners.as_flattened().iter().any(|x| x.abs() > 1e300);
            let scale = if is_great { 0.25 } else { 1.0 };
            let unit = |from: usize, to: usize| {
                let part = |i: usize| scale * corners[to % 3][i] - scale * corners[from % 3][i];
                let [x, y] = [part(0), part(1)];
                let most = f64::max(x.abs(), y.abs());
                if most > 0.0 {
                    [x / most, y / most]
                } else {
                    [0.0; 2]
                }
            };
            let angles = at.map(|k| {
                let ([a, b], [c, d]) = (unit(k, k + 1), unit(k, k + 2));
                cross([a, b], [c, d]).atan2(a * c + b * d).to_degrees()
            });
            angles.fold(f64::INFINITY, f64::min)
        }
        Broken::Area => cross(to(0, 1), to(0, 2)) / 2.0,
        _ => {
            let sides = at.map(|k| to(k, k + 1));
            sides.fold(0.0, |longest, [x, y]| f64::max(longest, x.hypot(y)))
        }
    }
}

/// The triangles that break bounds, once for each bound, in the order of the triangles. Triangles that name points that do
/// not exist break none: a verifier reports them.
///
/// ```
/// use sweep_cdt_edit::Bounds;
/// use sweep_cdt_engine::violators;
///
/// let points = [[0.0, 0.0], [4.0, 0.0], [0.0, 1.0]];
/// let bounds = Bounds { least_angle: Some(20.0), greatest_side: Some(4.0), ..Bounds::default() };
/// let found = violators(&bounds, &points, &[[0, 1, 2], [0, 1, 9]])?;
/// let names: Vec<_> = found.iter().map(|violator| violator.name()).collect();
/// assert_eq!(names, ["small-angle", "long-side"]);
/// # Ok::<(), sweep_cdt_edit::BoundsError>(())
/// ```
///
/// # Errors
/// [`BoundsError`], if the bounds are none.
pub fn violators<S: Exact>(
    bounds: &Bounds,
    points: &[[S; 2]],
    triangles: &[[usize; 3]],
) -> Result<Vec<Violator>, BoundsError> {
    let exists = |&t: &usize| triangles[t].iter().all(|&v| v < points.len());
    let known: Vec<usize> = (0..triangles.len()).filter(exists).collect();
    let corners: Vec<[usize; 3]> = known.iter().map(|&t| triangles[t]).collect();
    let none = Bounds::default();
    let each = [
        (
            bounds.least_angle,
            Bounds {
                least_angle: bounds.least_angle,
                ..none
            },
        ),
        (
            bounds.greatest_area,
            Bounds {
                greatest_area: bounds.greatest_area,
                ..none
            },
        ),
        (
            bounds.greatest_side,
            Bounds {
                greatest_side: bounds.greatest_side,
                ..none
            },
        ),
    ];
    let mut found = Vec::new();
    for (limit, one) in each {
        let Some(limit) = limit else { continue };
        for (position, bound) in one.violations(points, &corners)? {
            let size = size(bound, corners[position].map(|v| &points[v]));
            found.push(Violator {
                triangle: known[position],
                bound,
                size,
                limit,
            });
        }
    }
    found.sort_by_key(|violator| (violator.triangle, violator.bound));
    Ok(found)
}

/// How many triangles break a bound.
pub fn broken(violators: &[Violator]) -> usize {
    violators.chunk_by(|a, b| a.triangle == b.triangle).count()
}

/// The headline of an answer with what bounds add to it: so many of these triangles break one.
///
/// ```
/// use sweep_cdt_engine::with_bounds;
///
/// let right = "correct: a is a triangulation of b";
/// assert_eq!(with_bounds(right, 0, 8), "correct: a is a triangulation of b, within the bounds");
/// let wrong = "wrong: a is a triangulation of b, but 2 of 8 triangles break the bounds";
/// assert_eq!(with_bounds(right, 2, 8), wrong);
/// ```
pub fn with_bounds(headline: &str, broken: usize, triangles: usize) -> String {
    let breaks = if broken == 1 { "breaks" } else { "break" };
    match headline.split_once(": ") {
        _ if broken == 0 => format!("{headline}, within the bounds"),
        Some((verdict, what)) if verdict != "wrong" => {
            format!("wrong: {what}, but {broken} of {triangles} triangles {breaks} the bounds")
        }
        _ => format!("{headline}, and {broken} of {triangles} triangles {breaks} the bounds"),
    }
}
