// SPDX-License-Identifier: BSD-3-Clause
// Frames decoded ahead of need, on a thread of their own: decoding must not delay the pace.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "recording/ahead_queue.hpp"
#include "recording/frames/frame_input.hpp"
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
            std::size_t frames_ahead = default_frames_ahead);
  // The same of any input.
  ReadAhead(std::unique_ptr<FrameInput> input, bool loop,
            std::size_t frames_ahead = default_frames_ahead);
  ~ReadAhead();
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;

  using Result = AheadQueue<AheadFrame>::Result;
  // Throws FileError when the disk has failed.
  [[nodiscard]] Result next(std::chrono::milliseconds timeout, AheadFrame& frame);

  // Of the input: so far.
  [[nodiscard]] std::map<std::string, std::uint64_t> losses() const;
  // Once the end has been reported.
  [[nodiscard]] std::vector<std::string> problems() const;

 private:
  static constexpr std::size_t default_frames_ahead = 4;
  void run();
  std::size_t pass(std::uint64_t number);
  void note_losses();
  void end(const std::string& failure);

  bool loop_;
  std::unique_ptr<FrameInput> input_;  // of the thread
  AheadQueue<AheadFrame> ready_;

  mutable std::mutex mutex_;  // guards the three below
  std::string failure_;
  std::vector<std::string> problems_;
  std::map<std::string, std::uint64_t> losses_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace cleave::recording
