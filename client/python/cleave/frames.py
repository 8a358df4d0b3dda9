# SPDX-License-Identifier: BSD-3-Clause
"""Whole frames: a cloud, its label map and its segment list."""

from __future__ import annotations

import ctypes
import warnings
import weakref

import numpy as np
import numpy.typing as npt

from ._handles import opened
from ._library import check, lib
from ._source import Source
from ._stream import Stream, join
from .errors import Closed, HeldFramesWarning, Timeout
from .samples import Cloud, LabelMap, Sample, SegmentList
from .types import Border, Header, Segment

_MANY = 8  # frames that a process may hold without being warned


class Frame:
    """One frame. Its arrays keep the memory that they show, also when the frame itself is gone;
    after close() the frame hands out none."""

    def __init__(self, cloud: Cloud, labels: LabelMap, segments: SegmentList) -> None:
        self._samples: tuple[Cloud, LabelMap, SegmentList] | None = (cloud, labels, segments)
        self._cloud: npt.NDArray[np.float32] | None = None
        self._labels: npt.NDArray[np.uint16] | None = None

    def _open(self) -> tuple[Cloud, LabelMap, SegmentList]:
        if self._samples is None:
            raise Closed("the frame is closed: copy what you need before close()")
        return self._samples

    @property
    def header(self) -> Header:
        """Times, size, intrinsics and pose."""
        return self._open()[2].header

    @property
    def list(self) -> SegmentList:
        """All that the segment list says."""
        return self._open()[2]

    @property
    def segments(self) -> tuple[Segment, ...]:
        """In the order of their labels 1, 2, ...: the most points first."""
        return self._open()[2].segments

    @property
    def borders(self) -> tuple[Border, ...]:
        """Which segments touch."""
        return self._open()[2].borders

    @property
    def cloud(self) -> npt.NDArray[np.float32]:
        """(height, width, 3): x right, y down, z forward in metres in header.coordinate_frame,
        NaN = no measurement. Read-only, and over shared memory where the camera's grabber wrote
        it."""
        cloud = self._open()[0]
        if self._cloud is None:
            self._cloud = cloud.points
        return self._cloud

    @property
    def labels(self) -> npt.NDArray[np.uint16]:
        """(height, width), 0 = no segment. Read-only, in place as the cloud."""
        labels = self._open()[1]
        if self._labels is None:
            self._labels = labels.labels
        return self._labels

    def mask(self, segment: Segment | int) -> npt.NDArray[np.bool_]:
        """(height, width), True for the segment's points. By the segment or its label."""
        label = segment.label if isinstance(segment, Segment) else segment
        return np.equal(self.labels, label)

    def points(self, segment: Segment | int) -> npt.NDArray[np.float32]:
        """(n, 3) in metres: the segment's points in row order, copied."""
        return self.cloud[self.mask(segment)]

    @property
    def zero_copy(self) -> bool:
        """Whether cloud and labels are the writers' own memory."""
        cloud, labels, _ = self._open()
        return cloud.zero_copy and labels.zero_copy

    def close(self) -> None:
        """Gives the frame's memory back, as soon as no array shows it any more."""
        self._samples = self._cloud = self._labels = None

    def __enter__(self) -> Frame:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class Frames(Source[Frame]):
    """The frames of a sensor, each complete, the oldest first."""

    def __init__(self, stream: Stream, sensor: str, timeout: float | None) -> None:
        self._check_timeout(timeout)
        pointer = opened(lib.cleave_frames_open, stream.pointer, sensor.encode())
        super().__init__(pointer, lib.cleave_frames_close)
        self.stream = stream
        self.sensor = sensor
        self._held: weakref.WeakSet[Sample] = weakref.WeakSet()
        self._why = "no frame came in time"

    @property
    def given_up(self) -> int:
        """Samples that were dropped because the rest of their frame did not come."""
        return int(lib.cleave_frames_given_up(self.pointer))

    def _take(self, timeout_ms: int) -> Frame | None:
        found = [ctypes.c_void_p() for _ in range(3)]
        try:
            check(lib.cleave_frames_next(self.pointer, timeout_ms, *map(ctypes.byref, found)))
        except Timeout as error:
            self._why = str(error)
            return None
        cloud = Cloud(found[0], self.stream)
        labels, segments = LabelMap(found[1], self.stream), SegmentList(found[2], self.stream)
        self._held.add(cloud)
        if len(self._held) > _MANY:
            warnings.warn(
                f"{len(self._held)} frames of '{self.sensor}' are held, and their memory is "
                "missing to all: copy what you keep (frame.cloud.copy()) and let the frames go",
                HeldFramesWarning,
                stacklevel=4,
            )
        return Frame(cloud, labels, segments)

    def _descriptor(self) -> int:
        return int(lib.cleave_frames_fd(self.pointer))

    def _silence(self) -> str:
        return (
            f"sensor '{self.sensor}' in domain {self.stream.domain}: {self._why}. Start its "
            "grabber and cleave-segmenter, or see `cleave status` for what runs"
        )


def frames(
    sensor: str = "camera",
    *,
    timeout: float | None = None,
    domain: int | None = None,
    shared_memory: bool | None = None,
    interface: str | None = None,
) -> Frames:
    """An iterator over the frames of a sensor: `for frame in cleave.frames("camera"):`, or
    `async for`.

    timeout: seconds to wait for a frame before Timeout; None = for ever, with a warning in the log
    "cleave" when none comes for 2 s. domain: 0 to 99; else the environment's CLEAVE_DOMAIN, or 0.
    shared_memory=False: clouds are copied over loopback. interface: network interface of segment
    lists, by name or address.
    """
    return Frames(join(domain, shared_memory, interface, clouds=True), sensor, timeout)
