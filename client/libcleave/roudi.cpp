// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/roudi.hpp"

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <utility>

#include "libcleave/internal/roudi_access.hpp"

namespace cleave {
namespace {

constexpr std::chrono::seconds look_interval(1);
constexpr char gone[] =
    "RouDi is gone: who is connected goes on, nobody new can join; start it again";

// Tells one RouDi's socket file from the next one's, whatever became of its name and its rights; 0
// if there is none.
std::uint64_t identity_of(const std::filesystem::path& socket) {
  struct stat status {};
  if (::stat(socket.c_str(), &status) != 0) return 0;
  const auto seconds = static_cast<std::uint64_t>(status.st_mtim.tv_sec);
  const auto nanoseconds = static_cast<std::uint64_t>(status.st_mtim.tv_nsec);
  return (status.st_ino << 32U) ^ (seconds * 1'000'000'000U + nanoseconds);
}

}  // namespace

bool roudi_answers() {
  return connection_error(RouDiPlace{}.socket) == 0;
}

RouDiWatch::RouDiWatch(Transport in_force) : RouDiWatch(in_force, RouDiPlace{}.socket) {}

RouDiWatch::RouDiWatch(Transport in_force, std::filesystem::path socket)
    : socket_(in_force == Transport::shared_memory ? std::move(socket) : ""),
      identity_(identity_of(socket_)) {}

bool RouDiWatch::update(Clock::time_point now) {
  if (socket_.empty() || replaced_ || now < next_look_) return false;
  next_look_ = now + look_interval;
  const bool answers = connection_error(socket_) == 0;
  if (answers && identity_of(socket_) != identity_) {
    spdlog::warn("another RouDi runs: only a process that starts anew joins it");
    replaced_ = true;
    return false;
  }
  if (answers == error_.empty()) return false;
  error_ = answers ? "" : gone;
  if (answers) {
    spdlog::info("RouDi is back");
  } else {
    spdlog::warn("{}", error_);
  }
  return true;
}

}  // namespace cleave
