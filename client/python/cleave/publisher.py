# SPDX-License-Identifier: BSD-3-Clause
"""Your own camera's clouds, onto the stream."""

from __future__ import annotations

import contextlib
import ctypes
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from . import _structs
from ._handles import Handle, opened
from ._library import check, lib
from ._stream import join
from .errors import BadArgument
from .types import Pose


class Publisher(Handle):
    """Publishes the clouds of one sensor, as its grabber would; it publishes a status, too.

    width, height: points of a frame; height 1 = unorganised; at most 1600 x 1200 in all.
    fx, fy, cx, cy: pixels; all 0 = the frame is not an image, and has no depth.
    coordinate_frame: of the points; None = "<sensor>_optical". parent_frame and pose: where that
    is, p_parent = orientation * p + position; None = not known.
    """

    def __init__(
        self,
        sensor: str,
        width: int,
        height: int,
        *,
        fx: float = 0,
        fy: float = 0,
        cx: float = 0,
        cy: float = 0,
        coordinate_frame: str | None = None,
        parent_frame: str | None = None,
        pose: Pose | None = None,
        domain: int | None = None,
        shared_memory: bool | None = None,
        interface: str | None = None,
    ) -> None:
        if not (0 < width < 2**32 and 0 < height < 2**32):
            raise BadArgument(f"a frame of {width} x {height} points cannot be")
        if (parent_frame is None) != (pose is None):
            raise BadArgument("parent_frame and pose belong together: give both, or none")
        camera = _structs.Camera(sensor.encode(), width, height, fx, fy, cx, cy)
        camera.coordinate_frame = coordinate_frame.encode() if coordinate_frame else None
        camera.parent_frame = parent_frame.encode() if parent_frame else None
        if pose is not None:
            camera.pose.position = _structs.Point(*pose.position)
            camera.pose.orientation = _structs.Quaternion(*pose.orientation)
        self.stream = join(domain, shared_memory, interface, clouds=True)
        pointer = opened(lib.cleave_publisher_open, self.stream.pointer, ctypes.byref(camera))
        super().__init__(pointer, lib.cleave_publisher_close)
        self.shape = (height, width)

    @property
    def readers(self) -> int:
        """How many read the clouds."""
        return int(lib.cleave_publisher_readers(self.pointer))

    def publish_depth(
        self, depth: npt.ArrayLike, *, unit_m: float | None = None, capture_time_ns: int = 0
    ) -> None:
        """A depth image, (height, width): uint16 with `unit_m`, the metres of a depth of 1, and
        0 = no measurement; or float32 in metres, NaN or 0 = no measurement. capture_time_ns: of
        the wall clock; 0 = now. NoMemory: the frame is dropped, and counted."""
        image = np.asarray(depth)
        if image.dtype == np.uint16 and unit_m is not None:
            self._publish(lib.cleave_publish_depth16, image, self.shape, unit_m, capture_time_ns)
        elif image.dtype == np.float32 and unit_m is None:
            self._publish(lib.cleave_publish_depth32, image, self.shape, capture_time_ns)
        else:
            raise BadArgument(
                f"depth is uint16 with unit_m= or float32 (metres) without, not {image.dtype} "
                f"{'without' if unit_m is None else 'with'} unit_m="
            )

    def publish_points(self, xyz: npt.ArrayLike, *, capture_time_ns: int = 0) -> None:
        """(height, width, 3) float32 in metres, x right, y down, z forward, NaN = no
        measurement."""
        points = np.asarray(xyz)
        if points.dtype != np.float32:
            raise BadArgument(f"points are float32, not {points.dtype}")
        self._publish(lib.cleave_publish_points, points, (*self.shape, 3), capture_time_ns)

    def _publish(
        self, function: Any, array: npt.NDArray[Any], shape: tuple[int, ...], *rest: Any
    ) -> None:
        if array.shape != shape:
            raise BadArgument(f"a frame of this sensor is {shape}, not {array.shape}")
        dense = np.ascontiguousarray(array)
        with self.lock:
            check(function(self.pointer, dense.ctypes.data, shape[0] * shape[1], *rest))

    @contextlib.contextmanager
    def loan(self, *, capture_time_ns: int = 0) -> Iterator[npt.NDArray[np.float32]]:
        """`with publisher.loan() as xyz:` fill all of (height, width, 3) float32, which is
        published at the end of the block; not if the block raises. Over shared memory it is the
        memory that readers get: keep no part of it."""
        xyz = self._room()
        yield xyz
        xyz.flags.writeable = False
        if xyz.base is None:
            self.publish_points(xyz, capture_time_ns=capture_time_ns)
            return
        with self.lock:
            check(lib.cleave_publish_loan(self.pointer, capture_time_ns))

    def _room(self) -> npt.NDArray[np.float32]:
        shape = (*self.shape, 3)
        if not self.stream.transport()[0]:  # its memory would be gone with its publication
            return np.empty(shape, np.float32)
        first, count = ctypes.c_void_p(), ctypes.c_size_t()
        with self.lock:
            check(lib.cleave_loan(self.pointer, ctypes.byref(first), ctypes.byref(count)))
        floats = (ctypes.c_float * (3 * count.value)).from_address(first.value or 0)
        return np.ctypeslib.as_array(floats).reshape(shape)

    def __enter__(self) -> Publisher:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
