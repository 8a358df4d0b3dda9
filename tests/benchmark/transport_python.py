#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A reader of clouds in Python: see transport.hpp. Usage: read CLOUDS; started by
benchmark_transport."""

from __future__ import annotations

import sys
import time

import cleave

SILENCE_S = 10  # a reader that has had no cloud for so long has lost the rest

clouds = cleave.clouds("benchmark", timeout=SILENCE_S)
try:
    for _ in range(int(sys.argv[2])):
        cloud = next(clouds)
        points = cloud.points
        print(time.monotonic_ns() - cloud.header.publication_time_ns)
        del points, cloud
except cleave.Timeout:
    pass  # benchmark_transport counts what is missing
