// SPDX-License-Identifier: BSD-3-Clause
// The contract's IDL, as far as its tests need it: what each struct and enumeration holds.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace cleave::test {

struct IdlMember {
  std::string type;  // as written, e.g. "unsigned long long"; "string" of char arrays, too
  std::string name;
  bool operator==(const IdlMember&) const = default;
};

struct IdlFile {
  std::map<std::string, std::vector<IdlMember>> structs;
  std::map<std::string, std::vector<std::string>> enumerations;
};

// idl/cleave_v1.idl. Throws std::runtime_error where it cannot be read.
[[nodiscard]] IdlFile read_contract();

// For messages.
void PrintTo(const IdlMember& member, std::ostream* to);

}  // namespace cleave::test
