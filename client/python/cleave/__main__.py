# SPDX-License-Identifier: BSD-3-Clause
"""python3 -m cleave [SENSOR]: prints the largest object of every frame, as the example
client/examples/01_print_segments.cpp does. Needs no shared memory."""

from __future__ import annotations

import argparse
import logging
import sys

import cleave


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python3 -m cleave", description="Prints the largest object of every frame."
    )
    parser.add_argument("sensor", nargs="?", default="camera", metavar="SENSOR")
    sensor = parser.parse_args().sensor
    logging.basicConfig(format="cleave: %(message)s")
    try:
        for frame in cleave.segments(sensor, shared_memory=False):
            if len(frame.segments) < 2:
                continue
            # Labels go by size: the first is most often the table, the second the largest object.
            second = frame.segments[1]
            x, y, z = second.centroid
            print(
                f"frame {frame.header.frame_id}: {len(frame.segments)} segments; the second has "
                f"{second.point_count} points around ({x:.2f}, {y:.2f}, {z:.2f}) m",
                flush=True,
            )
    except KeyboardInterrupt:
        return 0
    except BrokenPipeError:  # whoever read this has read enough
        sys.stderr.close()
        return 0
    except cleave.Error as error:
        print(f"cleave: {error}", file=sys.stderr)
        return 2 if isinstance(error, cleave.BadArgument) else 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
