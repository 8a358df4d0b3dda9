// SPDX-License-Identifier: BSD-3-Clause
// What can go wrong with a recording.
#pragma once

#include <stdexcept>

namespace cleave::recording {

// A file cannot be opened, read or written: names it, says why and what to do.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Some bytes are not what they should be: says what is wrong, not where.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// An input or a choice that nothing here knows what to do with: says what there is.
class UnknownInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace cleave::recording
