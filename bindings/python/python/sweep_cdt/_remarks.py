"""Remarks: what is ignored, merged, missing, chosen or guessed. The engine makes them, in its words.

Those of a call are warnings, a list of its result, and, where `strict` asks for that, an error.
"""

from __future__ import annotations

import dataclasses
import sys
import warnings
from collections.abc import Sequence
from typing import Any, Protocol, TypeVar

from ._errors import RemarkError


class Remarked(Protocol):
    """A result that has remarks."""

    @property
    def remarks(self) -> Sequence[Remark]: ...


T = TypeVar("T", bound="Remarked")


@dataclasses.dataclass(frozen=True)
class Remark:
    """Something that the user of an input should know; as a string it is a sentence.

    Attributes
    ----------
    kind : str
        ``conflict``, for instance: one place has two heights.
    words : str
        The sentence.
    is_loss : bool
        Whether something of the input gets lost: `strict` refuses that.
    numbers : dict
        The numbers and names in the sentence, as the command writes them.
    """

    kind: str
    words: str
    is_loss: bool
    numbers: dict[str, Any] = dataclasses.field(default_factory=dict, hash=False)

    def __str__(self) -> str:
        return self.words


class RemarkWarning(UserWarning):
    """The warning of a remark, which it has as its attribute ``remark``."""

    def __init__(self, remark: Remark) -> None:
        super().__init__(remark)
        self.remark = remark


def say(remarks: Sequence[Remark], strict: bool = False) -> None:
    """Warns with each remark; with `strict`, what gets lost is an error."""
    lost = tuple(remark for remark in remarks if remark.is_loss)
    if strict and lost:
        raise RemarkError("; ".join(map(str, lost)) + " (strict=True)", remarks=lost)
    # The warning names the line outside of the package.
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for remark in remarks:
        warnings.warn(RemarkWarning(remark), stacklevel=level)


def told(result: T, strict: bool) -> T:
    """A result, after its remarks were said."""
    say(result.remarks, strict)
    return result
