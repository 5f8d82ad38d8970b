//! Campaigns against programs with planted faults: each is found, and made small.

use sweep_cdt::triangulate;
use sweep_cdt_testing::judge::{
    Asked, Campaign, Claims, Fault, Numbers, Operation, Outcome, Question, Reply, Special, Summary,
    Wrong, ask, campaign, least,
};
use sweep_cdt_testing::oracle::Domain;
use sweep_cdt_testing::suite::Case;

/// A program that is right.
fn right(question: &Question) -> Outcome {
    match question.operations.len() {
        0 => inside(question).into(),
        all => Outcome::After((1..=all).map(|steps| after(question, steps)).collect()),
    }
}

fn after(question: &Question, steps: usize) -> Vec<[usize; 3]> {
    let present = question.present(steps);
    let triangles = inside(&question.after(steps)).expect("points alone");
    triangles.iter().map(|t| t.map(|v| present[v])).collect()
}

fn inside(question: &Question) -> Reply {
    let edges = question.all_edges();
    let result = triangulate(&question.points, &edges).map_err(|error| error.to_string())?;
    let interior = question.interior(&result);
    let interior = interior.map_err(|error| error.to_string())?;
    Ok(interior.triangles().collect())
}

/// All kinds of claims, with everything that is unusual and can be answered.
fn claims() -> Vec<Claims> {
    use Special::{EdgesWithoutLength, FlatRings, OverlappingRings, RingsEitherWay};
    let unusual = [
        EdgesWithoutLength,
        FlatRings,
        OverlappingRings,
        RingsEitherWay,
    ];
    let mut all = Vec::new();
    for (asked, _) in Asked::ALL {
        for numbers in [
            "doubles",
            "integers:20",
            "integers:3",
            "single:1e-6..1e6",
            "doubles:1e-42..1e60",
        ] {
            let numbers = numbers.parse().expect("numbers");
            let claims = Claims::of(asked).with_numbers(numbers);
            all.push(
                claims
                    .clone()
                    .answering(&unusual)
                    .refusing(&[Special::CrossingEdges]),
            );
            if asked == Asked::Polygons {
                for domain in [Domain::Hull, Domain::EvenOdd, Domain::NonZero] {
                    all.push(Claims {
                        domain,
                        ..claims.clone().answering(&unusual)
                    });
                }
            }
            all.push(claims);
        }
    }
    all
}

#[test]
fn a_right_program_is_found_right() {
    for claims in claims() {
        let summary = campaign(&claims, 100, 1, right);
        assert!(summary.faults.is_empty(), "{claims}\n{summary}");
        // What must not be asked is left out of points and edges, not the whole question.
        let is_plain = [Asked::Points, Asked::Edges].contains(&claims.asked);
        assert!(!is_plain || summary.left_out == 0, "{claims}\n{summary}");
        println!("{claims}\n{summary}");
    }
}

/// A fault planted in a right answer.
type Plant = fn(&Question, Vec<[usize; 3]>) -> Vec<[usize; 3]>;

/// The side that two triangles share is replaced by the other diagonal, where both halves then turn left.
fn flip(question: &Question, mut triangles: Vec<[usize; 3]>) -> Vec<[usize; 3]> {
    let turn = |a: usize, b: usize, c: usize| {
        let [p, q, r] = [a, b, c].map(|v| question.points[v]);
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0
    };
    for t in 0..triangles.len() {
        for k in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|i| triangles[t][(i + k) % 3]);
            for u in 0..t {
                let across =
                    (0..3).find(|&j| [triangles[u][j], triangles[u][(j + 1) % 3]] == [b, a]);
                let Some(j) = across else { continue };
                let d = triangles[u][(j + 2) % 3];
                if turn(c, a, d) && turn(d, b, c) {
                    (triangles[t], triangles[u]) = ([c, a, d], [d, b, c]);
                    return triangles;
                }
            }
        }
    }
    triangles
}

/// A name, what it does to an answer, and how many points a small question with it has at most.
const PLANTS: [(&str, Plant, usize); 6] = [
    (
        "dropped",
        |_, mut t| {
            t.pop();
            t
        },
        4,
    ),
    ("flipped", flip, 4),
    (
        "repeated",
        |_, mut t| {
            t.extend(t.last().copied());
            t
        },
        3,
    ),
    (
        "reversed",
        |_, mut t| {
            if t.len() > 2 {
                t[0].reverse();
            }
            t
        },
        5,
    ),
    (
        "moved",
        |q, mut t| {
            if t.len() > 1 {
                t[0][0] = (t[0][0] + 1) % q.points.len();
            }
            t
        },
        4,
    ),
    (
        "no point",
        |_, mut t| {
            if t.len() > 3 {
                t[1][2] = 1000;
            }
            t
        },
        6,
    ),
];

fn spoiled(claims: &Claims, plant: Plant) -> Summary {
    campaign(claims, 60, 2, |question| match right(question) {
        Outcome::Triangles(triangles) => Outcome::Triangles(plant(question, triangles)),
        Outcome::After(mut states) => {
            let last = states.pop().unwrap_or_default();
            states.push(plant(question, last));
            Outcome::After(states)
        }
        other => other,
    })
}

#[test]
fn planted_faults_are_found_and_made_small() {
    let numbered = |asked| Claims::of(asked).with_numbers(Numbers::integers(20));
    for (asked, _) in Asked::ALL {
        // Nearly all polygons have holes. A question that cannot lose its hole has at least six vertices.
        if asked == Asked::Polygons {
            small(&numbered(asked), 6);
        }
        small(&numbered(asked).without(&[Special::Holes]), 0);
    }
}

/// Each plant is found, in a question with no more points than it needs, or than these.
fn small(claims: &Claims, at_least: usize) {
    for (name, plant, most) in PLANTS {
        if name == "flipped" && claims.level < sweep_cdt::verify::Level::Delaunay {
            continue;
        }
        let summary = spoiled(claims, plant);
        let points =
            |finding: &sweep_cdt_testing::judge::Finding| finding.least.question.points.len();
        let least = summary.findings.iter().map(points).min();
        assert!(
            least.is_some_and(|least| least <= most.max(at_least)),
            "{claims}: {name}\n{summary}"
        );
        println!("{claims}: {name}\n{summary}");
    }
}

/// Edges that the program does not look at are missed, and so are the holes of polygons.
#[test]
fn what_a_program_ignores_is_found() {
    let blind = |question: &Question| {
        let edges = Vec::new();
        inside(&Question {
            edges,
            ..question.clone()
        })
    };
    let claims = Claims::of(Asked::Edges).with_numbers(Numbers::integers(10));
    let summary = campaign(&claims, 200, 1, blind);
    let found = summary
        .findings
        .iter()
        .find(|finding| finding.least.fault.name == "missing-edge");
    let question = &found.expect("a missing edge").least.question;
    assert_eq!(
        (question.points.len(), question.edges.len()),
        (4, 1),
        "{summary}"
    );
    let fills = |question: &Question| {
        let polygons = question
            .polygons
            .iter()
            .map(|rings| rings[..1].to_vec())
            .collect();
        inside(&Question {
            polygons,
            ..question.clone()
        })
    };
    let claims = Claims::of(Asked::Polygons).with_numbers(Numbers::integers(10));
    let summary = campaign(&claims, 200, 1, fills);
    let sizes = summary
        .findings
        .iter()
        .map(|f| f.least.question.points.len());
    assert!(sizes.min().is_some_and(|least| least <= 6), "{summary}");
}

/// What an adapter forgets of polygons.
type Forgets = (&'static str, fn(&mut Question));

const FORGETS: [Forgets; 8] = [
    ("the second hole", |q| forget(q, |_, at| at == 2)),
    ("the third hole", |q| forget(q, |_, at| at == 3)),
    ("the fifth hole", |q| forget(q, |_, at| at == 5)),
    ("holes from the tenth on", |q| forget(q, |_, at| at >= 10)),
    ("the last of several holes", |q| {
        let last: Vec<usize> = q.polygons.iter().map(Vec::len).collect();
        forget(q, |polygon, at| at > 1 && at + 1 == last[polygon]);
    }),
    ("the second polygon", |q| {
        q.polygons = q
            .polygons
            .drain(..)
            .enumerate()
            .filter(|(at, _)| *at != 1)
            .map(|(_, rings)| rings)
            .collect();
    }),
    ("islands", |q| {
        let own = q.clone();
        let corner = |rings: &Vec<Vec<usize>>| own.points[rings[0][0]];
        q.polygons.retain(|rings| {
            let others = own.polygons.iter().filter(|other| *other != rings);
            let mut holes = others.flat_map(|other| &other[1..]);
            !holes.any(|hole| surrounds(&own, hole, corner(rings)))
        });
    }),
    ("a hole that touches its outline", |q| {
        let points = q.points.clone();
        for rings in &mut q.polygons {
            let outline = rings[0].clone();
            let mut at = 0..;
            rings.retain(|ring| {
                let touches = ring
                    .iter()
                    .any(|&v| outline.iter().any(|&w| points[v] == points[w]));
                at.next() == Some(0) || !touches
            });
        }
    }),
];

/// Leaves out rings, by the number of the polygon and their place in it.
fn forget(question: &mut Question, is_left_out: impl Fn(usize, usize) -> bool) {
    for (polygon, rings) in question.polygons.iter_mut().enumerate() {
        let mut at = 0..;
        rings.retain(|_| !at.next().is_some_and(|at| is_left_out(polygon, at)));
    }
}

/// Whether a ring goes round a place, as doubles say.
fn surrounds(question: &Question, ring: &[usize], [x, y]: [f64; 2]) -> bool {
    let crosses = |side: &[usize; 2]| {
        let [p, q] = side.map(|v| question.points[v]);
        (p[1] > y) != (q[1] > y) && x < (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1])) + p[0]
    };
    sweep_cdt_testing::generators::ring_sides(ring)
        .filter(crosses)
        .count()
        % 2
        == 1
}

/// A program that forgets a part of polygons is found within 1,000 questions, and by the suite of conformance.
#[test]
fn what_a_program_forgets_of_polygons_is_found() {
    let claims = Claims::of(Asked::Polygons);
    let cases = sweep_cdt_testing::suite::own();
    for (name, forgets) in FORGETS {
        let forgetful = |question: &Question| {
            let mut less = question.clone();
            forgets(&mut less);
            // The points are those of the question.
            inside(&less)
        };
        for (seed, numbers) in [(1, "doubles"), (2, "integers:20"), (3, "integers:10")] {
            let numbers = numbers.parse().expect("numbers");
            let claims = claims.clone().with_numbers(numbers);
            let found = Campaign {
                claims,
                executions: 1_000,
                seed,
                kept: 0,
            };
            let first = (0..1_000).position(|execution| {
                let (_, question) = found.question(execution);
                question.is_some_and(|question| {
                    let mut less = question.clone();
                    forgets(&mut less);
                    less != question
                        && found
                            .claims
                            .fault(&question, &ask(&question, &mut |q| forgetful(q)))
                            .is_some()
                })
            });
            println!("{name}: question {first:?}");
            assert!(first.is_some(), "{name} with seed {seed}");
        }
        let is_caught = |case: &&Case| {
            let question = case.question_within(&claims);
            question.is_some_and(|q| case.fault(&claims, &q, &forgetful(&q).into()).is_some())
        };
        let caught = cases.iter().find(is_caught).map(|case| &case.name);
        println!("{name}: case {caught:?}");
        assert!(caught.is_some(), "no case finds what forgets {name}");
    }
}

/// What a program may refuse is no finding, and anything else that it refuses is one.
#[test]
fn refusals_count_where_they_are_not_declared() {
    let proud = |question: &Question| match question.specials().contains(&Special::EqualPoints) {
        true => Err("equal points".to_owned()),
        false => inside(question),
    };
    let claims = Claims::of(Asked::Edges).with_numbers(Numbers::integers(4));
    let summary = campaign(&claims, 200, 1, proud);
    let least = &summary.findings[0].least;
    assert_eq!(
        (least.fault.name, least.question.points.len()),
        ("refused", 4),
        "{summary}"
    );
    let summary = campaign(&claims.refusing(&[Special::EqualPoints]), 200, 1, proud);
    assert!(summary.faults.is_empty(), "{summary}");
    assert!(
        summary.kinds.values().map(|row| row.refused).sum::<u64>() > 50,
        "{summary}"
    );
}

/// A program that does without holes, or without straight corners, is asked many questions, and none that has them.
#[test]
fn rings_are_made_without_holes_and_straight_corners() {
    for numbers in ["integers:10", "integers:20", "doubles"] {
        let numbers = numbers.parse().expect("numbers");
        let claims = Claims::of(Asked::Polygons).with_numbers(numbers);
        for never in [Special::Holes, Special::StraightCorners] {
            let mut asked = 0;
            let mut has_met = false;
            let mut answer = |question: &Question| {
                asked += 1;
                let specials = question.specials();
                assert!(!specials.contains(&never), "{question:?}");
                has_met |= !specials.is_empty();
                inside(question)
            };
            let summary = campaign(&claims.clone().without(&[never]), 300, 1, &mut answer);
            assert!(summary.faults.is_empty(), "{summary}");
            assert!(asked > 100 && has_met, "{asked} questions\n{summary}");
        }
        // Without the claim such questions are asked.
        let mut met = std::collections::BTreeSet::new();
        let _ = campaign(&claims, 300, 1, |question: &Question| {
            met.extend(question.specials());
            inside(question)
        });
        let both = [Special::Holes, Special::StraightCorners];
        assert!(both.iter().all(|special| met.contains(special)), "{met:?}");
    }
}

/// Triangles that run either way are right only where that is claimed, and what else is wrong with them is found.
#[test]
fn mixed_triangles_are_right_where_they_are_claimed() {
    let turned = |question: &Question| {
        let mut triangles = inside(question)?;
        triangles.iter_mut().step_by(2).for_each(|t| t.swap(0, 1));
        Ok(triangles)
    };
    let claims = Claims::of(Asked::Edges).with_numbers(Numbers::integers(6));
    let mixed = Claims {
        is_mixed: true,
        ..claims.clone()
    };
    assert!(!campaign(&claims, 200, 1, turned).faults.is_empty());
    assert!(campaign(&mixed, 200, 1, turned).faults.is_empty());
    let short = |question: &Question| {
        turned(question).map(|mut triangles| {
            triangles.pop();
            triangles
        })
    };
    assert!(!campaign(&mixed, 200, 1, short).faults.is_empty());
}

/// A program that forgets a removal is found by a sequence that removes one point.
#[test]
fn a_removal_that_is_forgotten_is_found() {
    let forgetful = |question: &Question| {
        let mut question = question.clone();
        question
            .operations
            .retain(|step| matches!(step, Operation::Insert(_)));
        let mut there = std::collections::BTreeSet::new();
        question.operations.retain(|step| match step {
            Operation::Insert(v) | Operation::Remove(v) => there.insert(*v),
        });
        Outcome::Triangles(after(&question, question.operations.len()))
    };
    let claims = Claims::of(Asked::Operations).with_numbers(Numbers::integers(10));
    let summary = campaign(&claims, 200, 1, forgetful);
    let least = &summary.findings[0].least.question;
    assert!(least.operations.len() <= 5, "{summary}");
    let mut steps = least.operations.iter();
    assert!(
        steps.any(|step| matches!(step, Operation::Remove(_))),
        "{summary}"
    );
}

/// Each hang takes as long as a program is given, so few of them make a question small.
#[test]
fn hangs_are_made_small_with_few_answers() {
    let mut hangs = 0;
    let sleepy = |question: &Question| match question.points.len() {
        0..5 => right(question),
        _ => {
            hangs += 1;
            Outcome::Failed(Fault::new("hang", "no answer"))
        }
    };
    let claims = Claims::of(Asked::Points).with_numbers(Numbers::integers(10));
    let points: Vec<[f64; 2]> = (0..40_u8)
        .map(|x| [f64::from(x), f64::from(x % 7)])
        .collect();
    let question = Question::new(&points, &[]);
    let outcome = Outcome::Failed(Fault::new("hang", "no answer"));
    let fault = Fault::new("hang", "no answer");
    let mut sleepy = sleepy;
    let least = least(
        &claims,
        Wrong {
            question,
            outcome,
            fault,
        },
        &mut sleepy,
    );
    assert_eq!(least.question.points.len(), 5);
    assert!(hangs <= 20, "{hangs}");
}

/// A program that keeps a structure is never asked nothing, for which it would have no states.
#[test]
fn sequences_are_never_empty() {
    let claims = Claims::of(Asked::Operations);
    let mut shortest = usize::MAX;
    campaign(&claims, 300, 1, |question| {
        shortest = shortest.min(question.operations.len());
        right(question)
    });
    assert!((1..10).contains(&shortest), "{shortest} operations");
}
