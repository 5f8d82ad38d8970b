"""Properties of random inputs, most of them degenerate: results judged by definitions, and no other end than documented.

SWEEP_CDT_EXAMPLES=100000 runs a hundred thousand examples of each.
"""

from fractions import Fraction

import exact
import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as npst

import sweep_cdt

SMALL = st.integers(0, 4)
DOUBLES = st.floats(allow_nan=False, allow_infinity=False)
NEAR = st.builds(lambda k, ulps: k + ulps * 2.0**-50, st.integers(0, 3), st.integers(-2, 2))
RATIONAL = st.fractions(-3, 3, max_denominator=7)


def inputs(coordinate, most=9):
    """Points and edges between them."""
    points = st.lists(st.tuples(coordinate, coordinate), max_size=most)

    def with_edges(points):
        if not points:
            return st.just((points, []))
        position = st.integers(0, len(points) - 1)
        return st.tuples(st.just(points), st.lists(st.tuples(position, position), max_size=4))

    return points.flatmap(with_edges)


def judge(points, edges):
    """Triangulates, and lets the second judge look at the result."""
    try:
        result = sweep_cdt.triangulate(points, edges)
    except sweep_cdt.CrossingEdgesError as error:
        a, b = error.edges
        at = exact.integers(points)
        ends = [[at[v] for v in edges[e]] for e in (a, b)]
        (p, q), (r, s) = ends
        # Each edge has the ends of the other on both its sides.
        assert exact.turn(p, q, r) * exact.turn(p, q, s) < 0 and exact.turn(r, s, p) * exact.turn(r, s, q) < 0
        assert sweep_cdt.crossings(points, edges).edges.tolist()
        split = sweep_cdt.triangulate(points, edges, split_crossings=True)
        assert sweep_cdt.verify(split)
        return
    simplices = result.simplices.tolist()
    at = exact.integers(points) if points else []
    assert len(sweep_cdt.crossings(points, edges)) == 0
    if len(exact.hull(at)) < 3:
        assert simplices == []
    else:
        reached, _ = exact.level([tuple(p) for p in points], edges, simplices)
        assert reached == "delaunay"
    for edge, (a, b) in enumerate(edges):
        chain = [at[v] for v in result.edge_chain(edge)]
        assert [chain[0], chain[-1]] == [at[a], at[b]]
    assert all(at[v] == at[first] and first < v for v, first in result.duplicates)
    assert sweep_cdt.verify(result).is_canonical


@given(inputs(SMALL))
def test_whole_numbers(question):
    judge(*question)


@given(inputs(NEAR))
def test_doubles_that_are_nearly_on_a_grid(question):
    judge(*question)


@given(inputs(DOUBLES, 6))
def test_doubles_of_all_sizes(question):
    judge(*question)


@given(inputs(RATIONAL))
def test_fractions(question):
    judge(*question)


@given(inputs(SMALL), st.permutations(range(9)))
def test_the_triangles_depend_on_the_set_of_points_alone(question, order):
    points, _ = question
    points = list(dict.fromkeys(points))
    order = [v for v in order if v < len(points)]
    places = lambda points: {frozenset(points[v] for v in t) for t in sweep_cdt.triangulate(points).simplices}
    assert places(points) == places([points[v] for v in order])


@given(inputs(SMALL))
def test_doubles_and_fractions_agree(question):
    points, edges = question
    exactly = [[Fraction(x), Fraction(y)] for x, y in points]
    try:
        one = sweep_cdt.triangulate(points, edges).canonical()
    except sweep_cdt.CrossingEdgesError:
        return
    assert (sweep_cdt.triangulate(exactly, edges).canonical() == one).all()


KINDS = st.one_of(
    npst.floating_dtypes(), npst.integer_dtypes(), npst.unsigned_integer_dtypes(), npst.boolean_dtypes(),
    npst.complex_number_dtypes(), npst.datetime64_dtypes(), npst.unicode_string_dtypes(max_len=3),
)  # fmt: skip
ARRAYS = st.one_of(
    npst.arrays(KINDS, npst.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=6)),
    npst.arrays(st.one_of(npst.floating_dtypes(), npst.integer_dtypes()), st.tuples(st.integers(0, 8), st.just(2))),
)
POSITIONS = st.one_of(
    st.none(),
    npst.arrays(npst.integer_dtypes(), st.tuples(st.integers(0, 5), st.integers(1, 3)), elements=st.integers(-1, 9)),
    ARRAYS,
)
JUNK = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(), st.floats(), st.text(max_size=3), st.fractions(), st.decimals()),
    lambda inner: st.lists(inner, max_size=4),
    max_leaves=12,
)


def ends_well(call):
    """Fails if a call gives neither a result nor a documented exception."""
    try:
        call()
    except sweep_cdt.Error as error:
        assert str(error)


@given(ARRAYS, POSITIONS, st.booleans())
def test_every_array_ends_well(points, edges, splits):
    ends_well(lambda: sweep_cdt.triangulate(points, edges, split_crossings=splits))
    ends_well(lambda: sweep_cdt.trace(points, edges))
    ends_well(lambda: str(sweep_cdt.verify(points, edges)))
    ends_well(lambda: str(sweep_cdt.verify(points, edges, edges, domain="even-odd")))


@given(JUNK, JUNK)
def test_every_list_ends_well(points, edges):
    ends_well(lambda: sweep_cdt.triangulate(points, edges))
    ends_well(lambda: sweep_cdt.triangulate(points, holes=edges))
    ends_well(lambda: sweep_cdt.triangulate([], polygons=edges))
    ends_well(lambda: sweep_cdt.triangulate({"vertices": [[0, 0]], "regions": points, "holes": edges}))
    ends_well(lambda: sweep_cdt.verify(points, edges))
    ends_well(lambda: sweep_cdt.verify({"vertices": points, "triangles": edges, "segments": edges}))
    ends_well(lambda: sweep_cdt.verify([[0, 0]], {"triangles": [], "triangle_attributes": edges}))
    ends_well(lambda: sweep_cdt.triangulate({"vertices": [[0, 0]], "vertex_attributes": points}))
    triangle = sweep_cdt.triangulate([[0, 0], [1, 0], [0, 1]])
    ends_well(lambda: triangle.interpolate(points, [[0.25, 0.25]]))
    ends_well(lambda: triangle.interpolate([1, 2, 3], points))
    ends_well(lambda: triangle.interpolate([1, 2, 3], (points, edges)))
    ends_well(lambda: triangle.find_simplex(points))


@given(inputs(SMALL), st.lists(st.tuples(*[st.integers(-1, 9)] * 3), max_size=8), st.sampled_from(["hull", "holes"]))
def test_every_soup_of_triangles_is_judged(question, triangles, domain):
    points, edges = question

    def judged():
        report = sweep_cdt.verify(points, triangles, edges, domain=domain, max_depth=1e-12)
        report.violations, str(report), report._repr_html_()
        if domain == "hull" and len(exact.hull(exact.integers(points) if points else [])) > 2:
            reached, _ = exact.level([tuple(p) for p in points], edges, triangles)
            expected = {None: "none", "canonical": "delaunay"}.get(report.reached, report.reached)
            assert reached == expected

    ends_well(judged)


@given(inputs(SMALL), ARRAYS)
def test_every_query_ends_well(question, queries):
    result = sweep_cdt.triangulate(question[0])
    ends_well(lambda: result.find_simplex(queries))
    ends_well(lambda: result.interpolate(queries, [[1.0, 1.0]]))
    ends_well(lambda: result.interpolate(np.zeros(len(question[0])), queries))
    if queries.dtype.kind == "f" and queries.shape[-1:] == (2,):
        found = result.find_simplex(queries)
        for t, query in zip(found.ravel(), queries.reshape(-1, 2)):
            if not np.isfinite(query).all():
                assert t == -1
            elif t >= 0:
                *corners, place = exact.integers([*result.points[result.simplices[t]].tolist(), query.tolist()])
                a, b, c = corners
                assert min(exact.turn(a, b, place), exact.turn(b, c, place), exact.turn(c, a, place)) >= 0
