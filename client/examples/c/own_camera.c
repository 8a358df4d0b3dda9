/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Your own camera in C: depth images of whatever device you have, onto the stream. Here a slanted
 * plane stands for what the device's SDK returns.
 *
 *   build/release/bin/c_own_camera [FRAMES] */
#define _POSIX_C_SOURCE 200809L

#include "cleave.h"
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { width = 640, height = 480 };

/* Your SDK's: a depth image in millimetres, 0 = no measurement. */
static const uint16_t* wait_for_depth(void) {
  static uint16_t depth[width * height];
  const struct timespec pause = {0, 33 * 1000 * 1000};
  nanosleep(&pause, NULL);
  for (int i = 0; i < width * height; ++i) depth[i] = (uint16_t)(900 - i / width);
  return depth;
}

int main(int argc, char** argv) {
  unsigned long left = argc > 1 ? strtoul(argv[1], NULL, 10) : (unsigned long)-1;
  const cleave_camera camera = {.sensor = "camera",
                                .width = width,
                                .height = height,
                                .fx = 525,
                                .fy = 525,
                                .cx = 319.5F,
                                .cy = 239.5F,
                                .parent_frame = "base_link", /* where it is on the robot */
                                .pose = {{0, 0, 1.2F}, {-.5F, .5F, -.5F, .5F}}};
  cleave_stream* stream = NULL;
  cleave_publisher* publisher = NULL;
  if (cleave_open(NULL, &stream) != CLEAVE_OK ||
      cleave_publisher_open(stream, &camera, &publisher) != CLEAVE_OK) {
    fprintf(stderr, "%s\n", cleave_error());
    return 1;
  }
  for (; left > 0; --left) {
    const cleave_result result =
        cleave_publish_depth16(publisher, wait_for_depth(), width * height, 0.001F, 0);
    if (result != CLEAVE_OK) fprintf(stderr, "%s\n", cleave_error());
  }
  cleave_publisher_close(publisher);
  cleave_close(stream);
  return 0;
}
