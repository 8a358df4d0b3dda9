// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace cleave::oni {

File::File(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  const auto refuse = [&](const std::string& why) {
    if (descriptor_ >= 0) ::close(descriptor_);
    throw std::runtime_error("cannot open the recording '" + path.string() + "': " + why);
  };
  if (descriptor_ < 0) refuse(std::generic_category().message(errno));
  struct stat status {};
  if (::fstat(descriptor_, &status) != 0) refuse(std::generic_category().message(errno));
  if (!S_ISREG(status.st_mode)) refuse("it is no file");
  size_ = static_cast<std::uint64_t>(status.st_size);
}

File::~File() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

File::File(File&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_) {}

std::span<const std::uint8_t> File::read(std::uint64_t position, std::size_t count,
                                         std::vector<std::uint8_t>& buffer) const {
  if (position >= size_) return {};
  count = static_cast<std::size_t>(std::min<std::uint64_t>(count, size_ - position));
  if (buffer.size() < count) buffer.resize(count);
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got = ::pread(descriptor_, buffer.data() + done, count - done,
                                static_cast<off_t>(position + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;  // the file has become shorter, or the disk fails
    done += static_cast<std::size_t>(got);
  }
  return {buffer.data(), done};
}

}  // namespace cleave::oni
