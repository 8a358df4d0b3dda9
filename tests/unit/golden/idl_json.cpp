// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/golden/idl_json.hpp"

#include "tests/unit/idl/idl_file.hpp"

namespace cleave::test {

std::string enumerator(const std::string& enumeration, std::size_t index) {
  static const IdlFile contract = read_contract();
  return contract.enumerations.at(enumeration).at(index);
}

}  // namespace cleave::test
