// SPDX-License-Identifier: BSD-3-Clause
// How the nodes of the stream are: each one twice a second, or all of them once.
import type { Topic } from "./connection.js";
import { type NodeStatus, contract } from "./contract.js";
import { decode } from "./decode.js";
import { ContractError, TimeoutError } from "./errors.js";
import type { Options } from "./options.js";
import { Reading } from "./reading.js";

export const status_topic: Topic = {
  name: "cleave/status", type: "NodeStatus", depth: 1, transient_local: true,
};

/** Throws a ContractError when the node, or a node that cannot be understood, is of another one. */
export function status_of(bytes: Uint8Array): NodeStatus {
  let status: NodeStatus;
  try {
    status = decode("NodeStatus", bytes);
  } catch (error) {
    throw new ContractError(
      `a node's status is not of this package's contract (${contract}): ` +
      (error as Error).message,
      { cause: error },
    );
  }
  if (status.contract !== contract) {
    throw new ContractError(
      `${status.node} speaks the contract '${status.contract}', this package ${contract}: ` +
      "install the cleave-client of the node's version",
    );
  }
  return status;
}

export function other_type(topic: Topic, type: string): ContractError {
  return new ContractError(
    `a node writes ${topic.name} as ${type}, which is not of this package's contract ` +
    `(${contract}): install the cleave-client of the node's version`,
  );
}

export const nobody_answers =
  "no node answers there: start cleave-segmenter and cleave-grabber, or say which domain is " +
  "theirs (the option `domain`, or CLEAVE_DOMAIN)";

class StatusReading extends Reading<NodeStatus> {
  constructor(options: Options) {
    super(options, [status_topic]);
  }
  protected override receive(_topic: Topic, bytes: Uint8Array): void {
    this.queue.push(bytes);
  }
  protected override other_type(topic: Topic, type: string): void {
    this.fail(other_type(topic, type));
  }
  protected override value(bytes: Uint8Array): NodeStatus {
    return status_of(bytes);
  }
  protected override late(): string {
    return `no status on domain ${this.connection.domain} for ${this.timeout_ms} ms: ` +
      nobody_answers;
  }
}

/**
 * Statuses as they come: of every node the last one, then each node's twice a second. Waits for
 * nodes that are not there yet, at most `timeout`.
 */
export function statuses(options: Options = {}): AsyncIterableIterator<NodeStatus> {
  return new StatusReading(options);
}

const first_wait_ms = 2000;
const collecting_ms = 1000;  // each node tells twice in it

/**
 * The nodes that answer now, by name; it takes a second. Throws a TimeoutError when none answers
 * for `timeout`, or two seconds.
 */
export async function status(options: Options = {}): Promise<NodeStatus[]> {
  const nodes = new Map<string, NodeStatus>();
  const reading = statuses({ ...options, timeout: options.timeout ?? first_wait_ms });
  let end: number | undefined;
  try {
    for await (const each of reading) {
      nodes.set(each.node, each);
      end ??= performance.now() + collecting_ms;
      if (performance.now() >= end) break;
    }
  } catch (error) {
    if (nodes.size === 0 || !(error instanceof TimeoutError)) throw error;
  }
  return [...nodes.values()].sort((a, b) => (a.node < b.node ? -1 : 1));
}
