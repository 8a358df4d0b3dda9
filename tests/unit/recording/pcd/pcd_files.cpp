// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/recording/pcd/pcd_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "recording/pcd/cloud.hpp"

namespace cleave::recording {

TestFolder::TestFolder() {
  static int number = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("cleave_pcd_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
  std::filesystem::create_directories(path_);
}

std::filesystem::path TestFolder::write(const std::string& name, const std::string& content) const {
  std::ofstream(path_ / name, std::ios::binary) << content;
  return path_ / name;
}

std::string to_file(const PcdText& pcd) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + pcd.fields +
         "\nSIZE " + pcd.size + "\nTYPE " + pcd.type + "\nCOUNT " + pcd.count + "\nWIDTH " +
         pcd.width + "\nHEIGHT " + pcd.height + "\nVIEWPOINT " + pcd.viewpoint + "\nPOINTS " +
         pcd.points + "\nDATA " + pcd.encoding + "\n" + pcd.data;
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string refusal_of(const std::string& content) {
  const TestFolder folder;
  const std::filesystem::path file = folder.write("a.pcd", content);
  try {
    (void)PcdCloud::read(file);
  } catch (const PcdError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.string(), 0), 0U) << "names no file";
    return std::string(name_of(error.cause())) + ": " + error.what();
  }
  return "";
}

void expect_refused(const std::string& content, const std::string& cause, const std::string& why) {
  const std::string refusal = refusal_of(content);
  EXPECT_EQ(refusal.rfind(cause + ": ", 0), 0U) << "refused with: '" << refusal << "'";
  EXPECT_NE(refusal.find(why), std::string::npos) << "refused with: '" << refusal << "'";
}

std::string binary_file(const std::vector<float>& xyz, std::uint32_t width, std::uint32_t height) {
  PcdText pcd;
  pcd.width = std::to_string(width);
  pcd.height = std::to_string(height);
  pcd.points = std::to_string(width * height);
  pcd.encoding = "binary";
  pcd.data = bytes_of(xyz);
  return to_file(pcd);
}

std::string compressed_body(const std::string& bytes) {
  std::string lzf;
  for (std::size_t i = 0; i < bytes.size(); i += 32) {
    const std::size_t run = std::min<std::size_t>(32, bytes.size() - i);
    lzf += static_cast<char>(run - 1);
    lzf += bytes.substr(i, run);
  }
  const std::vector<std::uint32_t> sizes = {static_cast<std::uint32_t>(lzf.size()),
                                            static_cast<std::uint32_t>(bytes.size())};
  return bytes_of(sizes) + lzf;
}

}  // namespace cleave::recording
