/** A server of a few lines for one client: a script says what it answers. */

import assert from 'node:assert/strict';
import { createServer, type AddressInfo, type Socket } from 'node:net';
import { player } from '../src/generated/index.js';
import { connect, Kind, type Client, type ClientOptions, type MessageType, type PlayerError } from '../src/index.js';
import { decodeHeader, encodeHeader, HEADER_BYTES, type Header } from '../src/wire.js';
import type { Message } from '../src/connection.js';

const kBanner = Buffer.from('Player v.3.1.1'.padEnd(32, '\0'));

export type Script = (peer: Peer) => Promise<void> | void;
export type Rounds = (peer: Peer, message: Message) => Promise<void> | void;

/** Thrown by a script: the server closes the connection. */
export class Leave extends Error {}

/** The server's end of the connection, for scripts. */
export class Peer {
  /** Every message of the client so far. */
  readonly received: Message[] = [];
  private bytes = Buffer.alloc(0);
  private ended = false;
  private wake = (): void => {};

  constructor(readonly socket: Socket) {
    socket.on('data', (chunk) => {
      this.bytes = Buffer.concat([this.bytes, chunk]);
      this.wake();
    });
    for (const event of ['end', 'error', 'close']) {
      socket.on(event, () => {
        this.ended = true;
        this.wake();
      });
    }
  }

  get port(): number {
    return this.socket.localPort!;
  }

  /** The client's next message, undefined at its end. */
  async receive(): Promise<Message | undefined> {
    const head = await this.exactly(HEADER_BYTES);
    if (!head) return undefined;
    const header = decodeHeader(head);
    const body = await this.exactly(header.size);
    if (!body) return undefined;
    const message = { header, body };
    this.received.push(message);
    return message;
  }

  send(data: Uint8Array): void {
    this.socket.write(data);
  }

  answer({ header }: Message, kind: number = Kind.ACK, body: Uint8Array = new Uint8Array(), sequence = header.sequence): void {
    this.say(header.interface, header.index, kind, header.subtype, body, { sequence, robot: this.port });
  }

  data<T>(message: MessageType<T>, value: Partial<T>, { index = 0, timestamp = 1 } = {}): void {
    this.say(message.interface, index, message.kind, message.subtype, message.payload!.encode(value), { timestamp });
  }

  /** Ends a round, with a number of lost messages or without. */
  synch(lost?: number): void {
    const body = lost === undefined ? new Uint8Array() : player.SYNCH_OVERFLOW.payload!.encode({ value: lost });
    this.say(player.CODE, 0, Kind.SYNCH, lost === undefined ? 1 : 2, body);
  }

  say(code: number, index: number, kind: number, subtype: number, body: Uint8Array, more: Partial<Header> = {}): void {
    const header = { interface: code, index, kind, subtype, timestamp: 1, sequence: 0, host: 0, robot: 0, ...more, size: body.length };
    this.send(Buffer.concat([encodeHeader(header), body]));
  }

  /** Acknowledges what every client asks (modes, opening, closing) and leaves the rest to `rounds`. */
  async serve(rounds: Rounds): Promise<void> {
    for (let message = await this.receive(); message; message = await this.receive()) {
      const { interface: code, subtype } = message.header;
      const opens = subtype === player.REQ_DEV.subtype;
      if (code === player.CODE && (opens || subtype === player.REQ_DATAMODE.subtype)) {
        this.answer(message, Kind.ACK, opens ? message.body : new Uint8Array());
      } else {
        await rounds(this, message);
      }
    }
  }

  private async exactly(size: number): Promise<Buffer | undefined> {
    while (this.bytes.length < size) {
      if (this.ended) return undefined;
      await new Promise<void>((resolve) => (this.wake = resolve));
    }
    const taken = this.bytes.subarray(0, size);
    this.bytes = this.bytes.subarray(size);
    return taken;
  }
}

export interface FakeServer {
  /** HOST:PORT. */
  address: string;
  /** Every message of the client so far. */
  received(): Message[];
}

/** Serves one client by a script, on a free port, while `use` runs; then waits for the script, and fails as it did. */
export async function withServer(script: Script, use: (server: FakeServer) => Promise<void>, banner = kBanner): Promise<void> {
  let peer: Peer | undefined;
  let ended: Promise<unknown> = Promise.resolve();
  const listener = createServer({ noDelay: true, allowHalfOpen: true }, (socket) => {
    peer = new Peer(socket);
    peer.send(banner);
    const run = async (made: Peer): Promise<void> => script(made);
    ended = run(peer).catch((error: unknown) => error).finally(() => socket.destroySoon());
  });
  await new Promise<void>((resolve) => listener.listen(0, '127.0.0.1', resolve));
  const { port } = listener.address() as AddressInfo;
  try {
    await use({ address: `127.0.0.1:${port}`, received: () => peer?.received ?? [] });
  } catch (error) {
    peer?.socket.destroy();
    throw error;
  } finally {
    listener.close();
  }
  const failure = await ended;
  if (failure !== undefined && !(failure instanceof Leave)) throw failure;
}

/** A client of a server that acknowledges what every client asks, and does the rest by `rounds`. */
export function withClient(
  rounds: Rounds, use: (client: Client, server: FakeServer) => Promise<void>, options?: ClientOptions,
): Promise<void> {
  return withServer((peer) => peer.serve(rounds), async (server) => {
    const client = await connect(server.address, options);
    try {
      await use(client, server);
    } finally {
      await client.close();
    }
  });
}

type Fault = new (...values: never[]) => PlayerError;

/** Insists on an error of this class with such a line. */
export async function fails(act: () => unknown, kind: Fault, line: RegExp): Promise<void> {
  await assert.rejects(async () => act(), (error: Error) => {
    assert.ok(error instanceof kind, `${error.name}: ${error.message}`);
    assert.match(error.message, line);
    return true;
  });
}

/** The first value of updates(). */
export async function first<T>(updates: AsyncGenerator<T, never, void>): Promise<T> {
  return (await updates.next()).value;
}

/** Answers of a round: what it says, then its end. */
export function round(say: (peer: Peer) => void): Rounds {
  return (peer, message) => {
    peer.answer(message);
    say(peer);
    peer.synch();
  };
}
