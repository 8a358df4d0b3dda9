// SPDX-License-Identifier: BSD-3-Clause
// The structs of cleave.h are those of the contract, byte by byte: that is why headers, segments,
// borders and causes are handed out where they are.
#include <cstddef>

#include "c/cleave.h"
#include "libcleave/types.hpp"

namespace {

// A member of ours, by the name that both have.
#define SAME_MEMBER(ours, theirs, member)                            \
  static_assert(offsetof(ours, member) == offsetof(theirs, member)); \
  static_assert(sizeof(ours::member) == sizeof(theirs::member))
#define SAME_SIZE(ours, theirs)                  \
  static_assert(sizeof(ours) == sizeof(theirs)); \
  static_assert(alignof(ours) == alignof(theirs))

SAME_SIZE(cleave_point, cleave_v1_Point);
SAME_MEMBER(cleave_point, cleave_v1_Point, x);
SAME_MEMBER(cleave_point, cleave_v1_Point, y);
SAME_MEMBER(cleave_point, cleave_v1_Point, z);

SAME_SIZE(cleave_quaternion, cleave_v1_Quaternion);
SAME_MEMBER(cleave_quaternion, cleave_v1_Quaternion, x);
SAME_MEMBER(cleave_quaternion, cleave_v1_Quaternion, y);
SAME_MEMBER(cleave_quaternion, cleave_v1_Quaternion, z);
SAME_MEMBER(cleave_quaternion, cleave_v1_Quaternion, w);

SAME_SIZE(cleave_pose, cleave_v1_Pose3);
SAME_MEMBER(cleave_pose, cleave_v1_Pose3, position);
SAME_MEMBER(cleave_pose, cleave_v1_Pose3, orientation);

SAME_SIZE(cleave_header, cleave_v1_FrameHeader);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, frame_id);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, epoch);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, capture_time_ns);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, arrival_time_ns);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, publication_time_ns);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, device_time_us);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, width);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, height);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, fx);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, fy);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, cx);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, cy);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, sensor);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, coordinate_frame);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, parent_frame);
SAME_MEMBER(cleave_header, cleave_v1_FrameHeader, pose);

SAME_SIZE(cleave_box, cleave_v1_OrientedBox);
SAME_MEMBER(cleave_box, cleave_v1_OrientedBox, centre);
SAME_MEMBER(cleave_box, cleave_v1_OrientedBox, orientation);
SAME_MEMBER(cleave_box, cleave_v1_OrientedBox, extent);

SAME_SIZE(cleave_rectangle, cleave_v1_ImageRectangle);
SAME_MEMBER(cleave_rectangle, cleave_v1_ImageRectangle, left);
SAME_MEMBER(cleave_rectangle, cleave_v1_ImageRectangle, top);
SAME_MEMBER(cleave_rectangle, cleave_v1_ImageRectangle, right);
SAME_MEMBER(cleave_rectangle, cleave_v1_ImageRectangle, bottom);

SAME_SIZE(cleave_segment, cleave_v1_Segment);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, label);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, point_count);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, centroid);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, mean_normal);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, box);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, rectangle);
SAME_MEMBER(cleave_segment, cleave_v1_Segment, planarity);

SAME_SIZE(cleave_border, cleave_v1_Border);
SAME_MEMBER(cleave_border, cleave_v1_Border, first);
SAME_MEMBER(cleave_border, cleave_v1_Border, second);
SAME_MEMBER(cleave_border, cleave_v1_Border, kind);

SAME_SIZE(cleave_cause, cleave_v1_CauseCount);
SAME_MEMBER(cleave_cause, cleave_v1_CauseCount, cause);
SAME_MEMBER(cleave_cause, cleave_v1_CauseCount, count);

#undef SAME_SIZE
#undef SAME_MEMBER

}  // namespace
