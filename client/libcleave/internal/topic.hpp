// SPDX-License-Identifier: BSD-3-Clause
// Which topic, domain and quality of service a type of the contract has. The table of the design.
#pragma once

#include <string>
#include <string_view>

#include "libcleave/types.hpp"

namespace cleave {

// Bulk: what travels in shared memory. Public: what any DDS client reads (`public` is a word of
// C++).
enum class Domain { bulk, public_domain };

struct Topic {
  std::string name;
  const dds_topic_descriptor_t* descriptor;
  Domain domain;
  int history_depth;     // KEEP_LAST
  bool transient_local;  // late joiners get the last sample of each instance
};

// Every topic is reliable with a blocking time of 50 ms and a liveliness lease of 1 s; none has a
// deadline, because a finite one switches shared memory off.
template <class T>
Topic topic_of(std::string_view sensor);
template <>
Topic topic_of<DepthCloud>(std::string_view sensor);
template <>
Topic topic_of<LabelMap>(std::string_view sensor);
template <>
Topic topic_of<LargeDepthCloud>(std::string_view sensor);
template <>
Topic topic_of<LargeLabelMap>(std::string_view sensor);
template <>
Topic topic_of<SegmentList>(std::string_view sensor);
template <>
Topic topic_of<NodeStatus>(std::string_view sensor);

}  // namespace cleave
