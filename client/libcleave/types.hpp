// SPDX-License-Identifier: BSD-3-Clause
// The contract's types under C++ names, and what each needs to travel: domain and quality of
// service.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cleave_v1.h"
#include "idl/capacity.hpp"
#include "idl/topics.hpp"

namespace cleave {

using FrameHeader = cleave_v1_FrameHeader;
using DepthCloud = cleave_v1_DepthCloud;
using LabelMap = cleave_v1_LabelMap;
using LargeDepthCloud = cleave_v1_LargeDepthCloud;
using LargeLabelMap = cleave_v1_LargeLabelMap;
using SegmentList = cleave_v1_SegmentList;
using SegmentMessage = cleave_v1_Segment;
using BorderMessage = cleave_v1_Border;
using NodeStatus = cleave_v1_NodeStatus;

static_assert(sizeof(DepthCloud::xyz) == small_capacity_points * 3 * sizeof(float));
static_assert(sizeof(LabelMap::label) == small_capacity_points * sizeof(std::uint16_t));
static_assert(sizeof(LargeDepthCloud::xyz) == capacity_points * 3 * sizeof(float));
static_assert(sizeof(LargeLabelMap::label) == capacity_points * sizeof(std::uint16_t));

// Points that the header announces, without overflow for any header that a foreign writer may send.
inline std::uint64_t point_count(const FrameHeader& header) {
  return std::uint64_t{header.width} * header.height;
}

// The text of a fixed char array of the contract; empty if it does not end within the array.
std::string_view name_of(const char (&text)[64]);
// Writes `name` with its NUL; false, and the array untouched, if it is longer than 63 characters.
[[nodiscard]] bool set_name(char (&text)[64], std::string_view name);

// CLOCK_MONOTONIC and the wall clock as the contract's headers carry them.
std::int64_t monotonic_now_ns();
std::int64_t wall_now_ns();

}  // namespace cleave
