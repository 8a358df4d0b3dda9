# SPDX-License-Identifier: BSD-3-Clause
"""Segment lists and statuses, which need no shared memory and come from other machines, too."""

from __future__ import annotations

import ctypes
import time
from typing import TypeVar

from ._handles import opened
from ._library import lib
from ._source import Source
from ._stream import Stream, join
from .errors import Timeout, WrongContract
from .samples import CONTRACT, Cloud, Sample, SegmentList, Status, status_of
from .types import Kind

Item = TypeVar("Item", Cloud, SegmentList, Status)


class Reader(Source[Item]):
    """What comes on one topic, the oldest first."""

    def __init__(self, stream: Stream, kind: Kind, sensor: str, timeout: float | None) -> None:
        self._check_timeout(timeout)
        pointer = opened(lib.cleave_reader_open, stream.pointer, int(kind), sensor.encode(), 0)
        super().__init__(pointer, lib.cleave_reader_close)
        self.stream = stream
        self.sensor = sensor

    @property
    def writers(self) -> int:
        """Those that are alive; 0 = nobody publishes."""
        return int(lib.cleave_reader_writers(self.pointer))

    def _descriptor(self) -> int:
        return int(lib.cleave_reader_fd(self.pointer))

    def _pointer_in_time(self, timeout_ms: int) -> ctypes.c_void_p | None:
        try:
            return opened(lib.cleave_next, self.pointer, timeout_ms)
        except Timeout:
            return None


class SegmentLists(Reader[SegmentList]):
    """The segment lists of a sensor."""

    def _take(self, timeout_ms: int) -> SegmentList | None:
        pointer = self._pointer_in_time(timeout_ms)
        return SegmentList(pointer, self.stream) if pointer is not None else None

    def _silence(self) -> str:
        who = "its segmenter sends nothing" if self.writers else "nobody publishes its segments"
        return (
            f"sensor '{self.sensor}' in domain {self.stream.domain}: {who}. Start its grabber and "
            "cleave-segmenter, or see `cleave status` for what runs"
        )


def of_our_contract(status: Status) -> Status:
    """The same; WrongContract if its node speaks another one."""
    if status.contract == CONTRACT:
        return status
    raise WrongContract(
        f"the node '{status.node}' (process {status.process_id}, version {status.version}) speaks "
        f"the contract '{status.contract}', and this package speaks '{CONTRACT}': use one release "
        "for all"
    )


class Statuses(Reader[Status]):
    """The statuses of all nodes, as they come. WrongContract names a node that speaks another
    contract; the iterator may go on."""

    def _take(self, timeout_ms: int) -> Status | None:
        pointer = self._pointer_in_time(timeout_ms)
        if pointer is None:
            return None
        return of_our_contract(status_of(Sample(pointer, self.stream)))

    def _silence(self) -> str:
        return f"no node of Cleave runs in domain {self.stream.domain}: start one, or set domain="


def segments(
    sensor: str = "camera",
    *,
    timeout: float | None = None,
    domain: int | None = None,
    shared_memory: bool | None = None,
    interface: str | None = None,
) -> SegmentLists:
    """An iterator, plain or asynchronous, over the segment lists of a sensor. Options as frames()
    has them; shared memory is used only if asked for."""
    stream = join(domain, shared_memory, interface, clouds=False)
    return SegmentLists(stream, Kind.SEGMENTS, sensor, timeout)


def statuses(
    *,
    timeout: float | None = None,
    domain: int | None = None,
    shared_memory: bool | None = None,
    interface: str | None = None,
) -> Statuses:
    """An iterator, plain or asynchronous, over what all nodes tell of themselves, about once a
    second each. Options as frames() has them."""
    stream = join(domain, shared_memory, interface, clouds=False)
    return Statuses(stream, Kind.STATUS, "", timeout)


def status(
    *, wait: float = 1.5, domain: int | None = None, interface: str | None = None
) -> dict[str, Status]:
    """The last status of each node that answers within `wait` seconds, by the node's name."""
    found: dict[str, Status] = {}
    end = time.monotonic() + wait
    with statuses(domain=domain, interface=interface) as reader:
        while (left := end - time.monotonic()) > 0:
            reader.timeout = left
            try:
                status = next(reader)
            except Timeout:
                break
            found[status.node] = status
    return found
