// SPDX-License-Identifier: BSD-3-Clause
// Is a pointer inside a mapping that processes share?
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

namespace cleave::test {

// The file behind the shared mapping that holds `pointer` (iceoryx: /dev/shm/...); empty if the
// memory is private.
inline std::string shared_mapping_of(const void* pointer) {
  std::ifstream maps("/proc/self/maps");
  const auto wanted = reinterpret_cast<std::uintptr_t>(pointer);
  for (std::string line; std::getline(maps, line);) {
    std::istringstream fields(line);
    std::uintptr_t begin = 0, end = 0;
    char dash = 0;
    std::string permissions, offset, device, inode, file;
    fields >> std::hex >> begin >> dash >> end >> permissions >> offset >> device >> inode >> file;
    if (wanted >= begin && wanted < end) return permissions.back() == 's' ? file : "";
  }
  return "";
}

}  // namespace cleave::test
