//! A sheet of pixels: areas, lines, dots and letters, with smooth borders.
//!
//! Each pixel has [`FINE`] times as many samples across and down. A sample has the colour of what was painted last over
//! its middle, and a pixel the mean of its samples. Two areas with a common side leave no gap and do not overlap: where a
//! row of samples crosses a side is computed from the lower end of the side, whichever area it bounds.
//!
//! Cost: the samples painted, and for each area a sort of the crossings of its sides with rows of samples.

use super::font;
use super::style::Rgb;
use super::window::PIXEL;

/// Samples of a pixel across and down.
const FINE: usize = 3;
/// Units of a picture for a sample.
const SAMPLE: f64 = PIXEL as f64 / FINE as f64;
/// Samples across and down for a dot of a letter.
const DOT: i64 = 4;
/// The directions of the corners of a disc.
const DISC: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [0.707, 0.707],
    [0.0, 1.0],
    [-0.707, 0.707],
    [-1.0, 0.0],
    [-0.707, -0.707],
    [0.0, -1.0],
    [0.707, -0.707],
];

/// Places of a picture, in its units.
type Place = [i64; 2];

/// The samples of a picture.
#[derive(Debug)]
pub(super) struct Raster {
    /// Samples across and down.
    size: [usize; 2],
    samples: Vec<Rgb>,
}

impl Raster {
    /// A sheet of a colour, for a picture of this size in units.
    pub(super) fn new(size: [i64; 2], colour: Rgb) -> Raster {
        let pixels = size.map(|side| usize::try_from(side / PIXEL).unwrap_or(0).max(1));
        let size = pixels.map(|side| side * FINE);
        Raster {
            size,
            samples: vec![colour; size[0] * size[1]],
        }
    }

    /// The width in pixels, and the pixels, row by row: red, green and blue.
    pub(super) fn pixels(&self) -> (usize, Vec<u8>) {
        let width = self.size[0] / FINE;
        let mut pixels = Vec::with_capacity(width * self.size[1] / FINE * 3);
        for rows in self.samples.chunks_exact(self.size[0] * FINE) {
            for x in 0..width {
                let mut sums = [0_usize; 3];
                for row in rows.chunks_exact(self.size[0]) {
                    for sample in &row[x * FINE..(x + 1) * FINE] {
                        (0..3).for_each(|part| sums[part] += usize::from(sample[part]));
                    }
                }
                let mean = |sum: usize| u8::try_from(sum / (FINE * FINE)).unwrap_or(u8::MAX);
                pixels.extend(sums.map(mean));
            }
        }
        (width, pixels)
    }

    /// Fills what sides go round, whichever way: each from its first to its second place.
    pub(super) fn fill(&mut self, colour: Rgb, sides: impl IntoIterator<Item = [Place; 2]>) {
        let mut crossings = Vec::new();
        for [from, to] in sides {
            let ends = [from, to].map(|end| end.map(|x| x as f64 / SAMPLE));
            let is_up = from[1] < to[1];
            let [low, high] = if is_up { ends } else { [ends[1], ends[0]] };
            for row in self.rows(low[1], high[1]) {
                let share = (row as f64 + 0.5 - low[1]) / (high[1] - low[1]);
                let x = low[0] + share * (high[0] - low[0]);
                crossings.push((row, x, if is_up { 1 } else { -1 }));
            }
        }
        crossings.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let mut winding = 0;
        for pair in crossings.windows(2) {
            winding += pair[0].2;
            if winding != 0 {
                self.paint(pair[0].0, [pair[0].1, pair[1].1], colour);
            }
        }
    }

    /// Draws a line of this width through places, with round ends.
    pub(super) fn stroke(&mut self, colour: Rgb, width: f64, places: &[Place]) {
        // A line is a sample wide at least.
        let half = width.max(SAMPLE) / 2.0;
        for step in places.windows(2) {
            let [[x, y], [to_x, to_y]] = [step[0], step[1]].map(|place| place.map(|x| x as f64));
            let [dx, dy] = [to_x - x, to_y - y];
            let length = (dx * dx + dy * dy).sqrt();
            if length > 0.0 {
                let [ax, ay] = [-dy, dx].map(|part| part / length * half);
                let corners = [
                    [x + ax, y + ay],
                    [to_x + ax, to_y + ay],
                    [to_x - ax, to_y - ay],
                    [x - ax, y - ay],
                ];
                self.fill_convex(colour, &corners);
            }
        }
        // Round ends and corners of what is too thin for them would not show.
        if half > SAMPLE {
            places
                .iter()
                .for_each(|&place| self.dot(colour, width, place));
        }
    }

    /// Draws dashes and gaps of these lengths along a line.
    pub(super) fn stroke_dashed(
        &mut self,
        colour: Rgb,
        width: f64,
        dashes: [f64; 2],
        places: &[Place],
    ) {
        // How far into a dash or gap, and which of the two.
        let (mut done, mut now) = (0.0, 0);
        for step in places.windows(2) {
            let [from, to] = [step[0], step[1]].map(|place| place.map(|x| x as f64));
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            let at = |way: f64| {
                let place = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * way / length);
                place.map(super::window::units)
            };
            let mut way = 0.0;
            // A dash that ends on this step ends there by rule, not by a sum: so every turn draws or goes on.
            while way < length {
                let rest = dashes[now] - done;
                let is_ended = way + rest <= length;
                let end = if is_ended { way + rest } else { length };
                if now == 0 {
                    self.stroke(colour, width, &[at(way), at(end)]);
                }
                (done, now) = if is_ended {
                    (0.0, 1 - now)
                } else {
                    (done + (end - way), now)
                };
                way = end;
            }
        }
    }

    /// Draws a disc of this diameter.
    pub(super) fn dot(&mut self, colour: Rgb, width: f64, [x, y]: Place) {
        let corner =
            |[dx, dy]: [f64; 2]| [x as f64 + dx * width / 2.0, y as f64 + dy * width / 2.0];
        self.fill_convex(colour, &DISC.map(corner));
    }

    /// Fills a box, from its upper left to its lower right corner.
    pub(super) fn fill_box(&mut self, colour: Rgb, [from, to]: [Place; 2]) {
        let [[left, top], [right, bottom]] = [from, to].map(|place| place.map(|x| x as f64));
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        self.fill_convex(colour, &corners);
    }

    /// Writes a text whose letters stand on a line through this place, which begins there.
    pub(super) fn text(&mut self, colour: Rgb, [x, y]: Place, text: &str) {
        let dot = DOT as f64 * SAMPLE;
        let left = x as f64;
        let top = y as f64 - font::ASCENT as f64 * dot;
        for (at, letter) in text.chars().enumerate() {
            for (across, column) in font::columns(letter).into_iter().enumerate() {
                let x = left + (at as f64 * font::ADVANCE as f64 + across as f64) * dot;
                for down in (0..8).filter(|down| column >> down & 1 == 1) {
                    let y = top + f64::from(down) * dot;
                    let [right, bottom] = [x + dot, y + dot];
                    let corners = [[x, y], [right, y], [right, bottom], [x, bottom]];
                    self.fill_convex(colour, &corners);
                }
            }
        }
    }

    /// How wide a text is, in units.
    pub(super) fn text_width(text: &str) -> i64 {
        let letters = i64::try_from(text.chars().count()).unwrap_or(0);
        letters * font::ADVANCE * DOT * PIXEL / FINE as i64
    }

    /// Fills a convex polygon, in units.
    fn fill_convex(&mut self, colour: Rgb, corners: &[[f64; 2]]) {
        let corner = |at: usize| corners[at % corners.len()].map(|x| x / SAMPLE);
        let ys = || (0..corners.len()).map(|at| corner(at)[1]);
        let low = ys().fold(f64::INFINITY, f64::min);
        let high = ys().fold(f64::NEG_INFINITY, f64::max);
        for row in self.rows(low, high) {
            let y = row as f64 + 0.5;
            let mut span = [f64::INFINITY, f64::NEG_INFINITY];
            for at in 0..corners.len() {
                let [a, b] = [corner(at), corner(at + 1)];
                if (a[1] <= y) != (b[1] <= y) {
                    let x = a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    span = [span[0].min(x), span[1].max(x)];
                }
            }
            self.paint(row, span, colour);
        }
    }

    /// The rows of samples whose middles are between two heights.
    fn rows(&self, low: f64, high: f64) -> std::ops::Range<usize> {
        first(low, self.size[1])..first(high, self.size[1])
    }

    /// Paints the samples of a row whose middles are between two places.
    fn paint(&mut self, row: usize, [from, to]: [f64; 2], colour: Rgb) {
        let [from, to] = [from, to].map(|x| first(x, self.size[0]));
        if from < to {
            let start = row * self.size[0];
            self.samples[start + from..start + to].fill(colour);
        }
    }
}

/// The first of so many samples whose middle is not before a place.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is between 0 and the number of samples"
)]
fn first(place: f64, count: usize) -> usize {
    (place - 0.5).ceil().clamp(0.0, count as f64) as usize
}

#[cfg(test)]
mod tests {
    use super::{FINE, Raster};

    const WHITE: [u8; 3] = [255; 3];
    const BLACK: [u8; 3] = [0; 3];

    fn painted(raster: &Raster) -> usize {
        let painted = raster.samples.iter().filter(|sample| **sample == BLACK);
        painted.count()
    }

    #[test]
    fn areas_that_share_sides_cover_each_sample_once() {
        let corners = [
            [100, 100],
            [1900, 250],
            [1700, 1900],
            [333, 1777],
            [977, 911],
        ];
        let whole: Vec<[[i64; 2]; 2]> =
            (0..4).map(|i| [corners[i], corners[(i + 1) % 4]]).collect();
        let mut raster = Raster::new([2000, 2000], WHITE);
        raster.fill(BLACK, whole);
        let together = painted(&raster);
        let mut parts = 0;
        for i in 0..4 {
            let [a, b, c] = [corners[i], corners[(i + 1) % 4], corners[4]];
            let mut raster = Raster::new([2000, 2000], WHITE);
            raster.fill(BLACK, [[a, b], [b, c], [c, a]]);
            parts += painted(&raster);
        }
        assert_eq!(parts, together);
        // The area by the formula of shoelaces, in samples.
        let cross = |a: [i64; 2], b: [i64; 2]| a[0] * b[1] - a[1] * b[0];
        let area: i64 = (0..4)
            .map(|i| cross(corners[i], corners[(i + 1) % 4]))
            .sum();
        let area = area as f64 / 2.0 / 10_000.0 * (FINE * FINE) as f64;
        assert!(
            (together as f64 - area).abs() < 0.01 * area,
            "{together} {area}"
        );
    }

    #[test]
    fn a_hole_is_not_filled() {
        let ring = |from: i64, to: i64| {
            let corners = [[from, from], [to, from], [to, to], [from, to]];
            [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]])
        };
        let mut raster = Raster::new([1000, 1000], WHITE);
        let hole = ring(300, 600).map(|[from, to]| [to, from]);
        raster.fill(BLACK, ring(100, 900).into_iter().chain(hole));
        assert_eq!(painted(&raster), (64 - 9) * FINE * FINE);
        let (width, pixels) = raster.pixels();
        assert_eq!((width, pixels.len()), (10, 300));
        let pixel = |x: usize, y: usize| &pixels[3 * (10 * y + x)..][..3];
        assert_eq!([pixel(1, 1), pixel(4, 4)], [&BLACK[..], &WHITE[..]]);
    }

    #[test]
    fn what_lies_beside_the_sheet_is_cut_off() {
        let mut raster = Raster::new([1000, 1000], WHITE);
        raster.stroke(BLACK, 200.0, &[[-5000, 500], [5000, 500]]);
        assert_eq!(painted(&raster), 20 * FINE * FINE);
        raster.stroke_dashed(BLACK, 100.0, [100.0, 100.0], &[[0, 0], [0, 0]]);
        raster.dot(BLACK, 100.0, [-4000, 90_000]);
        assert_eq!(painted(&raster), 20 * FINE * FINE);
    }

    /// A dash whose end was a sum could fall short of its length by less than the doubles there tell, and then no turn
    /// of the loop went on.
    #[test]
    fn dashes_come_to_an_end_on_every_line() {
        for i in 1..200_i64 {
            let mut raster = Raster::new([1000, 1000], WHITE);
            let places = [
                [0, 0],
                [9_973 * i % 7919, 137 * i],
                [61 * i, 7_001 * i % 9973],
            ];
            raster.stroke_dashed(BLACK, 50.0, [70.0, 30.0], &places);
            assert!(painted(&raster) > 0);
        }
        // Along a straight line seven tenths are dashes.
        let mut raster = Raster::new([100_000, 300], WHITE);
        // So thin a line is a sample wide, and has no round ends.
        raster.stroke_dashed(BLACK, 1.0, [700.0, 300.0], &[[0, 150], [100_000, 150]]);
        let whole = 1000 * FINE;
        assert!(painted(&raster).abs_diff(whole * 7 / 10) <= whole / 50);
    }
}
