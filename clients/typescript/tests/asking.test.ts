/** Requests that are refused, late, silent or answered with nonsense, and values that are not sent. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { common, opaque, player, position2d } from '../src/generated/index.js';
import {
  Access, connect, ConnectionLost, DeviceClosed, DeviceGone, InvalidValue, Kind, Mode, NoData, RequestRefused, RequestTimeout, Rule, WireError,
} from '../src/index.js';
import type { Message } from '../src/connection.js';
import { at } from './at.js';
import { fails, Leave, withClient, withServer, type Peer } from './fake_server.js';

const kGeom = position2d.Geom.encode({});

function nothingIsSent(_: Peer, { header }: Message): void {
  throw new Error(`this was sent: ${JSON.stringify(header)}`);
}

test('a refusal is an error and the connection stays', async () => {
  const answers = [Kind.NACK, Kind.ACK];
  await withClient((peer, message) => peer.answer(message, answers.shift(), kGeom), async (client) => {
    const robot = await client.position2d(0);
    const line = /^127\.0\.0\.1:\d+: position2d\.req\.get_geom of position2d:0 was refused$/;
    await fails(() => robot.geometry(), RequestRefused, line);
    await robot.geometry();
  });
});

for (const numbers of [true, false]) {
  test(`a late answer is not taken for another's, of a server that ${numbers ? 'numbers' : 'does not number'} them`, async () => {
    const held: Message[] = [];
    const rounds = (peer: Peer, message: Message): void => {
      if (held.push(message) !== 2) return;
      held.forEach((request, i) => {
        const body = common.IntpropReq.encode({ key: Buffer.from('x\0'), value: i + 1 });
        peer.answer(request, Kind.ACK, body, numbers ? request.header.sequence : 0);
      });
    };
    await withClient(rounds, async (client) => {
      const device = await client.device('dio', 0);
      const asked = device.request(common.REQ_GET_INTPROP, { key: Buffer.from('x\0') }, 0.02);
      await fails(() => asked, RequestTimeout, /: no answer to universal\.req\.get_intprop of dio:0 in 0\.02 s$/);
      assert.equal(await device.getInt('x'), 2);
      assert.equal(client.skippedCount, 1);
    });
  });
}

test('after a lost answer the next request of a server that numbers them is answered at once', async () => {
  let number = 0;
  const rounds = (peer: Peer, message: Message): void => {
    if ((number += 1) > 1) peer.answer(message, Kind.ACK, common.IntpropReq.encode({ value: number }));
  };
  await withClient(rounds, async (client) => {
    const device = await client.device('dio', 0);
    await fails(() => device.request(common.REQ_GET_INTPROP, {}, 0.02), RequestTimeout, /no answer to/);
    assert.equal(await device.getInt('x'), 2);
  });
});

test('a server that does not number answers and lost one is understood again after one more time-out', async () => {
  let number = 0;
  const rounds = (peer: Peer, message: Message): void => {
    number += 1;
    if (number > 1) peer.answer(message, Kind.ACK, common.IntpropReq.encode({ value: number }), 0);
  };
  await withClient(rounds, async (client) => {
    const device = await client.device('dio', 0);
    for (let i = 0; i < 2; ++i) {
      await fails(() => device.request(common.REQ_GET_INTPROP, {}, 0.02), RequestTimeout, /no answer to/);
    }
    assert.equal(await device.getInt('x'), 3);
  });
});

test('an answer that does not decode names the fault', async () => {
  await withClient((peer, message) => peer.answer(message, Kind.ACK, Buffer.from('1234')), async (client) => {
    const robot = await client.position2d(0);
    await fails(() => robot.geometry(), WireError, /^position2d\.Geom: byte 0: 8 bytes expected, 4 are left$/);
  });
});

test('an answer without contents is an error where they are needed', async () => {
  await withClient((peer, message) => peer.answer(message), async (client) => {
    const robot = await client.position2d(0);
    assert.equal(await robot.request(position2d.REQ_GET_GEOM), undefined);
    await fails(() => robot.geometry(), WireError, /an answer came without its contents/);
  });
});

test('a server that goes is noticed', async () => {
  const leave = (): void => {
    throw new Leave();
  };
  await withClient(leave, async (client) => {
    const robot = await client.position2d(0);
    await fails(() => robot.geometry(), ConnectionLost, /the run ended: the server closed the connection$/);
    assert.equal(client.connected, false);
    await fails(() => robot.drive(1), ConnectionLost, /the server closed the connection$/);
  });
});

test('errors name the device and what was asked of it', async () => {
  await withClient((peer, message) => peer.answer(message, Kind.NACK), async (client) => {
    const [robot, lights, simulator] = [await client.position2d(3), await client.device('dio'), await client.simulation(0)];
    await fails(() => robot.geometry(), RequestRefused, /position2d\.req\.get_geom of position2d:3 was refused$/);
    await fails(() => lights.getInt('lamp'), RequestRefused, /dio:0 has no int property "lamp"$/);
    await fails(() => lights.getBool('lamp'), RequestRefused, /dio:0 has no bool property "lamp"$/);
    await fails(() => lights.getDouble('lamp'), RequestRefused, /dio:0 has no float property "lamp"$/);
    await fails(() => lights.getString('lamp'), RequestRefused, /dio:0 has no str property "lamp"$/);
    await fails(() => lights.setInt('lamp', 7), RequestRefused, /dio:0 refuses 7 as "lamp"$/);
    await fails(() => lights.setBool('lamp', true), RequestRefused, /dio:0 refuses true as "lamp"$/);
    await fails(() => lights.setString('lamp', 'on'), RequestRefused, /dio:0 refuses "on" as "lamp"$/);
    await fails(() => simulator.pose('nosuch'), RequestRefused, /get_pose2d of model "nosuch" was refused$/);
    await fails(() => simulator.join('x'), RequestRefused, /: join was refused: the server does not do that$/);
    await fails(() => client.lostCount(), RequestRefused, /get_intprop of player:0 was refused$/);
    assert.equal(await lights.hasCapability(common.REQ_CAPABILITIES), false);
  }, { mode: Mode.PUSH });
});

test('properties of four types, and the count of lost data', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    const key = Buffer.from('k\0');
    const bodies = new Map<number, Uint8Array>([
      [common.REQ_GET_BOOLPROP.subtype, common.BoolpropReq.encode({ key, value: 1 })],
      [common.REQ_GET_INTPROP.subtype, common.IntpropReq.encode({ key, value: -7 })],
      [common.REQ_GET_DBLPROP.subtype, common.DblpropReq.encode({ key, value: 0.25 })],
      [common.REQ_GET_STRPROP.subtype, common.StrpropReq.encode({ key, value: Buffer.from('on\0') })],
    ]);
    peer.answer(message, Kind.ACK, bodies.get(message.header.subtype) ?? new Uint8Array());
  };
  await withClient(rounds, async (client, server) => {
    const device = await client.device('dio', 0);
    const got = [await device.getBool('k'), await device.getInt('k'), await device.getDouble('k'), await device.getString('k')];
    assert.deepEqual(got, [true, -7, 0.25, 'on']);
    assert.equal(await client.lostCount(), -7);
    await device.setString('k', 'off');
    await device.setDouble('k', 1.5);
    await device.setBool('k', true);
    const [name, number, flag] = server.received().slice(-3).map(({ body }) => Buffer.from(body).toString('hex'));
    assert.ok(name!.endsWith(Buffer.from('off\0').toString('hex')));
    assert.ok(number!.endsWith('3ff8000000000000'));
    assert.ok(flag!.endsWith('00000001'));
    await fails(() => client.setMode(7 as Mode), InvalidValue, /^a mode is Mode\.PUSH or Mode\.PULL, not 7$/);
    await client.setReplaceRule(Rule.IGNORE, { index: 3 });
    const rule = player.AddReplaceRuleReq.decode(server.received().at(-1)!.body);
    assert.deepEqual(rule, { interf: -1, index: 3, type: -1, subtype: -1, replace: Rule.IGNORE });
  }, { mode: Mode.PUSH });
});

test('values that mean nothing are not sent', async () => {
  await withClient(nothingIsSent, async (client) => {
    const [robot, simulator, finder] = [await client.position2d(0), await client.simulation(0), await client.fiducial(0)];
    const base = await client.position3d(0);
    const level = { x: 0, y: 0, z: 0, roll: 0, pitch: 0, yaw: NaN };
    const acts = [
      () => robot.drive(NaN), () => robot.drive(0, Infinity), () => robot.drive(0, 0, -Infinity),
      () => robot.drive('1' as never), () => robot.driveCar(0.1, NaN), () => robot.goTo({ x: NaN, y: 0, a: 0 }),
      () => robot.goTo({ x: 0, y: 0 } as never), () => robot.setOdometry({ x: 0, y: 0, a: NaN }),
      () => simulator.setPose('r0', { x: 0, y: NaN, a: 0 }), () => simulator.setPose3d('r0', level),
      () => simulator.spawn('r0', { x: NaN, y: 0, a: 0 }), () => finder.setFieldOfView(0, Infinity, 1),
      () => base.goTo(level), () => base.drive(0, 0, 0, NaN),
    ];
    for (const act of acts) await fails(act, InvalidValue, /is (-?inf|nan|"1"|undefined), not a finite number$/);
    await fails(() => robot.drive(NaN), InvalidValue, /^position2d:0: vx is nan, not a finite number$/);
    for (const ticks of [0, -1, 1.5, 2 ** 20 + 1, '1' as never, null as never]) {
      await fails(() => simulator.step(ticks), InvalidValue, /^simulation:0: ticks is \S+, not a whole number from 1 to 1048576$/);
    }
    for (const seed of [-1, 1.5, 2n ** 64n, '1' as never]) {
      await fails(() => simulator.reset(seed), InvalidValue, /^simulation:0: seed is \S+, not a whole number from 0 to 18446744073709551615$/);
    }
    for (const index of [-1, 65536, 0.5]) {
      await fails(() => client.position2d(index), InvalidValue, /^there is no position2d:\S+: indices are 0 to 65535$/);
    }
    for (const timeout of [-1, NaN]) await fails(() => client.read(timeout), InvalidValue, /^invalid time-out of/);
    await fails(() => robot.setInt('key', 1.5), InvalidValue, /value is 1\.5, not a whole number/);
    await fails(() => simulator.pose('r0\0'), WireError, /has a NUL in it/);
    await fails(() => simulator.pose('r\udcff'), WireError, /cannot be sent as UTF-8/);
  }, { mode: Mode.PUSH });
});

test('a reset drops what came before its answer and keeps what comes after', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.data(position2d.DATA_STATE, at(2), { timestamp: 2 });
    peer.data(opaque.DATA_STATE, { data: Buffer.from('old') }, { timestamp: 2 });
    peer.answer(message, Kind.ACK, message.body);
    peer.data(position2d.DATA_STATE, at(3), { timestamp: 0.5 });
  };
  await withClient(rounds, async (client) => {
    const [robot, radio, simulator] = [await client.position2d(0), await client.opaque(0), await client.simulation(0)];
    await simulator.step();
    assert.ok(robot.hasData && radio.hasData);
    await simulator.reset(7);
    for (const device of [robot, radio]) {
      assert.deepEqual([device.hasData, device.fresh, device.timestamp], [false, false, 0]);
    }
    assert.deepEqual(radio.takeMessages(), []);
    await fails(() => robot.pose, NoData, /position2d:0 has sent no data yet/);
    await robot.nextData();
    assert.deepEqual([robot.pose.x, robot.timestamp], [3, 0.5]);
  }, { mode: Mode.PUSH });
});

test('a refused reset drops nothing', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.data(position2d.DATA_STATE, at(2));
    peer.answer(message, Kind.NACK);
  };
  await withClient(rounds, async (client) => {
    const [robot, simulator] = [await client.position2d(0), await client.simulation(0)];
    await fails(() => simulator.reset(7), RequestRefused, /reset was refused/);
    await client.read();
    assert.equal(robot.pose.x, 2);
  }, { mode: Mode.PUSH });
});

test('a time that goes back drops what other devices have of a later one', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.data(position2d.DATA_STATE, at(1), { index: 0, timestamp: 0.5 });
    peer.data(position2d.DATA_STATE, at(2), { index: 1, timestamp: 1 });
    peer.data(position2d.DATA_STATE, at(3), { index: 2, timestamp: 2 });
    peer.data(position2d.DATA_STATE, at(4), { index: 1, timestamp: 0.5 });
    peer.answer(message, Kind.ACK, message.body);
  };
  await withClient(rounds, async (client) => {
    const [before, back, later] = [await client.position2d(0), await client.position2d(1), await client.position2d(2)];
    await (await client.simulation(0)).step();
    assert.deepEqual([before.pose.x, back.pose.x, later.hasData], [1, 4, false]);
  }, { mode: Mode.PUSH });
});

test('a closed device says so', async () => {
  await withServer((peer) => peer.serve(nothingIsSent), async ({ address }) => {
    const client = await connect(address);
    const [robot, other] = [await client.position2d(0), await client.position2d(1)];
    await robot.close();
    await robot.close();
    await client.close();
    for (const closed of [robot, other]) {
      assert.equal(closed.isOpen, false);
      for (const act of [() => closed.drive(0.1), () => closed.geometry(), () => closed.nextData()]) {
        await fails(act, DeviceClosed, new RegExp(`: ${closed.name} is closed$`));
      }
    }
    await fails(() => client.read(), ConnectionLost, /: the connection is closed$/);
    await fails(() => client.position2d(0), ConnectionLost, /: the connection is closed$/);
  });
});

test('what waits when the client is closed ends with an error', async () => {
  await withClient((peer, message) => peer.answer(message), async (client) => {
    const robot = await client.position2d(0);
    const waiting = fails(() => robot.nextData(30), ConnectionLost, /: the connection is closed$/);
    await client.close();
    await waiting;
  });
});

test('a device that is not there cannot be opened', async () => {
  const script = async (peer: Peer): Promise<void> => {
    for (let message = await peer.receive(); message; message = await peer.receive()) {
      peer.answer(message, message.header.subtype === player.REQ_DEV.subtype ? Kind.NACK : Kind.ACK);
    }
  };
  await withServer(script, async ({ address }) => {
    const client = await connect(address);
    await fails(() => client.position2d(3), RequestRefused, /: there is no position2d:3 to open$/);
    await fails(() => client.device('lazer', 0), InvalidValue, /^there is no interface "lazer" \(did you mean "laser"\?\)$/);
    await fails(() => client.device('xyzzy', 0), InvalidValue, /^there is no interface "xyzzy"$/);
    await fails(() => client.device('toString', 0), InvalidValue, /^there is no interface "toString"/);
    await client.close();
  });
});

test('a driver that refuses to start is an error, and an answer to opening that does not decode', async () => {
  const answers = [player.DeviceReq.encode({ access: player.ERROR_MODE }), Buffer.from('12345')];
  const script = async (peer: Peer): Promise<void> => {
    for (let message = await peer.receive(); message; message = await peer.receive()) {
      peer.answer(message, Kind.ACK, message.header.subtype === player.REQ_DEV.subtype ? answers.shift() : undefined);
    }
  };
  await withServer(script, async ({ address }) => {
    const client = await connect(address);
    await fails(() => client.position2d(0), RequestRefused, /: cannot open position2d:0$/);
    await fails(() => client.position2d(0), WireError, /^player\.DeviceReq: /);
    await client.close();
  });
});

test('what is queued of a retired device is not given to a new one at its address', async () => {
  let opened = 0;
  const script = async (peer: Peer): Promise<void> => {
    for (let message = await peer.receive(); message; message = await peer.receive()) {
      if (message.header.subtype === player.REQ_DEV.subtype && (opened += 1) === 2) {
        peer.data(position2d.DATA_STATE, { stall: 1 });
        const notice = { addr: common.Devaddr.make({ robot: 6665, interf: position2d.CODE }), access: 'e'.charCodeAt(0) };
        peer.say(player.CODE, 0, Kind.ACK, player.REQ_DEV.subtype, player.DeviceReq.encode(notice));
      }
      peer.answer(message, Kind.ACK, message.body);
      if (message.header.kind === Kind.REQ && message.header.interface !== player.CODE) peer.data(position2d.DATA_STATE, {});
    }
  };
  await withServer(script, async ({ address }) => {
    const client = await connect(address, { mode: Mode.PUSH });
    const [gone, following] = [await client.position2d(0), await client.position2d(0)];
    assert.deepEqual([gone.gone, following.gone, client.skippedCount], [true, false, 1]);
    await fails(() => gone.drive(1), DeviceGone, /^6665:position2d:0 is gone: the server retired it$/);
    await following.resetOdometry();
    await following.nextData();
    assert.equal(following.stalled, false);
    await client.close();
  });
});

test('reading access is asked for by its character', async () => {
  await withClient(() => {}, async (client, server) => {
    await client.position2d(0, Access.READ);
    assert.equal(player.DeviceReq.decode(server.received().at(-1)!.body).access, 'r'.charCodeAt(0));
  });
});
