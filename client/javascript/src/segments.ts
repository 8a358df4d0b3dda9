// SPDX-License-Identifier: BSD-3-Clause
// The segment lists of a sensor.
import type { Topic } from "./connection.js";
import { type FrameHeader, type NodeStatus, type SegmentList, contract } from "./contract.js";
import { decode } from "./decode.js";
import { ContractError } from "./errors.js";
import { type Options, check_sensor } from "./options.js";
import { Reading } from "./reading.js";
import { nobody_answers, other_type, status_of, status_topic } from "./statuses.js";

export interface SegmentStream extends AsyncIterableIterator<SegmentList> {
  /**
   * Frames of which no list came between two that did: lost on the way, dropped by the segmenter
   * (its status counts these), or pushed out because the loop was more than 64 lists behind.
   */
  readonly lost: number;
}

const topic_of = (sensor: string): Topic => ({
  name: `cleave/${sensor}/segments`, type: "SegmentList", depth: 4, transient_local: false,
});

/** Counts what is missing between the frames that it is shown: ids rise by 1 within an epoch. */
export class FrameGaps {
  lost = 0;
  private last: FrameHeader | undefined;

  show(header: FrameHeader): void {
    if (this.last?.epoch === header.epoch && header.frame_id > this.last.frame_id) {
      this.lost += Number(header.frame_id - this.last.frame_id - 1n);
    }
    this.last = header;
  }
}

class SegmentReading extends Reading<SegmentList> implements SegmentStream {
  private readonly gaps = new FrameGaps();
  private readonly nodes = new Map<string, NodeStatus>();
  private unreadable: Error | undefined;

  constructor(private readonly sensor: string, options: Options) {
    check_sensor(sensor);
    super(options, [topic_of(sensor), status_topic]);
  }

  get lost(): number {
    return this.gaps.lost;
  }

  protected override receive(topic: Topic, bytes: Uint8Array): void {
    if (topic !== status_topic) this.queue.push(bytes);
    else this.note_status(bytes);
  }

  protected override other_type(topic: Topic, type: string): void {
    const error = other_type(topic, type);
    if (topic !== status_topic) this.fail(error);
    else this.unreadable = error;
  }

  protected override value(bytes: Uint8Array): SegmentList {
    let list: SegmentList;
    try {
      list = decode("SegmentList", bytes);
    } catch (error) {
      throw new ContractError(
        `a segment list of sensor '${this.sensor}' is not of this package's contract ` +
        `(${contract}): ${(error as Error).message}`,
        { cause: error },
      );
    }
    this.gaps.show(list.header);
    return list;
  }

  protected override late(): string {
    const { domain, malformed } = this.connection;
    const nodes = [...this.nodes.values()].map(({ node, state }) => `${node} (${state})`).sort();
    let text = `no segment list of sensor '${this.sensor}' on domain ${domain} ` +
      `for ${this.timeout_ms} ms: `;
    if (nodes.length === 0) text += this.unreadable?.message ?? nobody_answers;
    else text += `there are ${nodes.join(", ")}: is it the right sensor? \`cleave status\` says more`;
    if (malformed > 0) text += ` (${malformed} messages were not understood)`;
    return text;
  }

  // Nodes of other sensors may be of any contract.
  private note_status(bytes: Uint8Array): void {
    try {
      const status = status_of(bytes);
      this.nodes.set(status.node, status);
    } catch (error) {
      this.unreadable = error as Error;
      const ours = [`segmenter/${this.sensor} `, `grabber/${this.sensor} `];
      if (ours.some((node) => this.unreadable?.message.startsWith(node))) this.fail(error);
    }
  }
}

/**
 * The segment lists of the sensor, from now on, each frame's once and in order. Waits for a sensor
 * that is not there yet, at most `timeout` for each list. The loop's end closes the sockets.
 * Throws a RangeError at once for a wrong name or option; in the loop a TimeoutError, a
 * ContractError when the sensor's nodes are of another version of the contract, and the signal's
 * reason when that is aborted.
 */
export function segments(sensor = "camera", options: Options = {}): SegmentStream {
  return new SegmentReading(sensor, options);
}
