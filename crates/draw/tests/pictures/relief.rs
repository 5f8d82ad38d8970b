//! Pictures of terrain: their colours, as SVG and as pixels.

use std::collections::BTreeSet;

use sweep_cdt::interior::FillRule;
use sweep_cdt::{Pslg, triangulate};
use sweep_cdt_draw::ResultPicture;
use sweep_cdt_formats::Column;

use crate::{assert_snapshot, graph, raster, text};

fn column(values: Vec<f64>) -> Column {
    Column {
        name: "z".to_owned(),
        values,
    }
}

fn drawn(graph: &Pslg<f64>, heights: &Column) -> String {
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let picture = ResultPicture::new(graph, &result).heights(heights);
    text(|out| picture.write(out))
}

/// The pixels of the PNG, by another decoder: the width, and three bytes for each.
fn pixels(picture: &ResultPicture<'_, f64>) -> (usize, Vec<u8>) {
    let mut file = Vec::new();
    picture.write_png(&mut file).expect("memory takes all");
    let decoder = png::Decoder::new(std::io::Cursor::new(file));
    let mut reader = decoder.read_info().expect("a header");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a small picture")];
    let info = reader.next_frame(&mut pixels).expect("pixels");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    pixels.truncate(info.buffer_size());
    (info.width as usize, pixels)
}

#[test]
fn terrain() {
    let graph = graph();
    let heights = column(vec![
        10.0,
        12.0,
        9.5,
        30.0,
        25.0,
        26.0,
        28.0,
        20.0,
        f64::NAN,
    ]);
    assert_snapshot("picture_terrain", &drawn(&graph, &heights));
}

fn plane(points: Vec<[f64; 2]>) -> Pslg<f64> {
    Pslg {
        points,
        ..Pslg::default()
    }
}

/// The colours of the areas, as they stand in the file.
fn colours(picture: &str) -> BTreeSet<&str> {
    let areas = picture.split("class=\"relief\" style=\"color:").skip(1);
    areas.map(|rest| &rest[..7]).collect()
}

fn lightness(colour: &str) -> u32 {
    let part = |at| u32::from_str_radix(&colour[at..at + 2], 16).expect("a number");
    2 * part(1) + 7 * part(3) + part(5)
}

/// Four slopes of equal steepness that cover the same heights: one falls towards the sun, one away from it.
#[test]
fn slopes_towards_the_north_west_are_light() {
    let slope = |east: f64, north: f64| {
        let graph = plane(raster(12, 12));
        let heights = graph.points.iter().map(|[x, y]| east * x + north * y);
        let picture = drawn(&graph, &column(heights.collect()));
        colours(&picture).into_iter().map(lightness).sum::<u32>() as f64
            / colours(&picture).len() as f64
    };
    let towards = slope(1.0, -1.0);
    let across = [slope(1.0, 1.0), slope(-1.0, -1.0)];
    let away = slope(-1.0, 1.0);
    for across in across {
        assert!(
            towards > across && across > away,
            "{towards} {across} {away}"
        );
    }
}

/// Equal heights, none, and none that are finite.
#[test]
fn level_ground_is_drawn_as_ever() {
    let graph = graph();
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let expected = text(|out| ResultPicture::new(&graph, &result).write(out));
    for heights in [
        vec![5.0; 9],
        vec![f64::NAN; 9],
        vec![],
        vec![f64::INFINITY; 9],
    ] {
        assert_eq!(drawn(&graph, &column(heights)), expected);
    }
}

/// The unit of the heights, and their size, do not show.
#[test]
fn heights_of_any_size_have_the_same_colours() {
    let graph = plane(raster(9, 9));
    let heights = |factor: f64| {
        let height = |[x, y]: &[f64; 2]| factor * (x * x - 3.0 * x * y + 2.0 * y);
        column(graph.points.iter().map(height).collect())
    };
    let areas = |factor| {
        let picture = drawn(&graph, &heights(factor));
        let area = |line: &&str| line.starts_with("<path class=\"relief\"");
        picture
            .lines()
            .filter(area)
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let expected = areas(1.0);
    assert!(expected.len() > 30);
    for factor in [2.0_f64.powi(-1000), 2.0_f64.powi(1013)] {
        assert_eq!(areas(factor), expected, "{factor:e}");
    }
}

/// Names of columns come from files.
#[test]
fn a_name_is_no_markup() {
    let heights = Column {
        name: "<b>&\u{7}".to_owned(),
        values: (0..9).map(f64::from).collect(),
    };
    assert!(drawn(&graph(), &heights).contains(">&lt;b&gt;&amp;: 0</text>"));
}

/// A place on a triangle has its colour in both pictures, outside of the hull there is paper, and a hole stays pale.
#[test]
fn pixels_have_the_colours_of_the_areas() {
    // A square frame around a square hole, 1000 pixels wide: a tilted plane, of which a corner is missing.
    let mut points = vec![[0.0, 0.0], [9.0, 0.0], [9.0, 9.0], [0.0, 9.0]];
    points.extend([[3.0, 3.0], [6.0, 3.0], [6.0, 6.0], [3.0, 6.0]]);
    let ring = |first: usize| [0, 1, 2, 3].map(|i| [first + i, first + (i + 1) % 4]);
    let graph = Pslg {
        points,
        edges: [ring(0), ring(4)].concat(),
        ..Pslg::default()
    };
    let mut heights: Vec<f64> = graph.points.iter().map(|[x, _]| *x).collect();
    heights[0] = f64::NAN;
    let heights = column(heights);
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let domain = result.interior(FillRule::EvenOdd).expect("closed rings");
    let picture = ResultPicture::new(&graph, &result)
        .interior(&domain)
        .heights(&heights);
    let (width, pixels) = pixels(&picture);
    // A margin of 28 pixels, and a legend of two rows of 44. The legend is the widest part.
    assert_eq!(pixels.len() / 3 / width, 1000 + 2 * 28 + 2 * 44);
    let at = |x: f64, y: f64| {
        let [x, y] = [x, 9.0 - y].map(|way| way * 1000.0 / 9.0);
        let left = (width as f64 - 1000.0) / 2.0;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "small"
        )]
        let place = (y + 28.0) as usize * width + (x + left) as usize;
        let pixel = &pixels[3 * place..][..3];
        format!("#{:02X}{:02X}{:02X}", pixel[0], pixel[1], pixel[2])
    };
    assert_eq!(at(-0.1, 4.5), "#FFFFFF");
    assert_eq!(at(4.5, 4.5), "#FFFFFF");
    // The corner without a height.
    assert_eq!(at(0.3, 0.9), "#B4B8BC");
    let svg = text(|out| picture.write(out));
    let areas = colours(&svg);
    let known = [at(8.4, 8.8), at(8.8, 0.3), at(1.0, 8.7)];
    for colour in &known {
        assert!(areas.contains(colour.as_str()), "{colour} of {areas:?}");
    }
    assert!(areas.contains("#B4B8BC"));
}

#[test]
fn pixels_show_what_has_no_heights() {
    let graph = graph();
    let result = triangulate(&graph.points, &graph.edges).expect("a correct input");
    let (width, pixels) = pixels(&ResultPicture::new(&graph, &result));
    let count = |colour: [u8; 3]| pixels.chunks(3).filter(|pixel| **pixel == colour).count();
    // Edges blue, vertices and letters dark, the area pale.
    assert!(count([0x00, 0x72, 0xB2]) > 1000);
    assert!(count([0x1B, 0x1F, 0x23]) > 500);
    assert!(count([0xF6, 0xF5, 0xF1]) > pixels.len() / 3 / 4);
    assert_eq!(width, 1056);
}
