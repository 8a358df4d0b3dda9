// SPDX-License-Identifier: BSD-3-Clause
// Clouds and label maps, on the machine of the camera: needs koffi and libcleave-c.
export { LibraryError, TimeoutError } from "../errors.js";
export type { Options } from "../options.js";
export type { Frame } from "./frame.js";
export { type FrameStream, frames } from "./frames.js";
export type { Transport } from "./stream.js";
