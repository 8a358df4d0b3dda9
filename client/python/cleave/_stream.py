# SPDX-License-Identifier: BSD-3-Clause
"""The process's stream: one, shared by all that is opened, left when the last of that is gone."""

from __future__ import annotations

import ctypes
import logging
import os
import threading
import weakref
from typing import NamedTuple

from ._handles import Handle, opened, refuse_fork
from ._library import lib, text
from ._structs import Options as _Options
from .errors import BadArgument, Error

log = logging.getLogger("cleave")


class Options(NamedTuple):
    """How to join; None = as the open stream has it, or the default."""

    domain: int | None = None
    shared_memory: bool | None = None
    interface: str | None = None

    def agree_with(self, others: Options) -> bool:
        """Whether a stream joined with `others` serves these."""
        return all(mine is None or mine == theirs for mine, theirs in zip(self, others))


class Stream(Handle):
    """A membership; what is opened on it keeps it."""

    def __init__(self, options: Options) -> None:
        interface = options.interface.encode() if options.interface is not None else None
        domain = -1 if options.domain is None else options.domain
        if not -1 <= domain <= 99:
            raise BadArgument(f"domain {domain} is not from 0 to 99")
        asked = _Options(domain, int(options.shared_memory is not False), interface)
        super().__init__(opened(lib.cleave_open, ctypes.byref(asked)), lib.cleave_close)
        self.options = options
        self.without_memory_by_default = False

    @property
    def domain(self) -> str:
        """As the environment or the caller has it."""
        asked = self.options.domain
        return str(asked) if asked is not None else os.environ.get("CLEAVE_DOMAIN", "0")

    def transport(self) -> tuple[bool, str]:
        """Whether shared memory carries clouds and label maps, and why (or why not)."""
        reason = ctypes.c_char_p()
        uses = lib.cleave_uses_shared_memory(self.pointer, ctypes.byref(reason))
        return bool(uses), text(reason.value)


_lock = threading.Lock()
_joined: weakref.ref[Stream] | None = None
_process: int | None = None  # the one that joined, once


def join(
    domain: int | None, shared_memory: bool | None, interface: str | None, *, clouds: bool
) -> Stream:
    """The process's stream; Error if it was joined with other options. `clouds`: whether they are
    what it is for: else shared memory is left out unless asked for."""
    global _joined, _process
    refuse_fork(_process)
    options = Options(domain, shared_memory, interface)
    with _lock:
        stream = _joined() if _joined is not None else None
        if stream is None:
            with_memory = clouds if shared_memory is None else shared_memory
            stream = Stream(options._replace(shared_memory=with_memory))
            stream.without_memory_by_default = not clouds and shared_memory is None
            _joined, _process = weakref.ref(stream), os.getpid()
    if not options.agree_with(stream.options):
        raise Error(
            f"this process is on the stream with {stream.options}, and cannot join with {options}, "
            "too: leave out what differs, or close all that is open and drop its frames first"
        )
    if clouds and stream.without_memory_by_default and shared_memory is None:
        log.warning(
            "clouds are copied over loopback: this process joined without shared memory, for "
            "segment lists or statuses. Open frames or publishers first, or pass "
            "shared_memory=True to what is opened first"
        )
    return stream


def _leave_alone_in_child() -> None:
    """A child that ends as C ends programs would sign its parent off at RouDi, which ends it: so
    it ends at once instead, with the code it was to end with."""
    global _lock
    _lock = threading.Lock()
    if _process is not None:
        libc = ctypes.CDLL(None)
        libc.on_exit(ctypes.cast(libc._exit, ctypes.c_void_p), None)


os.register_at_fork(after_in_child=_leave_alone_in_child)
