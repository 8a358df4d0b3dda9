// SPDX-License-Identifier: BSD-3-Clause
#include "c/new_sample.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "c/errors.hpp"

namespace cleave::c {
namespace {

bool ends(const char (&name)[64]) {
  return std::ranges::find(name, '\0') != std::end(name);
}

struct HeaderOf {
  const FrameHeader* operator()(const CloudSample& cloud) const { return &cloud.header(); }
  const FrameHeader* operator()(const LabelSample& labels) const { return &labels.header(); }
  const FrameHeader* operator()(const ListSample& list) const { return &list.header(); }
  const FrameHeader* operator()(const Sample<NodeStatus>& /*status*/) const { return nullptr; }
};

}  // namespace

const FrameHeader* header_of(const AnySample& sample) {
  return std::visit(HeaderOf{}, sample);
}

std::unique_ptr<cleave_sample> new_sample(std::shared_ptr<const void> owner, AnySample sample) {
  const FrameHeader* const header = header_of(sample);
  if (header != nullptr &&
      !(ends(header->sensor) && ends(header->coordinate_frame) && ends(header->parent_frame))) {
    throw Failure(CLEAVE_BAD_DATA, "a name in the header of a sample does not end");
  }
  return std::unique_ptr<cleave_sample>(new cleave_sample{std::move(owner), std::move(sample), {}});
}

}  // namespace cleave::c
