# SPDX-License-Identifier: BSD-3-Clause
"""A client that holds frames until it is killed: holder.py SENSOR COUNT."""

import sys
import time

import cleave

held = []
for frame in cleave.frames(sys.argv[1]):
    held.append(frame.cloud)
    if len(held) == int(sys.argv[2]):
        print("holds", "in place" if frame.zero_copy else "copies", flush=True)
        time.sleep(600)
