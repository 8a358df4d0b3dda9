# SPDX-License-Identifier: BSD-3-Clause
"""From the library's structs to the types of types.py, all values copied."""

from __future__ import annotations

import ctypes
import struct
from typing import Any, Iterator

from . import _structs
from ._library import text
from .types import Border, Box, Header, Point, Pose, Quaternion, Rectangle, Segment

# As _structs.Segment and Border are laid out: unpacking all at once is ten times as quick as asking
# ctypes for each number.
_SEGMENT = struct.Struct("@H2xI3f3f3f4f3f4If")
_BORDER = struct.Struct("@HHI")
assert _SEGMENT.size == ctypes.sizeof(_structs.Segment)
assert _BORDER.size == ctypes.sizeof(_structs.Border)


def pose_of(pose: Any) -> Pose:
    p, q = pose.position, pose.orientation
    return Pose(Point(p.x, p.y, p.z), Quaternion(q.x, q.y, q.z, q.w))


def header_of(h: Any) -> Header:
    return Header(
        h.frame_id,
        h.epoch,
        h.capture_time_ns,
        h.arrival_time_ns,
        h.publication_time_ns,
        h.device_time_us,
        h.width,
        h.height,
        h.fx,
        h.fy,
        h.cx,
        h.cy,
        text(h.sensor),
        text(h.coordinate_frame),
        text(h.parent_frame),
        pose_of(h.pose),
    )


def _records(layout: struct.Struct, first: Any, count: int) -> Iterator[tuple[Any, ...]]:
    return layout.iter_unpack(ctypes.string_at(first, layout.size * count) if count else b"")


def segments_of(message: _structs.List) -> tuple[Segment, ...]:
    return tuple(
        Segment(
            v[0],
            v[1],
            Point(*v[2:5]),
            Point(*v[5:8]),
            Box(Point(*v[8:11]), Quaternion(*v[11:15]), Point(*v[15:18])),
            Rectangle(*v[18:22]),
            v[22],
        )
        for v in _records(_SEGMENT, message.segments, message.segment_count)
    )


def borders_of(message: _structs.List) -> tuple[Border, ...]:
    return tuple(
        Border(first, second, kind == 1)
        for first, second, kind in _records(_BORDER, message.borders, message.border_count)
    )


def causes_of(first: Any, count: int) -> dict[str, int]:
    return {text(first[i].cause): first[i].count for i in range(count)}
