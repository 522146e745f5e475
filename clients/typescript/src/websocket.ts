/** A WebSocket, of browsers and of Node.js 22 and newer: Player's byte stream in binary messages. */

import type { Route, Stream, StreamEvents } from './stream.js';

/** The part of the standard's WebSocket that is used here. */
interface WebSocketLike {
  binaryType: string;
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(bytes: Uint8Array): void;
  close(): void;
}

/** The longest message that a server takes. */
const kMessageBytes = 128 * 1024;

/** `url` is for instance "ws://127.0.0.1:8080/player". */
export function overWebSocket(url: string): Route {
  return { peer: url, port: 0, open: (events) => open(url, events) };
}

function open(url: string, events: StreamEvents): Stream {
  const { WebSocket } = globalThis as unknown as { WebSocket?: new (url: string) => WebSocketLike };
  if (!WebSocket) throw new Error('this program has no WebSocket: Node.js has it since 22');
  const socket = new WebSocket(url);
  socket.binaryType = 'arraybuffer';
  let [connected, finished] = [false, false];
  socket.onopen = () => {
    connected = true;
    events.connected();
  };
  socket.onmessage = ({ data }) => {
    if (data instanceof ArrayBuffer) events.data(new Uint8Array(data));
  };
  socket.onclose = ({ code, reason }) => {
    const inOrder = connected && (finished || code === 1000 || (code === 1008 && !reason));
    events.end(reason || (connected ? `the connection is lost (${code})` : 'no WebSocket at this address'), inOrder);
  };
  return {
    write(bytes, done) {
      for (let at = 0; at < bytes.length; at += kMessageBytes) socket.send(bytes.subarray(at, at + kMessageBytes));
      queueMicrotask(done);
    },
    pause() {}, // the standard has no way to
    resume() {},
    finish() {
      finished = true;
      socket.close();
    },
    destroy() {
      finished = true;
      socket.close();
    },
  };
}
