"""Errors: their kinds, and the offenders that they name."""

import pickle
from fractions import Fraction

import numpy as np
import pytest

import sweep_cdt

POINTS = [[0, 0], [1, 0], [1, 1], [0, 1]]


@pytest.mark.parametrize(
    ("points", "kind", "message", "offenders"),
    [
        ([[0, 0], [1]], sweep_cdt.ShapeError, r"points\[1\] has 1 numbers, not 2", {"position": 1}),
        ([[0, 0], 1], sweep_cdt.ShapeError, r"points\[1\] is no pair", {"position": 1}),
        ([1, 2, 3], sweep_cdt.ShapeError, r"the shape \(3,\)", {"shape": (3,)}),
        (np.zeros((2, 3)), sweep_cdt.ShapeError, r"pass points\[:, :2\]", {"shape": (2, 3)}),
        (np.zeros((2, 2, 2)), sweep_cdt.ShapeError, r"\(2, 2, 2\)", {"shape": (2, 2, 2)}),
        ("ab.csv", sweep_cdt.KindError, "is no array but of the type str: read a file with pandas", {}),
        (None, sweep_cdt.KindError, "NoneType", {}),
        (7, sweep_cdt.KindError, "int", {}),
        ([["a", "b"]], sweep_cdt.KindError, "no type of coordinates", {}),
        (np.zeros((2, 2), dtype=complex), sweep_cdt.KindError, "complex128", {}),
        (np.zeros((2, 2), dtype=bool), sweep_cdt.KindError, "bool", {}),
        ([[0, 0], [Fraction(1), "x"]], sweep_cdt.KindError, "no type of coordinates|is no number", {}),
        ([[Fraction(1), None]], sweep_cdt.KindError, r"points\[0, 1\] is no number", {"position": (0, 1)}),
        ([[0, 0], [0, np.nan]], sweep_cdt.NonFiniteError, r"points\[1, 1\] is nan", {"vertex": 1, "axis": 1}),
        ([[0, 0], [np.inf, 0]], sweep_cdt.NonFiniteError, r"points\[1, 0\] is inf", {"vertex": 1, "axis": 0}),
        ([[Fraction(1), np.inf]], sweep_cdt.NonFiniteError, r"points\[0, 1\] is inf", {"vertex": 0, "axis": 1}),
    ],
)
def test_points(points, kind, message, offenders):
    for call in (sweep_cdt.triangulate, sweep_cdt.crossings, sweep_cdt.split, sweep_cdt.trace, sweep_cdt.measure):
        with pytest.raises(kind, match=message) as caught:
            call(points)
        assert isinstance(caught.value, ValueError)
        assert {name: getattr(caught.value, name) for name in offenders} == offenders


@pytest.mark.parametrize(
    ("edges", "kind", "message", "offenders"),
    [
        ([[0, 2], [1, 3]], sweep_cdt.CrossingEdgesError, r"edges 0 and 1 cross, at \(0.5, 0.5\) \(split_crossings", {"edges": (0, 1), "place": (0.5, 0.5)}),
        ([[0, 1], [1, 4]], sweep_cdt.EdgeOutOfRangeError, "edge 1 ends at vertex 4", {"edge": 1, "vertex": 4}),
        ([[0, 1], [1, -1]], sweep_cdt.EdgeOutOfRangeError, "vertex -1", {"edge": 1, "vertex": -1}),
        (np.array([[0, 2**40]]), sweep_cdt.EdgeOutOfRangeError, "1099511627776", {"edge": 0}),
        ([[0, 1, 2]], sweep_cdt.ShapeError, r"\(1, 3\)", {"shape": (1, 3)}),
        ([[0.0, 1.0]], sweep_cdt.KindError, "float64", {}),
        ([0, 1], sweep_cdt.ShapeError, r"\(2,\)", {"shape": (2,)}),
        ([[0, 1], [2]], sweep_cdt.ShapeError, r"edges\[1\] has 1 numbers, not 2", {"position": 1}),
        ("no", sweep_cdt.ShapeError, r"\(\)", {}),
    ],
)
def test_edges(edges, kind, message, offenders):
    with pytest.raises(kind, match=message) as caught:
        sweep_cdt.triangulate(POINTS, edges)
    assert {name: getattr(caught.value, name) for name in offenders} == offenders


def test_the_verifier_names_the_coordinate_too():
    with pytest.raises(sweep_cdt.NonFiniteError, match=r"points\[2, 1\] is nan") as caught:
        sweep_cdt.verify([*POINTS[:2], [1, np.nan], [0, 1]], [[0, 1, 3]], domain="even-odd")
    assert caught.value.vertex == 2 and caught.value.axis == 1


@pytest.mark.parametrize("options", [{"threads": -1}, {"threads": 1.5}, {"limit": -1}, {"limit": None}, {"tolerance": -1}])
def test_numbers_of_the_verifier(options):
    with pytest.raises(sweep_cdt.Error, match=f"{next(iter(options))} is .*, not a .* number from 0 on"):
        sweep_cdt.verify(POINTS, [[0, 1, 2], [0, 2, 3]], **options)


def test_interiors():
    with pytest.raises(sweep_cdt.OpenRingError) as caught:
        sweep_cdt.triangulate(POINTS, [[0, 2]], inside="even-odd")
    assert caught.value.vertex == 0
    ring = [[0, 1], [1, 2], [2, 3], [3, 0]]
    with pytest.raises(sweep_cdt.SeedError, match="hole 1") as caught:
        sweep_cdt.triangulate(POINTS, ring, holes=[[0.5, 0.25], [7, 7]])
    assert caught.value.hole == 1
    with pytest.raises(sweep_cdt.ShapeError, match="holes"):
        sweep_cdt.triangulate(POINTS, ring, holes=[1, 2])
    with pytest.raises(sweep_cdt.ShapeError, match=r"polygons\[0\]\[1\]"):
        sweep_cdt.triangulate(POINTS, polygons=[[[0, 1, 2], [[1, 2, 3]]]])
    with pytest.raises(sweep_cdt.EdgeOutOfRangeError):
        sweep_cdt.triangulate(POINTS, polygons=[[[0, 1, 9]]])
    with pytest.raises(sweep_cdt.ShapeError, match="-3"):
        sweep_cdt.triangulate(POINTS, polygons=[[[0, 1, -3]]])


def test_kinds_are_named_by_the_package():
    for kind in (sweep_cdt.Error, sweep_cdt.ShapeError, sweep_cdt.InternalError):
        assert kind.__module__ == "sweep_cdt"


def test_kinds_suit_what_else_catches_them():
    assert issubclass(sweep_cdt.KindError, TypeError)
    assert issubclass(sweep_cdt.EdgeOutOfRangeError, IndexError)
    assert issubclass(sweep_cdt.OutOfMemoryError, MemoryError)
    assert issubclass(sweep_cdt.InternalError, RuntimeError)


def test_errors_can_be_sent_to_other_processes():
    with pytest.raises(sweep_cdt.CrossingEdgesError) as caught:
        sweep_cdt.triangulate(POINTS, [[0, 2], [1, 3]])
    again = pickle.loads(pickle.dumps(caught.value))
    assert type(again) is sweep_cdt.CrossingEdgesError
    assert again.edges == (0, 1) and str(again) == str(caught.value)


def test_positions_that_there_are_not():
    result = sweep_cdt.triangulate(POINTS, [[0, 2]])
    for call in (lambda: result.edge_chain(1), lambda: result.edge_chain(-2)):
        with pytest.raises(IndexError, match="there is no edge"):
            call()
    with pytest.raises(IndexError):
        sweep_cdt.crossings(POINTS, [[0, 2], [1, 3]]).exact(1)
    with pytest.raises(IndexError):
        sweep_cdt.trace(POINTS)[1000]
    with pytest.raises(sweep_cdt.Error, match="threads"):
        sweep_cdt.triangulate(POINTS, threads=-1)
