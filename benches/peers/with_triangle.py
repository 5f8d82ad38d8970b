"""Triangle on a data set, as crates/testing/src/binary.rs describes it, through the Python package `triangle`.

`with_triangle.py INPUT CALLS [ANSWER]` triangulates it so many times and prints, for each input each time, a line with
nanoseconds, and bytes in the first one; without arguments it prints the package's version.
"""

import sys
import time
from importlib.metadata import version

import numpy
import triangle


def peak():
    """The largest resident set so far, in bytes."""
    with open("/proc/self/status") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmHWM:"))


def inputs(path):
    """The dictionaries that `triangle` takes."""
    numbers = numpy.fromfile(path, dtype="<u8")
    place = 1
    for _ in range(int(numbers[0])):
        points, edges = (int(size) for size in numbers[place : place + 2])
        place += 2
        parts = {"vertices": numbers[place : place + 2 * points].view("<f8").reshape(-1, 2).copy()}
        place += 2 * points
        if edges:
            ends = numbers[place : place + 2 * edges].astype("int32")
            parts["segments"] = ends.reshape(-1, 2)
        place += 2 * edges
        yield parts


def main():
    if len(sys.argv) < 2:
        print(version("triangle"))
        return
    before = None
    for _ in range(int(sys.argv[2])):
        answers = []
        for parts in inputs(sys.argv[1]):
            is_first = before is None
            if is_first:
                with open("/proc/self/clear_refs", "w") as file:
                    file.write("5")
                before = peak()
            start = time.perf_counter_ns()
            # With edges, up to the convex hull.
            result = triangle.triangulate(parts, "pc" if "segments" in parts else "")
            nanoseconds = time.perf_counter_ns() - start
            print(nanoseconds, peak() - before if is_first else "")
            answers.append(result["triangles"].astype("<u8"))
    if len(sys.argv) > 3:
        with open(sys.argv[3], "wb") as file:
            for triangles in answers:
                file.write(numpy.array([len(triangles)], dtype="<u8").tobytes())
                file.write(triangles.tobytes())


main()
