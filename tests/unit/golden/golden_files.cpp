// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/golden/golden_files.hpp"

#include <zlib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

// A file, or the file of that name in its compressed form; gzread() takes either.
std::vector<std::byte> read_cdr(const fs::path& path) {
  const std::string name = fs::exists(path) ? path.string() : path.string() + ".gz";
  gzFile file = gzopen(name.c_str(), "rb");
  if (file == nullptr) throw std::runtime_error("cannot read " + name);
  std::vector<std::byte> bytes;
  std::array<std::byte, 1 << 16> part;
  int size = 0;
  while ((size = gzread(file, part.data(), part.size())) > 0) {
    bytes.insert(bytes.end(), part.begin(), part.begin() + size);
  }
  if (gzclose(file) != Z_OK || size < 0) throw std::runtime_error("damaged: " + name);
  return bytes;
}

}  // namespace

std::vector<GoldenSample> golden_samples(const std::string& type) {
  const fs::path folder = fs::path(CLEAVE_GOLDEN) / type;
  std::vector<GoldenSample> samples;
  for (const char* const name : {"empty", "extreme", "typical"}) {
    std::ifstream json(folder / (std::string(name) + ".json"));
    samples.push_back({type + "/" + name, nlohmann::json::parse(json),
                       read_cdr(folder / (std::string(name) + ".le.cdr")),
                       read_cdr(folder / (std::string(name) + ".be.cdr"))});
  }
  return samples;
}

}  // namespace cleave::test
