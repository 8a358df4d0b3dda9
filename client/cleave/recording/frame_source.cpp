#include "cleave/recording/frame_source.hpp"

#include <spdlog/spdlog.h>

#include "cleave/commands/command.hpp"
#include "recording/ros/open_frames.hpp"

namespace cleave::client {
namespace {

const std::set every_kind = {recording::Kind::cloud, recording::Kind::labels,
                             recording::Kind::segments};

class McapFrames : public FrameSource {
 public:
  McapFrames(const recording::FileTopic& from, const std::string& sensor)
      : input_(recording::open_frames(from, every_kind, sensor)) {}

  std::optional<recording::Frame> next() override {
    auto frame = input_->next();
    name_new(input_->problems(), named_problems_);
    name_new(input_->remarks(), named_remarks_);
    return frame;
  }
  [[nodiscard]] std::size_t skipped() const override {
    std::size_t count = 0;
    for (const auto& [cause, frames] : input_->losses()) count += frames;
    return count;
  }

 private:
  static void name_new(const std::vector<std::string>& texts, std::size_t& named) {
    for (; named < texts.size(); ++named) spdlog::warn("{}", texts[named]);
  }

  std::unique_ptr<recording::FrameInput> input_;
  std::size_t named_problems_ = 0;
  std::size_t named_remarks_ = 0;
};

}  // namespace

recording::FileTopic mcap_input(const std::string& text) {
  constexpr std::string_view scheme = "mcap:";
  return recording::split_topic(text.starts_with(scheme) ? text.substr(scheme.size()) : text);
}

std::unique_ptr<FrameSource> open_mcap(const recording::FileTopic& from,
                                       const std::string& sensor) {
  return std::make_unique<McapFrames>(from, sensor);
}

bool is_recording(const std::string& input) {
  const std::filesystem::path path = mcap_input(input).file;
  return path.extension() == ".mcap" || path.extension() == ".oni";
}

std::unique_ptr<FrameSource> open_frame_source(const std::string& input,
                                               const std::string& sensor) {
  const recording::FileTopic from = mcap_input(input);
  const std::filesystem::path& path = from.file;
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error(path.string() + ": there is no such file or folder");
  }
  if (std::filesystem::is_directory(path) || path.extension() == ".pcd") {
    return open_pcd(path, sensor);
  }
  if (path.extension() == ".mcap") return open_mcap(from, sensor);
  if (path.extension() == ".oni") return open_oni(path, sensor);
  throw UsageError(path.string() +
                   ": cannot be converted: name a .mcap file, an .oni file, a .pcd file or a "
                   "folder of .pcd files");
}

}  // namespace cleave::client
