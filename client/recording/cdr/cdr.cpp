// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cdr/cdr.hpp"

#include <algorithm>
#include <array>

namespace cleave::recording {
namespace {

// "CDR, little endian", and no options.
constexpr std::array encapsulation = {std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};

std::size_t padding(std::size_t position, std::size_t size) {
  return (size - position % size) % size;
}

// An encapsulation's second byte; its first is 0, as are the options behind it.
enum class Representation : std::uint8_t {
  cdr_be = 0,
  cdr_le = 1,
  pl_cdr_be = 2,
  pl_cdr_le = 3,
  cdr2_be = 6,
  pl_cdr2_le = 11
};

Representation representation_of(ByteView message) {
  if (message.size() < encapsulation.size() || message[0] != std::byte{0}) {
    throw DataError("a message does not begin as CDR");
  }
  return static_cast<Representation>(message[1]);
}

bool is_big_endian(ByteView message) {
  return representation_of(message) == Representation::cdr_be;
}

ByteView body_of(ByteView message) {
  switch (const Representation representation = representation_of(message)) {
    case Representation::cdr_be:
    case Representation::cdr_le:
      return message.subspan(encapsulation.size());
    case Representation::pl_cdr_be:
    case Representation::pl_cdr_le:
      throw DataError("a message is a parameter list (PL_CDR), which ROS 2 never writes");
    default:
      if (representation >= Representation::cdr2_be &&
          representation <= Representation::pl_cdr2_le) {
        throw DataError("a message is XCDR2, which is not read: ROS 2 writes XCDR1");
      }
      throw DataError("a message does not begin as CDR");
  }
}

}  // namespace

CdrWriter::CdrWriter() : bytes_(encapsulation.begin(), encapsulation.end()) {}

void CdrWriter::align(std::size_t size) {
  bytes_.resize(bytes_.size() + padding(bytes_.size() - encapsulation.size(), size));
}

void CdrWriter::string(std::string_view text) {
  length(text.size() + 1);
  append(bytes_, bytes_of(text));
  bytes_.push_back(std::byte{0});
}

void CdrWriter::characters(std::string_view text, std::size_t size) {
  if (text.size() >= size) {
    throw DataError("'" + std::string(text) + "' has more than " + std::to_string(size - 1) +
                    " characters");
  }
  append(bytes_, bytes_of(text));
  bytes_.resize(bytes_.size() + size - text.size());
}

CdrReader::CdrReader(ByteView body, bool big_endian, bool ros1)
    : size_(body.size()), source_(body), big_endian_(big_endian), ros1_(ros1) {}

CdrReader::CdrReader(ByteView message)
    : CdrReader(body_of(message), is_big_endian(message), false) {}

CdrReader CdrReader::of_ros1(ByteView message) {
  return {message, false, true};
}

void CdrReader::align(std::size_t size) {
  if (!ros1_) (void)source_.take(padding(size_ - source_.left(), size));
}

std::string CdrReader::string() {
  const std::size_t count = length(1);
  const ByteView text = source_.take(count);
  if (ros1_) return {reinterpret_cast<const char*>(text.data()), count};
  if (count == 0 || text.back() != std::byte{0}) throw DataError("a text has no end");
  return {reinterpret_cast<const char*>(text.data()), count - 1};
}

std::string CdrReader::characters(std::size_t size) {
  const ByteView text = source_.take(size);
  const auto end = std::ranges::find(text, std::byte{0});
  if (end == text.end()) throw DataError("a name has no end");
  return {reinterpret_cast<const char*>(text.data()), static_cast<std::size_t>(end - text.begin())};
}

std::size_t CdrReader::length(std::size_t smallest_element) {
  const auto count = number<std::uint32_t>();
  if (count > source_.left() / smallest_element) {
    throw DataError("a sequence announces " + std::to_string(count) +
                    " elements, more than the message holds");
  }
  return count;
}

}  // namespace cleave::recording
