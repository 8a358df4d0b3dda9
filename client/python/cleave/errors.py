# SPDX-License-Identifier: BSD-3-Clause
"""What can go wrong, as exceptions: one class for each result code of cleave.h."""

from __future__ import annotations


class Error(Exception):
    """Something failed; its text says what, and what to do."""


class Timeout(Error, TimeoutError):
    """Nothing came in time: nothing is wrong, ask again."""


class BadArgument(Error, ValueError):
    """A name, a size or a kind that cannot be."""


class NoMemory(Error, MemoryError):
    """Readers hold all chunks: the frame is dropped. Or the machine has no memory left."""


class BadData(Error, ValueError):
    """Bytes that are no sample, or a sample of another kind or with a lie in it."""


class WrongContract(Error):
    """A node speaks another version of the contract than this package does."""


class Closed(Error, ValueError):
    """A frame, a reader or a publisher was used after its close()."""


class Forked(Error):
    """This process was forked from one that is on the stream, and has no part in it."""


class HeldFramesWarning(UserWarning):
    """Many frames are held; their memory is missing in a pool that all readers share."""


_OF_RESULT: dict[int, type[Error]] = {1: Timeout, 2: BadArgument, 3: NoMemory, 4: BadData, 5: Error}


def error_of(result: int, text: str) -> Error:
    """The exception for a cleave_result that is not CLEAVE_OK."""
    return _OF_RESULT.get(result, Error)(text)
