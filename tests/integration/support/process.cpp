// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace cleave::test {
namespace {

std::vector<std::string> merged_environment(const std::map<std::string, std::string>& extra) {
  std::vector<std::string> merged;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (!extra.contains(text.substr(0, text.find('=')))) merged.push_back(text);
  }
  for (const auto& [name, value] : extra) merged.push_back(name + "=" + value);
  return merged;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  return list;
}

}  // namespace

Process::Process(const std::vector<std::string>& command,
                 const std::map<std::string, std::string>& environment)
    : folder_(std::make_unique<TemporaryFolder>()) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int flags = O_WRONLY | O_CREAT | O_APPEND;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, (folder_->path() / "out").c_str(),
                                   flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (folder_->path() / "log").c_str(),
                                   flags, 0600);
  std::vector<std::string> words = command;
  std::vector<std::string> variables = merged_environment(environment);
  const int code = ::posix_spawn(&id_, words.front().c_str(), &actions, nullptr,
                                 pointers(words).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) throw std::system_error(code, std::generic_category(), "cannot start " + words[0]);
}

Process::Process(Process&& other) noexcept
    : id_(std::exchange(other.id_, -1)),
      status_(other.status_),
      folder_(std::move(other.folder_)) {}

Process::~Process() {
  if (running()) {
    signal(SIGTERM);
    if (wait(std::chrono::seconds(10)) == -1) {
      signal(SIGKILL);
      (void)wait();
    }
  }
}

bool Process::running() {
  return id_ > 0 && wait(std::chrono::milliseconds(0)) == -1;
}

void Process::signal(int number) const {
  ::kill(id_, number);
}

int Process::wait(std::chrono::milliseconds timeout) {
  const auto ended = [this] {
    if (status_ != -1) return true;
    int status = 0;
    if (::waitpid(id_, &status, WNOHANG) != id_) return false;
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return true;
  };
  return eventually(ended, timeout) ? status_ : -1;
}

std::string Process::output() const {
  return tests::read_file(folder_->path() / "out");
}
std::string Process::log() const {
  return tests::read_file(folder_->path() / "log");
}

bool Process::logs(const std::string& text, std::chrono::milliseconds timeout) {
  const auto found = [&] { return log().find(text) != std::string::npos; };
  return eventually([&] { return found() || !running(); }, timeout) && found();
}

bool eventually(const std::function<bool()>& condition, std::chrono::milliseconds timeout) {
  const auto end = std::chrono::steady_clock::now() + timeout;
  while (!condition()) {
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

std::string program(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace cleave::test
