/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Cleave's stream in C: clouds, label maps, segment lists and statuses in, your own camera's clouds
 * out. One header, one library, -lcleave-c, for every language that can call C.
 *
 * Results. A function that can fail returns a cleave_result; where it is not CLEAVE_OK,
 * cleave_error() says in words what failed and what to do, and nothing is written through the
 * pointers to results. No exception crosses this boundary; a null pointer is CLEAVE_BAD_ARGUMENT,
 * never a crash, and what returns no result answers it with 0, null or -1.
 *
 * Threads. A stream may be used from several threads; a reader, a frames, a publisher and a sample
 * from one at a time. Samples may be released on any thread. cleave_error() is the calling
 * thread's.
 *
 * Lifetime. What was opened may be closed, and what was taken released, in any order, each once: a
 * stream that is closed lives on for its readers and publishers, a reader for its samples. A
 * sample's pointers are valid until it is released: a cloud's and a label map's point into the
 * memory of its writer, so hold few of them.
 *
 * Frames and units. Points are x right, y down, z forward in metres in the header's coordinate
 * frame; NaN = no measurement. capture_time_ns is of the wall clock (Unix epoch), all other times
 * are CLOCK_MONOTONIC. The types are those of idl/cleave_v1.idl, which says more of each field.
 */
#ifndef CLEAVE_H
#define CLEAVE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Rises when a function or a struct below changes so that a program must be compiled anew. */
#define CLEAVE_ABI_VERSION 1

#define CLEAVE_API __attribute__((visibility("default")))

typedef enum cleave_result {
  CLEAVE_OK = 0,
  CLEAVE_TIMEOUT = 1,      /* nothing came in time, or a signal's handler ran: nothing is wrong */
  CLEAVE_BAD_ARGUMENT = 2, /* a null pointer, a name or a size that cannot be */
  CLEAVE_NO_MEMORY = 3,    /* readers hold all chunks: drop the frame; or the machine has none */
  CLEAVE_BAD_DATA = 4, /* bytes that are no sample, a sample of another kind or with a lie in it */
  CLEAVE_FAILED = 5    /* DDS, RouDi or the system: see cleave_error() */
} cleave_result;

typedef enum cleave_kind {
  CLEAVE_CLOUD = 0,
  CLEAVE_LABELS = 1,
  CLEAVE_SEGMENTS = 2,
  CLEAVE_STATUS = 3
} cleave_kind;

typedef struct cleave_stream cleave_stream;
typedef struct cleave_reader cleave_reader;
typedef struct cleave_frames cleave_frames;
typedef struct cleave_sample cleave_sample;
typedef struct cleave_publisher cleave_publisher;

/* ---- the contract's types ---- */

typedef struct cleave_point {
  float x, y, z;
} cleave_point;

typedef struct cleave_quaternion {
  float x, y, z, w;
} cleave_quaternion;

/* p_parent = orientation * p + position. */
typedef struct cleave_pose {
  cleave_point position;
  cleave_quaternion orientation; /* unit length; all 0 = not known */
} cleave_pose;

typedef struct cleave_header {
  uint64_t frame_id;
  uint32_t epoch;
  int64_t capture_time_ns;
  int64_t arrival_time_ns;
  int64_t publication_time_ns;
  uint64_t device_time_us;
  uint32_t width;
  uint32_t height;      /* 1 = unorganised */
  float fx, fy, cx, cy; /* pixels; all 0 = not an image */
  char sensor[64];
  char coordinate_frame[64];
  char parent_frame[64];
  cleave_pose pose; /* of coordinate_frame in parent_frame */
} cleave_header;

/* Full edge lengths along its axes; orientation turns box axes to the sensor's frame. */
typedef struct cleave_box {
  cleave_point centre;
  cleave_quaternion orientation;
  cleave_point extent;
} cleave_box;

/* Half-open: columns [left, right), rows [top, bottom). */
typedef struct cleave_rectangle {
  uint32_t left, top, right, bottom;
} cleave_rectangle;

typedef struct cleave_segment {
  uint16_t label; /* 1 = most points */
  uint32_t point_count;
  cleave_point centroid;
  cleave_point mean_normal;
  cleave_box box;
  cleave_rectangle rectangle;
  float planarity;
} cleave_segment;

typedef struct cleave_border {
  uint16_t first, second; /* labels of two segments that touch; first < second */
  uint32_t kind;          /* 0 = concave, 1 = convex */
} cleave_border;

typedef struct cleave_list {
  const cleave_header* header;
  int64_t cloud_publication_time_ns;
  int64_t cloud_reception_time_ns;
  uint32_t outcome;               /* 0 = segmented; else why not, cleave_outcome_name() */
  const cleave_segment* segments; /* in the order of their labels 1, 2, ... */
  size_t segment_count;
  const cleave_border* borders;
  size_t border_count;
  float queue_ms;
  float segmentation_ms;
} cleave_list;

typedef struct cleave_cause {
  const char* cause;
  uint64_t count;
} cleave_cause;

typedef struct cleave_status {
  const char* node;
  const char* version;
  const char* contract;
  const char* sensor;
  uint32_t process_id;
  uint32_t state;     /* cleave_state_name() */
  uint32_t transport; /* 0 = shared memory, 1 = network */
  const char* transport_reason;
  uint64_t frames_in;
  uint64_t frames_out;
  uint64_t frames_dropped;
  uint64_t frames_rejected;
  uint64_t frames_in_flight;
  uint64_t frames_zero_copy;
  uint64_t interruptions;
  const cleave_cause* dropped_by_cause;
  size_t dropped_cause_count;
  const cleave_cause* rejected_by_cause;
  size_t rejected_cause_count;
  float rate_hz;
  float latency_median_ms;
  float latency_p90_ms;
  float latency_p99_ms;
  double cpu_time_s;
  const char* last_error;
} cleave_status;

/* ---- the library ---- */

/* Of the library at run time; compare with CLEAVE_ABI_VERSION. */
CLEAVE_API uint32_t cleave_abi_version(void);
/* "0.1.0 (contract cleave_v1)" */
CLEAVE_API const char* cleave_version(void);
/* Of the last call that failed on this thread; never null. */
CLEAVE_API const char* cleave_error(void);
/* "segmented", "bad size", ...; "unknown" */
CLEAVE_API const char* cleave_outcome_name(uint32_t outcome);
/* "starting", "running", "source lost", "ended", "stopping"; "unknown" */
CLEAVE_API const char* cleave_state_name(uint32_t state);

/* ---- joining ---- */

typedef struct cleave_options {
  int32_t domain;        /* 0 to 99; -1 = the environment's CLEAVE_DOMAIN, or 0 */
  int32_t shared_memory; /* 0 = clouds and label maps are copied over loopback */
  /* Of segment lists and statuses, by name or address; null = the environment's CLEAVE_INTERFACE,
   * or loopback. */
  const char* interface;
} cleave_options;

/* Null options: {-1, 1, NULL}. One stream a process at a time. Without RouDi it falls back to the
 * network. */
CLEAVE_API cleave_result cleave_open(const cleave_options* options, cleave_stream** stream);
CLEAVE_API void cleave_close(cleave_stream* stream);
/* Whether shared memory carries clouds and label maps, and why (or why not). */
CLEAVE_API int cleave_uses_shared_memory(const cleave_stream* stream, const char** reason);

/* ---- reading one topic ---- */

/* `sensor` is ignored for CLEAVE_STATUS. `depth`: samples kept until they are taken, at most 256,
 * beyond which the oldest is lost; 0 = the contract's. */
CLEAVE_API cleave_result cleave_reader_open(cleave_stream* stream, cleave_kind kind,
                                            const char* sensor, uint32_t depth,
                                            cleave_reader** reader);
CLEAVE_API void cleave_reader_close(cleave_reader* reader);
/* The oldest sample that waits; CLEAVE_TIMEOUT when there is none. Never blocks, never copies out
 * of shared memory. CLEAVE_BAD_DATA: a foreign writer's sample made no sense and was dropped; go
 * on. */
CLEAVE_API cleave_result cleave_take(cleave_reader* reader, cleave_sample** sample);
/* Until a sample waits; timeout_ms < 0 = for ever. */
CLEAVE_API cleave_result cleave_wait(cleave_reader* reader, int32_t timeout_ms);
/* Both in one call: the oldest sample, waited for. */
CLEAVE_API cleave_result cleave_next(cleave_reader* reader, int32_t timeout_ms,
                                     cleave_sample** sample);
/* Becomes readable when samples come: for poll() and event loops. Take until CLEAVE_TIMEOUT, which
 * makes it unreadable again. The library's to close. */
CLEAVE_API int cleave_reader_fd(const cleave_reader* reader);
/* Writers that are alive: 0 = nobody publishes. */
CLEAVE_API uint32_t cleave_reader_writers(const cleave_reader* reader);

/* ---- reading whole frames ---- */

/* Clouds, label maps and segment lists of the same frame. */
CLEAVE_API cleave_result cleave_frames_open(cleave_stream* stream, const char* sensor,
                                            cleave_frames** frames);
CLEAVE_API void cleave_frames_close(cleave_frames* frames);
/* The next frame that is complete: its three samples, each to be released; timeout_ms < 0 = wait
 * for ever. */
CLEAVE_API cleave_result cleave_frames_next(cleave_frames* frames, int32_t timeout_ms,
                                            cleave_sample** cloud, cleave_sample** labels,
                                            cleave_sample** segments);
/* Becomes readable when a frame may be complete: for poll() and event loops. Ask for the next frame
 * with timeout_ms 0 until CLEAVE_TIMEOUT, which makes it unreadable again. The library's to close.
 */
CLEAVE_API int cleave_frames_fd(const cleave_frames* frames);
/* Samples that were given up because the rest of their frame did not come. */
CLEAVE_API uint64_t cleave_frames_given_up(const cleave_frames* frames);

/* ---- samples ---- */

CLEAVE_API void cleave_release(cleave_sample* sample);
CLEAVE_API cleave_kind cleave_sample_kind(const cleave_sample* sample);
/* Whether its memory is the writer's own. */
CLEAVE_API int cleave_sample_zero_copy(const cleave_sample* sample);
/* Of a cloud, labels or segments; null for a status. */
CLEAVE_API const cleave_header* cleave_sample_header(const cleave_sample* sample);
/* x, y, z of each point, row-major; count is points, not floats. */
CLEAVE_API cleave_result cleave_sample_cloud(const cleave_sample* sample, const float** xyz,
                                             size_t* count);
/* One a point, 0 = no segment. */
CLEAVE_API cleave_result cleave_sample_labels(const cleave_sample* sample, const uint16_t** labels,
                                              size_t* count, int64_t* cloud_publication_time_ns);
CLEAVE_API cleave_result cleave_sample_list(const cleave_sample* sample, cleave_list* list);
CLEAVE_API cleave_result cleave_sample_status(const cleave_sample* sample, cleave_status* status);

/* From bytes of CDR with their 4 bytes of encapsulation, as other clients and recordings have them,
 * of either byte order; and to such bytes, little endian, which are valid until the sample is
 * released. `large`: the bytes are of LargeDepthCloud or LargeLabelMap. */
CLEAVE_API cleave_result cleave_decode(cleave_kind kind, int large, const void* bytes, size_t size,
                                       cleave_sample** sample);
CLEAVE_API cleave_result cleave_encode(cleave_sample* sample, const void** bytes, size_t* size);

/* ---- publishing your own camera ---- */

typedef struct cleave_camera {
  const char* sensor;           /* names the topics: 1 to 63 letters, digits or '_' */
  uint32_t width, height;       /* points; height 1 = unorganised; at most 1600 x 1200 in all */
  float fx, fy, cx, cy;         /* pixels; all 0 = not an image */
  const char* coordinate_frame; /* of the points; null = "<sensor>_optical" */
  const char* parent_frame;     /* null = the pose is not known, and `pose` is ignored */
  cleave_pose pose;
} cleave_camera;

/* The sensor's only publisher on this machine. It publishes the status of a grabber, too. */
CLEAVE_API cleave_result cleave_publisher_open(cleave_stream* stream, const cleave_camera* camera,
                                               cleave_publisher** publisher);
CLEAVE_API void cleave_publisher_close(cleave_publisher* publisher);
/* Each publishes one frame of width * height points, written straight into the memory that is
 * published; capture_time_ns 0 = now. CLEAVE_NO_MEMORY and CLEAVE_FAILED: the frame is dropped and
 * counted. unit_m: metres of a depth of 1; 0 = no measurement. */
CLEAVE_API cleave_result cleave_publish_depth16(cleave_publisher* publisher, const uint16_t* depth,
                                                size_t count, float unit_m,
                                                int64_t capture_time_ns);
CLEAVE_API cleave_result cleave_publish_depth32(cleave_publisher* publisher, const float* depth_m,
                                                size_t count, int64_t capture_time_ns);
/* count is points: 3 * count floats. */
CLEAVE_API cleave_result cleave_publish_points(cleave_publisher* publisher, const float* xyz,
                                               size_t count, int64_t capture_time_ns);
/* The same in two steps: fill 3 * count floats, then publish them. Another loan gives the first one
 * back. */
CLEAVE_API cleave_result cleave_loan(cleave_publisher* publisher, float** xyz, size_t* count);
CLEAVE_API cleave_result cleave_publish_loan(cleave_publisher* publisher, int64_t capture_time_ns);
CLEAVE_API uint32_t cleave_publisher_readers(const cleave_publisher* publisher);

#ifdef __cplusplus
}
#endif

#endif /* CLEAVE_H */
