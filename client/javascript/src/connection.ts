// SPDX-License-Identifier: BSD-3-Clause
// A participant of the public domain that reads topics of the contract.
import { type Types, schema } from "./contract.js";
import { InOrder } from "./in_order.js";
import { type Options, address_of, domain_of } from "./options.js";
import { Socket } from "./socket.js";
import {
  Durability, HistoryKind, Participant, Reliability, type SubscribeOpts, type UserData,
} from "./vendor/rtps.js";

export interface Topic {
  name: string;
  type: keyof Types;
  depth: number;
  /** Who joins late gets the last sample of each instance. */
  transient_local: boolean;
}

export interface Listener {
  sample(topic: Topic, bytes: Uint8Array): void;
  /** A writer of one of the topics has another type. */
  other_type(topic: Topic, type: string): void;
}

const dds_type = (topic: Topic): string => `${schema.module}::${topic.type}`;

// Nodes that start later are found, and those that lost sight of this process find it again.
const announcement_ms = 500;

export class Connection {
  readonly domain: number;
  /** Datagrams and submessages that were not understood. */
  malformed = 0;
  private readonly sockets: Socket[] = [];
  private readonly orders = new Map<string, InOrder<Uint8Array>>();
  private readonly participant: Participant;
  private announcements: NodeJS.Timeout | undefined;
  private closed = false;

  /** Throws where the options are wrong; opens nothing yet. */
  constructor(
    options: Options, private readonly topics: Topic[], private readonly listener: Listener,
  ) {
    this.domain = domain_of(options);
    const network = address_of(options);
    this.participant = new Participant({
      name: "cleave-client",
      addresses: [network.address],
      domainId: this.domain,
      udpSocketCreate: async () => {
        const socket = new Socket(network);
        this.sockets.push(socket);
        return socket;
      },
    });
    this.participant.on("error", () => ++this.malformed);
    this.participant.on("userData", (data) => this.receive(data));
    this.participant.on("discoveredPublication", ({ topicName, typeName }) => {
      const topic = this.topics.find((each) => each.name === topicName);
      if (topic !== undefined && typeName !== undefined && typeName !== dds_type(topic)) {
        this.listener.other_type(topic, typeName);
      }
    });
  }

  async open(): Promise<void> {
    await this.participant.start();
    if (this.closed) {
      await this.release();
      return;
    }
    for (const topic of this.topics) this.participant.subscribe(subscription(topic));
    this.announcements = setInterval(() => {
      void this.participant.broadcastParticipant(this.participant.attributes);
    }, announcement_ms);
  }

  async close(): Promise<void> {
    if (this.closed) return;
    this.closed = true;
    await this.release();
  }

  private async release(): Promise<void> {
    clearInterval(this.announcements);
    for (const order of this.orders.values()) order.stop();
    await this.participant.shutdown();
    await Promise.all(this.sockets.map((socket) => socket.close()));
  }

  private receive(data: UserData): void {
    const { publication, subscription, writerSeqNumber, serializedData } = data;
    const topic = this.topics.find((each) => each.name === subscription.topicName);
    if (this.closed || topic === undefined || tells_of_an_end(serializedData)) return;
    const writer = `${publication.guidPrefix}${publication.entityId}`;
    let order = this.orders.get(writer);
    if (order === undefined) {
      order = new InOrder((bytes) => this.listener.sample(topic, bytes));
      this.orders.set(writer, order);
    }
    order.push(writerSeqNumber, serializedData);
  }
}

// Not a sample but its writer's word that an instance is gone: parameters (PID_KEY_HASH,
// PID_STATUS_INFO) where a sample has its encapsulation.
function tells_of_an_end(bytes: Uint8Array): boolean {
  const id = (bytes[0] ?? 0) | (bytes[1] ?? 0);
  return id === 0x70 || id === 0x71;
}

function subscription(topic: Topic): SubscribeOpts {
  const options = {
    topicName: topic.name,
    typeName: dds_type(topic),
    durability: topic.transient_local ? Durability.TransientLocal : Durability.Volatile,
    reliability: { kind: Reliability.Reliable, maxBlockingTime: { sec: 0, nsec: 100_000_000 } },
    history: { kind: HistoryKind.KeepLast, depth: topic.depth },
    keyed: schema.structs[topic.type]?.keyed ?? false,  // what build/bundle_rtps.mjs adds
  };
  return options;
}
