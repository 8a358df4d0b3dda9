# SPDX-License-Identifier: BSD-3-Clause
"""What the tests share: a sensor and a domain of their own, and samples made by hand."""

from __future__ import annotations

import os
import struct
import time
from typing import Any, Callable

import cleave

SENSOR = f"py{os.getpid()}"
DOMAIN = 20 + os.getpid() % 60
NETWORK: dict[str, Any] = {"domain": DOMAIN, "shared_memory": False}


def publisher(width: int = 4, height: int = 2, **options: Any) -> cleave.Publisher:
    """Its principal point is pixel (1, 1)."""
    return cleave.Publisher(SENSOR, width, height, fx=2, fy=2, cx=1, cy=1, **options)


def eventually(holds: Callable[[], bool], seconds: float = 10) -> bool:
    end = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > end:
            return False
        time.sleep(0.005)
    return True


class _Cdr:
    """Plain CDR, little endian, with its encapsulation."""

    def __init__(self) -> None:
        self.bytes = bytearray()

    def add(self, form: str, *values: Any) -> None:
        for kind, value in zip(form, values, strict=True):
            size = struct.calcsize(kind)
            self.bytes += bytes(-len(self.bytes) % size) + struct.pack("<" + kind, value)

    def text(self, value: str) -> None:
        data = value.encode() + b"\0"
        self.add("I", len(data))
        self.bytes += data

    def result(self) -> bytes:
        return b"\0\1\0\0" + bytes(self.bytes)


def _header(cdr: _Cdr, width: int, height: int, frame_id: int) -> None:
    cdr.add("QIqqqQII", frame_id, 1, 10, 20, 30, 40, width, height)
    cdr.add("ffff", 2, 2, 1, 1)
    for name in ("camera", "camera_optical", "base_link"):
        cdr.bytes += name.encode().ljust(64, b"\0")
    cdr.add("fffffff", 0, 0, 1, 0, 0, 0, 1)


def cloud_cdr(width: int = 4, height: int = 2, frame_id: int = 7) -> bytes:
    """Points (0, 1, 2), (3, 4, 5), ..."""
    cdr = _Cdr()
    _header(cdr, width, height, frame_id)
    values = [float(i) for i in range(3 * width * height)]
    cdr.bytes += struct.pack(f"<{len(values)}f", *values).ljust(921600 * 4, b"\0")
    return cdr.result()


def labels_cdr(width: int = 4, height: int = 2, frame_id: int = 7) -> bytes:
    """Labels 0, 1, 2, 0, 1, 2, ..."""
    cdr = _Cdr()
    _header(cdr, width, height, frame_id)
    cdr.add("q", 5)
    values = [i % 3 for i in range(width * height)]
    cdr.bytes += struct.pack(f"<{len(values)}H", *values).ljust(307200 * 2, b"\0")
    return cdr.result()


def list_cdr(frame_id: int = 7) -> bytes:
    """Two segments, of labels 1 and 2, that touch in a convex border."""
    cdr = _Cdr()
    _header(cdr, 4, 2, frame_id)
    cdr.add("qqI", 31, 32, 0)
    cdr.add("I", 2)
    for label in (1, 2):
        cdr.add("HI", label, 300 // label)
        cdr.add("f" * 16, 1.5, 2, 3, 0, 0, -1, 4, 5, 6, 0, 0, 0, 1, 0.5, 0.25, 0.125)
        cdr.add("IIIIf", 1, 2, 3, 4, 0.75)
    cdr.add("IHHI", 1, 1, 2, 1)
    cdr.add("ff", 0.5, 1.5)
    return cdr.result()


def status_cdr(contract: str = "cleave_v1") -> bytes:
    cdr = _Cdr()
    for value in ("segmenter/camera", "0.1.0", contract, "camera"):
        cdr.text(value)
    cdr.add("III", 4711, 1, 0)
    cdr.text("RouDi answers")
    cdr.add("QQQQQQQ", 10, 7, 2, 1, 0, 7, 0)
    cdr.add("I", 1)
    cdr.text("queue full")
    cdr.add("Q", 2)
    cdr.add("I", 0)
    cdr.add("ffffd", 30, 1, 2, 3, 4.5)
    cdr.text("")
    return cdr.result()


def frame() -> cleave.Frame:
    """Of 4 x 2 points, with no stream at all."""
    return cleave.Frame(
        cleave.decode(cleave.Kind.CLOUD, cloud_cdr()),
        cleave.decode(cleave.Kind.LABELS, labels_cdr()),
        cleave.decode(cleave.Kind.SEGMENTS, list_cdr()),
    )
