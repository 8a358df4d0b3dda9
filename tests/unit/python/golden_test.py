# SPDX-License-Identifier: BSD-3-Clause
"""The contract's golden files: read to their JSON, and written back to their bytes."""

from __future__ import annotations

import gzip
import json
import pathlib
import random
import unittest
from typing import Any, Iterator

import cleave
import numpy as np
from cleave import Kind

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "idl" / "golden"
KINDS = {
    "DepthCloud": Kind.CLOUD,
    "LargeDepthCloud": Kind.CLOUD,
    "LabelMap": Kind.LABELS,
    "LargeLabelMap": Kind.LABELS,
    "SegmentList": Kind.SEGMENTS,
    "NodeStatus": Kind.STATUS,
}
decode: Any = cleave.decode  # of any kind
HEADER_OF_A_CLOUD = 400  # bytes: behind it are numbers alone


def files() -> Iterator[tuple[str, str, pathlib.Path, bytes]]:
    """Type, sample, the file's path and its bytes of CDR."""
    for type_name in sorted(KINDS):
        for path in sorted((FOLDER / type_name).glob("*.cdr*")):
            data = path.read_bytes()
            yield type_name, path.name.split(".")[0], path, (
                gzip.decompress(data) if path.suffix == ".gz" else data
            )


def number(value: Any) -> float:
    """As the JSON has it: 64-bit integers, NaN and the infinities are texts."""
    return float(np.float32(value)) if isinstance(value, float) else float(value)


class GoldenFiles(unittest.TestCase):
    def same(self, value: Any, expected: Any, what: str) -> None:
        """That a value of the package is what the JSON says."""
        if isinstance(expected, dict):
            for name, member in expected.items():
                if name != "kind":  # in Python it is `convex`
                    self.same(getattr(value, name), member, f"{what}.{name}")
        elif isinstance(expected, list):
            self.assertEqual(len(value), len(expected), what)
            for i, (here, there) in enumerate(zip(value, expected)):
                self.same(here, there, f"{what}[{i}]")
        elif isinstance(value, str):
            self.assertEqual(value, expected, what)
        elif isinstance(value, int):
            self.assertEqual(value, int(expected), what)
        else:
            np.testing.assert_equal(np.float32(value), np.float32(number(expected)), what)

    def test_are_read_to_what_their_json_says(self) -> None:
        count = 0
        for type_name, sample, path, data in files():
            with self.subTest(path.name, type=type_name):
                expected = json.loads((path.parent / f"{sample}.json").read_text())
                large = type_name.startswith("Large")
                message = decode(KINDS[type_name], data, large=large)
                if type_name == "NodeStatus":
                    self.same(message.frames_in, expected["frames_in"], "frames_in")
                    for name in ("node", "version", "contract", "sensor", "last_error"):
                        self.same(getattr(message, name), expected[name], name)
                    causes = {c["cause"]: int(c["count"]) for c in expected["dropped_by_cause"]}
                    self.assertEqual(message.dropped_by_cause, causes)
                    continue
                self.same(message.header, expected["header"], "header")
                if type_name == "SegmentList":
                    self.same(message.segments, expected["segments"], "segments")
                    self.same(message.borders, expected["borders"], "borders")
                    convex = [border["kind"] == "BORDER_CONVEX" for border in expected["borders"]]
                    self.assertEqual([border.convex for border in message.borders], convex)
                elif expected["header"]["width"] * expected["header"]["height"] > 0:
                    name = "xyz" if "xyz" in expected else "label"
                    values = message.points if name == "xyz" else message.labels
                    said = np.array([number(value) for value in expected[name]], values.dtype)
                    np.testing.assert_equal(values.reshape(-1)[: said.size], said)
                count += 1
        self.assertGreater(count, 20)

    def test_are_written_back_to_their_little_endian_bytes(self) -> None:
        for type_name, sample, path, data in files():
            with self.subTest(path.name, type=type_name):
                little = path.with_name(path.name.replace(".be.", ".le.")).read_bytes()
                little = gzip.decompress(little) if path.suffix == ".gz" else little
                large = type_name.startswith("Large")
                message = decode(KINDS[type_name], data, large=large)
                self.assertTrue(cleave.encode(message) == little, sample)

    def test_damaged_a_thousand_times_are_an_error_or_a_sample(self) -> None:
        for type_name, _, path, data in files():
            if path.suffix == ".gz" and ".be." in path.name:
                continue
            dice = random.Random(7)
            large = type_name.startswith("Large")
            for _round in range(1000):
                end = dice.randrange(min(len(data), HEADER_OF_A_CLOUD))
                if path.suffix == ".gz":
                    damaged = bytearray(data[:end])
                else:
                    damaged = bytearray(data[: dice.randrange(len(data) + 1)])
                for _byte in range(min(3, len(damaged))):
                    damaged[dice.randrange(len(damaged))] = dice.randrange(256)
                try:
                    decode(KINDS[type_name], bytes(damaged), large=large)
                except cleave.BadData:
                    pass


if __name__ == "__main__":
    unittest.main()
