// SPDX-License-Identifier: BSD-3-Clause
#include "recording/replace_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>

namespace cleave::recording {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(error) +
                           "; name another output, or make room or the folder writable");
}

// The file's errno, or 0.
int write_all(const std::filesystem::path& file,
              std::initializer_list<std::span<const std::byte>> parts) {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  if (stream == nullptr) return errno;
  int error = 0;
  for (const std::span<const std::byte> part : parts) {
    if (std::fwrite(part.data(), 1, part.size(), stream) != part.size()) error = errno;
  }
  if (error == 0 && (std::fflush(stream) != 0 || fsync(fileno(stream)) != 0)) error = errno;
  if (std::fclose(stream) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace

void replace_file(const std::filesystem::path& file,
                  std::initializer_list<std::span<const std::byte>> parts) {
  std::filesystem::path target = file;
  if (std::filesystem::exists(file)) {
    if (!std::filesystem::is_regular_file(file)) {
      throw std::runtime_error(file.string() + ": is no regular file; name another output");
    }
    target = std::filesystem::canonical(file);
  }
  std::filesystem::path temporary = target;
  temporary.replace_filename("." + target.filename().string() + "." + std::to_string(getpid()) +
                             ".partial");
  int error = write_all(temporary, parts);
  if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    std::error_code ignored;  // the failure that is reported is the first one
    std::filesystem::remove(temporary, ignored);
    fail(file, error);
  }
}

void replace_file(const std::filesystem::path& file, std::string_view text) {
  replace_file(file, {std::as_bytes(std::span(text))});
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error && std::filesystem::is_directory(folder)) return;
  throw std::runtime_error(folder.string() + ": this folder cannot be made: " +
                           (error ? error.message() : "a file has its name") +
                           "; name another folder, or make its parent writable");
}

}  // namespace cleave::recording
