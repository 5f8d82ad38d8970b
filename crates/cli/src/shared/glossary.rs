//! What each figure of a report is: one line for each, which `--explain` prints below the figure.

/// The figures and their lines.
pub(crate) const GLOSSARY: &[(&str, &str)] = &[
    ("points", "vertices of the input"),
    (
        "distinct points",
        "vertices of the input at different places; equal ones count once",
    ),
    (
        "edges",
        "edges of the input, which must be sides or chains of sides",
    ),
    ("triangles", "triangles of the result"),
    (
        "boundary sides",
        "sides with a triangle on one side only; in a correct result they are the hull, or the boundary of the interior",
    ),
    (
        "constrained sides",
        "sides that are edges of the input or pieces of them; they need not be Delaunay",
    ),
    (
        "free sides",
        "sides between two triangles that are no edges of the input; each must be Delaunay",
    ),
    (
        "cocircular ties",
        "free sides whose four vertices are on one circle: either diagonal is Delaunay",
    ),
    (
        "ties not canonical",
        "ties where this program takes the other diagonal; they are right all the same",
    ),
    (
        "added points",
        "corners that are no vertices of the input, which --steiner allows",
    ),
    (
        "split edges",
        "edges of the input with an added point on them, or beside them by rounding",
    ),
    (
        "highest level",
        "what the triangles are: none, tiling, constrained, delaunay or canonical; each includes those before it",
    ),
    (
        "signs: by filter",
        "the share of decisions for which rounded numbers were certain enough",
    ),
    (
        "signs: exact",
        "the share of decisions that took exact arithmetic; both kinds are proven",
    ),
    (
        "from 1e-16 to 1e-15",
        "how many violations are so deep, for each power of ten; all near 1e-16 are rounding, a wrong algorithm goes deeper",
    ),
    (
        "not measured",
        "violations without a depth; of very many, those that are left out without --max-depth",
    ),
    (
        "the deepest",
        "the greatest of these depths: a --max-depth above it accepts them",
    ),
];

/// The line of a figure.
pub(crate) fn meaning(figure: &str) -> &'static str {
    let is_decade = figure.starts_with("1e");
    let named =
        |(name, _): &&(&str, &str)| *name == figure || is_decade && name.starts_with("from");
    GLOSSARY.iter().find(named).map_or("", |(_, line)| line)
}
