"""Memory, references, threads and signals."""

import concurrent.futures
import gc
import os
import pathlib
import signal
import sys
import threading

import numpy as np
import pytest

import sweep_cdt
from sweep_cdt import _native

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
    points = np.random.default_rng(3).random((1_000_000, 2))
    began, ended = threading.Event(), threading.Event()

    def profile(frame, event, function):
        if function is _native.triangulate:
            (began if event == "c_call" else ended).set()

    def work():
        sys.setprofile(profile)
        sweep_cdt.triangulate(points)
        sys.setprofile(None)

    worker = threading.Thread(target=work)
    worker.start()
    began.wait()
    steps = 0
    while not ended.is_set():
        steps += 1
    worker.join()
    # With the lock held this thread would not get on before the end.
    assert steps > 1000


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timers that send signals")
@pytest.mark.parametrize("name", ["triangulate", "verify", "trace"])
def test_a_signal_ends_a_long_call(name):
    points = np.random.default_rng(3).random((1_500_000, 2))
    triangles = sweep_cdt.triangulate(points).simplices if name == "verify" else None
    events = []

    def profile(frame, event, function):
        if function is getattr(_native, name):
            if event == "c_call":
                signal.setitimer(signal.ITIMER_REAL, 0.1)
            else:
                events.append(event)

    def stop(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, stop)
    sys.setprofile(profile)
    try:
        with pytest.raises(KeyboardInterrupt):
            if name == "verify":
                sweep_cdt.verify(points, triangles)
            else:
                getattr(sweep_cdt, name)(points)
    finally:
        sys.setprofile(None)
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    # The call itself ended so: it did not come to its end first.
    assert events == ["c_exception"]
