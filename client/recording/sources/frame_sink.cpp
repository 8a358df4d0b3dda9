// SPDX-License-Identifier: BSD-3-Clause
#include "recording/sources/frame_sink.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <deque>
#include <span>
#include <stdexcept>
#include <utility>

#include "idl/frame_key.hpp"
#include "recording/frames/frame_writer.hpp"
#include "recording/pcd/writer.hpp"

namespace cleave::recording {
namespace {

namespace fs = std::filesystem;

class McapSink : public FrameSink {
 public:
  explicit McapSink(const fs::path& path) : writer_(path) {}
  void write(Frame frame) override { writer_.write(frame); }
  void add_attachment(const Attachment& attachment, ByteView content) override {
    writer_.add_attachment(attachment, content);
  }
  void add_metadata(const Metadata& metadata) override { writer_.add_metadata(metadata); }
  void close() override { writer_.close(); }

 private:
  FrameWriter writer_;
};

// A label map comes after its cloud: clouds wait for theirs.
class PcdSink : public FrameSink {
 public:
  explicit PcdSink(fs::path folder) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
  }

  void write(Frame frame) override {
    if (auto* const cloud = std::get_if<Cloud>(&frame.content)) {
      waiting_.push_back(std::move(*cloud));
      if (waiting_.size() > longest_wait) write_first({});
    } else if (const auto* const labels = std::get_if<Labels>(&frame.content)) {
      add(*labels);
    }
  }
  void close() override {
    while (!waiting_.empty()) write_first({});
  }

 private:
  static constexpr std::size_t longest_wait = 16;

  void add(const Labels& labels) {
    const auto belongs = [&](const Cloud& cloud) {
      return cloud.header.sensor == labels.header.sensor &&
             key_of(cloud.header) == key_of(labels.header) &&
             cloud.header.points() == labels.label.size();
    };
    if (std::ranges::none_of(waiting_, belongs)) return;
    while (!belongs(waiting_.front())) write_first({});
    write_first(labels.label);
  }

  void write_first(std::span<const std::uint16_t> labels) {
    const Cloud& cloud = waiting_.front();
    auto pcd = PcdCloud::of_points(cloud.xyz, cloud.header.width, cloud.header.height);
    if (!labels.empty()) pcd.set_labels(labels);
    write_pcd(folder_ / fmt::format("frame_{:06}.pcd", ++written_), pcd);
    waiting_.pop_front();
  }

  fs::path folder_;
  std::deque<Cloud> waiting_;
  std::size_t written_ = 0;
};

}  // namespace

void refuse_existing(const fs::path& path) {
  if (!fs::exists(path)) return;
  throw std::runtime_error(path.string() +
                           ": exists already, and is not replaced; remove it or name another");
}

void refuse_without_folder(const fs::path& path) {
  const fs::path folder = fs::absolute(path).parent_path();
  if (fs::is_directory(folder)) return;
  throw std::runtime_error(path.string() + ": cannot be written, for " + folder.string() +
                           " is no folder; make it first (mkdir -p)");
}

std::unique_ptr<FrameSink> open_frame_sink(const fs::path& path) {
  refuse_existing(path);
  if (path.extension() == ".mcap") return std::make_unique<McapSink>(path);
  return std::make_unique<PcdSink>(path);
}

}  // namespace cleave::recording
