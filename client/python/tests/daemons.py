# SPDX-License-Identifier: BSD-3-Clause
"""RouDi, cleave-segmenter, cleave-grabber and programs in Python, as the tests start them."""

from __future__ import annotations

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from typing import Any

from support import DOMAIN

TOP = pathlib.Path(__file__).resolve().parents[3]
BIN = pathlib.Path(os.environ.get("CLEAVE_BIN", TOP / "build/release/bin"))
ROUDI = "/usr/bin/iox-roudi"


class Program:
    """A process with its output in a file, which ends with the test."""

    def __init__(self, test: unittest.TestCase, *command: object) -> None:
        self.output_file = tempfile.NamedTemporaryFile(mode="r", suffix=".log")
        environment = {**os.environ, "CLEAVE_DOMAIN": str(DOMAIN), "PYTHONUNBUFFERED": "1"}
        environment["PYTHONPATH"] = str(TOP / "client/python")
        with open(self.output_file.name, "w") as output:
            self.process = subprocess.Popen(
                [str(word) for word in command], stdout=output, stderr=output, env=environment
            )
        test.addCleanup(self.end)

    @property
    def output(self) -> str:
        return pathlib.Path(self.output_file.name).read_text()

    def says(self, text: str, seconds: float = 60) -> bool:
        end = time.monotonic() + seconds
        while text not in self.output:
            if time.monotonic() > end or self.process.poll() is not None:
                return text in self.output
            time.sleep(0.01)
        return True

    def end(self, number: int = signal.SIGTERM) -> int:
        if self.process.poll() is None:
            self.process.send_signal(number)
        try:
            return self.process.wait(30)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()


class WithDaemons(unittest.TestCase):
    """A segmenter and, over shared memory, RouDi."""

    shared_memory = False

    def setUp(self) -> None:
        if not (BIN / "cleave-segmenter").exists():
            self.skipTest(f"there is no cleave-segmenter in {BIN}: build it, or set CLEAVE_BIN")
        if self.shared_memory:
            if not os.path.exists(ROUDI):
                self.skipTest(f"there is no {ROUDI}: install iceoryx")
            roudi = Program(self, ROUDI, "-c", TOP / "config/roudi.toml")
            self.assertTrue(roudi.says("RouDi is ready"), roudi.output)

    def daemon(self, name: str, *options: object) -> Program:
        network = () if self.shared_memory else ("--no-shared-memory",)
        file = TOP / "config" / f"{name}.yaml"
        return Program(self, BIN / f"cleave-{name}", "--config", file, *network, *options)

    def segmenter(self, sensor: str, *options: object) -> Program:
        program = self.daemon("segmenter", "--sensor", sensor, *options)
        self.assertTrue(program.says(f"segmenting sensor '{sensor}'"), program.output)
        return program

    def python(self, *words: object) -> Program:
        return Program(self, sys.executable, *words)

    def join(self) -> dict[str, Any]:
        return {"domain": DOMAIN, "shared_memory": self.shared_memory}
