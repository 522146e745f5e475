/** Robots by name, from a server of a few lines that lists its models. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { common, laser, player, position2d, ranger, simulation } from '../src/generated/index.js';
import { connect, cString, Kind, RequestRefused, text, WireError } from '../src/index.js';
import { families, parseModels } from '../src/models.js';
import type { Message } from '../src/connection.js';
import { fails, withClient, withServer, type FakeServer, type Peer, type Rounds } from './fake_server.js';

const kHouse = [
  '0\tr0\tposition\t\t{port}:position2d:0',
  '1\tr0.ranger:0\tranger\tr0\t{port}:ranger:0 {port}:sonar:0',
  '2\twall\tmodel\t\t',
  '3\tguest\tposition\t\t{port}:position2d:12',
  '4\tguest.ranger:0\tranger\tguest\t{port}:ranger:20 {port}:laser:12',
  '5\tguest.arm\tmodel\tguest\t',
  '6\tguest.arm.eye\tfiducial\tguest.arm\t{port}:fiducial:3',
  '7\tguest.ranger:1\tranger\tguest\t{port}:ranger:21 {port}:laser:30',
  '8\tnext\tposition\t\t9999:position2d:0',
];

/** Answers questions for models from an index with a page and the index that follows. */
function lister(page: (index: number, port: number) => [lines: string, following: number]): Rounds {
  return (peer, message) => {
    if (message.header.interface !== simulation.CODE) return peer.answer(message, Kind.NACK);
    const asked = simulation.PropertyReq.decode(message.body);
    assert.deepEqual([text(asked.name), text(asked.prop)], ['', 'models']);
    const [lines, index] = page(asked.index, peer.port);
    peer.answer(message, Kind.ACK, simulation.PropertyReq.encode({ ...asked, index, value: Buffer.from(lines) }));
  };
}

/** All of kHouse, three models at a time. */
const house = lister((index, port) => {
  const lines = kHouse.slice(index, index + 3).map((line) => `${line.replaceAll('{port}', String(port))}\n`);
  return [lines.join(''), index + 3 < kHouse.length ? index + 3 : 0];
});

/** The devices that were opened (+) and closed (-), simulation aside. */
function opened(server: FakeServer): string[] {
  return server.received().flatMap(({ header, body }) => {
    if (header.interface !== player.CODE || header.subtype !== player.REQ_DEV.subtype) return [];
    const { addr, access } = player.DeviceReq.decode(body);
    return addr.interf === simulation.CODE ? [] : [`${access === player.CLOSE_MODE ? '-' : '+'}${addr.interf}:${addr.index}`];
  });
}

test('a line is a model with its devices', () => {
  const name = 'a\tb\\n\n';
  assert.deepEqual(parseModels('4\ta\\tb\\\\n\\n\tranger\tr 0\t6665:ranger:1 1:laser:2\n'), [{
    name,
    type: 'ranger',
    parent: 'r 0',
    devices: [
      { port: 6665, interface: 'ranger', index: 1, model: name },
      { port: 1, interface: 'laser', index: 2, model: name },
    ],
    id: 4,
  }]);
});

test('lines that make no sense are an error', () => {
  for (const line of ['x\n', 'x\ta\tb\tc\t\n', '0\ta\tb\tc\td\te\n', '0\ta\tb\tc\tlaser:0\n', '0\ta\tb\tc\t1:laser:\n']) {
    assert.throws(() => parseModels(line), (error: Error) => error instanceof WireError && /list of models/.test(error.message));
  }
});

test('what a model carries is found at any depth', () => {
  const models = parseModels(kHouse.join('\n').replaceAll('{port}', '1'));
  const names = families(models)[3]!.map(({ name }) => name);
  assert.deepEqual(names, ['guest', 'guest.ranger:0', 'guest.arm', 'guest.arm.eye', 'guest.ranger:1']);
});

test('a robot has the devices of all it carries', async () => {
  await withClient(house, async (client) => {
    const guest = await client.robot('guest');
    const names = guest.devices.map((at) => `${at.interface}:${at.index}`);
    assert.deepEqual(names, ['position2d:12', 'ranger:20', 'laser:12', 'fiducial:3', 'ranger:21', 'laser:30']);
    assert.deepEqual([guest.name, guest.type, guest.models.length], ['guest', 'position', 5]);
    assert.equal((await guest.position2d()).name, 'position2d:12');
    assert.deepEqual([(await guest.laser()).name, (await guest.fiducial()).name], ['laser:12', 'fiducial:3']);
    const rangers = await guest.rangers();
    assert.deepEqual(rangers.map(({ name }) => name), ['ranger:20', 'ranger:21']);
    assert.deepEqual(await guest.sonars(), []);
    assert.equal(await guest.ranger(1), rangers[1]);
  });
});

test('robots are the models at the top with devices here', async () => {
  await withClient(house, async (client) => {
    assert.deepEqual((await client.robots()).map(({ name }) => name), ['r0', 'guest']);
    assert.equal((await client.robots())[1], await client.robot('guest'));
  });
});

test('the last of equal names is meant', async () => {
  const page = '0\tr\tposition\t\t1:position2d:0\n1\tr.l\tranger\tr\t1:laser:0\n2\tr\tposition\t\t1:position2d:1\n';
  await withClient(lister(() => [page, 0]), async (client) => {
    assert.deepEqual((await client.robot('r')).devices.map(({ index }) => index), [1]);
  });
});

test('devices are listed with their models', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    if (message.header.interface === simulation.CODE) {
      const lines = kHouse.join('\n').replaceAll('{port}', String(peer.port));
      peer.answer(message, Kind.ACK, simulation.PropertyReq.encode({ value: Buffer.from(lines) }));
    } else if (message.header.subtype === player.REQ_DEVLIST.subtype) {
      const places = [[simulation.CODE, 0], [position2d.CODE, 12], [ranger.CODE, 20], [laser.CODE, 77], [999, 1]] as const;
      const devices = places.map(([interf, index]) => ({ host: 0, robot: peer.port, interf, index }));
      peer.answer(message, Kind.ACK, player.DeviceDevlist.encode({ devices }));
    } else if (message.header.subtype === player.REQ_DRIVERINFO.subtype) {
      const { addr } = player.DeviceDriverinfo.decode(message.body);
      const known = addr.interf === laser.CODE;
      peer.answer(message, known ? Kind.ACK : Kind.NACK, player.DeviceDriverinfo.encode({ driverName: cString('lms') }));
    }
  };
  await withClient(rounds, async (client) => {
    const told = (await client.devices()).map(({ name, driver, model, robot }) => [name, driver, model, robot]);
    assert.deepEqual(told, [
      ['simulation:0', '', '', ''], ['position2d:12', '', 'guest', 'guest'], ['ranger:20', '', 'guest.ranger:0', 'guest'],
      ['laser:77', 'lms', '', ''], ['999:1', '', '', ''],
    ]);
  });
});

test('devices are opened once and the models asked for once', async () => {
  await withServer((peer) => peer.serve(house), async (server) => {
    const client = await connect(server.address);
    for (let i = 0; i < 3; ++i) await (await (await client.robot('guest')).position2d()).stop();
    const guest = await client.robot('guest');
    const [one, other, all] = await Promise.all([guest.laser(), guest.laser(), guest.lasers()]);
    assert.ok(one === other && one === all[0]);
    await client.robot('r0');
    await client.close();
    assert.deepEqual(opened(server), ['+4:12', '+6:12', '+6:30', '-6:30', '-6:12', '-4:12']);
    assert.equal(server.received().filter(({ header }) => header.interface === simulation.CODE).length, 3);
  });
});

test('a robot that came later is found', async () => {
  const lists = ['0\tr0\tposition\t\t1:position2d:0\n', '0\tr0\tposition\t\t1:position2d:0\n1\tr1\tposition\t\t1:position2d:1\n'];
  await withClient(lister(() => [lists.length > 1 ? lists.shift()! : lists[0]!, 0]), async (client) => {
    const robot = await client.robot('r0');
    assert.equal((await client.robot('r1')).devices[0]!.index, 1);
    assert.equal(await client.robot('r0'), robot);
    assert.deepEqual((await client.models()).map(({ name }) => name), ['r0', 'r1']);
  });
});

test('closing a robot stops it and closes its devices, and they open again', async () => {
  await withClient(house, async (client, server) => {
    const guest = await client.robot('guest');
    const base = await guest.position2d();
    await base.drive(0.125);
    await guest.close();
    assert.equal(base.isOpen, false);
    assert.deepEqual(server.received().slice(-3).map(({ header }) => header.kind), [Kind.CMD, Kind.CMD, Kind.REQ]);
    const [one, other] = await Promise.all([guest.position2d(), guest.position2d()]);
    assert.ok(one.isOpen && one === other);
    await one.close();
    const [again, alike] = await Promise.all([guest.position2d(), guest.position2d()]);
    assert.ok(again.isOpen && again === alike && again !== one);
  });
});

test('a name that is not there gets the nearest one', async () => {
  await withClient(house, async (client) => {
    await fails(() => client.robot('gest'), RequestRefused, /^there is no robot "gest" at \S+ \(did you mean "guest"\?\)$/);
    await fails(() => client.robot('xyzzy'), RequestRefused, /^there is no robot "xyzzy" at \S+$/);
  });
});

test('a device that a robot lacks is told with what it has', async () => {
  await withClient(house, async (client) => {
    const [robot, wall, next] = [await client.robot('r0'), await client.robot('wall'), await client.robot('next')];
    await fails(() => robot.laser(), RequestRefused, /^robot "r0" has no laser \(it has position2d:0, ranger:0, sonar:0\)$/);
    await fails(() => robot.device('sonar', 1), RequestRefused, /^robot "r0" has no sonar number 1 \(it has/);
    await fails(() => wall.laser(), RequestRefused, /^robot "wall" has no laser \(it has no devices\)$/);
    const line = /^robot "next" has no position2d at port \d+, but position2d:0 at port 9999: connect there$/;
    await fails(() => next.position2d(), RequestRefused, line);
  });
});

test('a server that does not list models is told', async () => {
  await withClient((peer, message) => peer.answer(message, Kind.NACK), async (client) => {
    const line = /: this server does not tell the names of models; open devices by number$/;
    for (const ask of [() => client.robots(), () => client.robot('r0'), () => client.models()]) await fails(ask, RequestRefused, line);
  });
});

test('a list that goes round in circles is an error', async () => {
  await withClient(lister(() => ['0\tr0\tposition\t\t\n', 1]), async (client) => {
    await fails(() => client.robots(), WireError, /^the list of models goes on at 1 after 1$/);
  });
});

test('devices without a driver that answers have the name of none', async () => {
  const listed = player.DeviceDevlist.encode({ devices: [common.Devaddr.make({ interf: 4, index: 3 })] });
  const rounds = (peer: Peer, message: Message): void =>
    peer.answer(message, Kind.ACK, message.header.subtype === player.REQ_DEVLIST.subtype ? listed : Buffer.from('?'));
  await withClient(rounds, async (client) => {
    const entry = { name: 'position2d:3', interface: 'position2d', index: 3, driver: '', model: '', robot: '' };
    assert.deepEqual(await client.devices(), [entry]);
  });
});
