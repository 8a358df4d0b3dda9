// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/roudi.hpp"

#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include <utility>

#include "libcleave/internal/roudi/roudi_access.hpp"
#include "libcleave/internal/roudi/roudi_post.hpp"

namespace cleave {
namespace {

constexpr std::chrono::seconds look_interval(1);
// Its caller has frames to take; who is too busy to answer is asked again a second later.
constexpr std::chrono::milliseconds answer_patience(200);
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

RouDiWatch::Task task_of(const Stream& stream) {
  if (!stream.options().shared_memory) return RouDiWatch::Task::nothing;
  return stream.transport() == Transport::shared_memory ? RouDiWatch::Task::look_after
                                                        : RouDiWatch::Task::wait;
}

}  // namespace

bool roudi_answers() {
  return connection_error(RouDiPlace{}.socket) == 0;
}

RouDiWatch::RouDiWatch(const Stream& stream) : RouDiWatch(task_of(stream), RouDiPlace{}.socket) {}

RouDiWatch::RouDiWatch(Task task, std::filesystem::path socket)
    : task_(task), socket_(std::move(socket)) {
  // Whose pools were too small is not asked again.
  identity_ = task_ == Task::look_after || has_joined_roudi() ? identity_of(socket_) : 0;
}

bool RouDiWatch::update(Clock::time_point now) {
  if (task_ == Task::nothing || restart_joins_ || now < next_look_) return false;
  next_look_ = now + look_interval;
  const bool answers = connection_error(socket_) == 0;
  const bool another = answers && identity_of(socket_) != identity_;
  if (task_ == Task::wait) {
    if (another) wait_for_one();
    return false;
  }
  if (another) {
    spdlog::warn("another RouDi runs: only a process that starts anew joins it");
    restart_joins_ = true;
    return false;
  }
  if (answers) sign_off();
  if (answers == error_.empty()) return false;
  error_ = answers ? "" : gone;
  if (answers) {
    spdlog::info("RouDi is back");
  } else {
    spdlog::warn("{}", error_);
  }
  return true;
}

void RouDiWatch::wait_for_one() {
  RouDiPlace place;
  place.socket = socket_;
  restart_joins_ = obstacle_to_joining(answer_patience, place).empty();
  if (restart_joins_) spdlog::warn("RouDi is there now: only a process that starts anew joins it");
}

void RouDiWatch::sign_off() const {
  RouDiPlace place;
  place.socket = socket_;
  for (const std::string& name : sign_off_the_dead(place)) {
    spdlog::info("signed {} off at RouDi: its process has ended", name);
  }
}

}  // namespace cleave
