"""Memory, references, threads and signals."""

import concurrent.futures
import gc
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import sweep_cdt
from sweep_cdt import _native
from sweep_cdt._graph import as_input

# Each makes three calls, so that there are a hundred thousand.
ROUNDS = 33_334
STATM = pathlib.Path("/proc/self/statm")


def resident():
    """The bytes that the process holds in memory."""
    return int(STATM.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not STATM.exists(), reason="there is no /proc/self/statm, which tells the memory of the process")
def test_references_and_memory_stay_level():
    points = np.random.default_rng(1).random((12, 2))
    edges = np.array([[0, 1], [2, 3]], dtype=np.uintp)
    wrong = [[0, 1, 2]]

    def three_calls():
        result = sweep_cdt.triangulate(points)
        result.simplices, result.neighbors, result.find_simplex(points)
        try:
            sweep_cdt.triangulate(points, edges)
        except sweep_cdt.CrossingEdgesError:
            pass
        sweep_cdt.verify(points, wrong)

    for _ in range(ROUNDS // 10):
        three_calls()
    gc.collect()
    held = [points, edges, wrong, sweep_cdt.CrossingEdgesError]
    references, before = [sys.getrefcount(each) for each in held], resident()
    for _ in range(ROUNDS):
        three_calls()
    gc.collect()
    assert [sys.getrefcount(each) for each in held] == references
    # A leak of ten bytes a call would be a megabyte.
    assert resident() - before < 2**20


def test_four_threads_at_once():
    dice = np.random.default_rng(3)
    inputs = [dice.random((count, 2)) for count in (10, 1000, 30_000, 30_000)] * 6
    expected = [sweep_cdt.triangulate(points).canonical() for points in inputs]
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        results = list(pool.map(sweep_cdt.triangulate, inputs))
        reports = list(pool.map(sweep_cdt.verify, results))
    assert all((result.canonical() == canonical).all() for result, canonical in zip(results, expected))
    assert all(reports)


def test_one_result_is_read_by_four_threads():
    points = np.random.default_rng(3).random((30_000, 2))
    result = sweep_cdt.triangulate(points)
    names = ["simplices", "neighbors", "constrained", "convex_hull", "area"] * 8
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda name: getattr(result, name), names))
    assert all(np.array_equal(one, getattr(result, name)) for one, name in zip(found, names))


def test_the_lock_is_released():
    given = as_input(np.random.default_rng(3).random((2_000_000, 2)))
    happened = []

    def work():
        happened.append("begins")
        _native.triangulate(given, "hull", 1)
        happened.append("ends")

    interval = sys.getswitchinterval()
    worker = threading.Thread(target=work)
    try:
        # Nobody has to give the lock away: who has it keeps it, unless it is released.
        sys.setswitchinterval(1000)
        worker.start()
        happened.append("another thread works")
        worker.join()
    finally:
        sys.setswitchinterval(interval)
    assert happened.index("another thread works") < happened.index("ends")


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timers that send signals")
@pytest.mark.parametrize(("name", "size"), [("triangulate", 3_000_000), ("verify", 2_000_000), ("trace", 600_000)])
def test_a_signal_ends_a_long_call(name, size):
    points = np.random.default_rng(3).random((size, 2))
    arguments = [points]
    if name == "verify":
        arguments.append(sweep_cdt.triangulate(points).simplices)
    call = getattr(sweep_cdt, name)

    def processor(call):
        before = time.process_time()
        call()
        return time.process_time() - before

    def interrupted():
        with pytest.raises(KeyboardInterrupt):
            # Of the time that the processor works for this process.
            signal.setitimer(signal.ITIMER_PROF, 0.2 * whole)
            call(*arguments)

    def stop(number, frame):
        raise KeyboardInterrupt

    whole = processor(lambda: call(*arguments))
    before = signal.signal(signal.SIGPROF, stop)
    try:
        part = processor(interrupted)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
    # The work did not go on to its end.
    assert part < 0.8 * whole


# The limit on processes does not hold for root, so the call is made as nobody.
WITHOUT_THREADS = """
import os, resource
import numpy as np
import sweep_cdt
points = np.random.default_rng(1).random((30_000, 2))
if os.getuid() == 0:
    os.setgroups([])
    os.setgid(65534)
    os.setuid(65534)
resource.setrlimit(resource.RLIMIT_NPROC, (0, 0))
counts = [len(sweep_cdt.triangulate(points, threads=threads).simplices) for threads in (1, 2)]
assert counts[0] == counts[1] > 59_000, counts
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the limit on processes is that of Linux")
def test_one_thread_does_the_work_where_none_can_be_made():
    run = [sys.executable, "-c", WITHOUT_THREADS]
    done = subprocess.run(run, capture_output=True, text=True, env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    assert done.returncode == 0, done.stderr
