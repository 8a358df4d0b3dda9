// SPDX-License-Identifier: BSD-3-Clause
// Reads point clouds one ahead, on a thread of its own, so that decoding does not delay the pace.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "recording/ahead_queue.hpp"
#include "recording/pcd/origin_remark.hpp"
#include "recording/pcd/stream_cloud.hpp"
#include "recording/units/unit.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

using recording::StreamCloud;

struct LoadedCloud {
  std::shared_ptr<const StreamCloud> cloud;
  bool begins_loop;  // the first one of a second or later pass
};

class PcdLoader {
 public:
  // `unit`: of the files, which are scaled to metres; without one, those that seem to be in
  // millimetres are unusable. Unusable files are named in the log with the reason, counted, and not
  // tried again. With `loop` the files are read over and over, as long as one is usable; as many as
  // fit into `cache_bytes` stay decoded in memory. A cloud that is relative to an origin is named
  // in the log, the first one.
  PcdLoader(std::vector<std::filesystem::path> files, bool loop,
            std::optional<recording::Unit> unit = {}, std::uint64_t max_points = capacity_points,
            std::size_t cache_bytes = std::size_t{512} << 20U);
  ~PcdLoader();
  PcdLoader(const PcdLoader&) = delete;
  PcdLoader& operator=(const PcdLoader&) = delete;

  using Result = recording::AheadQueue<LoadedCloud>::Result;
  [[nodiscard]] Result next(std::chrono::milliseconds timeout, LoadedCloud& loaded) {
    return ready_.take(timeout, loaded);
  }
  // Waits until the first cloud is there; false if no file is usable.
  [[nodiscard]] bool wait_for_first() { return ready_.wait_for_one(); }
  [[nodiscard]] std::map<std::string, std::uint64_t> unusable() const;

 private:
  struct File {
    std::filesystem::path path;
    std::shared_ptr<const StreamCloud> cached;
  };
  void run();
  std::size_t pass(bool is_first);  // clouds handed over
  std::shared_ptr<const StreamCloud> load(File& file);

  bool loop_;
  std::optional<recording::Unit> unit_;
  std::uint64_t max_points_;
  std::size_t cache_left_bytes_;
  std::vector<File> files_;          // of the thread
  recording::OriginRemark origins_;  // of the thread
  recording::AheadQueue<LoadedCloud> ready_{1};

  mutable std::mutex mutex_;  // guards the counts
  std::map<std::string, std::uint64_t> unusable_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace cleave::sensor
