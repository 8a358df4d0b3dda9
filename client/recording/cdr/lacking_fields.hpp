// SPDX-License-Identifier: BSD-3-Clause
// What a recording of an earlier version of the contract does not have.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace cleave::recording {

// By type of the contract, the names of its fields.
using LackingFields = std::map<std::string, std::set<std::string, std::less<>>, std::less<>>;

// Compares a recording's schema, OMG IDL, with the contract of this version. Fields that were added
// since it was recorded are lacking: they are read as 0, "" and none. Nothing for a schema that
// defines a type of ours in another way: with a field that we do not know, or in another order, or
// of another type. Comments, layout and other types do not matter.
[[nodiscard]] std::optional<LackingFields> lacking_fields(std::string_view schema);

}  // namespace cleave::recording
