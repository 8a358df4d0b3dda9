# SPDX-License-Identifier: BSD-3-Clause
"""The contract's types as Python has them.

Lengths are metres, angles radians. Points are x right, y down, z forward in the header's coordinate
frame. capture_time_ns is of the wall clock (Unix epoch), all other times are CLOCK_MONOTONIC, that
is time.monotonic_ns().
"""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import NamedTuple


class Kind(enum.IntEnum):
    """What a sample is: the topics of the contract."""

    CLOUD = 0
    LABELS = 1
    SEGMENTS = 2
    STATUS = 3


class Point(NamedTuple):
    """Metres; or a direction of unit length."""

    x: float
    y: float
    z: float


class Quaternion(NamedTuple):
    """Unit length; all 0 = not known."""

    x: float
    y: float
    z: float
    w: float


@dataclass(frozen=True, slots=True)
class Pose:
    """p_parent = orientation * p + position."""

    position: Point
    orientation: Quaternion


@dataclass(frozen=True, slots=True)
class Header:
    """Of which frame a sample is, and how the camera saw it."""

    frame_id: int
    epoch: int
    capture_time_ns: int
    arrival_time_ns: int
    publication_time_ns: int
    device_time_us: int
    width: int
    height: int  # 1 = unorganised
    fx: float  # pixels; fx, fy, cx and cy are all 0 if the frame is not an image
    fy: float
    cx: float
    cy: float
    sensor: str
    coordinate_frame: str
    parent_frame: str  # "" = the pose is not known
    pose: Pose  # of coordinate_frame in parent_frame


@dataclass(frozen=True, slots=True)
class Box:
    """Full edge lengths along its axes; orientation turns box axes to the sensor's frame."""

    centre: Point
    orientation: Quaternion
    extent: Point


@dataclass(frozen=True, slots=True)
class Rectangle:
    """Half-open: columns [left, right), rows [top, bottom)."""

    left: int
    top: int
    right: int
    bottom: int


@dataclass(frozen=True, slots=True)
class Segment:
    """A part of the scene; label 1 is the one with the most points."""

    label: int
    point_count: int
    centroid: Point
    mean_normal: Point
    box: Box
    rectangle: Rectangle
    planarity: float


@dataclass(frozen=True, slots=True)
class Border:
    """Two segments that touch, by their labels; first < second."""

    first: int
    second: int
    convex: bool
