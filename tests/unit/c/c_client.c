/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A client and a camera in C11, over the network path: no RouDi, no camera. It ends with 0 if all
 * is as it should be, and else says what is not. */
#define _POSIX_C_SOURCE 200809L

#include "cleave.h"
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static void require(int holds, const char* what) {
  if (holds) return;
  fprintf(stderr, "c_client: %s; last error: %s\n", what, cleave_error());
  exit(1);
}

static void wait_for_a_reader(const cleave_publisher* publisher) {
  const struct timespec pause = {0, 5 * 1000 * 1000};
  for (int i = 0; i < 2000 && cleave_publisher_readers(publisher) == 0; ++i) {
    nanosleep(&pause, NULL);
  }
  require(cleave_publisher_readers(publisher) > 0, "no reader found the publisher within 10 s");
}

static cleave_sample* poll_and_take(cleave_reader* reader) {
  cleave_sample* sample = NULL;
  struct pollfd ready = {cleave_reader_fd(reader), POLLIN, 0};
  for (;;) {
    const cleave_result result = cleave_take(reader, &sample);
    if (result == CLEAVE_OK) return sample;
    require(result == CLEAVE_TIMEOUT, "a cloud could not be taken");
    require(poll(&ready, 1, 10 * 1000) == 1, "no cloud came within 10 s");
  }
}

static void check(const cleave_sample* sample) {
  const float* xyz = NULL;
  size_t count = 0;
  const cleave_header* header = cleave_sample_header(sample);
  require(cleave_sample_cloud(sample, &xyz, &count) == CLEAVE_OK, "a cloud has no points");
  require(count == 8 && xyz[2] == 1.0F && xyz[14] != xyz[14], "a cloud's points are wrong");
  require(header->capture_time_ns == 77 && strcmp(header->parent_frame, "base_link") == 0,
          "a cloud's header is wrong");
}

int main(void) {
  char sensor[64];
  snprintf(sensor, sizeof sensor, "c%ld", (long)getpid());
  const cleave_options options = {20 + (int32_t)(getpid() % 60), 0, NULL};
  const cleave_camera camera = {.sensor = sensor,
                                .width = 4,
                                .height = 2,
                                .fx = 2,
                                .fy = 2,
                                .cx = 1,
                                .cy = 1,
                                .parent_frame = "base_link",
                                .pose = {{1, 2, 3}, {0, 0, 0, 1}}};
  const uint16_t depth_mm[8] = {1000, 1000, 1000, 1000, 0, 2000, 2000, 2000};
  cleave_stream* stream = NULL;
  cleave_reader* reader = NULL;
  cleave_publisher* publisher = NULL;

  require(cleave_abi_version() == CLEAVE_ABI_VERSION, "the library is of another version");
  require(cleave_open(&options, &stream) == CLEAVE_OK, "the stream cannot be joined");
  require(cleave_reader_open(stream, CLEAVE_CLOUD, sensor, 0, &reader) == CLEAVE_OK, "no reader");
  require(cleave_publisher_open(stream, &camera, &publisher) == CLEAVE_OK, "no publisher");
  require(cleave_wait(reader, 0) == CLEAVE_TIMEOUT, "a cloud came out of nothing");
  wait_for_a_reader(publisher);

  require(cleave_publish_depth16(publisher, depth_mm, 8, 0.001F, 77) == CLEAVE_OK, "not published");
  cleave_sample* sample = poll_and_take(reader);
  check(sample);
  require(cleave_publish_depth16(publisher, depth_mm, 7, 0.001F, 77) == CLEAVE_BAD_ARGUMENT,
          "a frame of a wrong size was published");
  require(strstr(cleave_error(), "4 x 2") != NULL, "a wrong size is refused without its words");

  cleave_publisher_close(publisher);
  cleave_close(stream);
  cleave_reader_close(reader);
  check(sample);
  cleave_release(sample);
  printf("%s: a cloud came through\n", cleave_version());
  return 0;
}
