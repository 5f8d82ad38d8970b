//! The verifier accepts what is right and nothing else, and no input makes it panic.
//!
//! The triangles are a right answer with up to three changes, or garbage, or they go round a hub, some of them more
//! than once or with dents. For few points the judge is [`is_right`](sweep_cdt_testing::oracle::is_right), which compares
//! everything with everything in exact integers. For more points it is uniqueness: a constrained Delaunay
//! triangulation is unique up to cocircular vertices, so a result that the oracle's
//! [`check`](sweep_cdt_testing::oracle::check) has passed decides which triangles are right. Neither shares
//! code with the verifier. What the verifier calls canonical must be the sweep's answer. Its options must
//! not change its verdict, levels are what they say, and faults are as deep as fractions say. The last points may be
//! vertices that the input lacks, also on the sides of a declared domain. Holes, other domains, by each rule and
//! from polygons, and regions are declared in a right answer. Some bytes are a result whose vertices have moved.

mod case;
mod measured;
mod moved;
mod outline;
mod rules;
mod shown;

use arbitrary::{Result, Unstructured};
use sweep_cdt::verify::{Report, Verifier, Violation, Violations, verify};
use sweep_cdt_testing::tuned::triangulate;

use self::case::{
    Case, is_certainly_right, judge_hole, judge_part, judge_regions, judge_unused, judge_wound,
};
use self::moved::Moved;
use crate::file::File;
use crate::reached;
use sweep_cdt_testing::oracle::canonical;
use sweep_cdt_testing::{Input, generators};

/// As many points, triangles or edges of garbage at most.
const GARBAGE: usize = 12;

/// So many bytes come before those of a generated input at most: which case, and three changes.
pub const LEAD: usize = 13;

/// The case that the bytes stand for.
enum Kind {
    /// Or dented triangles around a hub, of which no more is known.
    Garbage,
    /// Triangles around a hub.
    Wound,
    /// A right answer to an input, and what is changed.
    Changed(Input, Vec<[u8; 4]>),
    /// A result whose vertices have moved.
    Moved(Option<Moved>),
}

/// Which of these, and the case to verify: none if vertices have moved.
fn read(style: u8, bytes: &mut Unstructured<'_>) -> Result<(Kind, Case)> {
    Ok(match style & 3 {
        0 if style >> 6 == 0 => (Kind::Wound, wound(bytes)?),
        0 if style >> 6 == 1 => (Kind::Moved(Moved::read(bytes)?), Case::default()),
        0 if style >> 6 == 2 => (Kind::Garbage, dented(bytes)?),
        0 => (Kind::Garbage, garbage(bytes)?),
        count => {
            let (input, changes) = changed(count, bytes)?;
            (Kind::Changed(input, changes), Case::default())
        }
    })
}

/// The style, and what the bytes stand for.
fn of(bytes: &[u8]) -> (u8, Kind, Case) {
    let mut bytes = Unstructured::new(bytes);
    // Reading is total but for a type that has no values.
    let style: u8 = bytes.arbitrary().unwrap_or_default();
    let (kind, mut case) = read(style, &mut bytes).unwrap_or((Kind::Garbage, Case::default()));
    if let Kind::Changed(input, changes) = &kind {
        case = answered(input);
        for &change in changes {
            case::change(&mut case, change);
        }
    }
    (style, kind, case)
}

/// The property for the case that the bytes stand for.
pub fn test(bytes: &[u8]) {
    let (style, kind, case) = of(bytes);
    match kind {
        Kind::Moved(moved) => return moved.as_ref().map_or((), Moved::judge),
        Kind::Wound => judge_wound(&case),
        Kind::Changed(input, _) => reached::sample(&input),
        Kind::Garbage => {}
    }
    judge(&case, style >> 2 & 7 == 0);
}

/// The input and the result to verify, with a picture of what is wrong with it; or the file whose vertices have moved.
pub fn files(bytes: &[u8]) -> Vec<File> {
    let (_, kind, case) = of(bytes);
    match kind {
        Kind::Moved(moved) => moved.map_or_else(Vec::new, Moved::files),
        _ => case.files(),
    }
}

/// Points of any bits, no numbers or on a lattice, and indices of which most are in range.
fn garbage(bytes: &mut Unstructured<'_>) -> Result<Case> {
    let mut case = Case::default();
    let counts: [u8; 3] = bytes.arbitrary()?;
    let [points, triangles, edges] = counts.map(|count| usize::from(count) % (GARBAGE + 1));
    let number = |bytes: &mut Unstructured<'_>| match bytes.arbitrary::<u8>()? {
        255 => bytes.arbitrary::<f64>(),
        254 => Ok(f64::NAN),
        253 => Ok(f64::INFINITY),
        place => Ok(f64::from(place & 3)),
    };
    for _ in 0..points {
        case.points.push([number(bytes)?, number(bytes)?]);
    }
    let index = |bytes: &mut Unstructured<'_>| match bytes.arbitrary::<u8>()? {
        255 => bytes.arbitrary::<usize>(),
        254 => Ok(points),
        place => Ok(usize::from(place) % points.max(1)),
    };
    for _ in 0..triangles {
        let corners = [index(bytes)?, index(bytes)?, index(bytes)?];
        case.triangles.push(corners);
    }
    for _ in 0..edges {
        case.edges.push([index(bytes)?, index(bytes)?]);
    }
    Ok(case)
}

/// So many points on a circle about the origin, counter-clockwise.
fn rim(n: usize) -> impl Iterator<Item = [f64; 2]> {
    let places = generators::around(25);
    (0..n).map(move |i| places[i * places.len() / n].map(f64::from))
}

/// Triangles from a hub to points around it, each over so many of them: above one they go round more than
/// once, on one closed line or on more, and no two of them conflict.
fn wound(bytes: &mut Unstructured<'_>) -> Result<Case> {
    let counts: [u8; 2] = bytes.arbitrary()?;
    let n = 3 + usize::from(counts[0] % 5);
    let over = 1 + usize::from(counts[1] % 3);
    let mut points = vec![[0.0, 0.0]];
    points.extend(rim(n));
    let triangles = (0..n).map(|i| [0, 1 + i, 1 + (i + over) % n]);
    Ok(Case {
        triangles: triangles.collect(),
        points,
        edges: Vec::new(),
    })
}

/// A case with rim points at several distances from the hub, so that the closed lines turn right at some.
fn dented(bytes: &mut Unstructured<'_>) -> Result<Case> {
    let counts: [u8; 2] = bytes.arbitrary()?;
    let n = 5 + usize::from(counts[0] % 8);
    let over = 1 + usize::from(counts[1] % 2);
    let mut points = vec![[0.0, 0.0]];
    for place in rim(n) {
        let distance = *bytes.choose(&[1.0, 1.0, 1.0, 0.5, 0.25, 0.125, 1.0 - f64::EPSILON])?;
        points.push(place.map(|x| distance * x));
    }
    let triangles = (0..n).map(|i| [0, 1 + i, 1 + (i + over) % n]);
    Ok(Case {
        triangles: triangles.collect(),
        points,
        edges: Vec::new(),
    })
}

/// An input, and so many changes of its answer.
fn changed(count: u8, bytes: &mut Unstructured<'_>) -> Result<(Input, Vec<[u8; 4]>)> {
    let mut words = Vec::new();
    for _ in 0..count {
        words.push(bytes.arbitrary()?);
    }
    Ok((generators::read(bytes)?, words))
}

/// An input with its right answer.
fn answered(Input { points, edges }: &Input) -> Case {
    // Of edges that cross only some are there, and the others to be missed.
    let result = triangulate(points, edges).or_else(|_| triangulate(points, &[]));
    Case {
        triangles: result.map_or_else(|_| Vec::new(), |result| result.triangles().collect()),
        points: points.clone(),
        edges: edges.clone(),
    }
}

/// Panics unless the verifier decides right, and the same in all ways to call it.
fn judge(case: &Case, in_parallel: bool) {
    let Case {
        points,
        edges,
        triangles,
    } = case;
    let verdict = verify(points, edges, triangles);
    if let Some(is_right) = is_certainly_right(case) {
        assert_eq!(verdict.is_ok(), is_right, "{verdict:?} of {case:?}");
    }
    if let (Ok(report), Ok(result)) = (&verdict, triangulate(points, edges)) {
        let is_ours = canonical(&result, triangles) == result.canonical_triangles();
        assert_eq!(report.is_canonical(), is_ours, "canonical (left) {case:?}");
    }
    check_list(case, &verdict);
    check_short_list(case, &verdict);
    if let Err(violations) = &verdict {
        measured::judge_depths(case, violations);
        outline::judge_turns(case, violations);
    }
    measured::judge_added(case);
    outline::judge_declared(case);
    measured::judge_levels(case);
    let verifier = Verifier::new();
    if in_parallel {
        let again = verifier.verify_parallel(points, edges, triangles);
        assert_eq!(again, verdict, "in parallel (left)");
    }
    let turned: Vec<[usize; 3]> = triangles.iter().map(|&[a, b, c]| [b, a, c]).collect();
    let tolerant = verifier.accept_clockwise(true);
    assert_eq!(
        tolerant.verify(points, edges, triangles).is_ok(),
        verdict.is_ok() || verify(points, edges, &turned).is_ok(),
        "clockwise triangles accepted (left) of {case:?}"
    );
    if let Ok(result) = triangulate(points, &[]) {
        let hull: Vec<usize> = result.hull().collect();
        let declared = [hull.clone()];
        let within = verifier.boundary(&declared);
        assert_eq!(
            within.verify(points, edges, triangles).is_ok(),
            verdict.is_ok(),
            "within the hull (left) of {case:?}"
        );
        if verdict.is_ok() {
            if let Some(verdict) = judge_hole(case, &hull) {
                check_list(case, &verdict);
            }
            judge_part(case);
            rules::judge(case);
            judge_unused(case, &hull);
            judge_regions(case);
        }
    }
    let chains: Vec<Vec<usize>> = triangles.iter().map(|t| t.to_vec()).collect();
    let within = verifier.boundary(&chains).verify(points, edges, triangles);
    check_list(case, &within);
}

/// Whether a verifier that lists one violation, and reports its progress, finds the same.
fn check_short_list(case: &Case, verdict: &std::result::Result<Report, Violations>) {
    let progress = |done, all| assert!(done <= all, "{done} of {all}");
    let verifier = Verifier::default().limit(1).progress(&progress);
    assert!(format!("{verifier:?}").contains("limit: 1"));
    let found = verifier.verify(&case.points, &case.edges, &case.triangles);
    let mut expected = verdict.clone();
    if let Err(violations) = &mut expected {
        violations.list.truncate(1);
        assert!(
            violations
                .to_string()
                .contains(&violations.list[0].to_string())
        );
    }
    assert_eq!(found, expected, "one listed (left)");
}

/// Whether the violations listed name what is there, and have a message.
fn check_list(case: &Case, verdict: &std::result::Result<Report, Violations>) {
    let Err(violations) = verdict else { return };
    assert_eq!(violations.list.len(), violations.found.min(100));
    for violation in &violations.list {
        assert!(!violation.to_string().is_empty() && !violation.name().is_empty());
        let named = violation.offenders();
        let is_below = |list: &[usize], count: usize| list.iter().all(|&i| i < count);
        let is_out_of_range = matches!(
            violation,
            Violation::EdgeOutOfRange { .. } | Violation::TriangleOutOfRange { .. }
        );
        // A declared boundary of garbage may have sides between what are no vertices.
        assert!(
            is_out_of_range != is_below(&named.vertices, case.points.len())
                || matches!(violation, Violation::MissingBoundary { .. }),
            "{violation:?}"
        );
        let is_there = is_below(&named.edges, case.edges.len())
            && is_below(&named.triangles, case.triangles.len());
        assert!(is_there, "{violation:?}");
    }
}
