#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import cleave

for frame in cleave.frames("camera"):
    if len(frame.segments) > 1:
        second = frame.segments[1]  # labels go by size: the first is most often the table
        print(frame.header.frame_id, second.centroid, frame.points(second)[:, 2].min())
