// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/process/roudi_process.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace cleave {

bool is_roudi(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/comm");
  std::string name;
  return file >> name && name == roudi_program;
}

pid_t find_roudi() {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (const pid_t process = std::stoi(name); is_roudi(process)) return process;
  }
  return 0;
}

}  // namespace cleave
