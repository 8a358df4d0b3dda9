// SPDX-License-Identifier: BSD-3-Clause

/** Nothing came for as long as `timeout` said; the message says what to do. */
export class TimeoutError extends Error {
  override name = "TimeoutError";
}

/** A node speaks another version of the contract, so that its messages would be misread. */
export class ContractError extends Error {
  override name = "ContractError";
}

/** The C library refused; the message is its own words. */
export class LibraryError extends Error {
  override name = "LibraryError";

  /** `code`: of cleave_result, without its CLEAVE_. */
  constructor(message: string, readonly code: string) {
    super(message);
  }
}
