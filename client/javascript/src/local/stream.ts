// SPDX-License-Identifier: BSD-3-Clause
// The process's stream: one, shared by all that is opened, left when the last of that is gone.
import { type Options, domain_of } from "../options.js";
import type { Place, Pointer } from "./functions.js";
import { type Library, check, library } from "./library.js";

export interface Transport {
  /** Whether shared memory carries clouds and label maps; else they are copied over loopback. */
  shared_memory: boolean;
  /** Why, or why not. */
  reason: string;
}

let joined: Stream | undefined;

export class Stream {
  private users = 0;

  private constructor(
    readonly library: Library, readonly pointer: Pointer, readonly domain: number,
    private readonly network: string | undefined,
  ) {}

  /** Throws where the options are wrong, or not those of the stream that the process is on. */
  static join(options: Options): Stream {
    const [domain, network] = [domain_of(options), options.interface];
    if (joined === undefined) {
      const stream: Place<Pointer> = [null];
      const asked = { domain, shared_memory: 1 as const, interface: network ?? null };
      check(library(), library().cleave_open(asked, stream));
      joined = new Stream(library(), stream[0] ?? 0n, domain, network);
    } else if (domain !== joined.domain || (network ?? joined.network) !== joined.network) {
      throw new Error(
        `this process reads frames on domain ${joined.domain}, interface ` +
        `${joined.network ?? "not named"}, and can join one stream at a time: end those loops ` +
        "first, or give the same options",
      );
    }
    return joined;
  }

  get transport(): Transport {
    const reason: Place<string> = [null];
    const uses = this.library.cleave_uses_shared_memory(this.pointer, reason);
    return { shared_memory: uses !== 0, reason: reason[0] ?? "" };
  }

  /** What is open on the stream, or of it, is a user. */
  enter(): void {
    ++this.users;
  }

  leave(): void {
    if (--this.users > 0) return;
    joined = undefined;
    this.library.cleave_close(this.pointer);
  }
}
