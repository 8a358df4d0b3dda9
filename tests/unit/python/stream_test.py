# SPDX-License-Identifier: BSD-3-Clause
"""On the stream, over loopback: no RouDi, no camera, no segmenter."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
import unittest
from typing import Callable

import cleave
import numpy as np
from support import DOMAIN, NETWORK, SENSOR, eventually, publisher


class Waiting(unittest.TestCase):
    def test_for_frames_that_do_not_come_names_sensor_domain_and_what_to_do(self) -> None:
        with cleave.frames(SENSOR, timeout=0.05, **NETWORK) as frames:
            with self.assertRaises(TimeoutError) as caught:
                next(frames)
        said = str(caught.exception)
        self.assertIsInstance(caught.exception, cleave.Timeout)
        for part in (f"'{SENSOR}'", f"domain {DOMAIN}", "nobody publishes", "cleave-segmenter"):
            self.assertIn(part, said)

    def test_for_lists_that_do_not_come_names_sensor_domain_and_what_to_do(self) -> None:
        with cleave.segments(SENSOR, timeout=0.05, **NETWORK) as lists:
            with self.assertRaisesRegex(cleave.Timeout, f"'{SENSOR}' in domain {DOMAIN}: nobody"):
                next(lists)

    def test_without_a_timeout_warns_once(self) -> None:
        with cleave.frames(SENSOR, **NETWORK) as frames:
            with self.assertLogs("cleave") as logs:
                signal.signal(signal.SIGALRM, signal.default_int_handler)
                signal.alarm(4)
                with self.assertRaises(KeyboardInterrupt):
                    next(frames)
        self.assertEqual(len(logs.output), 1)
        self.assertIn("nobody publishes", logs.output[0])

    def test_is_ended_by_ctrl_c(self) -> None:
        with cleave.segments(SENSOR, timeout=60, **NETWORK) as lists:
            threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                next(lists)

    def test_is_ended_by_close_in_another_thread(self) -> None:
        frames = cleave.frames(SENSOR, timeout=60, **NETWORK)
        threading.Timer(0.1, frames.close).start()
        with self.assertRaises(cleave.Closed):
            next(frames)

    def test_in_an_event_loop_leaves_it_to_others(self) -> None:
        async def wait() -> int:
            beats = 0

            async def beat() -> None:
                nonlocal beats
                while True:
                    beats += 1
                    await asyncio.sleep(0.001)

            other = asyncio.create_task(beat())
            with cleave.frames(SENSOR, timeout=0.1, **NETWORK) as frames:
                with self.assertRaises(cleave.Timeout):
                    async for _ in frames:
                        pass
            other.cancel()
            return beats

        self.assertGreater(asyncio.run(wait()), 3)


class Joining(unittest.TestCase):
    def test_is_once_for_all_that_a_process_opens(self) -> None:
        with cleave.frames(SENSOR, **NETWORK) as frames, cleave.segments(SENSOR) as lists:
            self.assertIs(frames.stream, lists.stream)

    def test_with_other_options_is_refused_until_all_is_gone(self) -> None:
        frames = cleave.frames(SENSOR, **NETWORK)
        with self.assertRaisesRegex(cleave.Error, "cannot join with .*domain=7"):
            cleave.segments(SENSOR, domain=7)
        del frames
        cleave.segments(SENSOR, domain=7, shared_memory=False).close()

    def test_for_frames_after_lists_says_that_clouds_are_copied(self) -> None:
        with cleave.segments(SENSOR, domain=DOMAIN):
            with self.assertLogs("cleave") as logs:
                cleave.frames(SENSOR).close()
        self.assertIn("clouds are copied over loopback", logs.output[0])

    def test_of_a_sensor_or_a_domain_that_cannot_be_is_refused(self) -> None:
        with self.assertRaisesRegex(cleave.BadArgument, "'a b'"):
            cleave.frames("a b", **NETWORK)
        with self.assertRaisesRegex(cleave.BadArgument, "domain 200"):
            cleave.frames(SENSOR, domain=200)
        with self.assertRaises(cleave.BadArgument):
            cleave.frames(SENSOR, timeout=-1, **NETWORK)

    def test_is_not_inherited_by_a_fork(self) -> None:
        with cleave.frames(SENSOR, timeout=1, **NETWORK) as frames:
            child = os.fork()
            if child == 0:
                signal.alarm(20)
                refused = 0
                uses: tuple[Callable[[], object], ...] = (
                    lambda: next(frames),
                    lambda: cleave.segments(SENSOR),
                )
                for use in uses:
                    try:
                        use()
                    except cleave.Forked:
                        refused += 1
                frames.close()
                os._exit(refused)
            _, state = os.waitpid(child, 0)
            self.assertEqual(os.waitstatus_to_exitcode(state), 2)
            with self.assertRaises(cleave.Timeout):
                next(frames)


class APublisher(unittest.TestCase):
    def test_tells_its_status(self) -> None:
        with publisher(**NETWORK) as camera:
            camera.publish_depth(np.full((2, 4), 1000, np.uint16), unit_m=0.001)
            node = f"grabber/{SENSOR}"
            self.assertTrue(eventually(lambda: node in cleave.status(wait=1.2)))

    def test_takes_depth_in_both_forms_points_and_a_loan(self) -> None:
        with publisher(**NETWORK) as camera:
            camera.publish_depth(np.ones((2, 4), np.uint16), unit_m=0.001)
            camera.publish_depth(np.ones((4, 2), np.float32).T)
            camera.publish_points(np.zeros((2, 4, 3), np.float32))
            with camera.loan() as xyz:
                xyz[...] = 1
            with self.assertRaises(ValueError):
                xyz[...] = 2

    def test_refuses_what_is_no_frame_of_its_sensor(self) -> None:
        with publisher(**NETWORK) as camera:
            with self.assertRaisesRegex(cleave.BadArgument, r"\(2, 4\), not \(4, 2\)"):
                camera.publish_depth(np.ones((4, 2), np.float32))
            with self.assertRaisesRegex(cleave.BadArgument, "uint16 without unit_m"):
                camera.publish_depth(np.ones((2, 4), np.uint16))
            with self.assertRaisesRegex(cleave.BadArgument, "float64"):
                camera.publish_points(np.ones((2, 4, 3)))

    def test_of_a_loan_whose_block_raises_publishes_nothing(self) -> None:
        with publisher(**NETWORK) as camera:
            with self.assertRaises(ZeroDivisionError):
                with camera.loan():
                    raise ZeroDivisionError
            camera.publish_points(np.zeros((2, 4, 3), np.float32))

    def test_is_refused_after_close(self) -> None:
        camera = publisher(**NETWORK)
        camera.close()
        with self.assertRaises(cleave.Closed):
            camera.publish_points(np.zeros((2, 4, 3), np.float32))


if __name__ == "__main__":
    unittest.main()
