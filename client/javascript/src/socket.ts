// SPDX-License-Identifier: BSD-3-Clause
// A UDP socket as the RTPS participant wants it. Cleave's domains have no multicast on loopback, so
// what is meant for the group goes to the discovery port of each process that may be there; and a
// datagram that is not RTPS, or a network that is down, must not end the program.
import dgram from "node:dgram";

import type { Address } from "./options.js";
import type { UdpAddress, UdpRemoteInfo, UdpSocket } from "./vendor/rtps.js";

const group = "239.255.0.1";
const first_unicast_offset = 10;  // 7410 + 250 * domain, then every second port
const participants = 61;          // as many as libcleave lets a machine have
const receive_buffer_bytes = 4 << 20;

type Handler = (...values: never[]) => void;

export class Socket implements UdpSocket {
  private readonly socket: dgram.Socket;
  private closed = false;

  constructor(private readonly network: Address) {
    this.socket = dgram.createSocket({
      type: "udp4", reuseAddr: true, recvBufferSize: receive_buffer_bytes,
    });
  }

  // Bound to the interface; for the group to the port that all processes share.
  async bind(options: { port?: number }): Promise<void> {
    const shared = options.port !== undefined && !this.network.loopback;
    await new Promise<void>((resolve, reject) => {
      this.socket.once("error", reject);
      this.socket.bind(
        shared ? { port: options.port } : { port: 0, address: this.network.address },
        () => {
          this.socket.removeListener("error", reject);
          resolve();
        },
      );
    });
  }

  on(event: string, listener: Handler): this {
    if (event !== "message") {
      this.socket.on(event, listener as () => void);
      return this;
    }
    const deliver = listener as unknown as (data: Uint8Array, from: UdpRemoteInfo) => void;
    this.socket.on("message", (data, from) => {
      try {
        deliver(data, from as UdpRemoteInfo);
      } catch (error) {
        this.socket.emit("error", error);
      }
    });
    return this;
  }

  async localAddress(): Promise<UdpAddress | undefined> {
    return this.socket.address();
  }
  async remoteAddress(): Promise<UdpAddress | undefined> {
    return undefined;
  }

  async send(
    data: Uint8Array, offset: number, length: number, port: number, address: string,
  ): Promise<void> {
    const datagram = data.subarray(offset, offset + length);
    if (!this.network.loopback || address !== group) {
      await this.send_to(datagram, port, address);
      return;
    }
    const sent: Promise<void>[] = [];
    for (let i = 0; i < participants; ++i) {
      const peer = port + first_unicast_offset + 2 * i;
      sent.push(this.send_to(datagram, peer, this.network.address));
    }
    await Promise.all(sent);
  }

  // What cannot be sent is lost, as anything on a network may be: RTPS sends it again.
  private async send_to(data: Uint8Array, port: number, address: string): Promise<void> {
    if (this.closed) return;
    await new Promise<void>((resolve) => this.socket.send(data, port, address, () => resolve()));
  }

  async addMembership(multicast: string): Promise<void> {
    if (this.network.loopback) return;
    this.socket.addMembership(multicast, this.network.address);
    this.socket.setMulticastInterface(this.network.address);
  }
  async dropMembership(): Promise<void> {}
  async setBroadcast(): Promise<void> {}
  async setMulticastInterface(): Promise<void> {}
  async setMulticastLoopback(): Promise<void> {}
  async setMulticastTTL(): Promise<void> {}

  async close(): Promise<void> {
    if (this.closed) return;
    this.closed = true;
    await new Promise<void>((resolve) => this.socket.close(() => resolve()));
  }
  async dispose(): Promise<void> {
    await this.close();
  }
}
