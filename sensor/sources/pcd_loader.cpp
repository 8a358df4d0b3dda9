// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/pcd_loader.hpp"

#include <spdlog/spdlog.h>

#include <utility>

#include "recording/pcd/error.hpp"
#include "recording/units/suspected_unit.hpp"

namespace cleave::sensor {

PcdLoader::PcdLoader(std::vector<std::filesystem::path> files, bool loop,
                     std::optional<recording::Unit> unit, std::uint64_t max_points,
                     std::size_t cache_bytes)
    : loop_(loop), unit_(unit), max_points_(max_points), cache_left_bytes_(loop ? cache_bytes : 0) {
  for (std::filesystem::path& file : files) files_.push_back({std::move(file), nullptr});
  thread_ = std::thread([this] { run(); });
}

PcdLoader::~PcdLoader() {
  ready_.stop();
  thread_.join();
}

std::map<std::string, std::uint64_t> PcdLoader::unusable() const {
  const std::lock_guard lock(mutex_);
  return unusable_;
}

void PcdLoader::run() {
  bool usable = pass(true) > 0;
  while (loop_ && usable) usable = pass(false) > 0;
  ready_.end();
}

std::size_t PcdLoader::pass(bool is_first) {
  std::size_t handed_over = 0;
  for (auto file = files_.begin(); file != files_.end();) {
    std::shared_ptr<const StreamCloud> cloud = load(*file);
    if (cloud == nullptr) {
      file = files_.erase(file);
      continue;
    }
    if (!ready_.put({std::move(cloud), !is_first && handed_over == 0})) return 0;
    ++handed_over;
    ++file;
  }
  return handed_over;
}

std::shared_ptr<const StreamCloud> PcdLoader::load(File& file) {
  if (file.cached) return file.cached;
  const auto skip = [this](const char* why, const std::string& cause) {
    spdlog::warn("skipped {} ({})", why, cause);
    const std::lock_guard lock(mutex_);
    ++unusable_[cause];
    return nullptr;
  };
  auto cloud = std::make_shared<StreamCloud>();
  try {
    *cloud = recording::read_stream_cloud(file.path, max_points_, unit_);
  } catch (const recording::PcdError& error) {
    return skip(error.what(), name_of(error.cause()));
  } catch (const recording::WrongUnit& error) {
    return skip(error.what(), "wrong unit");
  }
  if (const auto remark = origins_.of(file.path, *cloud)) spdlog::warn("{}", *remark);
  const std::size_t bytes = cloud->xyz.size() * sizeof(float);
  if (bytes <= cache_left_bytes_) {
    cache_left_bytes_ -= bytes;
    file.cached = cloud;
  }
  return cloud;
}

}  // namespace cleave::sensor
