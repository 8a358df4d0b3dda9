# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import gc
import os
import signal
import unittest
import weakref
from typing import Any, Callable

import cleave
import numpy as np
import numpy.typing as npt
from cleave import Kind
from support import cloud_cdr, frame


class AFrame(unittest.TestCase):
    def test_has_arrays_of_the_header_s_shape(self) -> None:
        f = frame()
        self.assertEqual((f.cloud.shape, f.cloud.dtype), ((2, 4, 3), np.float32))
        self.assertEqual((f.labels.shape, f.labels.dtype), ((2, 4), np.uint16))
        np.testing.assert_array_equal(f.cloud.reshape(-1), np.arange(24))
        np.testing.assert_array_equal(f.labels, [[0, 1, 2, 0], [1, 2, 0, 1]])
        self.assertFalse(f.zero_copy)

    def test_gives_the_points_of_a_segment(self) -> None:
        f = frame()
        second = f.segments[1]
        np.testing.assert_array_equal(f.mask(second), [[0, 0, 1, 0], [0, 1, 0, 0]])
        np.testing.assert_array_equal(f.points(second), [[6, 7, 8], [15, 16, 17]])
        np.testing.assert_array_equal(f.points(2), f.points(second))

    def test_copies_no_points(self) -> None:
        f = frame()
        self.assertIs(f.cloud, f.cloud)
        self.assertFalse(f.cloud.flags.owndata)
        self.assertTrue(np.shares_memory(f.cloud[1:], f.cloud))


class AView(unittest.TestCase):
    def test_is_read_only_for_good(self) -> None:
        arrays: list[npt.NDArray[Any]] = [frame().cloud, frame().labels]
        for array in arrays:
            with self.assertRaises(ValueError):
                array[0] = 1
            with self.assertRaises(ValueError):
                array.flags.writeable = True

    def test_outlives_its_frame_and_gives_its_sample_back_in_the_end(self) -> None:
        sample = cleave.decode(Kind.CLOUD, cloud_cdr())
        alive = weakref.ref(sample)
        cloud = sample.points
        part = cloud[1, :, 2]
        del sample, cloud
        gc.collect()
        self.assertIsNotNone(alive())
        np.testing.assert_array_equal(part, [14, 17, 20, 23])
        del part
        self.assertIsNone(alive())

    def test_outlives_the_frame_s_close(self) -> None:
        f = frame()
        cloud = f.cloud
        f.close()
        np.testing.assert_array_equal(cloud.reshape(-1), np.arange(24))

    def test_is_refused_after_close(self) -> None:
        with frame() as f:
            segment = f.segments[0]
        uses: tuple[Callable[[], object], ...] = (
            lambda: f.cloud, lambda: f.labels, lambda: f.segments, lambda: f.header,
            lambda: f.mask(segment), lambda: f.points(segment), lambda: f.zero_copy,
        )
        for use in uses:
            with self.assertRaisesRegex(cleave.Closed, "frame is closed"):
                use()


class AFork(unittest.TestCase):
    def test_raises_and_leaves_the_parent_s_frame_alone(self) -> None:
        f = frame()
        child = os.fork()
        if child == 0:
            signal.alarm(20)
            try:
                f.cloud
            except cleave.Forked:
                del f
                os._exit(3)
            os._exit(4)
        _, state = os.waitpid(child, 0)
        self.assertEqual(os.waitstatus_to_exitcode(state), 3)
        self.assertEqual(f.cloud[0, 1, 0], 3)


if __name__ == "__main__":
    unittest.main()
