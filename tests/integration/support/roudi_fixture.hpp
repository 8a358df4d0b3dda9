// SPDX-License-Identifier: BSD-3-Clause
// The one RouDi of the machine, for the tests that need shared memory.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"

namespace cleave::test {

// Held by whoever starts a RouDi in a test: waits until no other test does. Throws when a RouDi
// that is not a test's answers already.
class RouDiLock {
 public:
  RouDiLock();
  ~RouDiLock();
  RouDiLock(const RouDiLock&) = delete;
  RouDiLock& operator=(const RouDiLock&) = delete;

 private:
  int file_;
};

// Starts RouDi with our pools and ends it, by its process id, on destruction.
class RouDi {
 public:
  RouDi();
  // With other pools, or by way of a command that starts it (setpriv, to be another user).
  explicit RouDi(const std::filesystem::path& pools, std::vector<std::string> starter = {});

  void start();
  int stop();   // SIGTERM; its exit code
  void kill();  // -9: its socket and segments stay behind, as after a crash
  [[nodiscard]] pid_t id() const { return process_->id(); }

 private:
  RouDiLock lock_;
  std::vector<std::string> command_;
  std::unique_ptr<Process> process_;
};

}  // namespace cleave::test
