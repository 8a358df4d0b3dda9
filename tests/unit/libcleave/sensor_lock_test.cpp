// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/sensor_lock.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <string>

namespace cleave {
namespace {

// Of no other test and no grabber that may run on this machine.
std::string own_name(const std::string& name) {
  return name + "-" + std::to_string(::getpid());
}

// A process that holds the lock until it is killed.
class Holder {
 public:
  explicit Holder(const std::string& sensor) {
    std::array<int, 2> ready{};
    if (::pipe(ready.data()) != 0) throw std::runtime_error("pipe");
    id_ = ::fork();
    if (id_ == 0) {
      const SensorLock lock(0, sensor);
      (void)!::write(ready[1], "x", 1);
      for (;;) ::pause();
    }
    ::close(ready[1]);
    char held = 0;
    (void)!::read(ready[0], &held, 1);
    ::close(ready[0]);
  }
  ~Holder() { kill(); }
  Holder(const Holder&) = delete;
  Holder& operator=(const Holder&) = delete;
  void kill() {
    if (id_ == 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    id_ = 0;
  }
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  pid_t id_ = 0;
};

TEST(SensorLock, NamesTheProcessThatHoldsIt) {
  const std::string sensor = own_name("left");
  const Holder holder(sensor);
  try {
    const SensorLock second(0, sensor);
    FAIL() << "two processes hold the lock";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("sensor '" + sensor + "' is already published by process " +
                           std::to_string(holder.id())),
              std::string::npos)
        << message;
  }
}

TEST(SensorLock, IsFreeWhenItsHolderWasKilled) {
  const std::string sensor = own_name("left");
  Holder holder(sensor);
  holder.kill();
  EXPECT_NO_THROW(SensorLock(0, sensor));
}

TEST(SensorLock, IsFreeWhenItsHolderLetGo) {
  const std::string sensor = own_name("left");
  { const SensorLock lock(0, sensor); }
  EXPECT_NO_THROW(SensorLock(0, sensor));
}

TEST(SensorLock, IsPerSensorAndDomain) {
  const SensorLock lock(0, own_name("left"));
  EXPECT_NO_THROW(SensorLock(0, own_name("right")));
  EXPECT_NO_THROW(SensorLock(1, own_name("left")));
  EXPECT_NO_THROW(SensorLock(99, std::string(63, 'a')));
}

}  // namespace
}  // namespace cleave
