# SPDX-License-Identifier: BSD-3-Clause
"""The structs of cleave.h, laid out as C lays them out."""

from __future__ import annotations

import ctypes
from ctypes import c_char, c_char_p, c_double, c_float, c_int32, c_int64, c_size_t
from ctypes import c_uint16, c_uint32, c_uint64


class Point(ctypes.Structure):
    _fields_ = [("x", c_float), ("y", c_float), ("z", c_float)]


class Quaternion(ctypes.Structure):
    _fields_ = [("x", c_float), ("y", c_float), ("z", c_float), ("w", c_float)]


class Pose(ctypes.Structure):
    _fields_ = [("position", Point), ("orientation", Quaternion)]


class Header(ctypes.Structure):
    _fields_ = [
        ("frame_id", c_uint64),
        ("epoch", c_uint32),
        ("capture_time_ns", c_int64),
        ("arrival_time_ns", c_int64),
        ("publication_time_ns", c_int64),
        ("device_time_us", c_uint64),
        ("width", c_uint32),
        ("height", c_uint32),
        ("fx", c_float),
        ("fy", c_float),
        ("cx", c_float),
        ("cy", c_float),
        ("sensor", c_char * 64),
        ("coordinate_frame", c_char * 64),
        ("parent_frame", c_char * 64),
        ("pose", Pose),
    ]


class Box(ctypes.Structure):
    _fields_ = [("centre", Point), ("orientation", Quaternion), ("extent", Point)]


class Rectangle(ctypes.Structure):
    _fields_ = [(edge, c_uint32) for edge in ("left", "top", "right", "bottom")]


class Segment(ctypes.Structure):
    _fields_ = [
        ("label", c_uint16),
        ("point_count", c_uint32),
        ("centroid", Point),
        ("mean_normal", Point),
        ("box", Box),
        ("rectangle", Rectangle),
        ("planarity", c_float),
    ]


class Border(ctypes.Structure):
    _fields_ = [("first", c_uint16), ("second", c_uint16), ("kind", c_uint32)]


class List(ctypes.Structure):
    _fields_ = [
        ("header", ctypes.POINTER(Header)),
        ("cloud_publication_time_ns", c_int64),
        ("cloud_reception_time_ns", c_int64),
        ("outcome", c_uint32),
        ("segments", ctypes.POINTER(Segment)),
        ("segment_count", c_size_t),
        ("borders", ctypes.POINTER(Border)),
        ("border_count", c_size_t),
        ("queue_ms", c_float),
        ("segmentation_ms", c_float),
    ]


class Cause(ctypes.Structure):
    _fields_ = [("cause", c_char_p), ("count", c_uint64)]


class Status(ctypes.Structure):
    _fields_ = [
        ("node", c_char_p),
        ("version", c_char_p),
        ("contract", c_char_p),
        ("sensor", c_char_p),
        ("process_id", c_uint32),
        ("state", c_uint32),
        ("transport", c_uint32),
        ("transport_reason", c_char_p),
        ("frames_in", c_uint64),
        ("frames_out", c_uint64),
        ("frames_dropped", c_uint64),
        ("frames_rejected", c_uint64),
        ("frames_in_flight", c_uint64),
        ("frames_zero_copy", c_uint64),
        ("interruptions", c_uint64),
        ("dropped_by_cause", ctypes.POINTER(Cause)),
        ("dropped_cause_count", c_size_t),
        ("rejected_by_cause", ctypes.POINTER(Cause)),
        ("rejected_cause_count", c_size_t),
        ("rate_hz", c_float),
        ("latency_median_ms", c_float),
        ("latency_p90_ms", c_float),
        ("latency_p99_ms", c_float),
        ("cpu_time_s", c_double),
        ("last_error", c_char_p),
    ]


class Options(ctypes.Structure):
    _fields_ = [("domain", c_int32), ("shared_memory", c_int32), ("interface", c_char_p)]


class Camera(ctypes.Structure):
    _fields_ = [
        ("sensor", c_char_p),
        ("width", c_uint32),
        ("height", c_uint32),
        ("fx", c_float),
        ("fy", c_float),
        ("cx", c_float),
        ("cy", c_float),
        ("coordinate_frame", c_char_p),
        ("parent_frame", c_char_p),
        ("pose", Pose),
    ]
