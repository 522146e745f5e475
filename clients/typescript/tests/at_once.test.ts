/** Several tasks of a program use one client at the same time. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { common, laser, player, position2d } from '../src/generated/index.js';
import { connect, Kind, Mode, RequestTimeout } from '../src/index.js';
import type { Message } from '../src/connection.js';
import { at } from './at.js';
import { fails, first, round, withClient, withServer, type Peer } from './fake_server.js';

test('of several tasks that wait for data one reads for all', async () => {
  let asked = 0;
  const rounds = round((peer) => {
    asked += 1;
    peer.data(position2d.DATA_STATE, at(asked));
    peer.data(laser.DATA_SCAN, { maxRange: asked });
  });
  await withClient(rounds, async (client) => {
    const [robot, scanner] = [await client.position2d(0), await client.laser(0)];
    const states: number[] = [];
    const scans: number[] = [];
    const drive = async (): Promise<void> => {
      for await (const { pose } of robot.updates()) if (states.push(pose.x) === 4) break;
    };
    const look = async (): Promise<void> => {
      for await (const { maxRange } of scanner.updates()) if (scans.push(maxRange) === 4) break;
    };
    await Promise.all([drive(), look()]);
    assert.deepEqual([states, scans, asked], [[1, 2, 3, 4], [1, 2, 3, 4], 4]);
  });
});

test('two reads are two rounds, one after the other', async () => {
  let asked = 0;
  await withClient(round((peer) => peer.data(position2d.DATA_STATE, at((asked += 1)))), async (client) => {
    await client.position2d(0);
    assert.deepEqual(await Promise.all([client.read(), client.read()]), [1, 1]);
    assert.equal(asked, 2);
  });
});

test('requests of the same kind get their own answers, in order', async () => {
  let number = 0;
  const rounds = (peer: Peer, message: Message): void => {
    const body = common.IntpropReq.encode({ key: common.IntpropReq.decode(message.body).key, value: (number += 1) });
    peer.answer(message, Kind.ACK, body);
  };
  await withClient(rounds, async (client) => {
    const device = await client.device('dio', 0);
    const asked = ['a', 'b', 'c'].map((key) => device.getInt(key));
    assert.deepEqual(await Promise.all(asked), [1, 2, 3]);
  });
});

test('a request is answered while another task waits for data, and both end', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    if (message.header.interface === player.CODE) return peer.answer(message); // the round goes on
    peer.answer(message, Kind.ACK, position2d.Geom.encode({}));
    peer.data(position2d.DATA_STATE, at(1));
    peer.synch();
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const [state, geometry] = await Promise.all([first(robot.updates()), robot.geometry()]);
    assert.deepEqual([state.pose.x, geometry.size.x], [1, 0]);
  });
});

test('pushed data that another task has queued are delivered', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.socket.cork(); // in one piece, so that both tasks take turns at it
    for (let x = 0; x < 5000; ++x) peer.data(position2d.DATA_STATE, at(x));
    peer.answer(message, Kind.ACK, position2d.Geom.encode({}));
    peer.socket.uncork();
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    let count = 0;
    robot.onData(() => void (count += 1));
    const readAll = async (): Promise<void> => {
      while (count < 5000) await client.read();
    };
    await Promise.all([readAll(), robot.geometry()]);
    assert.deepEqual([count, client.overflowCount], [5000, 0]);
  }, { mode: Mode.PUSH });
});

test('a task with a longer time-out goes on when that of another is up', async () => {
  let held: Peer | undefined;
  await withClient((peer, message) => {
    peer.answer(message);
    held = peer;
  }, async (client) => {
    const robot = await client.position2d(0);
    const patient = robot.nextData(30);
    await fails(() => robot.nextData(0.02), RequestTimeout, /no data of position2d:0 in 0\.02 s$/);
    held!.data(position2d.DATA_STATE, at(1));
    held!.synch();
    await patient;
    assert.equal(robot.pose.x, 1);
  });
});

test('data that come with the answer to opening are those of the device, though another task reads', async () => {
  const script = async (peer: Peer): Promise<void> => {
    for (let message = await peer.receive(); message; message = await peer.receive()) {
      const { addr, access } = player.DeviceReq.decode(message.body);
      peer.socket.cork(); // in one piece, so that the reading task sees the data right behind the answer
      peer.answer(message, Kind.ACK, message.body);
      if (addr.index === 0 && access === player.OPEN_MODE) {
        peer.data(position2d.DATA_STATE, at(5));
        peer.data(position2d.DATA_STATE, at(6), { index: 1 });
      }
      peer.socket.uncork();
    }
  };
  await withServer(script, async ({ address }) => {
    const client = await connect(address, { mode: Mode.PUSH });
    const other = await client.position2d(1);
    const reading = other.nextData(30);
    const robot = await client.position2d(0);
    await reading;
    assert.deepEqual([robot.pose.x, other.pose.x, client.skippedCount], [5, 6, 0]);
    await client.close();
  });
});
