"""The errors of all functions. Programs end with an exit code for each class."""

from __future__ import annotations

from typing import Any


class Error(Exception):
    """Any refusal."""

    kind: str = "other"  # name of the kind, for example "not_oriented"
    data: dict[str, Any] = {}  # facts of the message: faces, edge, position, counts, lengths, name


class UsageError(Error, ValueError):
    """An argument that makes no sense; programs exit with 2."""


class InputError(Error, ValueError):
    """A mesh or a file that is not what the operation needs; exit code 3."""


class GoalError(Error, RuntimeError):
    """There is no result; exit code 4."""


class OutputError(Error, OSError):
    """A file could not be written; exit code 5."""


class Cancelled(Error, RuntimeError):
    """The progress callback returned False."""


for _class in (Error, UsageError, InputError, GoalError, OutputError, Cancelled):
    _class.__module__ = "transformesh"
