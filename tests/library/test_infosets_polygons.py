"""Polygons by support values against linear programming, the published scan and known cases."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from trajlib.infosets import Region, SupportPolygons
from trajlib.infosets.polygons import normals

SIZES = st.sampled_from([3, 4, 5, 6, 7, 8, 9, 12, 16])


def programmed(values):
    """Greatest n_i p over {n p <= values} by linear programming, or None if nothing satisfies
    it."""
    n = normals(len(values))
    result = [
        linprog(-direction, A_ub=n, b_ub=values, bounds=(None, None), method="highs")
        for direction in n
    ]
    return None if result[0].status == 2 else np.array([-single.fun for single in result])


def scanned(values, margin=1e-9):
    """The published scan (3.6), (3.7): the values of the sides that are left, filled up from
    corners; None if empty."""
    n, left = normals(len(values)), list(range(len(values)))

    def corner(i, j):
        return np.linalg.solve(n[[i, j]], values[[i, j]])

    changed = True
    while changed:
        changed = False
        for place in range(len(left)):
            i, j, k = (left[(place + offset) % len(left)] for offset in range(3))
            if n[k] @ corner(i, j) > values[k] + margin:
                left.remove(j)
                if n[i, 1] * n[k, 0] - n[i, 0] * n[k, 1] <= margin:
                    return None
                changed = True
                break
    result = values.copy()
    for i, k in zip(left, left[1:] + left[:1]):
        between = range(i + 1, k if k > i else k + len(values))
        for j in between:
            result[j % len(values)] = n[j % len(values)] @ corner(i, k)
    return result


@pytest.mark.slow
@given(m=SIZES, seed=st.integers(0, 10**6))
@settings(max_examples=150, deadline=None)
def test_tight_values_are_those_of_linear_programming(m, seed):
    values = np.random.default_rng(seed).normal(0.3 + 0.1 * m, 1, m)
    true, result = programmed(values), SupportPolygons(values)
    # what nearly touches is decided by rounding in one of the two
    assume(true is None or min(SupportPolygons(values - 1e-6).empty == result.empty, True))
    assert bool(result.empty) == (true is None)
    if true is not None:
        assert np.allclose(result.values, true, atol=1e-7) and (result.values >= true - 1e-7).all()


@pytest.mark.parametrize("m", [3, 4, 5, 6, 7, 8, 12, 16])
def test_published_scan_agrees(m):
    random = np.random.default_rng(m)
    empty = 0
    for _ in range(200):
        values = random.normal(0.3 + 0.1 * m, 1, m)
        true, result = scanned(values), SupportPolygons(values)
        assert bool(result.empty) == (true is None)
        empty += true is None
        if true is not None:
            assert np.allclose(result.values, true, atol=1e-8)
    assert 5 < empty < 195


def test_known_polygons():
    octagon = SupportPolygons(np.ones(8))
    assert octagon.area == pytest.approx(8 * np.tan(np.pi / 8))
    assert np.hypot(*octagon.vertices.T) == pytest.approx(1 / np.cos(np.pi / 8))
    # y <= 0: its lower half
    cut = octagon.intersect([0.0] + [5.0] * 7)
    assert cut.area == pytest.approx(4 * np.tan(np.pi / 8)) and cut.values[[1, 7]] == pytest.approx(
        1 / np.sqrt(2)
    )
    triangle = SupportPolygons(np.ones(3))
    assert triangle.area == pytest.approx(3 * np.sqrt(3))
    assert SupportPolygons.around([[3.0, 4.0]], 12).area == pytest.approx(0, abs=1e-12)


def test_touching_polygons_intersect():
    for m in (4, 8, 12, 16):
        square = Region.box([0, 0], 2).around(m)
        for by, empty in (
            ([2, 0], False),
            ([2, 2], False),
            ([2.000001, 0], True),
            ([0, -2.000001], True),
        ):
            assert bool(square.intersect(square.shift(by)).empty) == empty, (m, by)
    assert square.intersect(square.shift([2, 0])).area == pytest.approx(0, abs=1e-12)


@given(m=SIZES, seed=st.integers(0, 10**6))
@settings(max_examples=100, deadline=None)
def test_operations_on_points(m, seed):
    random = np.random.default_rng(seed)
    a, b = random.normal(0, 2, (2, 6, 2))
    A, B, by = SupportPolygons.around(a, m), SupportPolygons.around(b, m), random.normal(size=2)
    assert A.contains(a).all() and A.hull(B).contains(np.concatenate([a, b])).all()
    assert A.shift(by).contains(a + by).all()
    points = random.normal(0, 2, (200, 2))
    both = A.intersect(B)
    assert (both.contains(points) == (A.contains(points) & B.contains(points))).all()
    # the least polygon around the union: each of its values is that of a point
    assert np.allclose(A.hull(B).values, (np.concatenate([a, b]) @ normals(m).T).max(axis=0))
    # corners give the values back, and areas those of the shoelace formula over their hull
    if not both.empty:
        assert np.allclose((both.vertices @ normals(m).T).max(axis=0), both.values, atol=1e-9)
    assert A.area >= max(both.area - 1e-9, 0) and A.hull(B).area >= A.area - 1e-9


def test_the_error_of_a_hull_is_within_the_published_bound():
    """h <= diam tan(pi/m)/2, and nearly attained by a segment halfway between two normals."""
    random = np.random.default_rng(4)
    for m in (4, 8, 12, 16):
        worst = 0
        for _ in range(60):
            points = random.normal(size=(2 if worst == 0 else 4, 2))
            outer = SupportPolygons.around(points, m)
            diameter = max(np.hypot(*(p - q)) for p in points for q in points)
            worst = max(
                worst, max(distance_to_hull(corner, points) for corner in outer.vertices) / diameter
            )
        across = np.pi / m
        segment = np.array([[0, 0], [np.sin(across), np.cos(across)]]) @ np.array([[0, 1], [1, 0]])
        outer = SupportPolygons.around(segment, m)
        worst = max(worst, max(distance_to_hull(corner, segment) for corner in outer.vertices))
        assert 0.4 * np.tan(np.pi / m) < worst <= 0.5 * np.tan(np.pi / m) + 1e-9, m


def distance_to_hull(point, points):
    """By a quadratic programme over the weights of the points."""
    from scipy.optimize import nnls

    rows = np.vstack([points.T, 1e6 * np.ones(len(points))])
    weights, _ = nnls(rows, np.append(point, 1e6))
    return np.hypot(*(weights @ points - point))


def test_arrays_of_polygons_agree_with_single_ones():
    random = np.random.default_rng(0)
    values = random.normal(1.2, 1, (7, 5, 12))
    many = SupportPolygons(values)
    assert many.shape == (7, 5) and many.m == 12
    assert many.vertices.shape == (7, 5, 12, 2) and many.area.shape == (7, 5)
    for row in range(7):
        for column in range(5):
            single = SupportPolygons(values[row, column])
            assert np.array_equal(single.values, many[row, column].values)
    assert 0 < many.empty.sum() < 35 and (many.area[many.empty] == 0).all()
    assert (
        np.isnan(many.vertices[many.empty]).all() and not np.isnan(many.vertices[~many.empty]).any()
    )
    assert np.array_equal(many.hull(many).values, many.values)
    assert (
        many.hull().shape == ()
        and "empty" in repr(many)
        and repr(many[0, 0]).startswith("1 polygon")
    )
    assert many.shift([1, 1]).intersect(many).shape == (7, 5)


@pytest.mark.slow
@given(seed=st.integers(0, 10**6), m=st.sampled_from([5, 8, 12, 16, 64]))
@settings(max_examples=60, deadline=None)
def test_rounding_keeps_corners_far_from_the_origin(seed, m):
    random = np.random.default_rng(seed)
    far = random.uniform(-1e7, 1e7, 2)
    square = Region.box(far, 1.0).around(m)
    corner = far + random.choice([-0.5, 0.5], 2)
    for _ in range(20):
        other = Region.box(corner + 0.5 * random.choice([-1, 1], 2), 1.0).around(m)
        square = square.intersect(other)
        assert not square.empty and square.contains(corner)


def test_regions():
    assert np.allclose(Region.disc([3, -1], 2).around(8).values, 2 + normals(8) @ [3, -1])
    triangle = Region.polygon([[0, 0], [4, 0], [0, 3]])
    assert triangle.around(4).values == pytest.approx([3, 4, 0, 0], abs=1e-12)
    assert triangle.around(12).contains([[1, 1], [4, 0]]).all()
    assert triangle.outline().shape == (3, 2) and Region.disc([0, 0], 1).outline().shape == (120, 2)
    assert "disc of radius 2" in repr(Region.disc([0, 0], 2)) and "3 points" in repr(triangle)
    assert "4 x 2" in repr(Region.box([1, 1], 4, 2))
    # the polygon of a disc is outer
    angle = np.linspace(0, 2 * np.pi, 500)
    assert (
        Region.disc([5, 5], 2)
        .around(7)
        .contains(5 + 2 * np.stack([np.cos(angle), np.sin(angle)], axis=-1))
        .all()
    )


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: SupportPolygons([1.0, 2.0]), "m = 3 or more normals"),
        (lambda: SupportPolygons([1.0, np.nan, 2.0]), "finite numbers"),
        (lambda: SupportPolygons([1.0, np.inf, 2.0]), "bounded"),
        (lambda: SupportPolygons.around([], 4), "shape"),
        (lambda: SupportPolygons.around([1.0, 2.0], 4), "count, 2"),
        (
            lambda: SupportPolygons([1.0] * 4).intersect(SupportPolygons([1.0] * 5)),
            "expected polygons with 4 normals, got 5",
        ),
        (lambda: SupportPolygons([1.0] * 4).hull([1.0] * 3), "4 normals"),
        (lambda: SupportPolygons([1.0] * 4).shift([1, 2, 3]), "by: expected shape"),
        (lambda: SupportPolygons([1.0] * 4).contains([1.0, np.inf]), "points: expected finite"),
        (lambda: Region.box([0, 0], 0), "width: expected a positive"),
        (lambda: Region.box([0, 0], 1, -1), "height: expected a positive"),
        (lambda: Region.box([0, 0, 0], 1), "centre: expected shape"),
        (lambda: Region.disc([[0, 0]], 1), "centre: expected a point"),
        (lambda: Region.disc([0, 0], np.nan), "radius: expected a finite"),
        (lambda: Region.polygon([0, 0]), "points: expected shape"),
    ],
)
def test_bad_polygons_are_named(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_bad_types_and_entries():
    with pytest.raises(TypeError, match="points: expected numbers"):
        SupportPolygons([1.0] * 4).contains(["a", "b"])
    with pytest.raises(TypeError, match="radius: expected a number"):
        Region.disc([0, 0], "wide")
    with pytest.raises(IndexError, match="single polygon"):
        SupportPolygons([1.0] * 4)[0]
