# SPDX-License-Identifier: BSD-3-Clause
"""What travels on the stream: clouds, label maps, segment lists and statuses."""

from __future__ import annotations

import ctypes
import functools
import os
import sys
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from . import _structs
from ._convert import borders_of, causes_of, header_of, segments_of
from ._handles import refuse_fork
from ._library import check, lib, text
from .types import Border, Header, Kind, Segment

CONTRACT = "cleave_v1"  # what this package speaks


class Sample:
    """Keeps a sample's memory; it goes back to its writer when this and the last view are gone, or
    never, where that is at the process's end."""

    # Not a Handle: there are three a frame, and a weakref.finalize is a third of what they cost.
    def __init__(self, pointer: ctypes.c_void_p, owner: object = None) -> None:
        self._process = os.getpid()
        self._pointer = pointer.value or 0
        self._owner = owner  # the stream, which others shall find while this is in use

    @property
    def pointer(self) -> int:
        """For the library's functions; raises in a fork."""
        refuse_fork(self._process)
        return self._pointer

    def __del__(self) -> None:
        # Views hold this, so none is left. A child shares the memory, but nothing of this is its
        # own; and at the end of the process the library may be gone.
        if not sys.is_finalizing() and os.getpid() == self._process:
            lib.cleave_release(self._pointer)

    @property
    def kind(self) -> Kind:
        return Kind(lib.cleave_sample_kind(self.pointer))

    @property
    def zero_copy(self) -> bool:
        """Whether its memory is the writer's own."""
        return bool(lib.cleave_sample_zero_copy(self.pointer))

    @property
    def _size(self) -> tuple[int, int]:
        """Height and width, for less than the whole header."""
        header = lib.cleave_sample_header(self.pointer).contents
        return header.height, header.width

    @functools.cached_property
    def header(self) -> Header:
        return header_of(lib.cleave_sample_header(self.pointer).contents)


class _View:
    """Memory of a sample as numpy takes it; the arrays' base, and so what keeps the sample."""

    def __init__(self, owner: object, address: int, shape: tuple[int, ...], typestr: str) -> None:
        self._owner = owner
        self.__array_interface__ = {
            "version": 3,
            "data": (address, True),  # True = read only
            "shape": shape,
            "typestr": typestr,
        }


class Cloud(Sample):
    """The points of a frame."""

    @property
    def points(self) -> npt.NDArray[np.float32]:
        """(height, width, 3) in metres, NaN = no measurement. Read-only, in place."""
        first, count = ctypes.c_void_p(), ctypes.c_size_t()
        check(lib.cleave_sample_cloud(self.pointer, ctypes.byref(first), ctypes.byref(count)))
        shape = (*self._size, 3)
        if count.value == 0:
            return np.empty(shape, np.float32)
        return np.asarray(_View(self, first.value or 0, shape, "<f4"))


class LabelMap(Sample):
    """The segment of each point of a frame."""

    @property
    def labels(self) -> npt.NDArray[np.uint16]:
        """(height, width), 0 = no segment. Read-only, in place."""
        first, count = ctypes.c_void_p(), ctypes.c_size_t()
        check(lib.cleave_sample_labels(self.pointer, ctypes.byref(first), ctypes.byref(count), None))
        shape = self._size
        if count.value == 0:
            return np.empty(shape, np.uint16)
        return np.asarray(_View(self, first.value or 0, shape, "<u2"))


class SegmentList(Sample):
    """The segments of a frame, and which of them touch. Its values are copied when first asked."""

    @functools.cached_property
    def _list(self) -> _structs.List:
        result = _structs.List()
        check(lib.cleave_sample_list(self.pointer, ctypes.byref(result)))
        return result

    @functools.cached_property
    def segments(self) -> tuple[Segment, ...]:
        """In the order of their labels 1, 2, ...: the most points first."""
        return segments_of(self._list)

    @functools.cached_property
    def borders(self) -> tuple[Border, ...]:
        return borders_of(self._list)

    @property
    def outcome(self) -> str:
        """ "segmented"; else why the frame was not."""
        return text(lib.cleave_outcome_name(self._list.outcome))

    @property
    def cloud_publication_time_ns(self) -> int:
        return int(self._list.cloud_publication_time_ns)

    @property
    def cloud_reception_time_ns(self) -> int:
        return int(self._list.cloud_reception_time_ns)

    @property
    def queue_ms(self) -> float:
        return float(self._list.queue_ms)

    @property
    def segmentation_ms(self) -> float:
        return float(self._list.segmentation_ms)


@dataclass(frozen=True, slots=True)
class Status:
    """What a node tells of itself, about once a second."""

    node: str
    version: str
    contract: str
    sensor: str
    process_id: int
    state: str  # "starting", "running", "source lost", "ended", "stopping"
    shared_memory: bool  # whether it carries clouds and label maps; else the network does
    transport_reason: str
    frames_in: int
    frames_out: int
    frames_dropped: int
    frames_rejected: int
    frames_in_flight: int
    frames_zero_copy: int
    interruptions: int
    dropped_by_cause: dict[str, int]
    rejected_by_cause: dict[str, int]
    rate_hz: float
    latency_median_ms: float
    latency_p90_ms: float
    latency_p99_ms: float
    cpu_time_s: float
    last_error: str
    sample: Sample = field(repr=False, compare=False)


def status_of(sample: Sample) -> Status:
    """Its values, copied."""
    s = _structs.Status()
    check(lib.cleave_sample_status(sample.pointer, ctypes.byref(s)))
    return Status(
        text(s.node),
        text(s.version),
        text(s.contract),
        text(s.sensor),
        s.process_id,
        text(lib.cleave_state_name(s.state)),
        s.transport == 0,
        text(s.transport_reason),
        s.frames_in,
        s.frames_out,
        s.frames_dropped,
        s.frames_rejected,
        s.frames_in_flight,
        s.frames_zero_copy,
        s.interruptions,
        causes_of(s.dropped_by_cause, s.dropped_cause_count),
        causes_of(s.rejected_by_cause, s.rejected_cause_count),
        s.rate_hz,
        s.latency_median_ms,
        s.latency_p90_ms,
        s.latency_p99_ms,
        s.cpu_time_s,
        text(s.last_error),
        sample,
    )
