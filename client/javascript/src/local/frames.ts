// SPDX-License-Identifier: BSD-3-Clause
// The frames of a sensor as the event loop takes them: nothing here waits within the library.
import { decode } from "../decode.js";
import { LibraryError, TimeoutError } from "../errors.js";
import { type Options, check_sensor, timeout_of } from "../options.js";
import { Frame } from "./frame.js";
import type { Place, Pointer } from "./functions.js";
import { check } from "./library.js";
import { Samples } from "./samples.js";
import { Stream, type Transport } from "./stream.js";

export interface FrameStream extends AsyncIterableIterator<Frame> {
  /** Samples that were dropped because the rest of their frame did not come. */
  readonly given_up: number;
  /** A foreign writer's that made no sense and were dropped. */
  readonly bad_samples: number;
  /** How clouds and label maps come. */
  readonly transport: Transport;
}

// For loops that nobody ended.
const forgotten = new FinalizationRegistry<() => void>((close) => close());

const turn_of_the_event_loop = (): Promise<void> => new Promise((done) => setImmediate(done));

class FrameReading implements FrameStream {
  bad_samples = 0;
  readonly transport: Transport;
  private readonly stream: Stream;
  private readonly pointer: Pointer;
  private readonly timeout_ms: number | undefined;
  private readonly signal: AbortSignal | undefined;
  private readonly give_back: () => void;
  private readonly wake = (): void => this.stop_waiting?.();
  private stop_waiting: (() => void) | undefined;
  private frame: Frame | undefined;  // the last one
  private last_given_up = 0;
  private waits = false;
  private ended = false;

  constructor(private readonly sensor: string, options: Options) {
    check_sensor(sensor);
    this.timeout_ms = timeout_of(options);
    this.signal = options.signal;
    const stream = Stream.join(options);
    const { library } = stream;
    stream.enter();
    const place: Place<Pointer> = [null];
    try {
      check(library, library.cleave_frames_open(stream.pointer, sensor, place));
    } catch (error) {
      stream.leave();
      throw error;
    }
    const pointer = place[0] ?? 0n;
    [this.stream, this.pointer, this.transport] = [stream, pointer, stream.transport];
    this.give_back = (): void => {
      library.cleave_frames_close(pointer);
      stream.leave();
    };
    forgotten.register(this, this.give_back, this);
  }

  get given_up(): number {
    if (this.ended) return this.last_given_up;
    return Number(this.stream.library.cleave_frames_given_up(this.pointer));
  }

  [Symbol.asyncIterator](): this {
    return this;
  }

  async next(): Promise<IteratorResult<Frame, undefined>> {
    if (this.waits) throw new Error("a frame is being waited for: ask for one after the other");
    this.frame?.close();
    this.waits = true;
    try {
      this.frame = await this.come();
      if (this.frame !== undefined) return { done: false, value: this.frame };
    } catch (error) {
      this.close();
      throw error;
    } finally {
      this.waits = false;
    }
    return { done: true, value: undefined };
  }

  async return(): Promise<IteratorResult<Frame, undefined>> {
    this.close();
    return { done: true, value: undefined };
  }

  private close(): void {
    if (this.ended) return;
    this.last_given_up = this.given_up;
    this.ended = true;
    this.wake();
    this.frame?.close();
    forgotten.unregister(this);
    this.give_back();
  }

  // undefined when the loop has ended.
  private async come(): Promise<Frame | undefined> {
    const begin = performance.now();
    // Also where frames wait already: a loop that is behind would starve everything else.
    await turn_of_the_event_loop();
    while (!this.ended) {
      this.signal?.throwIfAborted();
      const frame = this.take();
      if (typeof frame !== "string") return frame;
      const left = (this.timeout_ms ?? Infinity) - (performance.now() - begin);
      if (left <= 0) throw new TimeoutError(this.late(frame));
      await this.readable(left);
    }
    return undefined;
  }

  // The next frame, or the library's words for why there is none.
  private take(): Frame | string {
    const { library } = this.stream;
    const places: [Place<Pointer>, Place<Pointer>, Place<Pointer>] = [[null], [null], [null]];
    for (;;) {
      try {
        check(library, library.cleave_frames_next(this.pointer, 0, ...places));
        break;
      } catch (error) {
        if (!(error instanceof LibraryError)) throw error;
        if (error.code === "TIMEOUT") return error.message;
        if (error.code !== "BAD_DATA") throw error;
        ++this.bad_samples;
      }
    }
    const [cloud, labels, segments] = places.map(([pointer]) => pointer ?? 0n) as
      [Pointer, Pointer, Pointer];
    const samples = new Samples(this.stream, cloud, labels);
    try {
      return new Frame(samples, decode("SegmentList", this.cdr_of(segments)));
    } catch (error) {
      samples.release();
      throw error;
    } finally {
      library.cleave_release(segments);
    }
  }

  private cdr_of(segments: Pointer): Uint8Array {
    const [bytes, size]: [Place<Pointer>, Place<number>] = [[null], [null]];
    const { library } = this.stream;
    check(library, library.cleave_encode(segments, bytes, size));
    return library.koffi.decode(bytes[0], "uint8_t", Number(size[0])) as Uint8Array;
  }

  // Until something may have come, `wake` is called or the time is over.
  private async readable(timeout_ms: number): Promise<void> {
    const { library } = this.stream;
    const descriptor = library.cleave_frames_fd(this.pointer);
    this.signal?.addEventListener("abort", this.wake);
    await new Promise<void>((resolve) => {
      const poll = library.koffi.node.poll(descriptor, { readable: true }, this.wake);
      const timer = timeout_ms < Infinity ? setTimeout(this.wake, timeout_ms) : undefined;
      this.stop_waiting = (): void => {
        this.stop_waiting = undefined;
        poll.close();
        clearTimeout(timer);
        resolve();
      };
    });
    this.signal?.removeEventListener("abort", this.wake);
  }

  private late(why: string): string {
    return `sensor '${this.sensor}' on domain ${this.stream.domain}, for ${this.timeout_ms} ms: ` +
      `${why}. Start its grabber and cleave-segmenter, or see \`cleave status\` for what runs`;
  }
}

/**
 * The frames of the sensor, from now on, each complete, the oldest first, in shared memory where
 * the camera's grabber and the segmenter wrote them. Each lasts until it is closed, the next one is
 * asked for, or the loop ends. Waits for a sensor that is not there yet, at most `timeout` for each
 * frame. Throws at once for a wrong name or option, where koffi or libcleave-c is missing or of
 * another version, and a LibraryError in the library's words where the stream cannot be joined; in
 * the loop a TimeoutError, a LibraryError, and the signal's reason when that is aborted.
 */
export function frames(sensor = "camera", options: Options = {}): FrameStream {
  return new FrameReading(sensor, options);
}
