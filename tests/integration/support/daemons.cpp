// SPDX-License-Identifier: BSD-3-Clause
#include "tests/integration/support/daemons.hpp"

#include <cstdlib>

namespace cleave::test {

Process Daemons::run(const std::string& name, const std::vector<std::string>& words) const {
  std::vector<std::string> command = {program(name)};
  command.insert(command.end(), words.begin(), words.end());
  return Process(command, {{"CLEAVE_DOMAIN", std::to_string(domain_)}});
}

Process Daemons::segmenter(std::vector<std::string> options) const {
  options.insert(options.begin(),
                 {"--config", std::string(CLEAVE_SOURCE_DIR) + "/config/segmenter.yaml"});
  if (!shared_memory_) options.emplace_back("--no-shared-memory");
  return run("cleave-segmenter", options);
}

Process Daemons::grabber(const std::string& source, std::vector<std::string> options) const {
  options.insert(
      options.begin(),
      {"--config", std::string(CLEAVE_SOURCE_DIR) + "/config/grabber.yaml", "--source", source});
  if (!shared_memory_) options.emplace_back("--no-shared-memory");
  return run("cleave-grabber", options);
}

std::string learn_scenes() {
  const char* const set = std::getenv("CLEAVE_DATA");
  const std::filesystem::path data =
      set != nullptr ? set : std::string(CLEAVE_SOURCE_DIR) + "/../shared/data";
  const std::filesystem::path scenes = data / "mosd" / "learn";
  return std::filesystem::is_directory(scenes) ? scenes.string() : std::string();
}

}  // namespace cleave::test
