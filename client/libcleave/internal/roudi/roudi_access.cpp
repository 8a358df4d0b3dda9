// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/roudi/roudi_access.hpp"

#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <vector>

namespace cleave {
namespace {

// The pools of config/roudi.toml (206 MB), and RouDi's own memory (66 MB).
constexpr std::uint64_t memory_of_roudi = 272'000'000;

std::string name_of(uid_t user) {
  const passwd* const entry = ::getpwuid(user);
  return "'" + (entry != nullptr ? std::string(entry->pw_name) : std::to_string(user)) + "'";
}

// As iceoryx sees them: those of the user, whatever the process was given.
std::vector<gid_t> groups_of(uid_t user, gid_t otherwise) {
  const passwd* const entry = ::getpwuid(user);
  if (entry == nullptr) return {otherwise};
  int count = 64;
  std::vector<gid_t> groups(static_cast<std::size_t>(count));
  if (::getgrouplist(entry->pw_name, entry->pw_gid, groups.data(), &count) < 0) {
    groups.resize(static_cast<std::size_t>(count));
    (void)::getgrouplist(entry->pw_name, entry->pw_gid, groups.data(), &count);
  }
  groups.resize(static_cast<std::size_t>(count));
  return groups;
}

bool allows(const std::filesystem::path& file, int access) {
  return ::faccessat(AT_FDCWD, file.c_str(), access, AT_EACCESS) == 0;
}

std::string no_roudi(const RouDiPlace& place) {
  const std::string what = "no RouDi answers at " + place.socket.string();
  struct statvfs room {};
  if (::statvfs(place.memory.c_str(), &room) == 0) {
    const std::uint64_t bytes = std::uint64_t{room.f_blocks} * room.f_frsize;
    if (bytes < memory_of_roudi) {
      return what + ", and " + place.memory.string() + " has room for " +
             std::to_string(bytes / 1'000'000) + " of the " +
             std::to_string(memory_of_roudi / 1'000'000) +
             " MB of config/roudi.toml: enlarge it (mount -o remount,size=512m " +
             place.memory.string() + "; docker run --shm-size=512m), then start RouDi";
    }
  }
  return what + ": start `iox-roudi -m off -c config/roudi.toml`";
}

std::string another_user(uid_t owner) {
  const std::string me = name_of(::geteuid());
  return "RouDi runs as user " + name_of(owner) + ", which keeps user " + me +
         " out: run both as the same user, or with one group as the first of both";
}

std::string no_rights(const std::filesystem::path& file, int error) {
  struct stat status {};
  std::array<char, 16> mode{"unknown"};
  if (::stat(file.c_str(), &status) == 0) {
    std::snprintf(mode.data(), mode.size(), "%04o", status.st_mode & 07777U);
  }
  return file.string() + " may not be used by user " + name_of(::geteuid()) + " (" +
         std::generic_category().message(error) + ", mode " + mode.data() +
         "): restart RouDi, which makes it anew, and see that all may enter " +
         file.parent_path().string() + " (chmod 1777)";
}

// RouDi answers through a socket of ours that is open to our user and our group.
bool may_answer(const struct stat& roudi) {
  if (roudi.st_uid == 0 || roudi.st_uid == ::geteuid()) return true;
  const std::vector<gid_t> groups = groups_of(roudi.st_uid, roudi.st_gid);
  return std::find(groups.begin(), groups.end(), ::getegid()) != groups.end();
}

// Of a group of ours or, by its access list, to be read.
bool has_segment(const RouDiPlace& place) {
  if (may_write_to_roudi(place)) return true;
  if (::geteuid() == 0) return false;  // may read everything, and is asked for its groups
  std::error_code error;
  for (const auto& file : std::filesystem::directory_iterator(place.memory, error)) {
    if (::getgrnam(file.path().filename().c_str()) != nullptr && allows(file.path(), R_OK)) {
      return true;
    }
  }
  return false;
}

}  // namespace

int connection_error(const std::filesystem::path& socket) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (socket.native().size() >= sizeof address.sun_path) return ENAMETOOLONG;
  std::memcpy(address.sun_path, socket.c_str(), socket.native().size() + 1);
  const int fd = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (fd < 0) return errno;
  const bool connected =
      ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  const int error = connected ? 0 : errno;
  ::close(fd);
  return error;
}

bool may_write_to_roudi(const RouDiPlace& place) {
  const std::vector<gid_t> groups = groups_of(::geteuid(), ::getegid());
  return std::any_of(groups.begin(), groups.end(), [&](gid_t id) {
    const group* const entry = ::getgrgid(id);
    return entry != nullptr && allows(place.memory / entry->gr_name, R_OK | W_OK);
  });
}

std::string obstacle_to_roudi(const RouDiPlace& place) {
  struct stat socket {};
  const bool seen = ::stat(place.socket.c_str(), &socket) == 0;
  const int error = connection_error(place.socket);
  if (error == ENOENT || error == ECONNREFUSED) return no_roudi(place);
  if (error == EACCES || error == EPERM) {
    const bool others = seen && socket.st_uid != ::geteuid();
    return others ? another_user(socket.st_uid) : no_rights(place.socket, error);
  }
  if (error != 0) {
    return place.socket.string() + " is no socket of RouDi's (" +
           std::generic_category().message(error) + "): remove it and start RouDi";
  }
  if (seen && !may_answer(socket)) return another_user(socket.st_uid);

  const std::filesystem::path management = place.memory / "iceoryx_mgmt";
  if (!std::filesystem::exists(management)) {
    return "RouDi answers, and its memory is not in " + place.memory.string() +
           ": share that, too (docker run --ipc=host, or the IPC of RouDi's container)";
  }
  if (!allows(management, R_OK | W_OK)) return no_rights(management, EACCES);
  if (!has_segment(place)) {
    return "RouDi's segments in " + place.memory.string() + " belong to no group of user " +
           name_of(::geteuid()) +
           ": name one as `writer` in roudi.toml, or join theirs (usermod -aG)";
  }
  return {};
}

}  // namespace cleave
