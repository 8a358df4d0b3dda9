// Frames decoded ahead of need, on a thread of their own: decoding must not delay the pace.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "recording/frames/frame_reader.hpp"

namespace cleave::recording {

struct AheadFrame {
  Frame frame;
  std::uint64_t pass = 0;  // how often the recording has begun again
};

class ReadAhead {
 public:
  // With `loop` the selection is read over and over, as long as it holds anything. Throws what
  // FrameReader throws.
  ReadAhead(const std::filesystem::path& path, const Selection& selection, bool loop,
            std::size_t frames_ahead = 4);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  enum class Result { frame, timeout, end };
  // Throws FileError when the disk has failed.
  [[nodiscard]] Result next(std::chrono::milliseconds timeout, AheadFrame& frame);

  // What was damaged, once the end has been reported.
  [[nodiscard]] std::vector<std::string> problems() const;

 private:
  void run();
  std::size_t pass(std::uint64_t number);
  bool hand_over(AheadFrame frame);  // false: asked to stop
  void end(const std::string& failure);

  bool loop_;
  std::size_t frames_ahead_;
  FrameReader reader_;  // of the thread

  mutable std::mutex mutex_;  // guards all below but the thread
  std::condition_variable changed_;
  std::deque<AheadFrame> ready_;
  bool ended_ = false;
  bool stop_ = false;
  std::string failure_;
  std::vector<std::string> problems_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace cleave::recording
