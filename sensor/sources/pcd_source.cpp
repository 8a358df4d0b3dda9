// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/pcd_source.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

#include "libcleave/types.hpp"
#include "recording/pcd/folder.hpp"
#include "sensor/sources/unusable_text.hpp"

namespace cleave::sensor {
namespace {

constexpr char wrong_extension[] = "wrong extension";

}  // namespace

PcdSource::PcdSource(const std::filesystem::path& path, bool loop,
                     std::optional<recording::Unit> unit, std::uint64_t max_points)
    : path_(std::filesystem::absolute(path)), loop_(loop), unit_(unit), max_points_(max_points) {}

Failure PcdSource::open() {
  const recording::PcdFiles found = recording::list_pcd_files(path_);
  if (!found.failure.empty()) {
    return "cannot read point clouds from " + path_.string() + ": " + found.failure;
  }
  other_files_ = found.others.size();
  for (const auto& file : found.others) {
    spdlog::warn("skipped {}: {}: its name does not end in .pcd", file.string(), wrong_extension);
  }
  loader_ = std::make_unique<PcdLoader>(found.files, loop_, unit_, max_points_);
  if (loader_->wait_for_first()) return std::nullopt;
  const std::string skipped = text_of(counts().unusable);
  return "looked for *.pcd in " + path_.string() +
         " and found no usable point cloud: " + (skipped.empty() ? "there is no file" : skipped) +
         "; name a PCD file, or a folder of them";
}

Poll PcdSource::next(std::chrono::milliseconds timeout, Frame& frame) {
  LoadedCloud loaded{};
  switch (loader_->next(timeout, loaded)) {
    case PcdLoader::Result::timeout:
      return Poll::timeout;
    case PcdLoader::Result::end:
      return Poll::end;
    case PcdLoader::Result::item:
      break;
  }
  held_ = std::move(loaded.cloud);
  frame = {held_->width, held_->height, held_->intrinsics, wall_now_ns(), 0, loaded.begins_loop};
  return Poll::frame;
}

void PcdSource::write_points(float* xyz) {
  std::copy(held_->xyz.begin(), held_->xyz.end(), xyz);
}

SourceCounts PcdSource::counts() const {
  SourceCounts counts;
  if (loader_) counts.unusable = loader_->unusable();
  if (other_files_ > 0) counts.unusable[wrong_extension] = other_files_;
  return counts;
}

}  // namespace cleave::sensor
