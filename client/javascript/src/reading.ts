// SPDX-License-Identifier: BSD-3-Clause
// A loop over what arrives: joins the domain at the first turn, leaves it when the loop ends.
import { Connection, type Listener, type Topic } from "./connection.js";
import { type Options, timeout_of } from "./options.js";
import { Queue } from "./queue.js";

// A second of a camera of 60 Hz, for a loop whose turn takes long once.
const capacity = 64;

export abstract class Reading<Value> implements AsyncIterableIterator<Value> {
  protected readonly connection: Connection;
  protected readonly timeout_ms: number | undefined;
  protected readonly queue = new Queue<Uint8Array>(capacity);
  private readonly signal: AbortSignal | undefined;
  private opened: Promise<void> | undefined;
  private readonly abort = (): void => this.fail(this.signal?.reason);

  constructor(options: Options, topics: Topic[]) {
    this.timeout_ms = timeout_of(options);
    this.signal = options.signal;
    const listener: Listener = {
      sample: (topic, bytes) => this.receive(topic, bytes),
      other_type: (topic, type) => this.other_type(topic, type),
    };
    this.connection = new Connection(options, topics, listener);
  }

  [Symbol.asyncIterator](): this {
    return this;
  }

  async next(): Promise<IteratorResult<Value, undefined>> {
    try {
      this.opened ??= this.open();
      await this.opened;
      const bytes = await this.queue.take(this.timeout_ms, () => this.late());
      if (bytes !== undefined) return { done: false, value: this.value(bytes) };
    } catch (error) {
      await this.close();
      throw error;
    }
    await this.close();
    return { done: true, value: undefined };
  }

  async return(): Promise<IteratorResult<Value, undefined>> {
    await this.close();
    return { done: true, value: undefined };
  }

  /** A sample came: to be queued, or looked at. Must not throw. */
  protected abstract receive(topic: Topic, bytes: Uint8Array): void;
  protected abstract other_type(topic: Topic, type: string): void;
  /** Of what was queued; a throw ends the loop. */
  protected abstract value(bytes: Uint8Array): Value;
  /** What to say when nothing came for `timeout_ms`. */
  protected abstract late(): string;

  protected fail(reason: unknown): void {
    this.queue.fail(reason);
    void this.close();
  }

  private async open(): Promise<void> {
    this.signal?.throwIfAborted();
    this.signal?.addEventListener("abort", this.abort, { once: true });
    await this.connection.open();
  }

  private async close(): Promise<void> {
    this.signal?.removeEventListener("abort", this.abort);
    this.queue.end();
    await this.connection.close();
  }
}
