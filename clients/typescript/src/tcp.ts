/** TCP, of Node.js. Bundles for browsers have nothing in place of its modules, and never get here. */

import net from 'node:net';
import util from 'node:util';
import type { Route, Stream, StreamEvents } from './stream.js';

export function overTcp(host: string, port: number): Route {
  return { peer: `${host}:${port}`, port, open: (events) => open(host, port, events) };
}

function open(host: string, port: number, events: StreamEvents): Stream {
  // With autoSelectFamily every address of a name is tried; Node.js has it since 18.13.
  const options = { host, port, noDelay: true, allowHalfOpen: true, autoSelectFamily: true };
  const socket = net.connect(options, () => events.connected());
  socket.on('data', (bytes) => events.data(bytes));
  socket.on('end', () => events.end('', true));
  socket.on('error', (error) => events.end(systemText(error)));
  socket.on('close', () => events.end('the connection is closed'));
  return {
    write: (bytes, done) => void socket.write(bytes, (error) => done(error ? systemText(error) : undefined)),
    pause: () => void socket.pause(),
    resume: () => void socket.resume(),
    finish: () => void socket.end(),
    destroy: () => void socket.destroy(),
  };
}

/** What the system says about an error: "Connection refused". */
function systemText(error: Error): string {
  const one = (error as AggregateError).errors?.[0] ?? error; // of several addresses of a host
  const known = util.getSystemErrorMap().get((one as NodeJS.ErrnoException).errno ?? 0);
  return known ? known[1].charAt(0).toUpperCase() + known[1].slice(1) : one.message;
}
