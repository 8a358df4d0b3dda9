# SPDX-License-Identifier: BSD-3-Clause
"""The segmenter's frames over loopback: no RouDi."""

from __future__ import annotations

import asyncio
import tempfile
import unittest

import cleave
import numpy as np
import numpy.typing as npt
from daemons import BIN, TOP, Program, WithDaemons
from support import SENSOR, eventually

WIDTH, HEIGHT = 64, 48


def scene() -> npt.NDArray[np.uint16]:
    """A wall at 2 m and a box before it, in millimetres."""
    depth = np.full((HEIGHT, WIDTH), 2000, np.uint16)
    depth[16:32, 24:44] = 1000
    depth[0, 0] = 0
    return depth


class OverLoopback(WithDaemons):
    def camera(self) -> cleave.Publisher:
        return cleave.Publisher(
            SENSOR, WIDTH, HEIGHT, fx=60, fy=60, cx=31.5, cy=23.5, **self.join()
        )

    def test_frames_of_a_published_camera_come_whole(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
            self.assertTrue(eventually(lambda: camera.readers >= 2))
            for number in range(3):
                camera.publish_depth(scene(), unit_m=0.001, capture_time_ns=100 + number)
                frame = next(frames)
                self.assertEqual(frame.header.capture_time_ns, 100 + number)
                self.assertEqual(frame.cloud.shape, (HEIGHT, WIDTH, 3))
                self.assertTrue(np.isnan(frame.cloud[0, 0, 2]))
                np.testing.assert_allclose(frame.cloud[20, 30], [-0.025, -3.5 / 60, 1], atol=1e-6)
                for segment in frame.segments:
                    self.assertEqual(np.count_nonzero(frame.mask(segment)), segment.point_count)
                    centroid = frame.points(segment).mean(axis=0)
                    np.testing.assert_allclose(centroid, segment.centroid, atol=1e-3)
                self.assertGreaterEqual(len(frame.segments), 2)
                self.assertFalse(frame.zero_copy)

    def test_frames_and_lists_come_in_an_event_loop(self) -> None:
        self.segmenter(SENSOR)

        async def first_of(source: object) -> int:
            async for item in source:  # type: ignore[attr-defined]
                return int(item.header.frame_id)
            return -1

        async def publish(camera: cleave.Publisher) -> None:
            while True:
                camera.publish_depth(scene(), unit_m=0.001)
                await asyncio.sleep(0.05)

        async def run() -> None:
            with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
                with cleave.segments(SENSOR, timeout=20) as lists:
                    publishing = asyncio.create_task(publish(camera))
                    numbers = await asyncio.gather(first_of(frames), first_of(lists))
                    publishing.cancel()
            self.assertGreaterEqual(min(numbers), 0)

        asyncio.run(run())

    def test_many_frames_that_are_held_are_warned_of(self) -> None:
        self.segmenter(SENSOR)
        with self.camera() as camera, cleave.frames(SENSOR, timeout=20) as frames:
            self.assertTrue(eventually(lambda: camera.readers >= 2))
            held = []
            with self.assertWarnsRegex(cleave.HeldFramesWarning, "9 frames"):
                for _ in range(9):
                    camera.publish_depth(scene(), unit_m=0.001)
                    held.append(next(frames))

    def test_status_has_each_node_by_its_name(self) -> None:
        self.segmenter(SENSOR)
        nodes = cleave.status(wait=3, domain=self.join()["domain"])
        self.assertEqual(nodes[f"segmenter/{SENSOR}"].contract, "cleave_v1")
        self.assertFalse(nodes[f"segmenter/{SENSOR}"].shared_memory)


def by_frame(output: str) -> dict[str, str]:
    """The lines about each frame."""
    lines = [line for line in output.splitlines() if line.startswith("frame ")]
    return {line.split(":")[0]: line for line in lines}


class TheCommandLine(WithDaemons):
    def test_prints_what_the_example_in_cpp_prints(self) -> None:
        self.segmenter(SENSOR)
        in_python = self.python("-m", "cleave", SENSOR)
        programs = [in_python]
        example = BIN / "01_print_segments"
        if example.exists():
            programs.append(Program(self, example, SENSOR))
        grabber = self.daemon(
            "grabber", "--source", "synthetic:simple", "--sensor", SENSOR, "--frames", 90,
            "--lossless",
        )
        self.assertEqual(grabber.process.wait(120), 0, grabber.output)
        for program in programs:
            program.says("frame 89: ", 10)
            program.end(2)
        self.assertEqual(in_python.process.returncode, 0, in_python.output)
        self.assertRegex(
            in_python.output,
            r"frame \d+: \d+ segments; the second has \d+ points around "
            r"\(-?\d+\.\d\d, -?\d+\.\d\d, -?\d+\.\d\d\) m\n",
        )
        if not example.exists():
            self.skipTest(f"there is no {example} to compare with: build it")
        here, there = (by_frame(program.output) for program in programs)
        both = here.keys() & there.keys()
        self.assertGreater(len(both), 10)
        for frame in both:
            self.assertEqual(here[frame], there[frame])

    def test_ends_with_2_for_a_sensor_that_cannot_be(self) -> None:
        program = self.python("-m", "cleave", "a b")
        self.assertEqual(program.process.wait(20), 2)
        self.assertIn("'a b'", program.output)


class TheExamples(WithDaemons):
    def test_own_camera_s_frames_of_a_file_are_what_largest_object_prints(self) -> None:
        self.segmenter("camera")
        examples = TOP / "client/examples/python"
        reader = self.python(examples / "largest_object.py")
        with tempfile.NamedTemporaryFile(suffix=".npy") as file:
            np.save(file, np.repeat(scene()[None], 90, axis=0))
            file.flush()
            camera = self.python(examples / "own_camera.py", file.name)
            self.assertTrue(reader.says(" points around ("), reader.output + camera.output)
            self.assertEqual(camera.process.wait(60), 0, camera.output)


if __name__ == "__main__":
    unittest.main()
