// SPDX-License-Identifier: BSD-3-Clause
#include "tests/interop/javascript_package.hpp"

#include <sstream>

#include "tests/interop/npm_packages.hpp"

namespace cleave::test {

namespace fs = std::filesystem;

namespace {

fs::path mirror() {
  return CLEAVE_JAVASCRIPT_MIRROR;
}

fs::path user() {
  return mirror() / "user";
}

fs::path users_koffi() {
  return user() / "node_modules" / "koffi";
}

}  // namespace

std::vector<Line> lines_of(const std::string& output) {
  std::vector<Line> lines;
  std::istringstream input(output.substr(0, output.rfind('\n') + 1));
  for (std::string text; std::getline(input, text);) {
    if (!text.starts_with("frame ")) continue;
    lines.push_back({std::stoull(text.substr(text.find(' ') + 1)), text});
  }
  return lines;
}

std::string common(const std::vector<Line>& lines, const std::vector<Line>& others) {
  std::string text;
  for (const Line& line : lines) {
    if (line.frame < others.front().frame || line.frame > others.back().frame) continue;
    text += line.text + "\n";
  }
  return text;
}

// A mirror of what the package is made of, because npm builds where the sources are.
void Javascript::SetUpTestSuite() {
  const fs::path top(CLEAVE_SOURCE_DIR);
  const fs::path sources = top / "client" / "javascript";
  fs::remove_all(mirror() / "idl");
  for (const char* const part : {"build", "examples", "src", "test"}) {
    fs::remove_all(package() / part);
  }
  ASSERT_NO_FATAL_FAILURE(install_npm_packages(sources, package()));
  constexpr auto everything = fs::copy_options::recursive | fs::copy_options::overwrite_existing;
  for (const char* const part : {"build", "examples", "src", "test", "tsconfig.json"}) {
    fs::copy(sources / part, package() / part, everything);
  }
  fs::copy(top / "idl", mirror() / "idl", everything);
  fs::copy(top / "LICENSE", mirror() / "LICENSE", everything);
  fs::copy(sources / "README.md", package() / "README.md", everything);

  fs::remove_all(user());
  fs::create_directories(user());
  npm({"pack", package().string(), "--pack-destination", user().string()});
  for (const auto& entry : fs::directory_iterator(user())) {
    if (entry.path().extension() != ".tgz") continue;
    npm({"install", "--no-audit", "--no-fund", "--prefix", user().string(), entry.path().string()});
    break;
  }
}

void Javascript::npm(const std::vector<std::string>& words) {
  std::vector<std::string> command = {"/usr/bin/env", "npm"};
  command.insert(command.end(), words.begin(), words.end());
  Process process(command);
  ASSERT_EQ(process.wait(std::chrono::minutes(5)), 0) << process.output() << process.log();
}

Process Javascript::node(const std::vector<std::string>& words, std::uint32_t domain,
                         const std::string& library) {
  std::vector<std::string> command = {"/usr/bin/env", "node"};
  command.insert(command.end(), words.begin(), words.end());
  return Process(command, {{"CLEAVE_DOMAIN", std::to_string(domain)}, {"CLEAVE_LIBRARY", library}});
}

Process Javascript::example(const std::string& name, std::uint32_t domain,
                            const std::string& library) {
  const fs::path script = user() / name;
  fs::copy_file(package() / "examples" / name, script, fs::copy_options::overwrite_existing);
  return node({script.string()}, domain, library);
}

void Javascript::install_koffi() {
  remove_koffi();
  fs::create_directory_symlink(package() / "node_modules" / "koffi", users_koffi());
}

void Javascript::remove_koffi() {
  fs::remove(users_koffi());
}

fs::path Javascript::package() {
  return mirror() / "client" / "javascript";
}

}  // namespace cleave::test
