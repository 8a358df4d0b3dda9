#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What tests/golden/make says of a contract whose golden files are not all there."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

TOP = pathlib.Path(__file__).resolve().parents[2]


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.idl = pathlib.Path(shutil.copy(TOP / "idl/cleave_v1.idl", folder.name))
        self.golden = pathlib.Path(shutil.copytree(TOP / "idl/golden", folder.name + "/golden"))
        self.edit_idl("@final struct LargeDepthCloud", "@final @nested struct LargeDepthCloud")
        shutil.rmtree(self.golden / "LargeDepthCloud")  # 140 MB, which teach nothing more

    def make(self, *words):
        return subprocess.run([TOP / "tests/golden/make", *words, self.idl, self.golden],
                              capture_output=True, text=True, check=False)

    def edit_idl(self, old, new):
        text = self.idl.read_text()
        self.assertIn(old, text)
        self.idl.write_text(text.replace(old, new))

    def assert_refused(self, words):
        result = self.make("--check")
        self.assertEqual(result.returncode, 1)
        self.assertIn(words, result.stderr)

    def test_passes_what_is_there(self):
        result = self.make("--check")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_names_a_new_field(self):
        self.edit_idl("float rate_hz;", "float rate_hz; float temperature_c;")
        self.assert_refused("the IDL's field NodeStatus.temperature_c is missing")

    def test_names_a_new_field_of_a_nested_type(self):
        self.edit_idl("float planarity;", "float planarity; string colour;")
        self.assert_refused("the IDL's field Segment.colour is missing")

    def test_names_a_field_that_went(self):
        self.edit_idl("float planarity;", "")
        self.assert_refused("the IDL's Segment has no field planarity")

    def test_sees_that_a_field_moved_or_changed_its_type(self):
        self.edit_idl("float rate_hz;", "double rate_hz;")
        self.assert_refused("NodeStatus/typical.le.cdr is not what its JSON and the IDL say")

    def test_names_a_new_topic(self):
        self.edit_idl("enum BorderKind", "@final struct Footprint { float area_m2; };\nenum BorderKind")
        self.assert_refused("Footprint/typical.json is missing")

    def test_sees_a_changed_byte_and_a_stray_file(self):
        file = self.golden / "SegmentList/typical.be.cdr"
        file.write_bytes(file.read_bytes()[:-1] + b"\1")
        self.assert_refused("SegmentList/typical.be.cdr is not")
        shutil.copy(file, self.golden / "NodeStatus/other.cdr")
        self.assert_refused("NodeStatus/other.cdr belongs to no sample")

    def test_makes_what_is_missing(self):
        (self.golden / "NodeStatus/empty.le.cdr").unlink()
        self.assertEqual(self.make().returncode, 0)
        self.assertEqual(self.make("--check").returncode, 0)

    def test_says_where_a_value_does_not_fit(self):
        file = self.golden / "LabelMap/typical.json"
        file.write_text(file.read_text().replace("[\n    1,", "[\n    65536,"))
        self.assert_refused("LabelMap/typical.json.label: 65536 does not fit")


if __name__ == "__main__":
    unittest.main()
