// SPDX-License-Identifier: BSD-3-Clause
// A child process of a test: started, watched, and ended by its own process id.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace cleave::test {

using tests::TemporaryFolder;

// The machine may be busy with other tests: generous, because no test asserts a duration.
inline constexpr std::chrono::seconds patience{60};

class Process {
 public:
  // Starts `command` (its first word is a path) with `environment` on top of this process's own.
  // Output goes to files, so that a chatty child never blocks.
  explicit Process(const std::vector<std::string>& command,
                   const std::map<std::string, std::string>& environment = {});
  // Ends the child if it still runs: SIGTERM, then SIGKILL after 10 s.
  ~Process();
  Process(Process&& other) noexcept;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  Process& operator=(Process&&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  [[nodiscard]] bool running();
  void signal(int number) const;
  // The exit code, 128 + n when signal n ended it, or -1 if it still runs after `timeout`.
  int wait(std::chrono::milliseconds timeout = patience);
  [[nodiscard]] std::string output() const;  // stdout so far
  [[nodiscard]] std::string log() const;     // stderr so far
  // Waits until the log holds `text`; false if it ends or `timeout` passes without.
  bool logs(const std::string& text, std::chrono::milliseconds timeout = patience);

 private:
  pid_t id_ = -1;
  int status_ = -1;
  std::unique_ptr<tests::TemporaryFolder> folder_;  // with what it has written
};

// Polls until `condition` holds; false after `timeout`.
bool eventually(const std::function<bool()>& condition,
                std::chrono::milliseconds timeout = patience);

// build/<preset>/bin/<name>
std::string program(const std::string& name);

}  // namespace cleave::test
