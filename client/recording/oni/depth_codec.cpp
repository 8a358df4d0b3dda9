// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/depth_codec.hpp"

#include <array>
#include <cctype>
#include <cstring>

#include "recording/mcap/bytes.hpp"

namespace cleave::oni {
namespace {

using recording::ByteSource;
using recording::ByteView;

using Problem = std::optional<std::string>;

constexpr std::uint32_t code(const char (&name)[5]) {
  std::uint32_t value = 0;
  for (unsigned i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(name[i]);
  return value;
}

// Where decoded values go: through the table, and no further than the last pixel.
class Sink {
 public:
  Sink(std::span<std::uint16_t> pixels, std::optional<ByteView> table)
      : pixels_(pixels), table_(table) {}

  [[nodiscard]] bool put(std::uint16_t value, std::size_t count = 1) {
    if (pixels_.size() - filled_ < count) return false;
    if (table_) {
      if (std::size_t{value} * 2 + 2 > table_->size()) return false;
      std::memcpy(&value, table_->data() + std::size_t{value} * 2, sizeof value);
    }
    for (; count > 0; --count) pixels_[filled_++] = value;
    return true;
  }
  [[nodiscard]] bool full() const { return filled_ == pixels_.size(); }

 private:
  std::span<std::uint16_t> pixels_;
  std::optional<ByteView> table_;
  std::size_t filled_ = 0;
};

std::uint16_t minus(std::uint16_t value, int difference) {
  return static_cast<std::uint16_t>(value - difference);
}

constexpr unsigned largest_small = 12;  // differences of -6 to 6, coded as 0 to 12
constexpr unsigned single = 0xD;
constexpr unsigned escape = 0xF;

// One code after the other; `value` is the pixel before, or its index in the table.
class DifferenceDecoder {
 public:
  DifferenceDecoder(ByteSource bytes, Sink& sink, std::uint16_t first)
      : bytes_(bytes), sink_(sink), value_(first) {}

  // False: `data` holds a code that there is not, ends within one, or does not fit.
  [[nodiscard]] bool run() {
    if (!sink_.put(value_)) return false;
    while (const auto next = bytes_.try_number<std::uint8_t>()) {
      if (!decode(*next)) return false;
    }
    return true;
  }

 private:
  bool decode(unsigned next) {
    const unsigned high = next >> 4U;
    const unsigned low = next & 0xFU;
    if (next == 0xFF) return full();
    if (high == 0xE) return sink_.put(value_, std::size_t{2} * low);
    if (high > largest_small) return false;
    if (low == single) return last_run() && small(high);
    if (!small(high)) return false;
    if (low == escape) return full();
    return low <= largest_small && small(low);
  }
  bool small(unsigned coded) {
    value_ = minus(value_, static_cast<int>(coded) - 6);
    return sink_.put(value_);
  }
  bool full() {
    const auto first = bytes_.try_number<std::uint8_t>();
    if (!first) return false;
    if (*first >= 0x80) {
      value_ = minus(value_, *first - 192);
    } else {
      const auto second = bytes_.try_number<std::uint8_t>();
      if (!second) return false;
      value_ = static_cast<std::uint16_t>(*first << 8 | *second);
    }
    return sink_.put(value_);
  }
  // The run that belongs before the single last pixel although it is written behind it.
  bool last_run() {
    const auto run = bytes_.try_number<std::uint8_t>();
    if (!run) return true;
    return *run >> 4 == 0xE && bytes_.left() == 0 &&
           sink_.put(value_, std::size_t{2} * (*run & 0xF));
  }

  ByteSource bytes_;
  Sink& sink_;
  std::uint16_t value_;
};

Problem decode_raw(std::span<const std::uint8_t> data, std::span<std::uint16_t> pixels) {
  if (data.size() != pixels.size_bytes()) {
    return std::to_string(data.size()) + " bytes where the image has " +
           std::to_string(pixels.size_bytes());
  }
  std::memcpy(pixels.data(), data.data(), data.size());
  return std::nullopt;
}

}  // namespace

std::optional<Codec> codec_of(std::uint32_t value) {
  if (value == code("NONE")) return Codec::none;
  if (value == code("16zP")) return Codec::difference;
  if (value == code("16zT")) return Codec::difference_table;
  return std::nullopt;
}

std::string name_of_codec(std::uint32_t value) {
  std::string name;
  for (unsigned i = 0; i < 4; ++i) {
    const int c = static_cast<int>(value >> (8 * i) & 0xFFU);
    name += std::isprint(c) != 0 ? static_cast<char>(c) : '?';
  }
  return name;
}

Problem decode(Codec codec, std::span<const std::uint8_t> data, std::span<std::uint16_t> pixels) {
  if (codec == Codec::none) return decode_raw(data, pixels);
  ByteSource bytes(std::as_bytes(data));
  std::optional<ByteView> table;
  if (codec == Codec::difference_table) {
    const auto entries = bytes.try_number<std::uint16_t>();
    if (entries) table = bytes.try_take(std::size_t{*entries} * 2);
    if (!table) return "the image is shorter than its table of values";
  }
  const auto first = bytes.try_number<std::uint16_t>();
  if (!first) return "the image has no pixel";
  Sink sink(pixels, table);
  if (!DifferenceDecoder(bytes, sink, *first).run()) return "the compressed image is damaged";
  if (!sink.full()) return "the image ends before its last pixel";
  return std::nullopt;
}

}  // namespace cleave::oni
