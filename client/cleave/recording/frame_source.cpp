#include "cleave/recording/frame_source.hpp"

#include <spdlog/spdlog.h>

#include "cleave/commands/command.hpp"
#include "recording/frames/frame_reader.hpp"

namespace cleave::client {
namespace {

class McapFrames : public FrameSource {
 public:
  explicit McapFrames(const std::filesystem::path& path) : reader_(path) {}

  std::optional<recording::Frame> next() override {
    auto frame = reader_.next();
    const auto problems = reader_.problems();
    for (; named_ < problems.size(); ++named_) spdlog::warn("{}", problems[named_]);
    return frame;
  }
  [[nodiscard]] std::size_t skipped() const override { return named_; }

 private:
  recording::FrameReader reader_;
  std::size_t named_ = 0;
};

}  // namespace

std::unique_ptr<FrameSource> open_mcap(const std::filesystem::path& path) {
  return std::make_unique<McapFrames>(path);
}

std::unique_ptr<FrameSource> open_frame_source(const std::filesystem::path& path,
                                               const std::string& sensor,
                                               std::optional<recording::Unit> unit) {
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error(path.string() + ": there is no such file or folder");
  }
  if (std::filesystem::is_directory(path) || path.extension() == ".pcd") {
    return open_pcd(path, sensor, unit);
  }
  if (path.extension() == ".mcap") return open_mcap(path);
  if (path.extension() == ".oni") return open_oni(path, sensor);
  throw UsageError(path.string() +
                   ": cannot be converted: name a .mcap file, an .oni file, a .pcd file or a "
                   "folder of .pcd files");
}

}  // namespace cleave::client
