# SPDX-License-Identifier: BSD-3-Clause
"""What the library opened, as objects that close it, once, and never in a forked child."""

from __future__ import annotations

import ctypes
import os
import threading
import weakref
from typing import Any, Callable

from ._library import check
from .errors import Closed, Forked


def _close(close: Callable[[int], None], pointer: int, process: int, lock: threading.Lock) -> None:
    if os.getpid() != process:  # a child shares the memory, but nothing of this is its own
        return
    with lock:
        close(pointer)


def refuse_fork(process: int | None) -> None:
    """Forked if what belongs to `process` is used in another one."""
    if process not in (None, os.getpid()):
        raise Forked(
            "this process was forked from one that is on Cleave's stream: a fork has no part in "
            "shared memory and DDS. Join after forking, or start the process with "
            "multiprocessing's 'spawn'"
        )


class Handle:
    """A pointer of cleave.h. `lock` is held while the library uses it, so that no thread closes
    what another one waits on."""

    def __init__(self, pointer: ctypes.c_void_p, close: Callable[[int], None]) -> None:
        self._process = os.getpid()
        self._pointer = pointer.value or 0
        self.lock = threading.Lock()
        # What is left open at the end is closed, so that others need not wait for a lease to run out.
        self._closer = weakref.finalize(
            self, _close, close, self._pointer, self._process, self.lock
        )

    @property
    def pointer(self) -> int:
        """For the library's functions; raises where it is of no use any more."""
        refuse_fork(self._process)
        if not self._closer.alive:
            raise Closed("it is closed")
        return self._pointer

    def close(self) -> None:
        """Closes it; a second time does nothing."""
        self._closer()


def opened(function: Callable[..., int], *arguments: Any) -> ctypes.c_void_p:
    """What a function of the library that opens something yields through its last argument."""
    result = ctypes.c_void_p()
    check(function(*arguments, ctypes.byref(result)))
    return result
