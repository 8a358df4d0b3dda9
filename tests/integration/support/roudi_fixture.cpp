// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/roudi_fixture.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <utility>

#include "libcleave/roudi.hpp"

namespace cleave::test {

RouDiLock::RouDiLock()
    : file_(::open("/tmp/cleave-tests.lock", O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
  if (file_ < 0 || ::flock(file_, LOCK_EX) != 0) {
    throw std::runtime_error("cannot lock /tmp/cleave-tests.lock");
  }
  if (roudi_answers()) {
    throw std::runtime_error(
        "a RouDi runs already (a demo?): end it, only one can run on a machine");
  }
}

RouDiLock::~RouDiLock() {
  ::close(file_);
}

RouDi::RouDi() : RouDi(std::string(CLEAVE_SOURCE_DIR) + "/config/roudi.toml") {}

RouDi::RouDi(const std::filesystem::path& pools, std::vector<std::string> starter)
    : command_(std::move(starter)) {
  command_.insert(command_.end(), {"/usr/bin/iox-roudi", "-m", "off", "-c", pools.string()});
  start();
}

void RouDi::start() {
  process_ = std::make_unique<Process>(command_);
  if (!eventually([] { return roudi_answers(); })) {
    throw std::runtime_error("RouDi does not answer: " + process_->log() + process_->output());
  }
}

int RouDi::stop() {
  process_->signal(SIGTERM);
  return process_->wait();
}

void RouDi::kill() {
  process_->signal(SIGKILL);
  (void)process_->wait();
}

}  // namespace cleave::test
