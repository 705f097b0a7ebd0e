"""Errors, each with the status of the toolkit."""

from __future__ import annotations


class ScallopError(Exception):
    """The base of all errors of this package.

    Attributes
    ----------
    status : str
        The status in words, as the column ``status`` of the command has it.
    """

    status = "error"

    def __init__(self, message: str, status: str | None = None) -> None:
        super().__init__(message)
        if status is not None:
            self.status = status


class DomainError(ScallopError, ValueError):
    """An argument outside its domain, or of a kind that the function does not take. The message names the argument
    and, in an array, the first bad row."""

    status = "a parameter is outside its domain"


class UnsolvedError(ScallopError, ArithmeticError):
    """A well-posed problem without an answer: `status` says why."""


class MissingError(ScallopError, OSError):
    """The library or the command is missing, is of another version, or was built without the part that is needed."""

    status = "not available"


class CommandError(ScallopError, RuntimeError):
    """The command failed.

    Attributes
    ----------
    code : int
        Its exit code: 1 a check failed, 2 bad input, 3 a computation could not be done, 4 a file could not be read.
    """

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message, f"exit code {code}")
        self.code = code
