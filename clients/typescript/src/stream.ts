/** A stream of bytes to and from a server, whatever carries it: TCP (tcp.ts) or a WebSocket (websocket.ts). */

/** What happens to a stream, in this order: connected once, data, end once. */
export interface StreamEvents {
  connected(): void;
  data(bytes: Uint8Array): void;
  /** Nothing more will arrive: `inOrder` if the server has ended, else why. What has been called may end it again. */
  end(why: string, inOrder?: boolean): void;
}

export interface Stream {
  /** Calls `done` when the system has taken the bytes, with the reason if it has not. After connected(). */
  write(bytes: Uint8Array, done: (why?: string) => void): void;
  /** Holds back what arrives, where that is possible, until resume(). */
  pause(): void;
  resume(): void;
  /** Sends no more; end() follows when the server has read everything. */
  finish(): void;
  /** Ends it at once; no event matters any more. */
  destroy(): void;
}

/** Where a server is, and how to get there. */
export interface Route {
  /** For errors: HOST:PORT, or a URL. */
  readonly peer: string;
  /** The server's port; 0 if the route does not tell. */
  readonly port: number;
  /** Begins to connect. Throws if the address is invalid. */
  open(events: StreamEvents): Stream;
}
