//! Circles of arrows.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::names::Arrow;

/// For each file in a circle a shortest one through it, as text; each circle once.
pub(crate) fn circles(arrows: &[Arrow]) -> Vec<String> {
    // Of several arrows between two files the first one stands for all.
    let mut from: BTreeMap<&str, BTreeMap<&str, &Arrow>> = BTreeMap::new();
    for arrow in arrows {
        let of_file = from.entry(&arrow.from).or_default();
        of_file.entry(&arrow.to).or_insert(arrow);
    }
    let mut seen = BTreeSet::new();
    let mut circles = Vec::new();
    for &start in from.keys() {
        let Some(circle) = shortest(start, &from) else {
            continue;
        };
        let files: BTreeSet<&str> = circle.iter().map(|arrow| arrow.to.as_str()).collect();
        if seen.insert(files) {
            circles.push(circle.iter().map(|arrow| format!("{arrow}\n")).collect());
        }
    }
    circles
}

/// A shortest circle from a file back to it, breadth first.
fn shortest<'a>(
    start: &'a str,
    from: &BTreeMap<&'a str, BTreeMap<&'a str, &'a Arrow>>,
) -> Option<Vec<&'a Arrow>> {
    let mut reached_by: BTreeMap<&str, &Arrow> = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(file) = queue.pop_front() {
        for (&to, &arrow) in from.get(file).into_iter().flatten() {
            if reached_by.contains_key(to) {
                continue;
            }
            reached_by.insert(to, arrow);
            queue.push_back(to);
        }
    }
    let mut circle = vec![*reached_by.get(start)?];
    while circle[circle.len() - 1].from != start {
        circle.push(reached_by[circle[circle.len() - 1].from.as_str()]);
    }
    circle.reverse();
    Some(circle)
}
