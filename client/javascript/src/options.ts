// SPDX-License-Identifier: BSD-3-Clause
// What a reader can be told, and the rules for it.
import { networkInterfaces } from "node:os";

export interface Options {
  /** DDS domain, 0 to 99; else the environment's CLEAVE_DOMAIN, else 0. */
  domain?: number;
  /**
   * Network interface, by name or IPv4 address: the daemons' `public_interface`; else the
   * environment's CLEAVE_INTERFACE, else "lo".
   */
  interface?: string;
  /** Ends the reading: what waits throws the signal's reason. */
  signal?: AbortSignal;
  /** Longest wait for the next one, in milliseconds; then a TimeoutError. None: for ever. */
  timeout?: number;
}

const max_domain = 99;

/** Throws a RangeError that names where the number came from. */
export function domain_of(options: Options): number {
  const set = process.env["CLEAVE_DOMAIN"];
  if (options.domain === undefined && set === undefined) return 0;
  const domain = options.domain ?? (/^\d+$/.test(set ?? "") ? Number(set) : NaN);
  if (!Number.isInteger(domain) || domain < 0 || domain > max_domain) {
    throw options.domain !== undefined
      ? new RangeError(`domain: expected a number from 0 to 99, found ${options.domain}`)
      : new RangeError(`CLEAVE_DOMAIN: expected a number from 0 to 99, found '${set}'`);
  }
  return domain;
}

export interface Address {
  address: string;
  /** On loopback there is no multicast: every port that a process may have is asked. */
  loopback: boolean;
}

/** Throws an Error with the interfaces that there are. */
export function address_of(options: Options): Address {
  const wanted = options.interface ?? process.env["CLEAVE_INTERFACE"] ?? "lo";
  if (wanted === "lo" || wanted === "127.0.0.1") return { address: "127.0.0.1", loopback: true };
  const there: string[] = [];
  for (const [name, addresses] of Object.entries(networkInterfaces())) {
    for (const { family, address, internal } of addresses ?? []) {
      if (family !== "IPv4") continue;
      if (wanted === name || wanted === address) return { address, loopback: internal };
      there.push(`${name} (${address})`);
    }
  }
  throw new Error(
    `no network interface '${wanted}' with an IPv4 address; there are ${there.join(", ")}`,
  );
}

export function timeout_of(options: Options): number | undefined {
  const { timeout } = options;
  if (timeout !== undefined && !(timeout > 0)) {
    throw new RangeError(`timeout: expected milliseconds above 0, found ${timeout}`);
  }
  return timeout;
}

/** A sensor's name is part of topic names, so DDS has a say. */
export function check_sensor(sensor: string): void {
  if (!/^[A-Za-z0-9_]{1,63}$/.test(sensor)) {
    throw new RangeError(`sensor '${sensor}': expected 1 to 63 letters, digits or '_'`);
  }
}
