// SPDX-License-Identifier: BSD-3-Clause
// What build/bundle_rtps.mjs writes beside the compiled sources.
export * from "@foxglove/rtps";
