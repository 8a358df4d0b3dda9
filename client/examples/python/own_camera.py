#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Your own camera in Python: depth images of whatever device you have, onto the stream.

client/examples/python/own_camera.py [FRAMES.npy]

FRAMES.npy: (n, height, width) uint16, millimetres, 0 = no measurement. Without it a slanted plane
stands for what the device's SDK returns.
"""

import itertools
import sys
import time
from typing import Iterator

import cleave
import numpy as np
import numpy.typing as npt


def depth_images() -> Iterator[npt.NDArray[np.uint16]]:
    """(height, width), millimetres. Your vendor's SDK goes here, for example

        pipeline.start()
        while True:
            yield np.asanyarray(pipeline.wait_for_frames().get_depth_frame().get_data())
    """
    if len(sys.argv) > 1:
        yield from np.load(sys.argv[1])
        return
    for _ in itertools.count():
        yield np.repeat(np.arange(900, 420, -1, dtype=np.uint16)[:, None], 640, axis=1)


def main() -> None:
    camera = None
    for depth in depth_images():
        if camera is None:
            height, width = depth.shape
            camera = cleave.Publisher(
                "camera",
                width,
                height,
                fx=525,  # your SDK's intrinsics, in pixels
                fy=525,
                cx=width / 2 - 0.5,
                cy=height / 2 - 0.5,
                parent_frame="base_link",  # where it is on the robot
                pose=cleave.Pose(
                    cleave.Point(0, 0, 1.2), cleave.Quaternion(-0.5, 0.5, -0.5, 0.5)
                ),
            )
        try:
            camera.publish_depth(depth, unit_m=0.001)
        except cleave.NoMemory as error:  # the frame is dropped, and counted in the status
            print(error, file=sys.stderr)
        time.sleep(1 / 30)  # your SDK waits for the next image itself


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
