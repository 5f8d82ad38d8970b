//! Lines of a drawing joined to long strokes, which are shorter to write than their pieces.

/// Long walks that together use each edge once. They start at vertices with an odd number of edges first, since a walk
/// must begin or end there.
///
/// Cost: linear.
pub(super) fn trails(vertices: usize, edges: &[[usize; 2]]) -> Vec<Vec<usize>> {
    let mut at_vertex = vec![Vec::new(); vertices];
    for (edge, &[a, b]) in edges.iter().enumerate() {
        at_vertex[a].push(edge);
        at_vertex[b].push(edge);
    }
    let odd = (0..vertices)
        .filter(|&v| at_vertex[v].len() % 2 == 1)
        .collect::<Vec<_>>();
    let mut used = vec![false; edges.len()];
    let mut trails = Vec::new();
    for start in odd.into_iter().chain(0..vertices) {
        loop {
            let mut trail = vec![start];
            let mut end = start;
            while let Some(edge) = at_vertex[end].pop() {
                if !std::mem::replace(&mut used[edge], true) {
                    let [a, b] = edges[edge];
                    end = a + b - end;
                    trail.push(end);
                }
            }
            if trail.len() == 1 {
                break;
            }
            trails.push(trail);
        }
    }
    trails
}

/// Closed walks that together use each side once, from its first end to its second. As many sides begin at each vertex as
/// end there, and the sides are sorted.
///
/// Cost: a search among the sides for each of them.
pub(super) fn loops(sides: &[[usize; 2]]) -> Vec<Vec<usize>> {
    // How many of the sides that begin where this one does, the first of them, are used.
    let mut used = vec![0; sides.len()];
    let mut next = |from: usize| {
        let first = sides.partition_point(|side| side[0] < from);
        let count = used.get_mut(first)?;
        let side = sides.get(first + *count).filter(|side| side[0] == from)?;
        *count += 1;
        Some(side[1])
    };
    let mut loops = Vec::new();
    for &[start, _] in sides {
        let mut walk = vec![start];
        let mut end = start;
        while let Some(to) = next(end) {
            walk.push(to);
            end = to;
        }
        if walk.len() > 1 {
            loops.push(walk);
        }
    }
    loops
}

#[cfg(test)]
mod tests {
    use super::{loops, trails};
    use sweep_cdt_formats::sorted_pairs;

    #[test]
    fn each_edge_is_walked_once() {
        let edges = [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [4, 5]];
        let trails = trails(6, &edges);
        let walked = trails
            .iter()
            .flat_map(|trail| trail.windows(2).map(|step| [step[0], step[1]]));
        assert_eq!(sorted_pairs(walked), edges);
        assert_eq!(trails.len(), 2);
    }

    /// Three triangles, two of which touch.
    #[test]
    fn each_side_is_walked_once_in_its_direction() {
        let mut sides = vec![
            [0, 1],
            [1, 2],
            [2, 0],
            [2, 3],
            [3, 4],
            [4, 2],
            [5, 6],
            [6, 7],
            [7, 5],
        ];
        sides.sort_unstable();
        let loops = loops(&sides);
        let steps = loops.iter().flat_map(|walk| walk.windows(2));
        let mut walked: Vec<[usize; 2]> = steps.map(|step| [step[0], step[1]]).collect();
        walked.sort_unstable();
        assert_eq!(walked, sides);
        assert!(loops.iter().all(|walk| walk.first() == walk.last()));
        assert_eq!(loops.len(), 3);
    }
}
