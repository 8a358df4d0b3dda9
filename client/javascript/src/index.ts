// SPDX-License-Identifier: BSD-3-Clause
// Cleave's stream of segments in Node.
export type * from "./contract.js";
export { contract } from "./contract.js";
export { DecodeError, decode } from "./decode.js";
export { EncodeError, encode } from "./encode.js";
export { ContractError, TimeoutError } from "./errors.js";
export type { Options } from "./options.js";
export { type SegmentStream, segments } from "./segments.js";
export { status, statuses } from "./statuses.js";
