// SPDX-License-Identifier: BSD-3-Clause
// The three ways in which .oni files hold a depth image.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace cleave::oni {

enum class Codec {
  none,             // "NONE": 16-bit pixels
  difference,       // "16zP": differences to the pixel before
  difference_table  // "16zT": a table of the values that occur; differences of indices into it
};

// Empty for other codes.
[[nodiscard]] std::optional<Codec> codec_of(std::uint32_t code);
// The code's four characters, for messages.
[[nodiscard]] std::string name_of_codec(std::uint32_t code);

// Fills `pixels` from `data`, or says why it does not hold exactly so many pixels. Never reads
// outside `data`. Deterministic.
//
// The difference codecs (OpenNI2's XnStreamCompression.cpp): a first value of 2 bytes, then codes
//   0xAB  A, B <= 12: two pixels, each its predecessor - (A - 6), - (B - 6)
//   0xAD  one pixel, as above: the last one of an odd number
//   0xAF  one pixel as above, then a full difference as after 0xFF
//   0xEn  2n pixels like the one before
//   0xFF  a full difference: 1 byte, 128 and above: predecessor - (byte - 192); else 2 bytes, the
//         value itself, high byte first
// OpenNI2's encoder writes a last single pixel before the run (0xEn) that precedes it; its decoder
// swaps them in the image. Here they come out in the right order.
[[nodiscard]] std::optional<std::string> decode(Codec codec, std::span<const std::uint8_t> data,
                                                std::span<std::uint16_t> pixels);

}  // namespace cleave::oni
