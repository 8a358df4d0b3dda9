// SPDX-License-Identifier: BSD-3-Clause
// Point clouds from PCD files, as if a camera had sent them.
#pragma once

#include <filesystem>
#include <memory>

#include "sensor/sources/pcd_loader.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

class PcdSource : public Source {
 public:
  // A file, or a folder whose *.pcd files are read in natural order, again and again with `loop`.
  // `unit`: see PcdLoader.
  PcdSource(const std::filesystem::path& path, bool loop, std::optional<recording::Unit> unit = {},
            std::uint64_t max_points = capacity_points);

  // Fails when nothing usable is found; says what was looked for.
  [[nodiscard]] Failure open() override;
  [[nodiscard]] Poll next(std::chrono::milliseconds timeout, Frame& frame) override;
  void write_points(float* xyz) override;
  [[nodiscard]] bool realtime() const override { return false; }
  [[nodiscard]] SourceCounts counts() const override;
  [[nodiscard]] std::string last_error() const override { return ""; }

 private:
  std::filesystem::path path_;
  bool loop_;
  std::optional<recording::Unit> unit_;
  std::uint64_t max_points_;
  std::uint64_t other_files_ = 0;
  std::unique_ptr<PcdLoader> loader_;
  std::shared_ptr<const StreamCloud> held_;
};

}  // namespace cleave::sensor
