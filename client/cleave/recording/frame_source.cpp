#include "cleave/recording/frame_source.hpp"

#include <spdlog/spdlog.h>

#include "cleave/commands/command.hpp"
#include "recording/ros/open_frames.hpp"

namespace cleave::client {
namespace {

constexpr std::string_view scheme = "mcap:";

class McapFrames : public FrameSource {
 public:
  McapFrames(const recording::FileTopic& from, const std::string& sensor)
      : input_(recording::open_frames(
            from, {recording::Kind::cloud, recording::Kind::labels, recording::Kind::segments},
            sensor)) {
    for (const std::string& remark : input_->remarks()) spdlog::warn("{}", remark);
  }

  std::optional<recording::Frame> next() override {
    auto frame = input_->next();
    const auto problems = input_->problems();
    for (; named_ < problems.size(); ++named_) spdlog::warn("{}", problems[named_]);
    return frame;
  }
  [[nodiscard]] std::size_t skipped() const override {
    std::size_t count = 0;
    for (const auto& [cause, frames] : input_->losses()) count += frames;
    return count;
  }

 private:
  std::unique_ptr<recording::FrameInput> input_;
  std::size_t named_ = 0;
};

bool is_mcap(const std::string& input) {
  return input.starts_with(scheme) || mcap_input(input).file.extension() == ".mcap";
}

}  // namespace

recording::FileTopic mcap_input(const std::string& text) {
  return recording::split_topic(text.starts_with(scheme) ? text.substr(scheme.size()) : text);
}

std::unique_ptr<FrameSource> open_mcap(const recording::FileTopic& from,
                                       const std::string& sensor) {
  return std::make_unique<McapFrames>(from, sensor);
}

bool is_recording(const std::string& input) {
  return is_mcap(input) || std::filesystem::path(input).extension() == ".oni";
}

std::unique_ptr<FrameSource> open_frame_source(const std::string& input, const std::string& sensor,
                                               std::optional<recording::Unit> unit,
                                               std::uint32_t decimation) {
  if (is_mcap(input)) return decimate(open_mcap(mcap_input(input), sensor), decimation);
  const std::filesystem::path path = input;
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error(path.string() + ": there is no such file or folder");
  }
  if (std::filesystem::is_directory(path) || path.extension() == ".pcd") {
    const std::uint64_t most = std::uint64_t{decimation} * decimation * recording::capacity_points;
    return decimate(open_pcd(path, sensor, unit, most), decimation);
  }
  if (path.extension() == ".oni") return decimate(open_oni(path, sensor), decimation);
  throw UsageError(path.string() +
                   ": cannot be converted: name a .mcap file, an .oni file, a .pcd file or a "
                   "folder of .pcd files");
}

}  // namespace cleave::client
