/** The end of a server, whose last data are delivered before the error, and the end of a client, which stops its robots. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { player, position2d, position3d } from '../src/generated/index.js';
import { connect, ConnectionLost, Kind, Mode, RunEnded } from '../src/index.js';
import type { Message } from '../src/connection.js';
import { at } from './at.js';
import { fails, Leave, withClient, withServer, type FakeServer, type Peer } from './fake_server.js';

/** Insists that the data which `end` says before the server goes are delivered, and then the end; returns the overflows. */
async function check(end: (peer: Peer, message: Message) => void, mode: Mode, wanted: number[]): Promise<number> {
  let overflows = 0;
  const rounds = (peer: Peer, message: Message): void => {
    end(peer, message);
    throw new Leave();
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const seen: number[] = [];
    robot.onData((_, value) => void seen.push((value as position2d.Data).pos.px));
    if (mode === Mode.PUSH) await robot.drive(0.1); // anything, for the script to go on
    let counted = 0;
    const readOn = async (): Promise<void> => {
      for (;;) counted += await client.read();
    };
    await fails(readOn, RunEnded, /: the run ended: the server closed the connection$/);
    assert.deepEqual(seen, wanted);
    assert.equal(counted, wanted.length);
    await fails(() => client.read(), RunEnded, /the server closed the connection$/);
    assert.equal(client.connected, false);
    overflows = client.overflowCount;
  }, { mode });
  return overflows;
}

test('a round that is never closed is delivered', async () => {
  await check((peer, message) => {
    peer.answer(message);
    peer.data(position2d.DATA_STATE, at(1));
    peer.data(position2d.DATA_STATE, at(2));
  }, Mode.PULL, [1, 2]);
});

test('data instead of an answer are delivered, and their losses counted', async () => {
  const wanted = Array.from({ length: 3000 }, (_, i) => i); // more than wait for an ordinary request
  const overflows = await check((peer) => {
    for (const x of wanted) peer.data(position2d.DATA_STATE, at(x));
    peer.synch(551);
  }, Mode.PULL, wanted);
  assert.equal(overflows, 551);
});

test('pushed data are delivered', async () => {
  await check((peer) => {
    peer.data(position2d.DATA_STATE, at(1));
    peer.data(position2d.DATA_STATE, at(2));
  }, Mode.PUSH, [1, 2]);
});

test('data that came before a command failed can still be read', async () => {
  const rounds = (peer: Peer): void => {
    peer.data(position2d.DATA_STATE, at(1));
    throw new Leave(); // what is sent there from now on is answered with a reset
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const drive = async (): Promise<void> => {
      for (;;) await robot.drive(0.1);
    };
    await fails(drive, ConnectionLost, /: the server is gone: (Broken pipe|Connection reset by peer)$/);
    await client.read();
    assert.equal(robot.pose.x, 1);
    await fails(() => client.read(), ConnectionLost, /: the server is gone: /);
  }, { mode: Mode.PUSH });
});

test('updates end with the last data', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.answer(message);
    peer.data(position2d.DATA_STATE, at(1));
    throw new Leave();
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const seen: number[] = [];
    const follow = async (): Promise<void> => {
      for await (const { pose } of robot.updates()) seen.push(pose.x);
    };
    await fails(follow, RunEnded, /the run ended/);
    assert.deepEqual(seen, [1]);
  });
});

/** What was sent: speeds of commands, "+" for opening and "-" for closing, with the device. */
function sent(server: FakeServer): string[] {
  return server.received().flatMap(({ header, body }) => {
    if (header.kind === Kind.CMD && header.interface === position2d.CODE) return [`${position2d.CmdVel.decode(body).vel.px}`];
    if (header.kind === Kind.CMD) return [`${position3d.CmdVel.decode(body).vel.pz}`];
    if (header.interface !== player.CODE || header.subtype !== player.REQ_DEV.subtype) return [];
    const { addr, access } = player.DeviceReq.decode(body);
    return [`${access === player.CLOSE_MODE ? '-' : '+'}${addr.interf}:${addr.index}`];
  });
}

test('moving robots are stopped before their devices are closed, in reverse order of opening', async () => {
  await withServer((peer) => peer.serve(() => {}), async (server) => {
    const client = await connect(server.address);
    await (await client.position2d(0)).drive(0.5, 0.1);
    await client.laser(0);
    await (await client.position3d(0)).drive(0, 0, 0, 0.25);
    await client.close();
    assert.deepEqual(sent(server), ['+4:0', '0.5', '+6:0', '+30:0', '0.25', '0', '-30:0', '-6:0', '0', '-4:0']);
  });
});

test('a robot that stands gets no further command', async () => {
  await withServer((peer) => peer.serve(() => {}), async (server) => {
    const client = await connect(server.address);
    const robot = await client.position2d(0);
    await robot.drive(0.5);
    await robot.stop();
    await robot.close();
    await client.close();
    assert.deepEqual(sent(server), ['+4:0', '0.5', '0', '-4:0']);
  });
});

test('no command gets between the stop and the closing', async () => {
  await withServer((peer) => peer.serve(() => {}), async (server) => {
    const client = await connect(server.address);
    const robot = await client.position2d(0);
    await robot.drive(0.5);
    const closing = client.close();
    await assert.rejects(robot.drive(0.75));
    await Promise.all([closing, client.close()]);
    assert.deepEqual(sent(server), ['+4:0', '0.5', '0', '-4:0']);
  });
});

test('a device that another task opens meanwhile is closed too', async () => {
  await withServer((peer) => peer.serve(() => {}), async (server) => {
    const client = await connect(server.address);
    await client.position2d(0);
    const opening = client.laser(0);
    await client.close();
    assert.equal((await opening).isOpen, false);
    assert.deepEqual(sent(server), ['+4:0', '+6:0', '-4:0', '-6:0']);
  });
});

test('await using closes', async () => {
  await withServer((peer) => peer.serve(() => {}), async (server) => {
    const client = await connect(server.address);
    const robot = await client.position2d(0);
    await robot[Symbol.asyncDispose]();
    assert.equal(robot.isOpen, false);
    await client[Symbol.asyncDispose]();
    assert.equal(client.connected, false);
  });
});

test('the last command arrives although unread data have come', async () => {
  const last: Message[] = [];
  const rounds = (peer: Peer, message: Message): void => {
    last.push(message);
    for (let x = 0; x < 5000; ++x) peer.data(position2d.DATA_STATE, at(x)); // nobody reads them
  };
  await withServer((peer) => peer.serve(rounds), async (server) => {
    const client = await connect(server.address, { mode: Mode.PUSH });
    await (await client.position2d(0)).drive(0.5);
    await client.close();
    assert.deepEqual(sent(server), ['+4:0', '0.5', '0', '-4:0']);
  });
  assert.equal(last.length, 2);
});
