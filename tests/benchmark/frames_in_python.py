#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What whole frames (lists, clouds and labels) cost a client in Python, beside a running demo.

PYTHONPATH=client/python /usr/bin/python3 tests/benchmark/frames_in_python.py [FRAMES]
"""

from __future__ import annotations

import statistics
import sys
import time

import cleave

count = int(sys.argv[1]) if len(sys.argv) > 1 else 600
latencies_ms = []
frames = cleave.frames("camera", timeout=20)
next(frames)
start, start_cpu = time.monotonic(), time.process_time()
for _ in range(count):
    frame = next(frames)
    in_hand = (frame.cloud.shape, frame.labels.shape, frame.segments)  # noqa: F841 as a client asks
    latencies_ms.append((time.monotonic_ns() - frame.header.publication_time_ns) * 1e-6)
seconds = time.monotonic() - start
latencies_ms.sort()
print(
    f"{count / seconds:.1f} frames/s, {(time.process_time() - start_cpu) / seconds:.3f} of a core, "
    f"zero copy {frame.zero_copy}; from the list's publication to the whole frame in hand, ms: "
    f"median {statistics.median(latencies_ms):.1f}, 99 % {latencies_ms[count * 99 // 100]:.1f}"
)
