/** Connecting to servers, to others, and to nobody. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { Connection } from '../src/connection.js';
import { overTcp } from '../src/tcp.js';
import { Client, connect, ConnectionLost, InvalidValue, Mode, RunEnded, WireError } from '../src/index.js';
import { MAX_BODY_BYTES } from '../src/wire.js';
import { fails, withServer, type Peer } from './fake_server.js';

test('nobody there', async () => {
  let address = '';
  await withServer(() => {}, async (server) => {
    ({ address } = server);
    await (await connect(address, { mode: Mode.PUSH })).close();
  });
  await fails(() => connect(address), ConnectionLost, /^127\.0\.0\.1:\d+: cannot connect: Connection refused$/);
});

test('a server of another kind', async () => {
  const banner = Buffer.from('220 mail.example.org ESMTP ready now');
  await withServer(() => {}, (server) => fails(() => connect(server.address), ConnectionLost, /not a Player server \(it says "220/), banner);
});

test('a server that ends before its banner', async () => {
  const banner = Buffer.alloc(0);
  await withServer(() => {}, (server) => fails(() => connect(server.address), RunEnded, /the server closed the connection/), banner);
});

test('a server without a banner in time', async () => {
  const silent = async (peer: { receive(): Promise<unknown> }): Promise<void> => void (await peer.receive());
  const line = /^127\.0\.0\.1:\d+: cannot connect: no banner in time$/;
  await withServer(silent, (server) => fails(() => connect(server.address, { timeout: 0.02 }), ConnectionLost, line), Buffer.alloc(0));
});

test('a banner in pieces', async () => {
  const pieces = (peer: { send(data: Uint8Array): void }): void => {
    for (const byte of Buffer.from('Player v.3.1'.padEnd(32, '\0'))) peer.send(Uint8Array.of(byte));
  };
  await withServer(pieces, async (server) => {
    const client = await connect(server.address, { mode: Mode.PUSH });
    assert.equal(client.banner, 'Player v.3.1');
    await client.close();
  }, Buffer.alloc(0));
});

test('an IPv6 address is in brackets', async () => {
  await fails(() => connect('[::1]:1'), ConnectionLost, /^::1:1: cannot connect: /);
  await fails(() => connect('[::1]:'), ConnectionLost, /is not HOST or HOST:PORT/);
});

test('an address without a host is this machine without a name to resolve', async () => {
  await fails(() => connect(':1'), ConnectionLost, /^127\.0\.0\.1:1: cannot connect: Connection refused$/);
});

test('an invalid host name', async () => {
  for (const host of ['a..b', 'x'.repeat(70), 'nul\0', 'no such host']) {
    await fails(() => connect(host), ConnectionLost, /cannot connect: \S/);
  }
  await fails(() => Client.open('127.0.0.1', 70000), ConnectionLost, /^127\.0\.0\.1:70000: cannot connect: \S/);
});

test('an invalid address', async () => {
  for (const address of ['localhost:port', 'localhost:0', 'localhost:65536']) {
    await fails(() => connect(address), ConnectionLost, /^"localhost:\w+" is not HOST or HOST:PORT$/);
  }
});

test('an invalid time-out', async () => {
  for (const timeout of [-1, NaN, '5' as never]) {
    await fails(() => connect('127.0.0.1', { timeout }), InvalidValue, /^invalid time-out of (-1|nan|"5") s: 0 or more is valid$/);
  }
});

test('a server that reads nothing is gone after the time-out', async () => {
  let end = (): void => {};
  const deaf = (peer: Peer): Promise<void> => {
    peer.socket.pause();
    return new Promise((resolve) => (end = resolve));
  };
  await withServer(deaf, async ({ address }) => {
    const [host, port] = address.split(':') as [string, string];
    const connection = await Connection.open(overTcp(host, Number(port)), 0.1);
    const header = { interface: 1, index: 0, kind: 3, subtype: 1, timestamp: 0, sequence: 0, size: 0, host: 0, robot: 0 };
    const body = Buffer.alloc(MAX_BODY_BYTES); // more than the system takes
    await fails(() => connection.send({ ...header, size: body.length }, body), ConnectionLost, /: the server is gone: timed out$/);
    assert.equal(connection.alive, false);
    await fails(() => connection.send(header, new Uint8Array()), ConnectionLost, /: the server is gone: timed out$/);
    const tooLong = new Uint8Array(MAX_BODY_BYTES + 1);
    await fails(() => connection.send(header, tooLong), WireError, /^a message of 33554393 bytes is over the wire's limit/);
    end();
    await connection.close(0);
  });
});
