//! A trace replays to the result; a damaged one is refused, or means the same.

use sweep_cdt::{Algorithm, Heuristics, Triangulator, Watch};
use sweep_cdt_testing::data::Hard;
use sweep_cdt_testing::generators::medium;
use sweep_cdt_testing::{Input, Random, Steps, families};
use sweep_cdt_trace::{BadTrace, Trace, read_trace};

use super::{HEURISTICS, lines, steps, text};
use crate::cases;

/// Writes, reads and replays the trace of an input.
fn assert_replays(input: &Input) {
    for heuristics in HEURISTICS {
        let Steps { trace, result, .. } = steps(input, heuristics);
        assert_eq!(Trace::parse(&text(&trace)).as_ref(), Ok(&trace));
        assert_eq!(read_trace(&lines(&trace)).as_ref(), Ok(&trace));
        let replayed = trace.replay();
        match result {
            Ok(result) => assert_eq!(replayed, Ok(result.canonical_triangles())),
            Err(_) => {
                let line = trace.events.len() + 2;
                assert_eq!(replayed.map_err(|bad| bad.line), Err(line));
            }
        }
    }
}

#[test]
fn replay_gives_the_result_of_every_case() {
    for (name, input) in cases::all() {
        println!("{name}");
        assert_replays(&input);
    }
}

#[test]
fn replay_gives_the_result_of_hard_inputs() {
    for Hard { name, input, .. } in Hard::own() {
        if input.points.len() <= 5000 {
            println!("{name}");
            assert_replays(&input);
        }
    }
}

fn read_and_replay(lines: &[&str]) -> Result<Vec<[usize; 3]>, BadTrace> {
    Trace::parse(&(lines.join("\n") + "\n"))?.replay()
}

/// Calls `damage` with the lines of the trace of every case and the result.
fn for_each_trace(damage: impl Fn(&[&str], &[[usize; 3]])) {
    for (name, input) in cases::all() {
        println!("{name}");
        for heuristics in [Heuristics::PAPER, Heuristics::OFF] {
            let Steps { trace, result, .. } = steps(&input, heuristics);
            if let Ok(result) = result {
                let text = text(&trace);
                let lines: Vec<&str> = text.lines().collect();
                damage(&lines, &result.canonical_triangles());
            }
        }
    }
}

#[test]
fn a_line_that_is_missing_is_noticed() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() {
            let mut damaged = lines.to_vec();
            let line = damaged.remove(at);
            match read_and_replay(&damaged) {
                Err(bad) => assert!(bad.line > at, "{line}: {bad}"),
                Ok(found) => {
                    let is_informal = line.starts_with("test") || line.starts_with("switch");
                    assert!(is_informal, "{line}");
                    assert_eq!(found, triangles);
                }
            }
        }
    });
}

#[test]
fn a_line_that_comes_twice_is_noticed() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() {
            let mut damaged = lines.to_vec();
            let line = damaged[at];
            damaged.insert(at, line);
            match read_and_replay(&damaged) {
                Err(bad) => assert!(bad.line > at + 1, "{line}: {bad}"),
                Ok(found) => {
                    // Only an illegal edge is not there to be tested again.
                    let stays = line.ends_with(": legal") || line.ends_with(": fixed");
                    assert!(line.starts_with("test") && stays, "{line}");
                    assert_eq!(found, triangles);
                }
            }
        }
    });
}

#[test]
fn a_trace_cut_short_is_noticed() {
    for_each_trace(|lines, _| {
        for length in 0..lines.len() {
            let bad = read_and_replay(&lines[..length]).expect_err("lines are missing");
            assert_eq!(bad.line, (length + 1).max(1));
        }
    });
}

#[test]
fn lines_that_change_places_are_noticed_or_commute() {
    for_each_trace(|lines, triangles| {
        for at in 0..lines.len() - 1 {
            let mut damaged = lines.to_vec();
            damaged.swap(at, at + 1);
            let pair = [lines[at], lines[at + 1]];
            if let Ok(found) = read_and_replay(&damaged) {
                let are_all = |starts: &[&str]| {
                    let is_one = |line: &&str| starts.iter().any(|start| line.starts_with(start));
                    pair.iter().all(is_one)
                };
                let commutes = are_all(&["front loses", "triangle"]) || are_all(&["removed"]);
                let has_test = pair.iter().any(|line| line.starts_with("test"));
                assert!(commutes || has_test, "{pair:?}");
                assert_eq!(found, triangles);
            }
        }
    });
}

#[test]
fn an_edited_word_is_noticed_or_a_name() {
    for_each_trace(|lines, triangles| {
        for (at, line) in lines.iter().enumerate() {
            let words: Vec<&str> = line.split(' ').collect();
            for (place, word) in words.iter().enumerate() {
                for other in edits(word) {
                    let mut words: Vec<String> =
                        words.iter().map(|&word| word.to_owned()).collect();
                    words[place] = other;
                    let edited = words.join(" ");
                    let mut damaged = lines.to_vec();
                    damaged[at] = &edited;
                    match read_and_replay(&damaged) {
                        Err(bad) => assert!(bad.line > at, "{line} -> {edited}: {bad}"),
                        Ok(found) => {
                            // Another number, or the ends of an edge that begins with the same part.
                            assert!(line.starts_with("edge"), "{line} -> {edited}");
                            assert_eq!(found, triangles);
                        }
                    }
                }
            }
        }
    });
}

/// Other numbers and other words in place of one.
fn edits(word: &str) -> Vec<String> {
    let number = word.trim_end_matches(':');
    let mark = &word[number.len()..];
    if let Ok(number) = number.parse::<i64>() {
        let others = [number - 1, number + 1].map(|n| n.to_string());
        let artificial = ["P-1".to_owned(), "P-2".to_owned()];
        let all = others.into_iter().chain(artificial);
        return all.map(|other| other + mark).collect();
    }
    let groups: [&[&str]; 4] = [
        &["middle", "left"],
        &["legal", "illegal", "fixed"],
        &["P-1", "P-2"],
        &[
            "(point)",
            "(basin)",
            "(first)",
            "(pocket)",
            "(pseudo-polygon)",
        ],
    ];
    let of_group = groups.into_iter().find(|group| group.contains(&word));
    let others = of_group
        .into_iter()
        .flatten()
        .filter(|&&other| other != word);
    others.map(|&other| other.to_owned()).collect()
}

/// Other algorithms than the paper's have steps that no event names: what they pass on replays to the result, or is
/// refused.
#[test]
fn steps_of_other_algorithms_replay_to_the_result_or_are_refused() {
    let mut refused = 0;
    let slanted = families::slanted().map(|family| (family.member)(200));
    let others = (0..300).map(|seed| medium(&mut Random::new(seed)));
    for Input { points, edges } in slanted.chain(others) {
        for algorithm in [
            Algorithm::Auto,
            Algorithm::Sweep,
            Algorithm::DivideAndConquer,
        ] {
            let mut trace = Trace::default();
            let mut push = |event| trace.events.push(event);
            let watch = Watch::new().events(&mut push);
            let triangulator = Triangulator::new().algorithm(algorithm);
            let Ok(result) = triangulator.run(&points, &edges, watch) else {
                continue;
            };
            match trace.replay() {
                Ok(triangles) => assert_eq!(triangles, result.canonical_triangles()),
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > 300, "{refused}");
}
