"""The limits of numbers that are taken exactly: those of the command, since one function in Rust has them for both."""

import random
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

import pytest

import sweep_cdt

# The most digits of a numerator or denominator, and the greatest exponent of a decimal.
DIGITS, EXPONENT = 10_000, 400

TOO_LONG = (
    [10**DIGITS, -(10**100_000), Fraction(1, 10**DIGITS), Fraction(10**DIGITS + 1, 7)]
    + [Decimal("1" * (DIGITS + 1)), Decimal("1." + "1" * DIGITS), Decimal("-" + "7" * 1_000_000)]
)  # fmt: skip
FAR = [Decimal(f"{digits}e{power}") for digits in ("1", "-2.5", "0") for power in (402, -402, 999_999_999, -999_999_999)]
WITHIN = [10**DIGITS - 1, Fraction(1, 1 - 10**DIGITS), Decimal("12e400"), Decimal("-1.5e-399"), Decimal("1" * DIGITS)]


@pytest.mark.parametrize("number", TOO_LONG + FAR, ids=range(len(TOO_LONG + FAR)))
def test_numbers_beyond_a_limit_are_refused_by_name(number):
    what, limit = (f"more than {DIGITS} digits", DIGITS) if number in TOO_LONG else (f"an exponent beyond {EXPONENT}", EXPONENT)
    message = rf"^points\[2, 1\] has {what}, "
    points = [[0, 0], [1, 0], [Fraction(1, 2), number]]
    for call in (sweep_cdt.triangulate, sweep_cdt.crossings, sweep_cdt.split, sweep_cdt.trace, sweep_cdt.measure):
        with pytest.raises(sweep_cdt.TooLargeError, match=message) as caught:
            call(points)
        assert (caught.value.vertex, caught.value.axis, caught.value.limit) == (2, 1, limit)
    with pytest.raises(sweep_cdt.TooLargeError, match=r"^holes\[0, 0\] has"):
        sweep_cdt.triangulate([[0, 0], [1, 0], [0, 1]], [[0, 1], [1, 2], [2, 0]], holes=[[number, Fraction(1, 3)]])
    result = sweep_cdt.triangulate([[0, 0], [1, 0], [0, 1]])
    with pytest.raises(sweep_cdt.TooLargeError, match=r"^xi\[0, 1\] has"):
        result.find_simplex([[Fraction(1, 2), number]])


@pytest.mark.parametrize("number", WITHIN, ids=range(len(WITHIN)))
def test_numbers_within_the_limits_are_exact(number):
    result = sweep_cdt.triangulate([[0, 0], [1, 0], [Fraction(1, 2), number]])
    assert result.points[2, 1] == Fraction(number) and len(result.simplices) == 1


def test_a_number_beside_doubles_is_refused_too():
    with pytest.raises(sweep_cdt.TooLargeError, match=r"^points\[1, 0\] has more than 10000 digits"):
        sweep_cdt.triangulate([[0.5, 0], [10**DIGITS, 0.25], [0, 1]])


@pytest.mark.skipif(sys.platform != "linux", reason="the unit of the memory is that of Linux")
def test_a_large_exponent_takes_no_memory():
    import resource

    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(sweep_cdt.TooLargeError):
        sweep_cdt.triangulate([[0, 0], [1, 0], [0, Decimal("1e999999999")]])
    # As a whole number it would have 400 megabytes; these are kilobytes.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 10_000


def written(dice):
    """A number near a limit: as Python has it, and as a file has it."""
    near = lambda limit: limit + dice.randint(-2, 2)
    if dice.random() < 0.5:
        digits = "".join(dice.choices("123456789", k=dice.choice([1, 3, near(DIGITS - EXPONENT), near(DIGITS)])))
        power = dice.choice([-1, 0, 1]) * near(EXPONENT)
        # A decimal with many digits does not know whether a point or an exponent made it small.
        is_long = power < 0 and len(digits) > EXPONENT
        text = f"{digits[:power]}.{digits[power:]}" if is_long else f"{digits}e{power}"
        return Decimal(text), text
    lengths = [dice.choice([1, near(DIGITS)]) for _ in range(2)]
    # Powers of coprime numbers, so that nothing cancels.
    numerator, denominator = 10 ** (lengths[0] - 1), 10 ** lengths[1] - 1
    return Fraction(numerator, denominator), "1" + "0" * (lengths[0] - 1) + "/" + "9" * lengths[1]


def test_the_limits_are_those_of_the_command(command, tmp_path):
    dice, counts = random.Random(5), [0, 0]
    for _ in range(60):
        number, text = written(dice)
        path = tmp_path / "points.csv"
        path.write_text(f"x,y\n0,0\n1,1/3\n0,{text}\n")
        ran = subprocess.run([command, "triangulate", path], capture_output=True, text=True)
        try:
            sweep_cdt.triangulate([[0, 0], [1, Fraction(1, 3)], [0, number]])
            ours = ""
        except sweep_cdt.TooLargeError as error:
            ours = str(error).removeprefix("points[2, 1] ")
        assert (ran.returncode == 0) == (ours == "") and ours in ran.stderr, (text[:30], ran.stderr[-300:], ours)
        counts[ours == ""] += 1
    assert min(counts) >= 10, counts
