# SPDX-License-Identifier: BSD-3-Clause
"""Which library is loaded, and what is said if none is: each in a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
import unittest


def import_with(library: str) -> str:
    """What the import says on stderr."""
    environment = {**os.environ, "CLEAVE_LIBRARY": library}
    command = [sys.executable, "-c", "import cleave"]
    return subprocess.run(command, env=environment, capture_output=True, text=True).stderr


class Import(unittest.TestCase):
    def test_without_a_library_says_where_it_looked_and_what_to_do(self) -> None:
        said = import_with("/nowhere/libcleave-c.so.1")
        self.assertIn("ImportError", said)
        self.assertIn("/nowhere/libcleave-c.so.1: cannot open", said.replace("\n", " "))
        self.assertIn("--target cleave-c", said)

    def test_of_another_library_names_it(self) -> None:
        said = import_with("libm.so.6")
        self.assertIn("ImportError: cleave: libm.so.6 is no libcleave-c", said)

    def test_of_another_version_names_both(self) -> None:
        fake = os.environ.get("CLEAVE_OTHER_VERSION")
        if fake is None:
            self.skipTest("CLEAVE_OTHER_VERSION names no library of another version")
        said = import_with(fake)
        self.assertRegex(said, "C interface's version 999.* for version 1")


if __name__ == "__main__":
    unittest.main()
