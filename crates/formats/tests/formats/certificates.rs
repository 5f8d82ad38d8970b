//! How certificates grow: with the input, however many rings lie in each other, beside each other or over each other.

use std::collections::HashMap;

use sweep_cdt::interior::Ring;
use sweep_cdt::triangulate;
use sweep_cdt_formats::{Polygons, write_certificate};

/// The left, lower, right and upper side of a rectangle.
type Rectangle = [u32; 4];

/// The bytes of the certificate of rectangles, each a polygon, for each triangle.
fn bytes_a_triangle(rectangles: impl Iterator<Item = Rectangle>) -> f64 {
    let (mut numbers, mut points) = (HashMap::new(), Vec::new());
    let mut number = |point: [u32; 2]| {
        *numbers.entry(point).or_insert_with(|| {
            points.push(point.map(f64::from));
            points.len() - 1
        })
    };
    let mut polygons = Polygons::default();
    let mut edges = Vec::new();
    for (ring, [left, low, right, high]) in rectangles.enumerate() {
        let corners = [[left, low], [right, low], [right, high], [left, high]].map(&mut number);
        for k in 0..4 {
            edges.push([corners[k], corners[(k + 1) % 4]]);
            polygons.ring_of.push(Some(ring));
        }
        polygons.rings.push(Ring {
            polygon: ring,
            is_hole: false,
        });
        polygons.features.push(ring + 1);
    }
    let result = triangulate(&points, &edges).expect("edges that do not cross");
    let interior = polygons.interior(&result).expect("closed rings");
    let triangles: Vec<[usize; 3]> = result.triangles().collect();
    let mut text = Vec::new();
    let is_inside = |t: usize| interior.is_inside(t);
    write_certificate(
        &points,
        &edges,
        Some(&polygons),
        &triangles,
        is_inside,
        &mut text,
    )
    .expect("a certificate");
    #[expect(clippy::cast_precision_loss, reason = "small numbers")]
    let quotient = text.len() as f64 / triangles.len() as f64;
    quotient
}

#[test]
fn certificates_grow_with_the_input() {
    let nested = |count: u32| (0..count).map(move |n| [n, n, 4 * count - n, 4 * count - n]);
    let beside = |count: u32| (0..count).map(move |n| [n, 0, n + 1, 1]);
    // Each over the three before it and after it.
    let over = |count: u32| (0..count).map(move |n| [n, n % 2, n + 3, n % 2 + 1]);
    let growth = [
        (
            "nested",
            [100, 3200].map(|count| bytes_a_triangle(nested(count))),
        ),
        (
            "beside",
            [100, 3200].map(|count| bytes_a_triangle(beside(count))),
        ),
        (
            "over",
            [100, 3200].map(|count| bytes_a_triangle(over(count))),
        ),
    ];
    for (name, [small, large]) in growth {
        println!("{name}: {small:.1} and {large:.1} bytes a triangle");
        // Numbers become longer.
        assert!(large < 1.6 * small, "{name}: {small} and {large}");
    }
}
