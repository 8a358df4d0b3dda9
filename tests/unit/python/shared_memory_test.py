# SPDX-License-Identifier: BSD-3-Clause
"""Frames in place, with RouDi."""

from __future__ import annotations

import contextlib
import ctypes
import os
import pathlib
import signal
import tracemalloc
from typing import Any

import cleave
import numpy as np
import numpy.typing as npt
from daemons import WithDaemons, main_with_roudi
from support import SENSOR, eventually

WIDTH, HEIGHT = 640, 480


def shared_mapping_of(address: int) -> str:
    """The line of /proc/self/maps that holds the address."""
    for line in pathlib.Path("/proc/self/maps").read_text().splitlines():
        first, last = (int(part, 16) for part in line.split()[0].split("-"))
        if first <= address < last:
            return line
    return "nothing"


def slope() -> npt.NDArray[np.float32]:
    return np.repeat(np.linspace(2, 1, HEIGHT, dtype=np.float32)[:, None], WIDTH, axis=1)


class InSharedMemory(WithDaemons):
    shared_memory = True

    def camera(self) -> cleave.Publisher:
        return cleave.Publisher(
            SENSOR, WIDTH, HEIGHT, fx=525, fy=525, cx=319.5, cy=239.5, **self.join()
        )

    def test_arrays_lie_in_the_writers_mapping_and_nothing_large_is_copied(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
            self.assertTrue(eventually(lambda: camera.readers >= 2))
            camera.publish_depth(slope())
            next(frames).close()  # what is made once is made
            camera.publish_depth(slope())
            tracemalloc.start()
            frame = next(frames)
            arrays: list[npt.NDArray[Any]] = [frame.cloud, frame.labels]
            _, most = tracemalloc.get_traced_memory()
            tracemalloc.stop()
            self.assertLess(most, 100_000)
            self.assertTrue(frame.zero_copy)
            for array in arrays:
                last = array.ctypes.data + array.nbytes - 1
                mapping = shared_mapping_of(array.ctypes.data)
                self.assertEqual(mapping.split()[1][-1], "s", mapping)
                self.assertIn("/dev/shm/", mapping)
                self.assertEqual(shared_mapping_of(last), mapping)
            np.testing.assert_array_equal(frame.cloud[..., 2], slope())

    def test_clouds_come_in_place_without_a_segmenter(self) -> None:
        with self.camera() as camera, cleave.clouds(SENSOR, timeout=20) as clouds:
            self.assertTrue(eventually(lambda: camera.readers >= 1))
            camera.publish_depth(slope())
            cloud = next(clouds)
            self.assertTrue(cloud.zero_copy)
            np.testing.assert_array_equal(cloud.points[..., 2], slope())

    def test_a_loan_is_the_memory_that_readers_get(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
            self.assertTrue(eventually(lambda: camera.readers >= 2))
            with camera.loan(capture_time_ns=5) as xyz:
                address = xyz.ctypes.data
                xyz[...] = 1
                xyz[..., 2] = slope()
            frame = next(frames)
            self.assertEqual(frame.header.capture_time_ns, 5)
            np.testing.assert_array_equal(frame.cloud[..., 2], slope())
            # The same file, mapped by reader and writer of one process at one place.
            self.assertEqual(shared_mapping_of(address), shared_mapping_of(frame.cloud.ctypes.data))

    def test_a_fork_that_ends_leaves_its_parent_s_frames_alone(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
            self.assertTrue(eventually(lambda: camera.readers >= 2))
            camera.publish_depth(slope())
            frame = next(frames)
            child = os.fork()
            if child == 0:
                signal.alarm(20)
                del frame
                ctypes.CDLL(None).exit(0)  # with all that C++ does at the end
            _, state = os.waitpid(child, 0)
            self.assertEqual(os.waitstatus_to_exitcode(state), 0)
            np.testing.assert_array_equal(frame.cloud[..., 2], slope())
            camera.publish_depth(slope())
            self.assertTrue(next(frames).zero_copy)

    def test_a_killed_process_gives_the_chunks_of_its_views_back(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera:
            for _ in range(8):  # of a pool of 50 chunks
                holder = self.python(pathlib.Path(__file__).with_name("holder.py"), SENSOR, 8)
                self.assertTrue(eventually(lambda: camera.readers >= 2))

                def holds() -> bool:
                    with contextlib.suppress(cleave.NoMemory):  # until RouDi misses the last one
                        camera.publish_depth(slope())
                    return "holds in place" in holder.output

                self.assertTrue(eventually(holds, 60), holder.output)
                holder.end(signal.SIGKILL)
            self.assertTrue(eventually(lambda: camera.readers == 1, 30))
            for _ in range(100):
                camera.publish_depth(slope())


if __name__ == "__main__":
    main_with_roudi()
