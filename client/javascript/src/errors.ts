// SPDX-License-Identifier: BSD-3-Clause

/** Nothing came for as long as `timeout` said; the message says what to do. */
export class TimeoutError extends Error {
  override name = "TimeoutError";
}

/** A node speaks another version of the contract, so that its messages would be misread. */
export class ContractError extends Error {
  override name = "ContractError";
  /** The node, where its status could be read so far. */
  readonly node: string | undefined;

  constructor(message: string, options: { cause?: unknown; node?: string } = {}) {
    super(message, options);
    this.node = options.node;
  }
}
