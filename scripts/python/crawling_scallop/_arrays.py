"""Arguments as the C library reads them: numbers and arrays in one shape, in order and without gaps."""

from __future__ import annotations

import reprlib
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._errors import DomainError

Array = npt.NDArray[np.float64]
Floats = Union[np.float64, Array]  # numbers, if every argument was a number
Texts = Union[np.str_, npt.NDArray[np.str_]]
Flags = Union[np.bool_, npt.NDArray[np.bool_]]


def column(name: str, value: npt.ArrayLike) -> Array:
    """The value as float64, itself where it is that already."""
    try:
        array = np.asarray(value)
        if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
            raise DomainError(f"{name}: some of its elements are masked: leave them out, or fill them")
        if array.dtype == np.float64:
            return array
        if array.dtype.kind in "fiub":
            return array.astype(np.float64)
        if array.dtype.kind == "O":  # fractions and the like; astype would make nan of None
            return np.array([float(each) for each in array.flat], float).reshape(array.shape)
    except DomainError:
        raise
    except (TypeError, ValueError, OverflowError):
        pass
    raise DomainError(f"{name}: real numbers are wanted, not {reprlib.repr(value)}")


def spread(array: npt.NDArray[Any], shape: tuple[int, ...]) -> npt.NDArray[Any]:
    """The array in that shape as the library reads it, in order and without gaps: itself where it is so already."""
    if array.shape == shape and array.flags.c_contiguous and array.flags.aligned:
        return array
    full = np.empty(shape, array.dtype)
    full[...] = array
    return full


def count(name: str, value: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not 1 <= value < 2**31:
        raise DomainError(f"{name} = {value!r}: a whole number from 1 to 2147483647")
    return int(value)


def texts(codes: npt.NDArray[Any], text_of: Any) -> Any:
    """text_of each code, called once for each that is different."""
    different, which = np.unique(codes, return_inverse=True)
    return np.array([text_of(code) for code in different], dtype=str)[which.reshape(-1)].reshape(codes.shape)[()]
