//! The table: name, points, edges; written as coordinates and indices with commas between.

type Case = (&'static str, &'static str, &'static str);

/// The situations that the paper draws.
pub(super) const PAPER: &[Case] = &[
    ("figure 6: first triangle", "0 0, 4 1, 1 3", ""),
    ("figure 7: middle case", "0 0, 9 1, 4 6", ""),
    ("figure 8: left case", "0 0, 9 1, 4 2, 4 6", ""),
    (
        "figure 9: fill while the angle is below pi/2",
        "0 0, 6 1, 12 2, 14 8, 7 9",
        "",
    ),
    (
        "figure 10: basin",
        "4 0, 6 0.5, 2 1, 8 2, 1 4, 9.5 5, 0 8, 10 9, -0.5 12",
        "",
    ),
    (
        "figure 11: first pierced triangle",
        "0 0, 6 1, 3 2, 5 4, 2 8",
        "1 4",
    ),
    (
        "figure 12: upper and lower pseudo-polygon",
        "0 2, 1 0, 1.5 4, 3 0.5, 3.5 4.5, 5 1, 5.5 5, 7 1.5, 7.5 5.5, 9 2, 9.5 6, 11 7",
        "0 11",
    ),
    (
        "figure 13: edge above the front",
        "2 0, 1 1, 3 1.5, 0 5, 4 6",
        "3 4",
    ),
    (
        "figure 14: edge through teeth of the front",
        "0 1, 3 6, 5 0, 7 7, 9 2, 11 9, 12 3, 14 10",
        "0 7",
    ),
    (
        "figure 15: upper hull",
        "0 0, 1 0.25, 2 1, 3 2.25, -1 0.5, -2 1.5, -3 3",
        "",
    ),
    (
        "figure 15: lower hull",
        "-3 0, 3 0.5, -2 5, 2 6, -1 8, 1 8.5, 0 9",
        "",
    ),
];

/// What else is known to break programs.
pub(super) const CASES: &[Case] = &[
    ("nothing", "", ""),
    ("one point", "1 2", "0 0"),
    ("two points", "0 0, 0 1", "0 1"),
    ("a row of three", "0 0, 1 0, 0.5 0", "0 1"),
    ("a column", "3 0, 3 5, 3 -2, 3 1", "1 2, 0 3"),
    ("a slanted line", "0 0, 2 1, 6 3, 4 2", "0 2, 1 3"),
    ("one point four times", "1 1, 1 1, 1 1, 1 1", "0 3"),
    (
        "lattice of three by three",
        "0 0, 1 0, 2 0, 0 1, 1 1, 2 1, 0 2, 1 2, 2 2",
        "",
    ),
    (
        "four points that finite artificial points lose",
        "0.213 0.972, 0.655 0.0356, 0.602 0.408, 0.458 0.663",
        "",
    ),
    (
        "artificial points round onto these",
        "1e16 0, 10000000000000002 0, 1e16 2",
        "",
    ),
    (
        "sums of these overflow",
        "-1.5e308 0, 1.5e308 -1.5e308, 1 1.5e308",
        "0 1",
    ),
    (
        "products of these underflow",
        "0 0, 1e-200 0, 3e-200 1e-200, 0 5e-324",
        "",
    ),
    ("zero has two signs", "0 -0, -0 0, 1 -0, -0 1", "1 3, 0 1"),
    ("horizontal edge", "0 2, 6 2, 3 0, 3 1.9, 2 2.5", "0 1"),
    (
        "horizontal edge, ends swapped",
        "0 2, 6 2, 2.5 0, 3 1.5",
        "1 0",
    ),
    ("vertical edge", "2 0, 2 6, 1 1, 3 2, 1.5 4, 2.5 5", "0 1"),
    ("above the leftmost", "0 0, 3 2, 0 5", ""),
    ("above the rightmost", "3 0, 0 2, 3 5, 3 6", ""),
    (
        "three in a column on the front",
        "0 0, 8 0, 4 1, 4 2, 4 3",
        "",
    ),
    (
        "edge that is there already",
        "0 0, 4 0, 1 3",
        "0 2, 1 0, 2 1",
    ),
    (
        "front falls below the extended edge beyond its end",
        "-3 -2, 2 0, 4 1, 0 2, 6 6",
        "3 4",
    ),
    (
        "front falls below the extended edge to the right",
        "9 -2, 4 0, 2 1, 6 2, 0 6",
        "3 4",
    ),
    (
        "lower end buried under the front",
        "5 0, 0 1, 10 1.2, 3 2, 7 2.2, 5 3, 4 5, 5.5 9",
        "0 7",
    ),
    ("vertex on an edge", "0 0, 4 4, 2 2, 3 0, 0 3", "0 1"),
    (
        "vertices on an edge, triangles between",
        "0 0, 9 9, 3 3, 6 6, 2 1, 1 2, 5 4, 4 5, 8 7",
        "0 1",
    ),
    ("vertices on a row", "0 0, 9 0, 3 0, 6 0, 4 -1, 5 1", "1 0"),
    (
        "vertices on a column",
        "0 0, 0 9, 0 3, 0 6, -1 4, 1 5",
        "0 1",
    ),
    (
        "the front touches the edge from below",
        "0 0, 2 2, 4 1, 5 5, 7 3, 8 8",
        "0 5",
    ),
    (
        "the front touches the edge from above",
        "0 0, 1 3, 2 2, 3 5, 6 6, 7 1, 9 9",
        "0 6",
    ),
    (
        "overlapping edges",
        "0 0, 2 1, 4 2, 6 3, 3 4, 3 -4",
        "0 2, 1 3, 3 0, 2 1",
    ),
    (
        "an edge three times",
        "0 0, 4 1, 2 3, 2 -3",
        "2 3, 3 2, 2 3",
    ),
    ("edges of no length", "0 0, 4 1, 2 3, 4 1", "1 1, 1 3, 3 0"),
    ("two edges cross", "0 0, 4 4, 0 4, 4 0", "0 1, 2 3"),
    (
        "two edges cross at a vertex",
        "0 0, 4 4, 0 4, 4 0, 2 2",
        "0 1, 2 3",
    ),
    ("one edge ends on another", "0 0, 4 4, 2 2, 4 0", "0 1, 2 3"),
    (
        "an edge crosses an edge above the front",
        "0 3, 6 4, 3 0, 3 9, 1 1, 5 1.5",
        "0 1, 2 3",
    ),
    (
        "an edge crosses an edge with overlapping copies",
        "0 3, 6 3, 3 0, 3 9, 2 3, 4 3",
        "0 5, 4 1, 2 3",
    ),
    (
        "star with one upper end",
        "5 9, 0 0, 2 1, 4 0, 6 1, 8 0, 10 2, 3 5",
        "0 1, 0 2, 0 3, 0 4, 0 5, 0 6, 0 7",
    ),
    (
        "star with one lower end",
        "5 0, 0 9, 2 8, 4 9, 6 8, 8 9, 10 7, 3 4",
        "1 0, 2 0, 3 0, 4 0, 5 0, 6 0, 7 0",
    ),
    (
        "hanging edges in the lower pseudo-polygon",
        "0 4, 12 5, 3 3.9, 3.5 0, 6 4.1, 5 0.5, 9 4.2, 8 0.2, 6 4.9",
        "2 3, 4 5, 6 7, 0 1",
    ),
    (
        "hanging edges in the upper pseudo-polygon",
        "0 2, 12 12, 3 5, 2 8, 6 7.5, 5 9, 9 10, 8 11, 6 1, 10 3",
        "2 3, 4 5, 6 7, 0 1",
    ),
    (
        "a hanging edge stays constrained",
        "-3 -96, -1 -53, 2 -101, -2 -74, -1 -106, 0 -83, -2 -95",
        "4 1, 6 0",
    ),
    (
        "hanging edges on both sides, one visited twice",
        "0 0, 20 1, 5 0.5, 6 -4, 7 -3, 10 0.4, 10 0.7, 9 0.9, 11 0.95, 15 0.5, 15 -5",
        "2 3, 2 4, 6 7, 6 8, 9 10, 0 1",
    ),
    (
        "loop in a pseudo-polygon",
        "0 0, 16 2, 8 0.8, 6 -3, 10 -3, 8 -2, 8 -0.5, 4 0.9, 12 1.8",
        "2 3, 3 4, 4 2, 5 6, 0 1",
    ),
    (
        "closed polygon with a hole",
        "0 0, 8 1, 9 8, 4 6, 1 9, 3 2, 5 2.5, 4 4",
        "0 1, 1 2, 2 3, 3 4, 4 0, 5 6, 6 7, 7 5",
    ),
    (
        "fan of a circle cut by an edge",
        "5 0, 4 3, 3 4, 0 5, -3 4, -4 -3, 0 -5, 3 -4",
        "1 5",
    ),
    (
        "circle with its centre",
        "5 0, 0 5, -5 0, 0 -5, 3 4, -3 -4, 0 0",
        "",
    ),
    (
        "circle, an edge beside the fan",
        "0 0, 2 0, 2 2, 0 2, 1 3",
        "1 2",
    ),
    (
        "one unit in the last place above a line",
        "0 0, 0.1 0.1, 0.2 0.2, 0.3 0.30000000000000004, 0.7 0.7, 1 0",
        "0 4",
    ),
    (
        "vertices on an edge of the largest numbers",
        "-1.5e308 -1.5e308, 1.5e308 1.5e308, 0 0, 5e-324 0, 1 1",
        "0 1",
    ),
    (
        "integers that need more than 128 bits",
        "-2147483648 -2147483648, 2147483647 -2147483648, 2147483647 2147483647, -2147483648 2147483647, 0 0",
        "0 2",
    ),
];
