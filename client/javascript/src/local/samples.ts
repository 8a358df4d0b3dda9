// SPDX-License-Identifier: BSD-3-Clause
// A frame's cloud and label map in the library's hands.
import type { Place, Pointer } from "./functions.js";
import { check } from "./library.js";
import { buffer_of, detach, shows_memory } from "./memory.js";
import type { Stream } from "./stream.js";

let in_place: boolean | undefined;  // asked of the runtime once

// Each buffer keeps the samples that it shows, so that these outlive every array over it.
const keeper = Symbol("samples");
type Kept = ArrayBuffer & { [keeper]?: Samples };

// For frames that nobody closed: by then no array shows them any more.
const forgotten = new FinalizationRegistry<() => void>((release) => release());

export class Samples {
  private readonly buffers: ArrayBuffer[] = [];
  private readonly in_place: boolean;
  private readonly give_back: () => void;

  constructor(
    private readonly stream: Stream, private readonly cloud: Pointer,
    private readonly labels: Pointer,
  ) {
    in_place ??= shows_memory(stream.library.koffi);
    this.in_place = in_place;
    stream.enter();
    this.give_back = (): void => {
      stream.library.cleave_release(cloud);
      stream.library.cleave_release(labels);
      stream.leave();
    };
    forgotten.register(this, this.give_back, this);
  }

  get zero_copy(): boolean {
    const { cleave_sample_zero_copy } = this.stream.library;
    return this.in_place &&
      [this.cloud, this.labels].every((sample) => cleave_sample_zero_copy(sample) !== 0);
  }

  xyz(): Float32Array {
    const [address, count]: [Place<Pointer>, Place<number>] = [[null], [null]];
    const { library } = this.stream;
    check(library, library.cleave_sample_cloud(this.cloud, address, count));
    return new Float32Array(this.buffer(address, 3 * Number(count[0]) * 4));
  }

  label_map(): Uint16Array {
    const [address, count]: [Place<Pointer>, Place<number>] = [[null], [null]];
    const { library } = this.stream;
    check(library, library.cleave_sample_labels(this.labels, address, count, null));
    return new Uint16Array(this.buffer(address, Number(count[0]) * 2));
  }

  /** Empties every array, then gives the memory back. Once. */
  release(): void {
    for (const buffer of this.buffers) detach(buffer);
    forgotten.unregister(this);
    this.give_back();
  }

  private buffer([address]: Place<Pointer>, bytes: number): ArrayBuffer {
    const buffer: Kept = buffer_of(this.stream.library.koffi, address ?? 0n, bytes, this.in_place);
    buffer[keeper] = this;
    this.buffers.push(buffer);
    return buffer;
  }
}
