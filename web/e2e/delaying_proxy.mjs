// A link that delays: what passes it arrives, in order, so much later.

import { connect, createServer } from 'node:net';

/** Passes everything on to a port of this machine; `delay(ms)` counts for what comes from then on, on both ways. */
export async function startDelayingProxy(port) {
  let late = 0;
  const sockets = new Set();
  const pass = (from, to) => {
    from.on('data', (bytes) => setTimeout(() => to.write(bytes), late));
    from.on('end', () => setTimeout(() => to.end(), late));
    from.on('error', () => to.destroy());
    from.on('close', () => sockets.delete(from));
    sockets.add(from);
  };
  const server = createServer((near) => {
    const far = connect(port, '127.0.0.1');
    pass(near, far);
    pass(far, near);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  return {
    page: `http://127.0.0.1:${server.address().port}/`,
    delay: (ms) => (late = ms),
    stop: () => {
      for (const socket of sockets) socket.destroy();
      server.close();
    },
  };
}
