// SPDX-License-Identifier: BSD-3-Clause
// Another source's images with fewer points.
#include <utility>

#include "recording/cloud/decimate.hpp"
#include "recording/sources/frame_source.hpp"

namespace cleave::recording {
namespace {

class DecimatedFrames : public FrameSource {
 public:
  DecimatedFrames(std::unique_ptr<FrameSource> source, std::uint32_t factor)
      : source_(std::move(source)), decimator_(factor) {}

  // Labels and segments of the whole image do not fit the smaller one: they are passed over.
  std::optional<Frame> next() override {
    while (auto frame = source_->next()) {
      auto* const cloud = std::get_if<Cloud>(&frame->content);
      if (cloud == nullptr) continue;
      if (cloud->header.height > 1) decimate(*cloud);
      return frame;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t skipped() const override { return source_->skipped(); }

 private:
  void decimate(Cloud& cloud) {
    FrameHeader& h = cloud.header;
    const Intrinsics whole = {h.fx, h.fy, h.cx, h.cy};
    const Intrinsics smaller = decimator_.intrinsics(whole);
    const std::uint32_t width = decimator_.width(h.width);
    const std::uint32_t height = decimator_.height(h.height);
    std::vector<float> xyz(3 * std::size_t{width} * height);
    decimator_.decimate(cloud.xyz.data(), h.width, h.height, whole, xyz.data());
    cloud.xyz = std::move(xyz);
    h.width = width;
    h.height = height;
    h.fx = smaller.fx;
    h.fy = smaller.fy;
    h.cx = smaller.cx;
    h.cy = smaller.cy;
  }

  std::unique_ptr<FrameSource> source_;
  Decimator decimator_;
};

}  // namespace

std::unique_ptr<FrameSource> decimate(std::unique_ptr<FrameSource> source, std::uint32_t factor) {
  if (factor == 1) return source;
  return std::make_unique<DecimatedFrames>(std::move(source), factor);
}

}  // namespace cleave::recording
