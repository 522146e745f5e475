// A link that delays, or stops for a while: what passes it arrives, in order, so much later.

import { connect, createServer } from 'node:net';
import { setTimeout as sleep } from 'node:timers/promises';

/**
 * Passes everything on to a port of this machine. `delay(ms)` counts for what comes from then on, on both ways; between
 * `hold()` and `release()` nothing arrives.
 */
export async function startDelayingProxy(port) {
  let late = 0;
  let open = Promise.resolve();
  let release = () => {};
  const sockets = new Set();
  const pass = (from, to) => {
    let passed = Promise.resolve();
    const later = (act) => {
      const due = Date.now() + late;
      passed = passed.then(() => open).then(() => sleep(Math.max(0, due - Date.now()))).then(act);
    };
    from.on('data', (bytes) => later(() => to.write(bytes)));
    from.on('end', () => later(() => to.end()));
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
    hold: () => (open = new Promise((done) => (release = done))),
    release: () => release(),
    stop: () => {
      release();
      for (const socket of sockets) socket.destroy();
      server.close();
    },
  };
}
