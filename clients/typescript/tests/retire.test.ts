/** What a program sees of devices that the real server retires. PLAYHOUSE_RETIRING_SERVER names its program. */

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import test from 'node:test';
import { connect, DeviceGone, Mode, RequestRefused, type Client } from '../src/index.js';
import { fails } from './fake_server.js';

const kLong = 30; // an answer is not waited for: it comes, or something hangs

type Do = (...lines: string[]) => Promise<void>;

/** Runs the server of clients/tests/retiring_server.cc with two devices, and a client of it. */
async function withRetiring(mode: Mode, use: (client: Client, act: Do, port: string) => Promise<void>): Promise<void> {
  const program = process.env['PLAYHOUSE_RETIRING_SERVER'];
  assert.ok(program, 'PLAYHOUSE_RETIRING_SERVER names no program');
  const server = spawn(program, { stdio: ['pipe', 'pipe', 'inherit'] });
  const ended = once(server, 'exit');
  const lines = createInterface(server.stdout)[Symbol.asyncIterator]();
  const next = async (): Promise<string> => String((await lines.next()).value).trim();
  const act: Do = async (...words) => {
    for (const line of words) {
      server.stdin.write(`${line}\n`);
      assert.equal(await next(), 'done');
    }
  };
  try {
    const address = await next();
    await act('add 0', 'add 3');
    const client = await connect(address, { mode, timeout: kLong });
    await use(client, act, address.split(':')[1]!);
    await client.close();
  } finally {
    server.stdin.end();
    await ended;
  }
}

for (const [word, mode] of Object.entries(Mode)) {
  test(`a retired device gives its last data and fails at once from then on (${word})`, async () => {
    await withRetiring(mode, async (client, act, port) => {
      const [gone, other] = [await client.position2d(3), await client.position2d(0)];
      await act('publish 3 1', 'retire 3', 'publish 0 2');
      while (!(gone.gone && other.hasData)) await client.read();
      assert.equal(gone.pose.x, 1);
      await gone.nextData(); // its last
      const line = new RegExp(`^${port}:position2d:3 is gone: the server retired it$`);
      for (const use of [() => gone.drive(1), () => gone.geometry(), () => gone.nextData()]) await fails(use, DeviceGone, line);
      await gone.close();
      assert.equal(gone.isOpen, false);
      await other.geometry();
    });
  });

  test(`nextData() of a retired device does not wait (${word})`, async () => {
    await withRetiring(mode, async (client, act) => {
      const gone = await client.position2d(3);
      const waiting = fails(() => gone.nextData(), DeviceGone, /is gone/);
      await act('retire 3');
      await waiting;
      await fails(() => gone.nextData(), DeviceGone, /is gone/);
      assert.ok(client.connected);
    });
  });

  test(`a retired device leaves its address to another and does not become it (${word})`, async () => {
    await withRetiring(mode, async (client, act) => {
      const gone = await client.position2d(3);
      await act('publish 3 1', 'retire 3', 'add 3');
      const following = await client.position2d(3);
      assert.ok(gone.gone);
      await act('publish 3 2');
      while (!following.hasData) await client.read();
      assert.equal(following.pose.x, 2);
      assert.equal(following.gone, false);
      assert.ok(!(gone.hasData && gone.pose.x === 2));
      await gone.close();
      await following.geometry();
    });
  });
}

test('a request before the notice is refused', async () => {
  await withRetiring(Mode.PULL, async (client, act) => {
    const gone = await client.position2d(3);
    await act('retire 3');
    await fails(() => gone.geometry(), RequestRefused, /position2d\.req\.get_geom of position2d:3 was refused$/);
    await client.read();
    await fails(() => gone.geometry(), DeviceGone, /is gone/);
  });
});
