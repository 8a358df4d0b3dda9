// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/roudi/roudi_post.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iceoryx_posh/internal/runtime/ipc_interface_base.hpp>
#include <iceoryx_posh/internal/runtime/ipc_message.hpp>
#include <iceoryx_posh/version/version_info.hpp>
#include <iterator>
#include <optional>
#include <system_error>

#include "libcleave/roudi.hpp"

// These lack it.
extern "C" {
#include <iceoryx_binding_c/log.h>
#include <iceoryx_binding_c/runtime.h>
}

#include "libcleave/process/roudi_process.hpp"
#include "libcleave/types.hpp"

namespace cleave {
namespace {

namespace fs = std::filesystem;
using iox::runtime::IpcMessage;
using iox::runtime::IpcMessageType;
using iox::runtime::IpcMessageTypeToString;

// A name once only, also of a process that starts anew in place: whoever has it cannot be taken for
// one that has ended.
std::string unique_name(const char* prefix) {
  return prefix + std::to_string(::getpid()) + "_" + std::to_string(monotonic_now_ns());
}

// "" until this process has joined.
std::string& joined_name() {
  static std::string name;
  return name;
}

class Socket {
 public:
  Socket() : descriptor_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Socket() { ::close(descriptor_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  [[nodiscard]] bool bind(const fs::path& file) const {
    const auto address = address_of(file);
    return address && ::bind(descriptor_, as_any(*address), sizeof *address) == 0 &&
           ::chmod(file.c_str(), S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP) == 0;
  }
  // False: the receiver is not there, or takes nothing now.
  [[nodiscard]] bool send(const IpcMessage& message, const fs::path& to) const {
    const auto address = address_of(to);
    const std::string text = message.getMessage();
    return address && ::sendto(descriptor_, text.c_str(), text.size() + 1, MSG_DONTWAIT,
                               as_any(*address), sizeof *address) >= 0;
  }
  [[nodiscard]] bool receives(std::chrono::milliseconds patience) const {
    pollfd waiting{descriptor_, POLLIN, 0};
    return ::poll(&waiting, 1, static_cast<int>(patience.count())) == 1;
  }

 private:
  static std::optional<sockaddr_un> address_of(const fs::path& file) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (file.native().size() >= sizeof address.sun_path) return std::nullopt;
    file.native().copy(address.sun_path, sizeof address.sun_path - 1);
    return address;
  }
  static const sockaddr* as_any(const sockaddr_un& address) {
    return reinterpret_cast<const sockaddr*>(&address);
  }
  int descriptor_;
};

IpcMessage registration(const std::string& name) {
  const auto version =
      static_cast<iox::cxx::Serialization>(iox::version::VersionInfo::getCurrentVersion());
  return {IpcMessageTypeToString(IpcMessageType::REG),
          name,
          std::to_string(::getpid()),
          std::to_string(::geteuid()),
          std::to_string(monotonic_now_ns()),
          version.toString()};
}

IpcMessage sign_off(const std::string& name) {
  return {IpcMessageTypeToString(IpcMessageType::TERMINATION), name};
}

// Ours, or of a Cyclone that named itself.
bool is_of_the_stream(const std::string& name) {
  return name.starts_with("cleave_") || name.starts_with("iceoryx_rt_");
}

// iceoryx's socket and lock file of a name, which it leaves behind when its process is killed.
// Tells whether there was a socket.
bool remove_files_of(const std::string& name, const RouDiPlace& place) {
  const fs::path socket = place.socket.parent_path() / name;
  std::error_code error;  // another user's: theirs to remove
  fs::remove(socket.native() + ".lock", error);
  return fs::remove(socket, error);
}

// Of the RouDi that asked this process's predecessor in place to end.
constexpr char ending_roudi[] = "CLEAVE_ENDING_ROUDI";

bool is_ending(pid_t roudi) {
  const char* const ending = std::getenv(ending_roudi);
  return ending != nullptr && roudi != 0 && std::to_string(roudi) == ending;
}

}  // namespace

bool has_joined_roudi() {
  return !joined_name().empty();
}

void join_roudi() {
  if (has_joined_roudi()) return;
  joined_name() = unique_name("cleave_");
  iox_set_loglevel(Iceoryx_LogLevel_Off);  // until Cyclone sets its own
  iox_runtime_init(joined_name().c_str());
}

void leave_roudi(pid_t ending) {
  ::setenv(ending_roudi, std::to_string(ending).c_str(), 1);
  if (!has_joined_roudi()) return;
  const RouDiPlace place;
  (void)Socket().send(sign_off(joined_name()), place.socket);
  (void)remove_files_of(joined_name(), place);
}

bool roudi_responds(std::chrono::milliseconds patience, const RouDiPlace& place) {
  const std::string name = unique_name("cleave_question_");
  const fs::path file = place.socket.parent_path() / name;
  const Socket socket;
  const bool responds = socket.bind(file) && socket.send(registration(name), place.socket) &&
                        socket.receives(patience);
  // If RouDi takes nothing now, the file stays: the sign-off is made up for by whoever finds it.
  if (socket.send(sign_off(name), place.socket)) ::unlink(file.c_str());
  return responds;
}

std::string obstacle_to_joining(std::chrono::milliseconds patience, const RouDiPlace& place) {
  std::string obstacle = obstacle_to_roudi(place);
  if (!obstacle.empty()) return obstacle;
  const pid_t roudi = find_roudi();
  if (is_ending(roudi)) return "RouDi (process " + std::to_string(roudi) + ") is ending";
  if (roudi_responds(patience, place)) return {};
  return place.socket.string() + " is there, and nobody answers: " +
         (roudi == 0 ? "another program listens on it, end that; then"
                     : "RouDi (process " + std::to_string(roudi) +
                           ") is suspended or hangs: let it go on (kill -CONT), or end it and") +
         " start `iox-roudi -m off -c config/roudi.toml`";
}

bool roudi_drops_suspended() {
  const pid_t process = find_roudi();
  if (process == 0) return false;
  std::ifstream file(fs::path("/proc") / std::to_string(process) / "cmdline");
  std::string words{std::istreambuf_iterator<char>(file), {}};
  std::ranges::replace(words, '\0', ' ');
  return words.find("-m off") == std::string::npos &&
         words.find("--monitoring-mode off") == std::string::npos;
}

std::vector<std::string> sign_off_the_dead(const RouDiPlace& place) {
  std::vector<std::string> dead;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(place.socket.parent_path(), error)) {
    const std::string name = entry.path().filename();
    std::error_code gone;
    if (!is_of_the_stream(name) || !entry.is_socket(gone)) continue;
    if (connection_error(entry.path()) != ECONNREFUSED) continue;  // it is heard
    if (!Socket().send(sign_off(name), place.socket)) continue;
    if (remove_files_of(name, place)) dead.push_back(name);
  }
  return dead;
}

}  // namespace cleave
