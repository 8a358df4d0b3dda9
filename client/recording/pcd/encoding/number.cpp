// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/encoding/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace cleave::recording {
namespace {

template <class Number>
struct Parsed {
  Number value{};
  std::errc error{};
};

template <class Number>
Parsed<Number> parse(std::string_view word) {
  Parsed<Number> parsed;
  const char* const end = word.data() + word.size();
  const auto [stopped, error] = std::from_chars(word.data(), end, parsed.value);
  parsed.error = stopped == end ? error : std::errc::invalid_argument;
  return parsed;
}

// Of a number that double has no room for: is it too large, and not too small? The power of ten of
// its first digit tells.
bool is_huge(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  const std::string_view digits = word.substr(0, e);
  std::int64_t exponent = 0;
  if (e != std::string_view::npos) {
    word.remove_prefix(e + 1);
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto parsed = parse<std::int32_t>(word);
    if (parsed.error == std::errc::result_out_of_range) return !word.starts_with('-');
    exponent = parsed.value;
  }
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<std::int64_t>(digits.find_first_of("123456789"));
  return point - first + exponent > 0;
}

// A number beyond the range of double becomes an infinity, or 0 below it.
std::optional<double> real(std::string_view word) {
  const auto parsed = parse<double>(word);
  if (parsed.error == std::errc()) return parsed.value;
  if (parsed.error != std::errc::result_out_of_range) return std::nullopt;
  const double value = is_huge(word) ? std::numeric_limits<double>::infinity() : 0;
  return word.starts_with('-') ? -value : value;
}

template <class Number>
const char* write_real(std::string_view word, std::uint8_t* to) {
  const std::optional<double> value = real(word);
  if (!value) return "is no number";
  const auto rounded = static_cast<Number>(*value);
  std::memcpy(to, &rounded, sizeof rounded);
  return nullptr;
}

// The low bits of a whole number from -2^63 to 2^64 - 1, and whether they are enough for it.
struct Whole {
  std::uint64_t bits = 0;
  bool is_negative = false;

  [[nodiscard]] bool fits(std::uint32_t bytes) const {
    if (bytes == sizeof(bits)) return true;
    const std::uint64_t limit = std::uint64_t{1} << (8 * bytes);
    return is_negative ? ~bits < limit / 2 : bits < limit;
  }
};

std::optional<Whole> whole_of(double value) {
  constexpr double two_to_63 = 9223372036854775808.0;
  if (std::isnan(value)) return Whole{};
  if (value != std::trunc(value) || value < -two_to_63 || value >= 2 * two_to_63) {
    return std::nullopt;
  }
  if (value < 0) return Whole{static_cast<std::uint64_t>(static_cast<std::int64_t>(value)), true};
  return Whole{static_cast<std::uint64_t>(value), false};
}

const char* write_whole(std::string_view word, std::uint32_t bytes, std::uint8_t* to) {
  std::optional<Whole> whole;
  if (const auto positive = parse<std::uint64_t>(word); positive.error == std::errc()) {
    whole = Whole{positive.value, false};
  } else if (const auto any = parse<std::int64_t>(word); any.error == std::errc()) {
    whole = Whole{static_cast<std::uint64_t>(any.value), any.value < 0};
  } else {
    const auto decimal = real(word);
    if (!decimal) return "is no number";
    whole = whole_of(*decimal);
    if (!whole) return "is no whole number that it can hold";
  }
  if (!whole->fits(bytes)) return "does not fit into it";
  std::memcpy(to, &whole->bits, bytes);  // little-endian, as PCD is
  return nullptr;
}

}  // namespace

const char* write_number(std::string_view word, const PcdField& field, std::uint8_t* to) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if (field.type != 'F') return write_whole(word, field.size, to);
  return field.size == sizeof(float) ? write_real<float>(word, to) : write_real<double>(word, to);
}

}  // namespace cleave::recording
