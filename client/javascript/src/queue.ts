// SPDX-License-Identifier: BSD-3-Clause
// Between what arrives and a loop that awaits: bounded, the oldest makes room.
import { TimeoutError } from "./errors.js";

interface Waiter<Item> {
  resolve: (item: Item | undefined) => void;
  reject: (reason: unknown) => void;
  timer: NodeJS.Timeout | undefined;
}

export class Queue<Item> {
  private readonly items: Item[] = [];
  private readonly waiters: Waiter<Item>[] = [];
  private ended = false;
  private failure: { reason: unknown } | undefined;

  constructor(private readonly capacity: number) {}

  push(item: Item): void {
    if (this.ended) return;
    const waiter = this.waiters.shift();
    if (waiter !== undefined) {
      clearTimeout(waiter.timer);
      waiter.resolve(item);
      return;
    }
    if (this.items.push(item) > this.capacity) this.items.shift();
  }

  /** undefined when the queue has ended. `late` says what to tell after `timeout_ms` without. */
  async take(timeout_ms: number | undefined, late: () => string): Promise<Item | undefined> {
    if (this.items.length > 0) return this.items.shift();
    if (this.failure !== undefined) {
      const { reason } = this.failure;
      this.failure = undefined;
      throw reason;
    }
    if (this.ended) return undefined;
    return new Promise((resolve, reject) => {
      const waiter: Waiter<Item> = { resolve, reject, timer: undefined };
      if (timeout_ms !== undefined) {
        waiter.timer = setTimeout(() => {
          this.waiters.splice(this.waiters.indexOf(waiter), 1);
          reject(new TimeoutError(late()));
        }, timeout_ms);
      }
      this.waiters.push(waiter);
    });
  }

  /** What waits gets undefined, and so does who comes later; what is queued is gone. */
  end(): void {
    this.ended = true;
    this.items.length = 0;
    for (const waiter of this.waiters.splice(0)) {
      clearTimeout(waiter.timer);
      waiter.resolve(undefined);
    }
  }

  /** Ends it; one who waits, or else the next one to come, is thrown `reason`. */
  fail(reason: unknown): void {
    if (this.ended) return;
    const waiter = this.waiters.shift();
    if (waiter === undefined) {
      this.failure = { reason };
    } else {
      clearTimeout(waiter.timer);
      waiter.reject(reason);
    }
    this.end();
  }
}
