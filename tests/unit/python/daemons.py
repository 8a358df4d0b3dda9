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
    """Tests that start daemons of their own; shared memory needs main_with_roudi()."""

    shared_memory = False

    def setUp(self) -> None:
        if not (BIN / "cleave-segmenter").exists():
            self.skipTest(f"there is no cleave-segmenter in {BIN}: build it, or set CLEAVE_BIN")
        if self.shared_memory and not os.path.exists(ROUDI):
            self.skipTest(f"there is no {ROUDI}: install iceoryx")

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


def main_with_roudi() -> None:
    """unittest.main() in a process of its own: RouDi ends all that are connected as it ends."""
    if "CLEAVE_WITH_ROUDI" in os.environ or not os.path.exists(ROUDI):
        unittest.main()
    with subprocess.Popen([ROUDI, "-m", "off", "-c", str(TOP / "config/roudi.toml")], stdout=subprocess.PIPE) as roudi:
        try:
            assert roudi.stdout is not None
            for line in roudi.stdout:
                if b"RouDi is ready" in line:
                    break
            environment = {**os.environ, "CLEAVE_WITH_ROUDI": "yes"}
            code = subprocess.run([sys.executable, *sys.argv], env=environment).returncode
        finally:
            roudi.terminate()
    sys.exit(code)
