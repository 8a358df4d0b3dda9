/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A libcleave-c of a version that no client knows. */
#include <stdint.h>

uint32_t cleave_abi_version(void);

uint32_t cleave_abi_version(void) {
  return 999;
}
