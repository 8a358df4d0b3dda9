// SPDX-License-Identifier: BSD-3-Clause
// One source for the few loops that most time goes into, compiled for more than one instruction
// set; the program picks when it starts.
#pragma once

// Results are the same whichever is picked: every operation rounds as IEEE 754 says, and without
// fused multiply-add (-ffp-contract=off) both sets have the same operations.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(CLEAVE_SINGLE_VERSION)
#define CLEAVE_MULTIVERSION __attribute__((target_clones("avx2", "default")))
#else
#define CLEAVE_MULTIVERSION
#endif
