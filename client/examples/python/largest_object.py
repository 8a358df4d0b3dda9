#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
import cleave

for frame in cleave.segments("camera", shared_memory=False):
    if len(frame.segments) > 1:
        # Labels go by size: the first is most often the table, the second the largest object.
        count, (x, y, z) = frame.segments[1].point_count, frame.segments[1].centroid
        print(f"frame {frame.header.frame_id}: {len(frame.segments)} segments; the second has "
              f"{count} points around ({x:.2f}, {y:.2f}, {z:.2f}) m", flush=True)
