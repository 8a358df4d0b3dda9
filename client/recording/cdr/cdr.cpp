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

CdrReader::CdrReader(ByteView message) : size_(message.size()), source_(message) {
  if (message.size() < encapsulation.size() ||
      !std::ranges::equal(source_.take(2), ByteView(encapsulation).first(2))) {
    throw DataError("a message is not little-endian CDR");
  }
  (void)source_.take(2);  // options, of no meaning here
}

void CdrReader::align(std::size_t size) {
  const std::size_t position = size_ - source_.left() - encapsulation.size();
  (void)source_.take(padding(position, size));
}

std::string CdrReader::string() {
  const std::size_t count = length(1);
  const ByteView text = source_.take(count);
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
