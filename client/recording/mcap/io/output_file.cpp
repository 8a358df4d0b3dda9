// SPDX-License-Identifier: BSD-3-Clause
#include "recording/mcap/io/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "recording/mcap/format.hpp"

namespace cleave::recording {
namespace {

// The errno of the write that failed, or 0.
int write_all(int descriptor, ByteView bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return written < 0 ? errno : ENOSPC;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)),
      descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  ::close(descriptor_);
}

void OutputFile::append(ByteView bytes) {
  if (const int error = write_all(descriptor_, bytes); error != 0) {
    // If this fails, too, readers find half a record at the end, which they can tell.
    if (::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0) {
      (void)::lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET);
    }
    fail(error);
  }
  size_ += bytes.size();
  crc_ = crc32_of(bytes, crc_);
}

void OutputFile::sync() {
  // A pipe or a device cannot be synchronised, and need not be.
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail(errno);
}

void OutputFile::fail(int error) const {
  throw FileError(path_.string() + ": cannot be written: " + std::strerror(error) +
                  "; name another output, or make room or the folder writable");
}

}  // namespace cleave::recording
