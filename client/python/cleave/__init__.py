# SPDX-License-Identifier: BSD-3-Clause
"""Cleave's stream in Python: what a depth camera sees, in geometric segments.

    import cleave
    for frame in cleave.frames("camera"):
        largest = frame.segments[0]
        print(largest.centroid, frame.points(largest).mean(axis=0))

A process is on the stream once: all that is opened shares it, and options that are given a second
time must agree. An iterator, a publisher and a frame may be used from any thread.
"""

from __future__ import annotations

from ._library import lib as _lib
from .clouds import Clouds, clouds
from .codec import decode, encode
from .errors import (
    BadArgument,
    BadData,
    Closed,
    Error,
    Forked,
    HeldFramesWarning,
    NoMemory,
    Timeout,
    WrongContract,
)
from .frames import Frame, Frames, frames
from .lists import SegmentLists, Statuses, segments, status, statuses
from .publisher import Publisher
from .samples import Cloud, LabelMap, SegmentList, Status
from .types import Border, Box, Header, Kind, Point, Pose, Quaternion, Rectangle, Segment

__version__: str = _lib.cleave_version().decode()  # "0.1.0 (contract cleave_v1, C ABI 1)"

__all__ = [
    "BadArgument",
    "BadData",
    "Border",
    "Box",
    "Closed",
    "Cloud",
    "Clouds",
    "Error",
    "Forked",
    "Frame",
    "Frames",
    "Header",
    "HeldFramesWarning",
    "Kind",
    "LabelMap",
    "NoMemory",
    "Point",
    "Pose",
    "Publisher",
    "Quaternion",
    "Rectangle",
    "Segment",
    "SegmentList",
    "SegmentLists",
    "Status",
    "Statuses",
    "Timeout",
    "WrongContract",
    "clouds",
    "decode",
    "encode",
    "frames",
    "segments",
    "status",
    "statuses",
]
