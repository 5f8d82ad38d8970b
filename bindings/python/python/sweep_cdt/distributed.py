"""Triangulations on many machines: points and edges in files, sorted by Dask and triangulated in bands.

`pip install "sweep-cdt[dask]"` brings Dask with it. All workers must see the files and the folder by the same paths.

A band is triangulated by itself. Triangles that no other band can change are final, and written; what is left is a rest,
and rests of bands that follow each other are joined, up to one for all. So the files together are the triangulation: as
a set that of `sweep_cdt.triangulate`, however many bands and workers there are.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from uuid import uuid4

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import EdgeOutOfRangeError, Error, NonFiniteError, ShapeError

try:
    import dask.dataframe as dd
    import pandas as pd
    from dask.distributed import Client, Future, default_client
    from dask.distributed import progress as show
except ImportError as error:
    raise ImportError('sweep_cdt.distributed needs Dask: pip install "sweep-cdt[dask]"') from error

__all__ = ["join", "triangulate"]

Name = str | os.PathLike[str]

# So many rests are joined at once.
_FAN = 8


def triangulate(
    files: Name | Sequence[Name],
    *,
    folder: Name,
    edges: Name | None = None,
    band: int = 1_000_000,
    client: Client | None = None,
    progress: bool = False,
) -> list[Path]:
    """Triangulates the points of files, with edges, on the workers of a `Client` (by default, of the last one).

    - `files`: raw doubles, little-endian, x and y of each point (`.f64`). Points are numbered from 0 through all files.
      Other formats `sweep-cdt stream INPUT --band N -o BANDS` makes bands of, for `join`.
    - `folder`: where the triangles go; empty or new. It has them once all are made.
    - `edges`: pairs of whole numbers of 64 bits, little-endian: the points at both ends.
    - `band`: about so many points are triangulated at once. All points of one y are in one band.
    - `progress`: whether Dask's bar is shown.

    Returns the files of triangles, one for each band and each join: the numbers of three points for each triangle,
    counter-clockwise, little-endian, of 32 bits (`.u32`), or of 64 (`.u64`) where there are more than 2^32 points. What a
    worker held that dies, Dask makes again: the same files.

    Raises `NonFiniteError`, `EdgeOutOfRangeError`, `CrossingEdgesError` as `sweep_cdt.triangulate` does; of edges that
    cross another pair may be named. A point takes 24 bytes of the workers' memory while Dask sorts, an edge 48 for each
    band that it passes; Dask spills to disk what does not fit.
    """
    client = client or default_client()
    source = _Source.of([files] if isinstance(files, str | os.PathLike) else files)
    total = source.begins[-1]
    if total == 0:
        raise Error("there are no files, or no points in them")
    if band < 1:
        raise Error(f"band is {band}: it is at least one point")
    points = dd.from_map(source.points, _pieces(total, band))
    points = points.sort_values(["y", "x", "number"])
    parts = client.compute(points.persist().to_delayed())
    summaries = client.gather(client.map(_summary, parts))
    held = [(part, found) for part, found in zip(parts, summaries, strict=True) if found]
    lows, between = [found.low for _, found in held], _between([found for _, found in held])
    of_bands = [None] * len(held)
    if edges is not None:
        path = Path(edges).absolute()
        table = dd.from_map(source.edges, _pieces(_count(path), band), path=path, lows=np.array(lows))
        divided = table.set_index("band", divisions=list(range(len(held) + 1)))
        of_bands = client.compute(divided.to_delayed())
    firsts = np.cumsum([0, *(found.count for _, found in held)])
    with _written(folder) as out:
        made = [
            client.submit(
                _band,
                part,
                of_band,
                total,
                between,
                int(first),
                _Output(out, k, k, len(held)),
                pure=False,
            )
            for k, ((part, _), of_band, first) in enumerate(
                zip(held, of_bands, firsts, strict=False)
            )
        ]
        _join(client, made, out, progress)
    return _files(folder)


def join(
    bands: Sequence[Name], *, folder: Name, client: Client | None = None, progress: bool = False
) -> list[Path]:
    """Triangulates bands that are files, from below: those of `sweep-cdt stream --band`, sorted by their names.

    Takes and returns what `triangulate` does.
    """
    client = client or default_client()
    if not bands:
        raise Error("there are no bands")
    paths = [Path(path).absolute() for path in bands]
    with _written(folder) as out:
        made = [
            client.submit(_band_of_file, path, _Output(out, k, k, len(paths)), pure=False)
            for k, path in enumerate(paths)
        ]
        _join(client, made, out, progress)
    return _files(folder)


def _join(client: Client, rests: list[Future[Any]], folder: Path, progress: bool) -> None:
    """Joins rests as a tree."""
    count, width = len(rests), 1
    while len(rests) > 1:
        width *= _FAN
        rests = [
            client.submit(
                _settled,
                rests[k : k + _FAN],
                _Output(folder, k // _FAN * width, min((k // _FAN + 1) * width, count) - 1, count),
                pure=False,
            )
            for k in range(0, len(rests), _FAN)
        ]
    if progress:
        show(rests)
    client.gather(rests)


@contextmanager
def _written(folder: Name) -> Iterator[Path]:
    """A folder that gets its name once all is in it, and is removed if that fails."""
    folder = Path(folder).absolute()
    if folder.exists() and any(folder.iterdir()):
        raise Error(f"{folder} is not empty: its files would be taken for triangles of this run")
    part = folder.with_name(f".{folder.name}.{uuid4().hex[:8]}")
    part.mkdir(parents=True)
    try:
        yield part
        # Files of workers that died while they wrote.
        for unfinished in part.glob(".*"):
            unfinished.unlink()
        part.replace(folder)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise


def _files(folder: Name) -> list[Path]:
    return sorted(Path(folder).absolute().iterdir())


@dataclass(frozen=True)
class _Output:
    """Where the triangles of a run go that joins bands, from one to another of so many."""

    folder: Path
    low: int
    high: int
    bands: int

    def write(self, triangles: NDArray[np.uint64], total: int) -> None:
        """Writes a file that is whole or not there."""
        digits = len(str(self.bands - 1))
        names = [f"{k:0{digits}}" for k in sorted({self.low, self.high})]
        kind = "u32" if total <= 1 << 32 else "u64"
        with tempfile.NamedTemporaryFile(dir=self.folder, prefix=".", delete=False) as file:
            triangles.astype(f"<u{int(kind[1:]) // 8}").tofile(file)
        os.replace(file.name, self.folder / f"{'-'.join(names)}.{kind}")


def _settled(rests: list[bytes], out: _Output) -> bytes | None:
    """Joins rests, and writes what is final. Returns what is left."""
    triangles, total, left = _native.join(rests)
    out.write(triangles, total)
    return left


def _band_of_file(path: Path, out: _Output) -> bytes | None:
    return _settled([path.read_bytes()], out)


def _band(
    points: pd.DataFrame,
    edges: pd.DataFrame | None,
    total: int,
    between: tuple[float, float],
    first: int,
    out: _Output,
) -> bytes | None:
    if edges is None:
        edges = pd.DataFrame(np.empty((0, 5)), columns=["edge", *_ENDS])
    band = _native.band(
        total,
        between,
        first,
        np.require(points["number"], np.uint64, ["C", "A"]),
        np.require(points[["x", "y"]], np.float64, ["C", "A"]),
        np.require(edges["edge"], np.uint64, ["C", "A"]),
        np.require(edges[_ENDS], np.float64, ["C", "A"]),
    )
    return _settled([band], out)


@dataclass(frozen=True)
class _Summary:
    count: int
    low: float
    least: float
    most: float


def _summary(points: pd.DataFrame) -> _Summary | None:
    """How many points a band has, its lowest y and its range of x."""
    if points.empty:
        return None
    return _Summary(len(points), points["y"].iloc[0], points["x"].min(), points["x"].max())


def _between(found: list[_Summary]) -> tuple[float, float]:
    return min(each.least for each in found), max(each.most for each in found)


_ENDS = ["ax", "ay", "bx", "by"]


@dataclass(frozen=True)
class _Source:
    """Files of points, and the number of the first point of each, and of all."""

    paths: list[Path]
    begins: list[int]

    @staticmethod
    def of(files: Sequence[Name]) -> _Source:
        paths = [Path(path).absolute() for path in files]
        for path in paths:
            if path.suffix not in {".f64", ".xy"}:
                raise Error(
                    f"{path}: not .f64, raw doubles; `sweep-cdt stream {path} --band N -o BANDS` makes bands of other "
                    "formats, for sweep_cdt.distributed.join"
                )
        return _Source(paths, np.cumsum([0, *map(_count, paths)]).tolist())

    def places(self, begin: int, end: int) -> NDArray[np.float64]:
        """The points of a range of numbers."""
        parts = [
            _read(path, "<f8", max(begin - low, 0), min(end, high) - low)
            for path, low, high in zip(self.paths, self.begins, self.begins[1:], strict=False)
            if begin < high and low < end
        ]
        # There is one zero.
        return np.concatenate(parts) + 0.0

    def points(self, piece: tuple[int, int]) -> pd.DataFrame:
        """The table of a range of numbers."""
        places = self.places(*piece)
        bad = np.argwhere(~np.isfinite(places))
        if len(bad):
            vertex, axis = int(bad[0, 0]) + piece[0], int(bad[0, 1])
            raise NonFiniteError(f"vertex {vertex} has a coordinate that is not finite", vertex=vertex, axis=axis)
        number = np.arange(*piece, dtype=np.uint64)
        return pd.DataFrame({"number": number, "x": places[:, 0], "y": places[:, 1]})

    def edges(self, piece: tuple[int, int], path: Path, lows: NDArray[np.float64]) -> pd.DataFrame:
        """The table of a range of edges: a row for each band that one begins or ends in, or passes."""
        pairs = _read(path, "<u8", *piece)
        bad = np.argwhere(pairs >= self.begins[-1])
        if len(bad):
            edge, vertex = int(bad[0, 0]) + piece[0], int(pairs[tuple(bad[0])])
            message = f"edge {edge} ends at vertex {vertex}, and there are {self.begins[-1]} points"
            raise EdgeOutOfRangeError(message, edge=edge, vertex=vertex)
        ends = self.gathered(pairs.reshape(-1)).reshape(-1, 4)
        by_y = np.sort(ends[:, [1, 3]], axis=1)
        low, high = np.searchsorted(lows, by_y, side="right").T - 1
        times = high - low + 1
        row = np.repeat(np.arange(len(pairs)), times)
        first = np.repeat(np.cumsum(times) - times, times)
        table = pd.DataFrame(ends[row], columns=_ENDS)
        table["edge"] = (row + piece[0]).astype(np.uint64)
        table["band"] = low[row] + np.arange(len(row)) - first
        return table

    def gathered(self, numbers: NDArray[np.uint64]) -> NDArray[np.float64]:
        """The places of these points."""
        places = np.empty((len(numbers), 2))
        for path, low, high in zip(self.paths, self.begins, self.begins[1:], strict=False):
            here = (low <= numbers) & (numbers < high)
            if here.any():
                places[here] = np.memmap(path, "<f8", "r").reshape(-1, 2)[numbers[here] - np.uint64(low)]
        return places + 0.0


def _count(path: Path) -> int:
    """How many pairs of eight bytes each a file has."""
    pairs, beyond = divmod(path.stat().st_size, 16)
    if beyond:
        raise ShapeError(f"{path}: not a whole number of pairs, {beyond} bytes too long")
    return pairs


def _read(path: Path, kind: str, begin: int, end: int) -> NDArray[Any]:
    return np.fromfile(path, kind, count=2 * (end - begin), offset=16 * begin).reshape(-1, 2)


def _pieces(total: int, size: int) -> list[tuple[int, int]]:
    return [(begin, min(begin + size, total)) for begin in range(0, max(total, 1), size)]
