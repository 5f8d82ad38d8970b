//! Lines of a drawing joined to long strokes, which are shorter to write than their pieces.

/// Long walks that together use each edge once. They start at vertices with an odd number of edges first,
/// since a walk must begin or end there.
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

#[cfg(test)]
mod tests {
    use super::trails;
    use crate::formats::sorted_pairs;

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
}
