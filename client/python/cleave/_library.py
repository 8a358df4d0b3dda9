# SPDX-License-Identifier: BSD-3-Clause
"""Finds libcleave-c, loads it, and declares its functions as cleave.h does."""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
from ctypes import POINTER, c_char_p, c_float, c_int, c_int32, c_int64, c_size_t, c_uint32
from ctypes import c_uint64, c_void_p
from typing import Any

from . import _structs
from .errors import error_of

ABI_VERSION = 1  # CLEAVE_ABI_VERSION of the cleave.h that _structs.py follows
_NAME = f"libcleave-c.so.{ABI_VERSION}"

_handle = c_void_p
_out = POINTER(c_void_p)
_RESULT = c_int  # a cleave_result, which check() looks at

_FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "cleave_version": (c_char_p, []),
    "cleave_error": (c_char_p, []),
    "cleave_outcome_name": (c_char_p, [c_uint32]),
    "cleave_state_name": (c_char_p, [c_uint32]),
    "cleave_open": (_RESULT, [POINTER(_structs.Options), _out]),
    "cleave_close": (None, [_handle]),
    "cleave_uses_shared_memory": (c_int, [_handle, POINTER(c_char_p)]),
    "cleave_reader_open": (_RESULT, [_handle, c_int, c_char_p, c_uint32, _out]),
    "cleave_reader_close": (None, [_handle]),
    "cleave_next": (_RESULT, [_handle, c_int32, _out]),
    "cleave_reader_fd": (c_int, [_handle]),
    "cleave_reader_writers": (c_uint32, [_handle]),
    "cleave_frames_open": (_RESULT, [_handle, c_char_p, _out]),
    "cleave_frames_close": (None, [_handle]),
    "cleave_frames_next": (_RESULT, [_handle, c_int32, _out, _out, _out]),
    "cleave_frames_fd": (c_int, [_handle]),
    "cleave_frames_given_up": (c_uint64, [_handle]),
    "cleave_release": (None, [_handle]),
    "cleave_sample_kind": (c_int, [_handle]),
    "cleave_sample_zero_copy": (c_int, [_handle]),
    "cleave_sample_header": (POINTER(_structs.Header), [_handle]),
    "cleave_sample_cloud": (_RESULT, [_handle, _out, POINTER(c_size_t)]),
    "cleave_sample_labels": (_RESULT, [_handle, _out, POINTER(c_size_t), POINTER(c_int64)]),
    "cleave_sample_list": (_RESULT, [_handle, POINTER(_structs.List)]),
    "cleave_sample_status": (_RESULT, [_handle, POINTER(_structs.Status)]),
    "cleave_decode": (_RESULT, [c_int, c_int, c_char_p, c_size_t, _out]),
    "cleave_encode": (_RESULT, [_handle, _out, POINTER(c_size_t)]),
    "cleave_publisher_open": (_RESULT, [_handle, POINTER(_structs.Camera), _out]),
    "cleave_publisher_close": (None, [_handle]),
    "cleave_publish_depth16": (_RESULT, [_handle, c_void_p, c_size_t, c_float, c_int64]),
    "cleave_publish_depth32": (_RESULT, [_handle, c_void_p, c_size_t, c_int64]),
    "cleave_publish_points": (_RESULT, [_handle, c_void_p, c_size_t, c_int64]),
    "cleave_loan": (_RESULT, [_handle, _out, POINTER(c_size_t)]),
    "cleave_publish_loan": (_RESULT, [_handle, c_int64]),
    "cleave_publisher_readers": (c_uint32, [_handle]),
}


def _candidates() -> list[str]:
    """Where the library may be; one that CLEAVE_LIBRARY names is the only one."""
    named = os.environ.get("CLEAVE_LIBRARY")
    if named:
        return [named]
    package = pathlib.Path(__file__).resolve().parent
    checkout = package.parents[2]
    builds = (checkout / "build").glob(f"*/lib/{_NAME}") if (checkout / "idl").is_dir() else ()
    # Of several builds the optimised one.
    ordered = sorted(builds, key=lambda path: (path.parts[-3] != "release", path))
    installed = package.parents[2] / _NAME  # the package is in lib/python3/dist-packages
    # The last: as ld.so finds it.
    return [str(package / _NAME), str(installed), *map(str, ordered), _NAME]


_ADVICE = (
    "build it with `cmake --build --preset release --target cleave-c`, install it, or set "
    "CLEAVE_LIBRARY to its path"
)


def load() -> ctypes.CDLL:
    """The library of this package's version; ImportError says why not, and what to do."""
    tried = []
    for path in _candidates():
        try:
            library = ctypes.CDLL(path)
        except OSError as error:
            tried.append(f"  {path}: {error}")
            continue
        return _declared(library, path)
    raise ImportError(
        f"cleave: found no {_NAME} that loads; {_ADVICE}. Looked at:\n" + "\n".join(tried)
    )


def _declared(library: ctypes.CDLL, path: str) -> ctypes.CDLL:
    try:
        library.cleave_abi_version.restype = c_uint32
        found = library.cleave_abi_version()
        if found != ABI_VERSION:
            raise ImportError(
                f"cleave: {path} has the C interface's version {found}, and this package is made "
                f"for version {ABI_VERSION}: use the package and the library of one release; "
                f"{_ADVICE}"
            )
        for name, (result, arguments) in _FUNCTIONS.items():
            function = getattr(library, name)
            function.restype, function.argtypes = result, arguments
    except AttributeError as error:
        raise ImportError(f"cleave: {path} is no libcleave-c ({error}); {_ADVICE}") from error
    return library


lib = load()


def text(value: bytes | None) -> str:
    """A C string as str; what is no UTF-8 is escaped, not refused."""
    return (value or b"").decode("utf-8", "backslashreplace")


def check(result: int) -> None:
    """Raises the exception of a result that is not CLEAVE_OK."""
    if result != 0:
        raise error_of(result, text(lib.cleave_error()))
