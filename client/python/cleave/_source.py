# SPDX-License-Identifier: BSD-3-Clause
"""Waiting for what comes next, in a thread and in an event loop."""

from __future__ import annotations

import asyncio
import logging
import time
from abc import abstractmethod
from types import TracebackType
from typing import Generic, TypeVar

from ._handles import Handle
from .errors import BadArgument, BadData, Timeout

Item = TypeVar("Item")
Self = TypeVar("Self", bound="Source")  # type: ignore[type-arg]

log = logging.getLogger("cleave")

_PATIENCE_S = 2.0  # of silence, until it is told
_SLICE_S = 0.5  # the longest wait within the library: so long close() in another thread takes


class Source(Handle, Generic[Item]):
    """An endless iterator, plain and asynchronous. Timeout ends a wait, not the iterator."""

    timeout: float | None
    bad_samples = 0  # a foreign writer's, which made no sense and were dropped
    _warned = False

    def _check_timeout(self, timeout: float | None) -> None:
        if timeout is not None and not 0 <= timeout < 1e6:
            raise BadArgument(f"a timeout of {timeout} s is not from 0 to a million")
        self.timeout = timeout

    @abstractmethod
    def _take(self, timeout_ms: int) -> Item | None:
        """The next one; None if it does not come in time. Called with the lock held."""

    @abstractmethod
    def _descriptor(self) -> int:
        """Becomes readable when something may have come."""

    @abstractmethod
    def _silence(self) -> str:
        """Why nothing came: who, where, and what to do."""

    def _next(self, timeout_s: float) -> Item | None:
        with self.lock:
            try:
                return self._take(int(timeout_s * 1000))
            except BadData as error:
                self.bad_samples += 1
                log.warning("a sample is dropped: %s", error)
                return None

    def _left(self, start: float) -> float:
        """Seconds to wait on; Timeout when they are over."""
        waited = time.monotonic() - start
        if self.timeout is not None and waited >= self.timeout:
            raise Timeout(f"nothing came within {self.timeout:g} s: {self._silence()}")
        if self.timeout is None and waited >= _PATIENCE_S and not self._warned:
            self._warned = True
            log.warning("nothing came for %.0f s: %s; waiting on", _PATIENCE_S, self._silence())
        return min(_SLICE_S, float("inf") if self.timeout is None else self.timeout - waited)

    def __iter__(self: Self) -> Self:
        return self

    def __next__(self) -> Item:
        item, start = self._next(0), time.monotonic()
        while item is None:  # Ctrl-C interrupts the library's wait, and is raised here
            item = self._next(self._left(start))
        return item

    def __aiter__(self: Self) -> Self:
        return self

    async def __anext__(self) -> Item:
        item, start = self._next(0), time.monotonic()
        while item is None:
            await self._readable(self._left(start))
            item = self._next(0)
        return item

    async def _readable(self, timeout_s: float) -> None:
        loop, event = asyncio.get_running_loop(), asyncio.Event()
        descriptor = self._descriptor()
        loop.add_reader(descriptor, event.set)
        try:
            await asyncio.wait_for(event.wait(), timeout_s)
        except asyncio.TimeoutError:
            pass  # __anext__ looks at the time
        finally:
            loop.remove_reader(descriptor)

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
