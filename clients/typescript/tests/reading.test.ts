/** What a client makes of data: in rounds, pushed, in pieces, late, lost or damaged. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { laser, player, position2d } from '../src/generated/index.js';
import {
  ConnectionLost, Kind, Mode, NoData, PlayerError, RequestRefused, RequestTimeout, Rule, type AnyMessage,
} from '../src/index.js';
import { WAITING_LIMIT } from '../src/session.js';
import { encodeHeader } from '../src/wire.js';
import type { Message } from '../src/connection.js';
import { at } from './at.js';
import { fails, first, round, withClient, type Peer } from './fake_server.js';

const kGeom = position2d.Geom.encode({});

test('a round ends with SYNCH and brings everything', async () => {
  const say = (peer: Peer): void => {
    peer.data(position2d.DATA_STATE, at(1));
    peer.data(position2d.DATA_STATE, at(2), { timestamp: 7.5 });
  };
  await withClient(round(say), async (client) => {
    const robot = await client.position2d(0);
    assert.equal(await client.read(), 2);
    assert.deepEqual([robot.pose.x, robot.timestamp, robot.state.time], [2, 7.5, 7.5]);
  });
});

test('messages in single bytes arrive whole', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    const sent: Uint8Array[] = [];
    const recording = Object.assign(Object.create(peer) as Peer, { send: (data: Uint8Array) => void sent.push(data) });
    recording.answer(message);
    recording.data(position2d.DATA_STATE, at(3));
    recording.synch();
    for (const byte of Buffer.concat(sent)) peer.send(Uint8Array.of(byte));
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    assert.equal(await client.read(), 1);
    assert.equal(robot.pose.x, 3);
  });
});

test('a message larger than what is received at once arrives whole, with others around it', async () => {
  const ranges = Float32Array.from({ length: 300_000 }, (_, i) => i);
  const say = (peer: Peer): void => {
    peer.data(position2d.DATA_STATE, at(1));
    peer.data(laser.DATA_SCAN, { ranges });
    peer.data(position2d.DATA_STATE, at(2));
  };
  await withClient(round(say), async (client) => {
    const [robot, scanner] = [await client.position2d(0), await client.laser(0)];
    for (let i = 0; i < 3; ++i) {
      assert.equal(await client.read(), 3);
      assert.deepEqual(scanner.ranges, ranges);
      assert.equal(robot.pose.x, 2);
    }
  });
});

for (const dataFirst of [true, false]) {
  test(`a round that ends ${dataFirst ? 'while' : 'after'} a request waits is the next read`, async () => {
    let asked = 0;
    const rounds = (peer: Peer, message: Message): void => {
      if (message.header.interface === player.CODE) {
        asked += Number(message.header.subtype === player.REQ_DATA.subtype);
        return peer.answer(message); // and nothing else
      }
      if (!dataFirst) peer.answer(message, Kind.ACK, kGeom);
      peer.data(position2d.DATA_STATE, at(4));
      peer.synch();
      if (dataFirst) peer.answer(message, Kind.ACK, kGeom);
    };
    await withClient(rounds, async (client) => {
      const robot = await client.position2d(0);
      await fails(() => client.read(0.02), RequestTimeout, /^127\.0\.0\.1:\d+: no data in time$/);
      await robot.geometry();
      assert.equal(await client.read(), 1);
      assert.equal(robot.pose.x, 4);
      await client.setReplaceRule(Rule.ACCEPT); // when it is answered, another request for data would have arrived
      assert.equal(asked, 1);
    });
  });
}

test('lost messages are counted and not an error', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.answer(message);
    peer.data(position2d.DATA_STATE, at(1));
    peer.synch(41);
  };
  await withClient(rounds, async (client) => {
    await client.position2d(0);
    await client.read();
    assert.equal(client.overflowCount, 41);
  });
});

test('data that come before an answer wait for read(), the newest of them', async () => {
  const sent = WAITING_LIMIT + 10;
  const rounds = (peer: Peer, message: Message): void => {
    for (let x = 0; x < sent; ++x) peer.data(position2d.DATA_STATE, at(x));
    peer.answer(message, Kind.ACK, kGeom);
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const seen: number[] = [];
    robot.onData((_, value) => void seen.push((value as position2d.Data).pos.px));
    await robot.geometry();
    await fails(() => robot.pose, NoData, /position2d:0 has sent no data yet; nextData\(\) waits for them$/);
    assert.equal(await client.read(), WAITING_LIMIT);
    assert.deepEqual([seen[0], seen.at(-1), client.overflowCount], [10, sent - 1, 10]);
  }, { mode: Mode.PUSH });
});

test('before the first data there is no value', async () => {
  await withClient((peer, message) => peer.answer(message, Kind.NACK), async (client) => {
    const [robot, scanner, ring] = [await client.position2d(0), await client.laser(0), await client.sonar(0)];
    const [finder, ranger, skirt] = [await client.fiducial(0), await client.ranger(0), await client.bumper(0)];
    const looks = [
      () => robot.state, () => robot.pose, () => robot.velocity, () => robot.stalled, () => scanner.scan(),
      () => scanner.ranges, () => scanner.intensities, () => ring.ranges, () => finder.markers, () => ranger.scan(),
      () => ranger.ranges, () => ranger.intensities, () => skirt.pressed,
    ];
    for (const look of looks) await fails(look, NoData, /:0 has sent no data yet/);
    assert.equal(robot.latest(position2d.DATA_STATE), undefined);
    assert.equal(robot.hasData, false);
  }, { mode: Mode.PUSH });
});

test('data of others do not prolong the time-out of one', async () => {
  await withClient(round((peer) => peer.data(laser.DATA_SCAN, {})), async (client) => {
    const [robot, scanner] = [await client.position2d(0), await client.laser(0)];
    await fails(() => robot.nextData(0.05), RequestTimeout, /no data of position2d:0 in 0\.05 s$/);
    assert.ok(scanner.fresh);
  });
});

test('a server that refuses data is an error', async () => {
  await withClient((peer, message) => peer.answer(message, Kind.NACK), async (client) => {
    for (let i = 0; i < 2; ++i) await fails(() => client.read(), RequestRefused, /the server refuses to send data$/);
  });
});

test('what makes no sense is skipped and counted', async () => {
  const say = (peer: Peer): void => {
    peer.say(4, 0, Kind.DATA, 99, Buffer.from('1234')); // no such kind of data
    peer.say(4, 0, Kind.DATA, 1, Buffer.from('1234')); // too short
    peer.say(4, 9, Kind.DATA, 1, position2d.Data.encode({})); // a device that is not open
    peer.say(4, 0, Kind.NACK, 5, new Uint8Array()); // nobody asked
    peer.say(4, 0, 77, 5, new Uint8Array()); // no such kind of message
    peer.data(position2d.DATA_STATE, at(6));
  };
  await withClient(round(say), async (client) => {
    const robot = await client.position2d(0);
    assert.equal(await client.read(), 1);
    assert.deepEqual([robot.pose.x, client.skippedCount], [6, 5]);
  });
});

test('a size over the limit ends the connection', async () => {
  const header = { interface: 4, index: 0, kind: 1, subtype: 1, timestamp: 0, sequence: 0, size: 0x7fffffff, host: 0, robot: 0 };
  const rounds = (peer: Peer, message: Message): void => {
    peer.answer(message);
    peer.send(encodeHeader(header));
  };
  await withClient(rounds, async (client) => {
    await client.position2d(0);
    await fails(() => client.read(), ConnectionLost, /a header announces 2147483647 bytes, over the limit$/);
    assert.equal(client.connected, false);
  });
});

test('callbacks may ask, and read() waits for them, but they may not read', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    const asksData = message.header.interface === player.CODE;
    peer.answer(message, Kind.ACK, asksData ? new Uint8Array() : kGeom);
    if (!asksData) return;
    peer.data(position2d.DATA_STATE, at(1));
    peer.synch();
  };
  await withClient(rounds, async (client) => {
    const robot = await client.position2d(0);
    const heard: AnyMessage[] = [];
    let faults = 0;
    robot.onData(async (message) => {
      await robot.geometry();
      await fails(() => client.read(), PlayerError, /from a callback that read\(\) itself is running/);
      faults += 1;
      heard.push(message);
    });
    await client.read();
    assert.deepEqual([heard, faults], [[position2d.DATA_STATE], 1]);
    robot.onData(() => {
      throw new TypeError('of the program');
    });
    await assert.rejects(client.read(), /of the program/);
    robot.onData(undefined);
    assert.equal(await client.read(), 0, 'the rest of that round');
    assert.equal(await client.read(), 1, 'the next one');
  });
});

test('a time-out may be infinite', async () => {
  await withClient(round((peer) => peer.data(position2d.DATA_STATE, at(1))), async (client) => {
    const robot = await client.position2d(0);
    await robot.nextData();
    assert.equal(await client.read(Infinity), 1);
  }, { timeout: Infinity });
});

test('updates are one per new data', async () => {
  let x = 0;
  await withClient(round((peer) => peer.data(position2d.DATA_STATE, at((x += 1)))), async (client) => {
    const robot = await client.position2d(0);
    const seen: number[] = [];
    for await (const { pose } of robot.updates()) {
      seen.push(pose.x);
      if (seen.length === 3) break;
    }
    assert.deepEqual(seen, [1, 2, 3]);
    assert.equal((await first(robot.updates())).pose.x, 4);
  });
});
