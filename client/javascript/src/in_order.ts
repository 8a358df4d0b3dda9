// SPDX-License-Identifier: BSD-3-Clause
// What a reliable writer sends again arrives late and maybe twice: each sample once, in order.

// As many as a writer of the contract keeps to send again: what is older does not come any more.
const most_waiting = 4;
const longest_wait_ms = 100;  // twice as long as a writer waits for its readers

export class InOrder<Sample> {
  private next: bigint | undefined;
  private readonly waiting = new Map<bigint, Sample>();
  private timer: NodeJS.Timeout | undefined;

  constructor(private readonly deliver: (sample: Sample) => void) {}

  push(sequence: bigint, sample: Sample): void {
    this.next ??= sequence;
    if (sequence < this.next) return;
    this.waiting.set(sequence, sample);
    this.deliver_next();
    while (this.waiting.size > most_waiting) this.skip();
    if (this.waiting.size === 0) this.stop();
    else this.timer ??= setTimeout(() => this.give_up(), longest_wait_ms);
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private give_up(): void {
    this.timer = undefined;
    while (this.waiting.size > 0) this.skip();
  }

  private skip(): void {
    this.next = [...this.waiting.keys()].reduce((least, each) => (each < least ? each : least));
    this.deliver_next();
  }

  private deliver_next(): void {
    while (this.next !== undefined) {
      const sample = this.waiting.get(this.next);
      if (sample === undefined) return;
      this.waiting.delete(this.next++);
      this.deliver(sample);
    }
  }
}
