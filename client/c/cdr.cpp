// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/cdr.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "c/new_sample.hpp"

namespace cleave::c {
namespace {

AnySample decoded(std::uint32_t kind, bool large, std::span<const std::byte> bytes) {
  switch (kind) {
    case CLEAVE_CLOUD:
      return CloudSample(
          large ? sample_of_cdr<LargeDepthCloud>(bytes) : sample_of_cdr<DepthCloud>(bytes), large);
    case CLEAVE_LABELS:
      return LabelSample(
          large ? sample_of_cdr<LargeLabelMap>(bytes) : sample_of_cdr<LabelMap>(bytes), large);
    case CLEAVE_SEGMENTS:
      return ListSample(Sample<SegmentList>(sample_of_cdr<SegmentList>(bytes)));
    case CLEAVE_STATUS:
      return Sample<NodeStatus>(sample_of_cdr<NodeStatus>(bytes));
    default:
      throw std::invalid_argument(std::to_string(kind) + " is no cleave_kind");
  }
}

struct Encode {
  std::vector<std::byte> operator()(const CloudSample& s) const {
    return s.large() ? cdr_of(*reinterpret_cast<const LargeDepthCloud*>(&s.header()))
                     : cdr_of(*reinterpret_cast<const DepthCloud*>(&s.header()));
  }
  std::vector<std::byte> operator()(const LabelSample& s) const {
    return s.large() ? cdr_of(*reinterpret_cast<const LargeLabelMap*>(&s.header()))
                     : cdr_of(*reinterpret_cast<const LabelMap*>(&s.header()));
  }
  std::vector<std::byte> operator()(const ListSample& s) const { return cdr_of(s.message()); }
  std::vector<std::byte> operator()(const Sample<NodeStatus>& s) const { return cdr_of(*s); }
};

}  // namespace
}  // namespace cleave::c

cleave_result cleave_decode(cleave_kind kind, int large, const void* bytes, size_t size,
                            cleave_sample** sample) {
  const auto number = static_cast<std::uint32_t>(kind);
  return cleave::c::guarded([&] {
    const std::span view(&cleave::c::given(static_cast<const std::byte*>(bytes), "bytes"), size);
    cleave_sample*& result = cleave::c::given(sample, "sample");
    result = cleave::c::new_sample(nullptr, cleave::c::decoded(number, large != 0, view)).release();
    return CLEAVE_OK;
  });
}

cleave_result cleave_encode(cleave_sample* sample, const void** bytes, size_t* size) {
  return cleave::c::guarded([&] {
    cleave_sample& handle = cleave::c::given(sample, "sample");
    const void*& first = cleave::c::given(bytes, "bytes");
    size_t& count = cleave::c::given(size, "size");
    if (handle.cdr.empty()) handle.cdr = std::visit(cleave::c::Encode{}, handle.sample);
    first = handle.cdr.data();
    count = handle.cdr.size();
    return CLEAVE_OK;
  });
}
