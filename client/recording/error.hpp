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

}  // namespace cleave::recording
