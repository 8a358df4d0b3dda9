# SPDX-License-Identifier: BSD-3-Clause
from __future__ import annotations

import random
import unittest

import cleave
from cleave import Kind
from cleave.lists import of_our_contract
from support import cloud_cdr, labels_cdr, list_cdr, status_cdr


class Decoding(unittest.TestCase):
    def test_a_list_has_its_values(self) -> None:
        message = cleave.decode(Kind.SEGMENTS, list_cdr())
        self.assertEqual(message.outcome, "segmented")
        self.assertEqual(message.cloud_publication_time_ns, 31)
        self.assertEqual(message.cloud_reception_time_ns, 32)
        self.assertEqual((message.queue_ms, message.segmentation_ms), (0.5, 1.5))
        self.assertEqual([s.label for s in message.segments], [1, 2])
        self.assertEqual(
            message.segments[1],
            cleave.Segment(
                label=2,
                point_count=150,
                centroid=cleave.Point(1.5, 2, 3),
                mean_normal=cleave.Point(0, 0, -1),
                box=cleave.Box(
                    cleave.Point(4, 5, 6),
                    cleave.Quaternion(0, 0, 0, 1),
                    cleave.Point(0.5, 0.25, 0.125),
                ),
                rectangle=cleave.Rectangle(1, 2, 3, 4),
                planarity=0.75,
            ),
        )
        self.assertEqual(message.borders, (cleave.Border(1, 2, convex=True),))

    def test_a_header_has_its_values(self) -> None:
        header = cleave.decode(Kind.SEGMENTS, list_cdr()).header
        self.assertEqual((header.frame_id, header.epoch, header.device_time_us), (7, 1, 40))
        self.assertEqual((header.capture_time_ns, header.arrival_time_ns), (10, 20))
        self.assertEqual((header.width, header.height, header.fx, header.cy), (4, 2, 2, 1))
        self.assertEqual((header.sensor, header.parent_frame), ("camera", "base_link"))
        self.assertEqual(header.pose.position, (0, 0, 1))
        self.assertEqual(header.pose.orientation, (0, 0, 0, 1))

    def test_a_status_has_its_values(self) -> None:
        status = cleave.decode(Kind.STATUS, status_cdr())
        self.assertEqual((status.node, status.state), ("segmenter/camera", "running"))
        self.assertEqual((status.frames_in, status.frames_out), (10, 7))
        self.assertEqual(status.dropped_by_cause, {"queue full": 2})
        self.assertEqual(status.rejected_by_cause, {})
        self.assertTrue(status.shared_memory)
        self.assertEqual(status.cpu_time_s, 4.5)

    def test_a_status_of_another_contract_is_refused_by_its_node_s_name(self) -> None:
        status = cleave.decode(Kind.STATUS, status_cdr(contract="cleave_v2"))
        with self.assertRaisesRegex(cleave.WrongContract, "'segmenter/camera'.*'cleave_v2'"):
            of_our_contract(status)

    def test_what_is_encoded_again_is_the_same_bytes(self) -> None:
        cases = ((Kind.CLOUD, cloud_cdr()), (Kind.LABELS, labels_cdr()),
                 (Kind.SEGMENTS, list_cdr()), (Kind.STATUS, status_cdr()))
        for kind, data in cases:
            with self.subTest(kind=kind):
                sample = cleave.decode(kind, data)  # type: ignore[call-overload]
                again = cleave.encode(sample)
                self.assertEqual(again, data)


class BadBytes(unittest.TestCase):
    def test_cut_off_anywhere_are_an_error(self) -> None:
        for kind, data in ((Kind.SEGMENTS, list_cdr()), (Kind.STATUS, status_cdr())):
            for size in range(len(data) - 3):  # the last bytes may be padding
                with self.assertRaises(cleave.BadData):
                    cleave.decode(kind, data[:size])  # type: ignore[call-overload]

    def test_a_thousand_mutations_are_a_sample_or_an_error(self) -> None:
        chance = random.Random(11)
        for kind, data in ((Kind.SEGMENTS, list_cdr()), (Kind.STATUS, status_cdr())):
            refused = 0
            for _ in range(1000):
                mutated = bytearray(data)
                for _ in range(chance.randint(1, 8)):
                    mutated[chance.randrange(len(mutated))] = chance.choice((0, 1, 127, 255))
                try:
                    sample = cleave.decode(kind, bytes(mutated))  # type: ignore[call-overload]
                    repr(sample)
                    if kind == Kind.SEGMENTS:
                        repr((sample.header, sample.segments, sample.borders, sample.outcome))
                    cleave.encode(sample)
                except cleave.BadData:
                    refused += 1
            self.assertGreater(refused, 0)

    def test_that_are_of_another_kind_are_an_error(self) -> None:
        with self.assertRaises(cleave.BadData):
            cleave.decode(Kind.CLOUD, list_cdr())
        with self.assertRaises(cleave.BadArgument):
            cleave.decode(9, list_cdr())  # type: ignore[call-overload]


if __name__ == "__main__":
    unittest.main()
