//! How each kind of line and area of a step looks. The sheet makes style rules of this table, the page reads
//! it with the steps, and its legend lists it in this order.

use serde::Serialize;

use crate::style::{BLUE, GREEN, GREY, INK, OCHRE, ORANGE, PURPLE, SAND, SKY, SLATE, VERMILION};
use crate::window::{PIXEL, units};

/// A kind of line or area. Lengths are in pixels.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Style {
    /// The class in the sheet, and the key in the page's script.
    name: &'static str,
    /// The meaning, for the legend; nothing if it needs no explanation.
    meaning: &'static str,
    stroke: &'static str,
    width: f64,
    /// Lengths of dashes and gaps, if the line is broken.
    dash: &'static [f64],
    /// Opacity of the line.
    alpha: f64,
    /// The colour of the area.
    fill: Option<&'static str>,
    /// Opacity of the area.
    fill_alpha: f64,
    /// The direction of hatching, `/` or `\`, in the colour of the line.
    hatch: Option<char>,
}

/// All of them, in the order of the legend.
pub(super) const STYLES: [Style; 17] = [
    line("triangle", "triangle", GREY, 1.0).fill(SAND, 1.0),
    line("added", "new triangle", GREEN, 1.5).fill(GREEN, 0.3),
    line("front", "advancing front", ORANGE, 8.0).alpha(0.85),
    line("sweep", "sweep line", PURPLE, 2.0).dash(&[14.0, 5.0, 1.0, 5.0]),
    line("input", "edge to come", BLUE, 1.2)
        .dash(&[5.0, 5.0])
        .alpha(0.7),
    line("constraint", "constraint", BLUE, 3.0),
    line("inserted", "inserted edge", BLUE, 3.5).dash(&[11.0, 7.0]),
    line("pierced", "pierced triangle", SLATE, 2.0)
        .dash(&[0.1, 5.0])
        .fill(GREY, 0.15),
    line("upper", "upper pseudo-polygon", SKY, 2.0).hatch('/'),
    line("lower", "lower pseudo-polygon", OCHRE, 2.0).hatch('\\'),
    line("legal", "test: legal", GREEN, 2.0),
    line("illegal", "test: illegal", VERMILION, 2.0).dash(&[7.0, 6.0]),
    line("gone", "swapped side", VERMILION, 4.0).dash(&[0.1, 8.0]),
    line("came", "new side", VERMILION, 4.0),
    line("ray", "triangle with P‑1, P‑2", GREY, 1.0)
        .dash(&[2.0, 6.0])
        .alpha(0.55)
        .fill(GREY, 0.07),
    line("line", "front segment", INK, 4.0),
    line("quad", "", INK, 1.0).fill(INK, 0.05),
];

const fn line(
    name: &'static str,
    meaning: &'static str,
    stroke: &'static str,
    width: f64,
) -> Style {
    Style {
        name,
        meaning,
        stroke,
        width,
        dash: &[],
        alpha: 1.0,
        fill: None,
        fill_alpha: 1.0,
        hatch: None,
    }
}

impl Style {
    const fn dash(self, dash: &'static [f64]) -> Style {
        Style { dash, ..self }
    }

    const fn alpha(self, alpha: f64) -> Style {
        Style { alpha, ..self }
    }

    const fn fill(self, fill: &'static str, fill_alpha: f64) -> Style {
        Style {
            fill: Some(fill),
            fill_alpha,
            ..self
        }
    }

    const fn hatch(self, direction: char) -> Style {
        Style {
            fill_alpha: 0.19,
            hatch: Some(direction),
            ..self
        }
    }

    /// The style rule of its class, with lengths in units of the picture.
    pub(super) fn rule(&self) -> String {
        let pixels = |length: f64| units(length * PIXEL as f64);
        let (name, stroke) = (self.name, self.stroke);
        let mut rule = format!(
            ".{name} {{ stroke: {stroke}; stroke-width: {}",
            pixels(self.width)
        );
        if !self.dash.is_empty() {
            let dashes = self.dash.iter().map(|&length| pixels(length).to_string());
            rule += "; stroke-dasharray: ";
            rule += &dashes.collect::<Vec<_>>().join(" ");
        }
        if self.alpha < 1.0 {
            rule += &format!("; stroke-opacity: {}", self.alpha);
        }
        match (self.hatch, self.fill) {
            (Some(_), _) => rule += &format!("; fill: url(#{name})"),
            (None, Some(fill)) if self.fill_alpha < 1.0 => {
                rule += &format!("; fill: {fill}; fill-opacity: {}", self.fill_alpha);
            }
            (None, Some(fill)) => rule += &format!("; fill: {fill}"),
            (None, None) => {}
        }
        rule + " }\n"
    }

    /// The pattern of its hatching, if it has one: a tile of 8 pixels, with the line through the corners
    /// drawn in all tiles that it touches.
    pub(super) fn pattern(&self) -> Option<String> {
        let lines = match self.hatch? {
            '/' => "M-100 100L100 -100M-100 900L900 -100M700 900L900 700",
            _ => "M700 -100L900 100M-100 -100L900 900M-100 700L100 900",
        };
        let (name, stroke, alpha) = (self.name, self.stroke, self.fill_alpha);
        Some(format!(
            r#"<pattern id="{name}" width="800" height="800" patternUnits="userSpaceOnUse"><rect width="800" height="800" fill="{stroke}" fill-opacity="{alpha}"/><path d="{lines}" style="stroke: {stroke}; stroke-width: 120"/></pattern>
"#
        ))
    }
}
