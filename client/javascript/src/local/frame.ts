// SPDX-License-Identifier: BSD-3-Clause
// A cloud, its label map and its segment list.
import type { Border, FrameHeader, Segment, SegmentList } from "../contract.js";
import type { Samples } from "./samples.js";

/**
 * One frame, until it is closed or the next one is asked for: then its arrays are empty and its
 * memory is the camera's again. Its list stays.
 */
export class Frame {
  /** Whether cloud and labels are their writers' own memory. */
  readonly zero_copy: boolean;
  private samples: Samples | undefined;
  private xyz: Float32Array | undefined;
  private label_map: Uint16Array | undefined;

  constructor(samples: Samples, readonly list: SegmentList) {
    this.samples = samples;
    this.zero_copy = samples.zero_copy;
  }

  /** Times, size, intrinsics and pose. */
  get header(): FrameHeader {
    return this.list.header;
  }

  /** In the order of their labels 1, 2, ...: the most points first. */
  get segments(): Segment[] {
    return this.list.segments;
  }

  /** Which segments touch. */
  get borders(): Border[] {
    return this.list.borders;
  }

  /**
   * x, y, z of each point, row-major, 3 * width * height numbers: x right, y down, z forward in
   * metres in header.coordinate_frame, NaN = no measurement. Not to be written: other readers see
   * the same memory.
   */
  get cloud(): Float32Array {
    this.xyz ??= this.open().xyz();
    return this.xyz;
  }

  /** The segment's label of each point, width * height, 0 = no segment. As the cloud. */
  get labels(): Uint16Array {
    this.label_map ??= this.open().label_map();
    return this.label_map;
  }

  /** x, y, z of each of the segment's points in row order, copied. By the segment or its label. */
  points(segment: Segment | number): Float32Array {
    const label = typeof segment === "number" ? segment : segment.label;
    const { cloud, labels } = this;
    let count = 0;
    for (const each of labels) {
      if (each === label) ++count;
    }
    const points = new Float32Array(3 * count);
    for (let i = 0, to = 0; to < points.length; ++i) {
      if (labels[i] !== label) continue;
      for (let axis = 0; axis < 3; ++axis) points[to++] = cloud[3 * i + axis] as number;
    }
    return points;
  }

  /** Gives the memory back. What is asked of the frame's arrays afterwards throws. */
  close(): void {
    this.samples?.release();
    this.samples = this.xyz = this.label_map = undefined;
  }

  [Symbol.dispose](): void {
    this.close();
  }

  private open(): Samples {
    if (this.samples !== undefined) return this.samples;
    throw new Error(
      "the frame is closed, by close() or because the next one was asked for: copy what you keep " +
      "(frame.cloud.slice()) before",
    );
  }
}
