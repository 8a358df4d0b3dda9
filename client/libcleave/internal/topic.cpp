// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/topic.hpp"

namespace cleave {

template <>
Topic topic_of<DepthCloud>(std::string_view sensor) {
  return {cloud_topic(sensor), &cleave_v1_DepthCloud_desc, Domain::bulk, 2, false};
}

template <>
Topic topic_of<LabelMap>(std::string_view sensor) {
  return {labels_topic(sensor), &cleave_v1_LabelMap_desc, Domain::bulk, 2, false};
}

template <>
Topic topic_of<LargeDepthCloud>(std::string_view sensor) {
  return {large_cloud_topic(sensor), &cleave_v1_LargeDepthCloud_desc, Domain::bulk, 2, false};
}

template <>
Topic topic_of<LargeLabelMap>(std::string_view sensor) {
  return {large_labels_topic(sensor), &cleave_v1_LargeLabelMap_desc, Domain::bulk, 2, false};
}

template <>
Topic topic_of<SegmentList>(std::string_view sensor) {
  return {segments_topic(sensor), &cleave_v1_SegmentList_desc, Domain::public_domain, 4, false};
}

template <>
Topic topic_of<NodeStatus>(std::string_view /*sensor*/) {
  return {std::string(status_topic), &cleave_v1_NodeStatus_desc, Domain::public_domain, 1, true};
}

}  // namespace cleave
