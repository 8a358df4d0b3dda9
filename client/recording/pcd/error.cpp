// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/error.hpp"

namespace cleave::recording {

const char* name_of(PcdCause cause) {
  switch (cause) {
    case PcdCause::unreadable:
      return "unreadable";
    case PcdCause::not_pcd:
      return "not PCD";
    case PcdCause::bad_header:
      return "bad header";
    case PcdCause::no_points:
      return "no points";
    case PcdCause::too_many_points:
      return "too many points";
    case PcdCause::truncated:
      return "truncated";
    case PcdCause::damaged_data:
      return "damaged data";
  }
  return "";
}

}  // namespace cleave::recording
