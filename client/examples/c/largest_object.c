/* SPDX-License-Identifier: BSD-3-Clause
 *
 * In C: prints the largest object of every frame, as 01_print_segments.cpp does, and the point of
 * it that is nearest to the camera, read where the camera's grabber wrote it.
 *
 *   build/release/bin/c_largest_object [SENSOR [FRAMES]] */
#include "cleave.h"
#include <stdio.h>
#include <stdlib.h>

/* Distance along z in metres; 0 if the segment has no point. */
static float nearest(const float* xyz, const uint16_t* labels, size_t count, uint16_t label) {
  float z = 0;
  for (size_t i = 0; i < count; ++i) {
    if (labels[i] == label && (z == 0 || xyz[3 * i + 2] < z)) z = xyz[3 * i + 2];
  }
  return z;
}

static void print(const cleave_sample* cloud, const cleave_sample* labels,
                  const cleave_sample* segments) {
  cleave_list list;
  const float* xyz;
  const uint16_t* label;
  size_t count;
  if (cleave_sample_list(segments, &list) != CLEAVE_OK || list.segment_count < 2) return;
  if (cleave_sample_cloud(cloud, &xyz, &count) != CLEAVE_OK) return;
  if (cleave_sample_labels(labels, &label, &count, NULL) != CLEAVE_OK) return;
  /* Labels go by size: the first is most often the table, the second the largest object. */
  const cleave_segment* object = &list.segments[1];
  printf("frame %llu: %zu segments; the second has %u points around (%.2f, %.2f, %.2f) m\n",
         (unsigned long long)list.header->frame_id, list.segment_count, object->point_count,
         (double)object->centroid.x, (double)object->centroid.y, (double)object->centroid.z);
  fprintf(stderr, "frame %llu: nearest point at %.3f m (%s)\n",
          (unsigned long long)list.header->frame_id,
          (double)nearest(xyz, label, count, object->label),
          cleave_sample_zero_copy(cloud) ? "zero copy" : "copied");
}

int main(int argc, char** argv) {
  unsigned long left = argc > 2 ? strtoul(argv[2], NULL, 10) : (unsigned long)-1;
  cleave_stream* stream = NULL;
  cleave_frames* frames = NULL;
  if (cleave_open(NULL, &stream) != CLEAVE_OK ||
      cleave_frames_open(stream, argc > 1 ? argv[1] : "camera", &frames) != CLEAVE_OK) {
    fprintf(stderr, "%s\n", cleave_error());
    return 1;
  }
  while (left > 0) {
    cleave_sample *cloud, *labels, *segments;
    const cleave_result result = cleave_frames_next(frames, 5000, &cloud, &labels, &segments);
    if (result != CLEAVE_OK) fprintf(stderr, "%s\n", cleave_error());
    if (result == CLEAVE_FAILED) break;
    if (result != CLEAVE_OK) continue;
    print(cloud, labels, segments);
    cleave_release(cloud);
    cleave_release(labels);
    cleave_release(segments);
    --left;
  }
  cleave_frames_close(frames);
  cleave_close(stream);
  return left > 0;
}
