/** Values of the proxies, and what they send. */

import assert from 'node:assert/strict';
import test from 'node:test';
import { deflateSync } from 'node:zlib';
import {
  actarray, aio, bumper, camera, common, fiducial, gps, imu, laser, localize, map, opaque, planner, player, pointcloud3d, position2d,
  position3d, power, ptz, ranger, simulation, sonar, speech, speech_recognition, wifi,
} from '../src/generated/index.js';
import {
  Access, Charging, cString, covarianceOfDeviations, Device, Grid, InvalidValue, Kind, Marker, Mode, NoData, RequestRefused, Rule, RunEnded, Scan, text,
  WireError, type Client, type MessageType,
} from '../src/index.js';
import type { Message } from '../src/connection.js';
import { fails, first, round, withClient, type FakeServer, type Peer } from './fake_server.js';

const kLevel = { x: 1, y: 2, z: 3, roll: 0.5, pitch: 0.25, yaw: 0.125 };
const kWireLevel = { px: 1, py: 2, pz: 3, proll: 0.5, ppitch: 0.25, pyaw: 0.125 };
const kSize = { sl: 4, sw: 5, sh: 6 };
const kGeometry = { pose: kLevel, size: { x: 4, y: 5, z: 6 } };
const kNoCovariance = { xx: 0, yy: 0, aa: 0, xy: 0, ya: 0, xa: 0 };

/** The decoded bodies of what the client has sent with this message type. */
async function sent<T>(client: Client, server: FakeServer, row: MessageType<T>): Promise<T[]> {
  await client.setReplaceRule(Rule.ACCEPT); // when it is answered, commands sent before have arrived
  const { interface: code, kind, subtype } = row;
  const same = server.received().filter(({ header: h }) => h.interface === code && h.kind === kind && h.subtype === subtype);
  return same.map(({ body }) => row.payload!.decode(body));
}

/** Rounds in which every request is answered with these bodies, by message type, and a round has these data. */
function serving(answers: [MessageType<any>, Uint8Array][], say: (peer: Peer) => void = () => {}) {
  return (peer: Peer, message: Message): void => {
    if (message.header.kind === Kind.CMD) return;
    const { interface: code, subtype } = message.header;
    const found = answers.find(([row]) => row.interface === code && row.subtype === subtype);
    peer.answer(message, Kind.ACK, found?.[1]);
    if (code !== player.CODE || subtype !== player.REQ_DATA.subtype) return;
    say(peer);
    peer.synch();
  };
}

test('a base tells its state and is driven', async () => {
  const answers: [MessageType<any>, Uint8Array][] = [
    [position2d.REQ_GET_GEOM, position2d.Geom.encode({ pose: kWireLevel, size: kSize })],
  ];
  const say = (peer: Peer): void => {
    const value = { pos: { px: 1, py: 2, pa: 0.5 }, vel: { px: 0.25, py: 0, pa: 1 }, stall: 1 };
    peer.data(position2d.DATA_STATE, value, { timestamp: 7.5 });
  };
  await withClient(serving(answers, say), async (client, server) => {
    const robot = await client.position2d(0);
    const wanted = { pose: { x: 1, y: 2, a: 0.5 }, velocity: { x: 0.25, y: 0, a: 1 }, stalled: true, time: 7.5 };
    assert.deepEqual(await first(robot.updates()), wanted);
    assert.deepEqual([robot.pose, robot.velocity, robot.stalled], [wanted.pose, wanted.velocity, true]);
    assert.deepEqual(await robot.geometry(), kGeometry);
    await robot.driveCar(0.5, 0.25);
    assert.deepEqual(await sent(client, server, position2d.CMD_CAR), [{ velocity: 0.5, angle: 0.25 }]);
    await robot.goTo({ x: 1, y: 2, a: 3 }, 0.5);
    const goal = { vel: { px: 0.5, py: 0, pa: 0 }, pos: { px: 1, py: 2, pa: 3 }, state: 1 };
    assert.deepEqual(await sent(client, server, position2d.CMD_POS), [goal]);
    await robot.drive(0.5, 0.25, 0.125);
    assert.deepEqual(await sent(client, server, position2d.CMD_VEL), [{ vel: { px: 0.5, py: 0.125, pa: 0.25 }, state: 1 }]);
    await robot.setMotorPower(true);
    assert.deepEqual(await sent(client, server, position2d.REQ_MOTOR_POWER), [{ state: 1 }]);
    await robot.setOdometry({ x: 1, y: 2, a: 3 });
    assert.deepEqual(await sent(client, server, position2d.REQ_SET_ODOM), [{ pose: { px: 1, py: 2, pa: 3 } }]);
    await robot.resetOdometry();
    assert.equal(server.received().at(-1)!.header.subtype, position2d.REQ_RESET_ODOM.subtype);
  });
});

test('a base in space tells its state and is driven', async () => {
  const answers: [MessageType<any>, Uint8Array][] = [
    [position3d.REQ_GET_GEOM, position3d.Geom.encode({ pose: kWireLevel, size: kSize })],
  ];
  const say = (peer: Peer): void => {
    peer.data(position3d.DATA_STATE, { pos: kWireLevel, vel: common.Pose3d.make({ px: 0.5 }), stall: 1 }, { timestamp: 7.5 });
  };
  await withClient(serving(answers, say), async (client, server) => {
    const base = await client.position3d(0);
    const state = await first(base.updates());
    assert.deepEqual([state.pose, state.velocity.x, state.stalled, state.time], [kLevel, 0.5, true, 7.5]);
    assert.deepEqual(await base.geometry(), kGeometry);
    await base.drive(0.5, 0.25, 0.125, 1);
    const velocity = { px: 0.5, py: 0.125, pz: 1, proll: 0, ppitch: 0, pyaw: 0.25 };
    assert.deepEqual(await sent(client, server, position3d.CMD_SET_VEL), [{ vel: velocity, state: 1 }]);
    await base.goTo(kLevel);
    assert.deepEqual((await sent(client, server, position3d.CMD_SET_POS))[0]!.pos, kWireLevel);
    await base.setOdometry(kLevel);
    assert.deepEqual(await sent(client, server, position3d.REQ_SET_ODOM), [{ pos: kWireLevel }]);
    await base.setMotorPower(false);
    await base.resetOdometry();
  });
});

test('scans have ranges, directions and a time', async () => {
  const ranges = [1, 2, 0.5];
  const elements = [0.5, 0, -0.5].map((pyaw) => common.Pose3d.make({ pyaw }));
  const config = ranger.Config.make({ minAngle: -1, maxAngle: 1, maxRange: 8 });
  const answers = (geom: Partial<ranger.Geom>): [MessageType<any>, Uint8Array][] => [
    [ranger.REQ_GET_CONFIG, ranger.Config.encode(config)],
    [ranger.REQ_GET_GEOM, ranger.Geom.encode({ pose: kWireLevel, size: kSize, ...geom })],
    [laser.REQ_GET_GEOM, laser.Geom.encode({ pose: kWireLevel, size: kSize })],
    [laser.REQ_GET_CONFIG, laser.Config.encode({ maxRange: 8 })],
  ];
  const say = (peer: Peer): void => {
    peer.data(ranger.DATA_RANGE, { ranges: Float64Array.from(ranges) }, { timestamp: 2.5 });
    peer.data(ranger.DATA_INTNS, { intensities: Float64Array.of(7) });
    const scan = { minAngle: -1, maxAngle: 1, maxRange: 8, ranges: Float32Array.from(ranges), intensity: Uint8Array.of(1, 2, 3) };
    peer.data(laser.DATA_SCAN, scan, { timestamp: 8.5 });
  };
  const spread = new Scan(Float64Array.from(ranges), Float64Array.of(-1, 0, 1), 8, 2.5);
  await withClient(serving(answers({}), say), async (client, server) => {
    const [scanner, rangefinder] = [await client.laser(0), await client.ranger(0)];
    assert.deepEqual(await first(scanner.updates()), new Scan(Float32Array.from(ranges), Float64Array.of(-1, 0, 1), 8, 8.5));
    assert.deepEqual(rangefinder.scan(), spread);
    assert.deepEqual([[...scanner.ranges], [...scanner.intensities]], [ranges, [1, 2, 3]]);
    assert.deepEqual([[...rangefinder.ranges], [...rangefinder.intensities]], [ranges, [7]]);
    assert.deepEqual([await scanner.geometry(), rangefinder.geometry()], [kGeometry, kGeometry]);
    assert.equal((await scanner.config()).maxRange, 8);
    await rangefinder.setConfig(ranger.Config.make({ maxRange: 4 }));
    assert.equal(rangefinder.config.maxRange, 8, 'the values in effect');
    await rangefinder.setPower(true);
    await rangefinder.setIntensities(true);
    assert.deepEqual([await sent(client, server, ranger.REQ_POWER), await sent(client, server, ranger.REQ_INTNS)], [[{ state: 1 }], [{ state: 1 }]]);
  });
  await withClient(serving(answers({ elementPoses: elements }), say), async (client) => {
    assert.deepEqual((await first((await client.ranger(0)).updates())).angles, Float64Array.of(0.5, 0, -0.5));
  });
});

test('the nearest range between two directions, and end points', () => {
  const scan = new Scan(Float64Array.of(3, 2, 4), Float64Array.of(-1, 0, 1), 8, 0);
  assert.deepEqual([scan.nearest(), scan.nearest(0.5, 2), scan.nearest(2, 3)], [2, 4, 8]);
  const [right, ahead] = scan.points();
  assert.deepEqual(ahead, { x: 2, y: 0 });
  assert.ok(right!.y < 0);
});

test('sonars, markers and switches', async () => {
  const front = { pose: kWireLevel, length: 0.5, radius: 0.25 };
  const answers: [MessageType<any>, Uint8Array][] = [
    [sonar.REQ_GET_GEOM, sonar.Geom.encode({ poses: [kWireLevel] })],
    [bumper.REQ_GET_GEOM, bumper.Geom.encode({ bumperDef: [front] })],
    [fiducial.REQ_GET_GEOM, fiducial.Geom.encode({ pose: kWireLevel, size: kSize })],
    [fiducial.REQ_GET_FOV, fiducial.Fov.encode({ minRange: 1, maxRange: 2, viewAngle: 3 })],
  ];
  const say = (peer: Peer): void => {
    peer.data(sonar.DATA_RANGES, { ranges: Float32Array.of(0.5, 1) });
    peer.data(bumper.DATA_STATE, { bumpers: Uint8Array.of(0, 1, 255) });
    peer.data(fiducial.DATA_SCAN, { fiducials: [fiducial.Item.make({ id: 7, pose: { ...kWireLevel, px: 3, py: 4 } })] });
  };
  await withClient(serving(answers, say), async (client, server) => {
    const [ring, skirt, finder] = [await client.sonar(0), await client.bumper(0), await client.fiducial(0)];
    assert.deepEqual(await first(skirt.updates()), [false, true, true]);
    assert.deepEqual([...ring.ranges], [0.5, 1]);
    assert.deepEqual(await ring.poses(), [kLevel]);
    assert.deepEqual(await skirt.faces(), [{ pose: kLevel, length: 0.5, radius: 0.25 }]);
    const [marker] = finder.markers;
    assert.deepEqual(marker, new Marker(7, { ...kLevel, x: 3, y: 4 }));
    assert.deepEqual([marker!.distance, marker!.bearing], [5, Math.atan2(4, 3)]);
    assert.deepEqual((await first(finder.updates())).length, 1);
    assert.deepEqual([await finder.geometry(), await finder.fieldOfView()], [kGeometry, { minRange: 1, maxRange: 2, viewAngle: 3 }]);
    await finder.setFieldOfView(0.5, 4, 1.5);
    assert.deepEqual(await sent(client, server, fiducial.REQ_SET_FOV), [{ minRange: 0.5, maxRange: 4, viewAngle: 1.5 }]);
    await ring.setPower(false);
    assert.deepEqual(await sent(client, server, sonar.REQ_POWER), [{ state: 0 }]);
  });
});

test('a camera tells its pixels', async () => {
  const picture = (width: number, height: number, format: number, image: number[], compression: number = camera.COMPRESS_RAW) =>
    ({ width, height, format, compression, image: Uint8Array.from(image) });
  const pictures = [
    picture(2, 1, camera.FORMAT_RGB888, [1, 2, 3, 4, 5, 6]),
    picture(1, 2, camera.FORMAT_MONO16, [0x34, 0x12, 0, 0]),
    picture(2, 1, camera.FORMAT_RGB888, [255, 216], camera.COMPRESS_JPEG),
    picture(2, 1, camera.FORMAT_RGB888, [1, 2, 3, 4, 5]),
    picture(2, 1, camera.FORMAT_RGB888, [0, 0, 0, 0, 0, 1]),
    picture(1, 1, camera.FORMAT_MONO8, [9]),
  ];
  await withClient(round((peer) => peer.data(camera.DATA_STATE, pictures.shift()!, { timestamp: 2.5 })), async (client) => {
    const eye = await client.camera(0);
    const color = await first(eye.updates());
    assert.deepEqual([color.pixel(0, 0), color.pixel(1, 0), color.time], [[1, 2, 3], [4, 5, 6], 2.5]);
    assert.equal(color.modelId(1, 0), 0x040505);
    for (const [column, row] of [[2, 0], [0, 1], [-1, 0], [0.5, 0], [0, NaN]] as const) {
      await fails(() => color.pixel(column, row), InvalidValue, / is outside the 2 x 1 picture$/);
    }
    const depth = await first(eye.updates());
    assert.deepEqual([depth.pixel(0, 0), depth.pixel(0, 1)], [[0x1234], [0]]);
    await fails(() => depth.modelId(0, 0), InvalidValue, /which model a pixel shows is told by RGB888 alone/);
    const jpeg = await first(eye.updates());
    assert.ok(jpeg.isJpeg);
    await fails(() => jpeg.pixel(0, 0), InvalidValue, /pixels can be told of raw MONO8, MONO16 and RGB888 alone/);
    const short = await first(eye.updates());
    assert.deepEqual(short.pixel(0, 0), [1, 2, 3]);
    await fails(() => short.pixel(1, 0), InvalidValue, /the picture has fewer bytes than pixels: 5/);
    const segments = await first(eye.updates());
    assert.deepEqual([segments.modelId(0, 0), segments.modelId(1, 0)], [undefined, 0], 'none, and the first model');
    assert.deepEqual((await first(eye.updates())).pixel(0, 0), [9]);
  });
});

test('a mount turns a camera', async () => {
  const answers: [MessageType<any>, Uint8Array][] = [[ptz.REQ_GEOM, ptz.Geom.encode({ pos: kWireLevel, size: kSize })]];
  const say = (peer: Peer): void => {
    peer.data(ptz.DATA_STATE, { pan: 0.5, tilt: 0.25, zoom: 1, panspeed: 2, tiltspeed: 3 });
  };
  await withClient(serving(answers, say), async (client, server) => {
    const mount = await client.ptz(0);
    assert.deepEqual(await first(mount.updates()), { pan: 0.5, tilt: 0.25, zoom: 1, panSpeed: 2, tiltSpeed: 3 });
    await mount.look(0.5, 0.25, 1);
    await mount.turn(0.5, 0.25);
    const still = { pan: 0, tilt: 0, zoom: 0, panspeed: 0, tiltspeed: 0 };
    const turns = [{ ...still, pan: 0.5, tilt: 0.25, zoom: 1 }, { ...still, panspeed: 0.5, tiltspeed: 0.25 }];
    assert.deepEqual(await sent(client, server, ptz.CMD_STATE), turns);
    await mount.setVelocityControl(true);
    assert.deepEqual(await sent(client, server, ptz.REQ_CONTROL_MODE), [{ mode: ptz.VELOCITY_CONTROL }]);
    assert.deepEqual(await mount.geometry(), kGeometry);
  });
});

test('an inertial unit tells what it feels and how it stands', async () => {
  const felt = { accelX: 0.5, accelY: 0.25, accelZ: 9.75, gyroX: 0, gyroY: 0, gyroZ: 1.5, magnX: 0, magnY: 0.5, magnZ: -0.5 };
  const say = (peer: Peer): void => {
    peer.data(imu.DATA_STATE, {}, { timestamp: 1 });
    peer.data(imu.DATA_EULER, { calibData: felt, orientation: { proll: 0.5, ppitch: 0.25, pyaw: 0.125 } }, { timestamp: 2 });
    peer.data(imu.DATA_QUAT, { calibData: { ...felt, accelX: 1 }, q0: 1 }, { timestamp: 3 });
    peer.data(imu.DATA_FULLSTATE, { pose: kWireLevel, vel: common.Pose3d.make({ px: 0.25 }) }, { timestamp: 4 });
    peer.data(imu.DATA_CALIB, { ...felt, accelX: 2 }, { timestamp: 2.5 });
  };
  await withClient(serving([], say), async (client, server) => {
    const unit = await client.imu(0);
    await fails(() => unit.inertia, NoData, /imu:0 has sent no data yet/);
    await unit.send(imu.DATA_EULER);
    await unit.nextData();
    const wanted = { acceleration: [1, 0.25, 9.75], turnRate: [0, 0, 1.5], field: [0, 0.5, -0.5] };
    assert.deepEqual(unit.inertia, wanted, 'the newest of three kinds of data');
    assert.deepEqual(unit.attitude, { roll: 0.5, pitch: 0.25, yaw: 0.125 });
    assert.deepEqual(unit.quaternion, [1, 0, 0, 0]);
    assert.deepEqual(unit.pose, kLevel, 'the newer of two kinds of data');
    assert.equal(unit.velocity.x, 0.25);
    await unit.resetOrientation();
    await fails(() => unit.resetAttitude({ roll: 0, pitch: 0, yaw: NaN }), InvalidValue, /yaw is nan/);
    await unit.resetAttitude({ roll: 0.5, pitch: 0.25, yaw: 0.125 });
    assert.deepEqual(await sent(client, server, imu.REQ_SET_DATATYPE), [{ value: 4 }]);
    assert.deepEqual(await sent(client, server, imu.REQ_RESET_ORIENTATION), [{ value: 0 }]);
    assert.deepEqual((await sent(client, server, imu.REQ_RESET_EULER))[0]!.orientation, { ...kWireLevel, px: 0, py: 0, pz: 0 });
  });
});

test('data of another kind are named', async () => {
  await withClient(serving([], (peer) => peer.data(imu.DATA_STATE, {})), async (client) => {
    const unit = await client.imu(0);
    await unit.nextData();
    const line = /imu:0 sends imu\.data\.state, not imu\.data\.calib; send\(imu\.DATA_CALIB\) selects it$/;
    await fails(() => unit.inertia, NoData, line);
  });
});

test('a receiver tells degrees and metres, a cloud points, a box voltages', async () => {
  const told = { latitude: 507747000, longitude: -60839000, altitude: 220500, quality: 1, numSats: 8, errHorz: 2, utmE: 294000, course: 1.5 };
  const say = (peer: Peer): void => {
    peer.data(gps.DATA_STATE, told, { timestamp: 3.5 });
    const color = { alpha: 255, red: 200, green: 1, blue: 2 };
    peer.data(pointcloud3d.DATA_STATE, { points: [{ point: { px: 1, py: 2, pz: 3 }, color }] });
    peer.data(aio.DATA_STATE, { voltages: Float32Array.of(0.5, -3) });
  };
  await withClient(serving([], say), async (client, server) => {
    const [receiver, cloud, box] = [await client.gps(0), await client.pointcloud3d(0), await client.aio(0)];
    const fix = await first(receiver.updates());
    assert.ok(Math.abs(fix.latitude - 50.7747) < 1e-9 && Math.abs(fix.longitude + 6.0839) < 1e-9);
    assert.deepEqual([fix.altitude, fix.quality, fix.satellites, fix.horizontalError], [220.5, 1, 8, 2]);
    assert.deepEqual([fix.easting, fix.course, fix.time], [294000, 1.5, 3.5]);
    assert.deepEqual(cloud.points, [{ x: 1, y: 2, z: 3, color: [200, 1, 2, 255] }]);
    assert.deepEqual([...box.voltages], [0.5, -3]);
    await fails(() => box.set(1, NaN), InvalidValue, /voltage is nan, not a finite number/);
    await box.set(1, 0.5);
    assert.deepEqual(await sent(client, server, aio.CMD_STATE), [{ id: 1, voltage: 0.5 }]);
    assert.equal((await first(cloud.updates())).length, 1);
    assert.equal((await first(box.updates())).length, 2);
  });
});

test('messages are kept until they are taken, the newest of them', async () => {
  const say = (peer: Peer): void => {
    for (let i = 0; i < 1030; ++i) peer.data(opaque.DATA_STATE, { data: Uint8Array.of(i & 255) });
    for (const word of ['marco', 'schön']) peer.data(speech_recognition.DATA_STRING, { text: cString(word) });
  };
  await withClient(serving([], say), async (client, server) => {
    const [radio, ears, voice] = [await client.opaque(0), await client.speechRecognition(0), await client.speech(0)];
    await client.read();
    const taken = radio.takeMessages();
    assert.deepEqual([taken.length, taken[0]![0]], [1024, 6]);
    assert.deepEqual(radio.takeMessages(), []);
    assert.deepEqual(ears.takeTexts(), ['marco', 'schön']);
    const words: string[] = [];
    for await (const word of ears.updates()) if (words.push(word) === 3) break;
    assert.deepEqual(words, ['marco', 'schön', 'marco']);
    assert.deepEqual(ears.takeTexts(), ['schön']);
    await voice.say('ä');
    assert.equal(text((await sent(client, server, speech.CMD_SAY))[0]!.string), 'ä');
    await radio.send('\0x');
    await radio.sendTo('10.0.0.2', Uint8Array.of(0, 1));
    assert.equal(Buffer.from((await sent(client, server, opaque.CMD_DATA))[0]!.data).toString(), '\0x');
    assert.equal(Buffer.from((await sent(client, server, opaque.REQ_DATA))[0]!.data).toString(), '10.0.0.2\0\0\x01');
  });
});

test('a localization tells where the robot may be and is told', async () => {
  const cov = Float64Array.of(0.25, 0.5, 0.125, 0.1, 0.2, 0.3);
  const told = [[{ mean: { px: 1, py: 2, pa: 0.5 }, cov, alpha: 0.75 }, localize.Hypoth.make({ alpha: 0.25 })], []];
  const rounds = (peer: Peer, message: Message): void => {
    if (message.header.interface === localize.CODE) {
      const refused = message.header.subtype === 1 && localize.SetPose.decode(message.body).cov[0]! < 0;
      const few = localize.GetParticles.encode({ particles: [{ pose: { px: 3, py: 4, pa: 1 }, alpha: 0.5 }] });
      return peer.answer(message, refused ? Kind.NACK : Kind.ACK, message.header.subtype === 2 ? few : undefined);
    }
    peer.answer(message);
    if (message.header.subtype !== player.REQ_DATA.subtype) return;
    peer.data(localize.DATA_HYPOTHS, { hypoths: told.shift()! });
    peer.synch();
  };
  await withClient(rounds, async (client, server) => {
    const place = await client.localize(0);
    await fails(() => place.pose, NoData, /localize:0 has sent no data yet/);
    const covariance = { xx: 0.25, yy: 0.5, aa: 0.125, xy: 0.1, ya: 0.2, xa: 0.3 };
    const pose = { x: 1, y: 2, a: 0.5 };
    const none = { pose: { x: 0, y: 0, a: 0 }, covariance: kNoCovariance, weight: 0.25 };
    assert.deepEqual(await first(place.updates()), [{ pose, covariance, weight: 0.75 }, none]);
    assert.deepEqual(place.pose, pose);
    await client.read();
    await fails(() => place.pose, NoData, /localize:0 has no hypothesis/);
    await place.setPose(pose, covarianceOfDeviations(0.5, 2, 3));
    const line = /localize\.req\.set_pose of localize:0 was refused$/;
    await fails(() => place.setPose(pose, { ...kNoCovariance, xx: -1 }), RequestRefused, line);
    await fails(() => place.setPose({ ...pose, y: NaN }, kNoCovariance), InvalidValue, /^localize:0: y is nan, not a finite number$/);
    await fails(() => place.setPose(pose, { ...kNoCovariance, xa: Infinity }), InvalidValue, /^localize:0: xa is inf, not/);
    assert.deepEqual(await place.particles(), [{ pose: { x: 3, y: 4, a: 1 }, weight: 0.5 }]);
    const [pinned, ...more] = await sent(client, server, localize.REQ_SET_POSE);
    assert.deepEqual(pinned, { mean: { px: 1, py: 2, pa: 0.5 }, cov: Float64Array.of(0.25, 4, 9, 0, 0, 0) });
    assert.equal(more.length, 1);
  });
});

test('a planner goes to a goal and tells when the robot is there', async () => {
  const [goal, way] = [{ px: 6, py: 4, pa: 1.5 }, { px: 2, py: 1, pa: 0 }];
  const told = [
    { valid: 1, done: 1, waypointIdx: -1, waypointsCount: 2 }, // of a goal before
    { valid: 1, done: 0, pos: { px: 0.5, py: 0, pa: 0 }, goal, waypoint: way, waypointIdx: 1, waypointsCount: 3 },
    { valid: 1, done: 1, pos: goal, goal, waypointIdx: -1, waypointsCount: 3 },
  ];
  const path = planner.WaypointsReq.encode({ waypointsDistance: 7.5, waypoints: [way, goal] });
  const say = (peer: Peer): void => peer.data(planner.DATA_STATE, told.shift()!, { timestamp: 2.5 });
  await withClient(serving([[planner.REQ_GET_WAYPOINTS, path]], say), async (client, server) => {
    const guide = await client.planner(0);
    assert.equal(guide.arrived, false);
    await guide.goTo({ x: 6, y: 4, a: 1.5 + 4 * Math.PI });
    const states = [];
    for await (const state of guide.updates()) {
      states.push(state);
      if (guide.arrived) break;
    }
    const to = { x: 6, y: 4, a: 1.5 };
    const onTheWay = { pose: { x: 0.5, y: 0, a: 0 }, goal: to, waypoint: { x: 2, y: 1, a: 0 } };
    assert.equal(states.length, 3);
    assert.deepEqual(states[1], { valid: true, done: false, ...onTheWay, index: 1, count: 3, time: 2.5 });
    await guide.stop();
    await guide.resume();
    assert.deepEqual(await sent(client, server, planner.REQ_ENABLE), [{ state: 0 }, { state: 1 }]);
    assert.deepEqual(await guide.path(), { waypoints: [{ x: 2, y: 1, a: 0 }, to], length: 7.5 });
    await guide.goTo({ x: 6, y: 4, a: 0 });
    assert.equal(guide.arrived, false, 'another heading');
    await fails(() => guide.goTo({ x: 0, y: Infinity, a: 0 }), InvalidValue, /^planner:0: y is inf, not a finite number$/);
    await guide.close();
    const kinds = server.received().filter(({ header }) => header.interface === planner.CODE).map(({ header }) => header.kind);
    assert.deepEqual(kinds, [Kind.CMD, Kind.REQ, Kind.REQ, Kind.REQ, Kind.CMD], 'no command as it closes');
  });
});

test('a map comes whole in tiles', async () => {
  const [width, height] = [600, 514];
  const value = (column: number, row: number): number => ((column + 3 * row) % 201) - 100;
  const rounds = (peer: Peer, message: Message): void => {
    if (message.header.interface !== map.CODE) return peer.answer(message);
    if (message.header.subtype === map.REQ_GET_INFO.subtype) {
      return peer.answer(message, Kind.ACK, map.Info.encode({ scale: 0.5, width, height, origin: { px: -1, py: 2, pa: 0 } }));
    }
    const tile = map.Data.decode(message.body);
    const cells = Int8Array.from({ length: tile.width * tile.height }, (_, i) =>
      value(tile.col + (i % tile.width), tile.row + Math.floor(i / tile.width)));
    const data = new Uint8Array(cells.buffer);
    // The others as a server without zlib.
    peer.answer(message, Kind.ACK, map.Data.encode({ ...tile, dataRange: 100, data: tile.row === 0 ? deflateSync(data) : data }));
  };
  await withClient(rounds, async (client, server) => {
    const plan = await client.map(0);
    assert.deepEqual(await plan.grid(), new Grid(0.5, width, height, { x: -1, y: 2, a: 0 }));
    const cells = await plan.cells();
    assert.equal(cells.length, height);
    cells.forEach((row, y) => {
      const wanted = Int8Array.from({ length: width }, (_, x) => Number(value(x, y) > 50) - Number(value(x, y) < -50));
      assert.deepEqual(row, wanted);
    });
    const tiles = (await sent(client, server, map.REQ_GET_DATA)).map((one) => [one.col, one.row, one.width, one.height]);
    assert.deepEqual(tiles, [[0, 0, 512, 512], [512, 0, 88, 512], [0, 512, 512, 2], [512, 512, 88, 2]]);
  }, { mode: Mode.PUSH });
});

test('maps that make no sense are an error', async () => {
  const square = { scale: 0.5, width: 2, height: 2 };
  const infos: Partial<map.Info>[] = [
    { ...square, scale: 0 }, { ...square, scale: NaN }, { ...square, origin: { px: Infinity, py: 0, pa: 0 } },
    { ...square, width: 1 << 14, height: (1 << 12) + 1 }, square, square, square, { ...square, width: 0, height: 2 ** 31 },
  ];
  const whole = deflateSync(Uint8Array.of(1, 1, 1, 1));
  const tiles = [deflateSync(Uint8Array.of(1, 1, 1)), deflateSync(new Uint8Array(1 << 20)), whole.subarray(0, 3)];
  const rounds = (peer: Peer, message: Message): void => {
    const asksInfo = message.header.subtype === map.REQ_GET_INFO.subtype;
    const body = asksInfo ? map.Info.encode(infos.shift()!) : map.Data.encode({ width: 2, height: 2, dataRange: 1, data: tiles.shift()! });
    peer.answer(message, Kind.ACK, body);
  };
  await withClient(rounds, async (client) => {
    const plan = await client.map(0);
    const damaged = 'a tile of 2 x 2 cells is damaged';
    const faults = ['invalid map', 'invalid map', 'invalid map', '16384 x 4097 cells are over the limit', damaged, damaged, damaged];
    for (const fault of faults) await fails(() => plan.cells(), WireError, new RegExp(`^map:0: .*${fault}`));
    assert.deepEqual(await plan.cells(), []);
  }, { mode: Mode.PUSH });
});

test('a point of the world is in a cell or beyond the map', () => {
  const grid = new Grid(0.5, 4, 2, { x: 10, y: 20, a: Math.PI / 2 }); // columns go along y, rows against x
  assert.deepEqual(grid.cellOf(9.9, 20.1), { column: 0, row: 0 });
  assert.deepEqual(grid.cellOf(9.4, 21.9), { column: 3, row: 1 });
  for (const [x, y] of [[10.1, 20.1], [9.9, 19.9], [9.9, 22.1], [8.9, 20.1], [NaN, 20.1], [9.9, Infinity]] as const) {
    assert.equal(grid.cellOf(x, y), undefined);
  }
});

test('a simulator tells poses and changes the world', async () => {
  const answers: [MessageType<any>, Uint8Array][] = [
    [simulation.REQ_GET_POSE2D, simulation.Pose2dReq.encode({ pose: { px: 1, py: 2, pa: 0.5 } })],
    [simulation.REQ_GET_POSE3D, simulation.Pose3dReq.encode({ pose: kWireLevel })],
    [simulation.REQ_SET_PROPERTY, simulation.PropertyReq.encode({ value: cString('r1') })],
  ];
  await withClient(serving(answers), async (client, server) => {
    const simulator = await client.simulation(0);
    assert.deepEqual([await simulator.pose('r0'), await simulator.pose3d('r0')], [{ x: 1, y: 2, a: 0.5 }, kLevel]);
    await simulator.setPose('r0', { x: 1, y: 2, a: 0.5 });
    await simulator.setPose3d('r0', kLevel);
    const [flat] = await sent(client, server, simulation.REQ_SET_POSE2D);
    assert.deepEqual([text(flat!.name), flat!.pose], ['r0', { px: 1, py: 2, pa: 0.5 }]);
    assert.deepEqual((await sent(client, server, simulation.REQ_SET_POSE3D))[0]!.pose, kWireLevel);
    await simulator.step(3);
    await simulator.reset(258n);
    await simulator.join('me');
    assert.equal(await simulator.spawn('r0', { x: 1, y: 0, a: 0 }, 'new'), 'r1');
    await simulator.remove('r1');
    const told = (await sent(client, server, simulation.REQ_SET_PROPERTY)).map(({ name, prop, value }) =>
      [text(name), text(prop), Buffer.from(value).toString('hex')]);
    assert.deepEqual(told, [
      ['', 'step', '03000000'], ['', 'reset', '0201000000000000'], ['', 'join', '6d6500'],
      ['r0', 'spawn', `${'000000000000f03f'}${'0'.repeat(32)}6e657700`], ['r1', 'remove', ''],
    ]);
    await simulator.pause();
    await simulator.save();
    await simulator.reset();
    await simulator.pose('r0'); // when it is answered, the commands have arrived
    const commands = server.received().filter(({ header }) => header.kind === Kind.CMD).map(({ header }) => header.subtype);
    assert.deepEqual(commands, [simulation.CMD_PAUSE, simulation.CMD_SAVE, simulation.CMD_RESET].map(({ subtype }) => subtype));
  }, { mode: Mode.PUSH });
});

test('a step that is refused tells why, and the end of the run is an end', async () => {
  const reasons = ['the run has ended', 'nobody joined'];
  const rounds = (peer: Peer, message: Message): void =>
    peer.answer(message, Kind.NACK, simulation.PropertyReq.encode({ value: cString(reasons.shift()!) }));
  await withClient(rounds, async (client) => {
    const simulator = await client.simulation(0);
    await fails(() => simulator.step(), RunEnded, /: the run has ended$/);
    await fails(() => simulator.step(), RequestRefused, /: step was refused: nobody joined$/);
  }, { mode: Mode.PUSH });
});

test('in push mode a step ends when its data have been delivered', async () => {
  const rounds = (peer: Peer, message: Message): void => {
    peer.data(position2d.DATA_STATE, { pos: { px: 9, py: 0, pa: 0 } });
    peer.answer(message, Kind.ACK);
  };
  await withClient(rounds, async (client) => {
    const [robot, simulator] = [await client.position2d(0), await client.simulation(0)];
    await simulator.step();
    assert.equal(robot.pose.x, 9);
  }, { mode: Mode.PUSH });
});

test('any interface opens, as its proxy if there is one', async () => {
  await withClient(serving([]), async (client: Client) => {
    const any = await client.device('vectormap', 2, Access.WRITE);
    assert.deepEqual([any.constructor, any.name, any.interface, any.access], [Device, 'vectormap:2', 'vectormap', 119]);
    const scanner = await client.device('laser');
    assert.equal(scanner.constructor.name, 'Laser');
  });
});

test('a chain of joints tells its state and is moved', async () => {
  const actuators = [
    { position: 0.5, speed: 0.25, acceleration: 2, current: -1, state: actarray.ACTSTATE_MOVING },
    { position: 1, speed: 0, acceleration: 0, current: 3, state: actarray.ACTSTATE_BRAKED | actarray.ACTSTATE_STALLED },
  ];
  const geom = actarray.Geom.encode({
    actuators: [{
      type: actarray.TYPE_ROTARY, length: 2, orientation: { proll: 0.5, ppitch: 0.25, pyaw: 0.125 }, axis: { px: 0, py: 0, pz: 1 },
      min: -1, centre: 0, max: 1, home: 0.5, configSpeed: 4, hasbrakes: 1,
    }],
    basePos: { px: 1, py: 2, pz: 3 }, baseOrientation: { proll: 0.5, ppitch: 0.25, pyaw: 0.125 },
  });
  const say = (peer: Peer): void => peer.data(actarray.DATA_STATE, { actuators, motorState: 1 }, { timestamp: 2 });
  await withClient(serving([[actarray.REQ_GET_GEOM, geom]], say), async (client, server) => {
    const arm = await client.actarray(0);
    const { joints, motorsOn, time } = await first(arm.updates());
    assert.deepEqual([motorsOn, time], [true, 2]);
    assert.deepEqual(joints.map(({ current, moving, braked, stalled }) => [current, moving, braked, stalled]),
      [[undefined, true, false, false], [3, false, true, true]]);
    const { pose, joints: [joint] } = await arm.geometry();
    assert.deepEqual(pose, kLevel);
    assert.deepEqual([joint?.rotary, joint?.axis, joint?.highest, joint?.hasBrakes], [true, [0, 0, 1], 1, true]);
    await arm.moveTo(1, 0.5);
    assert.deepEqual(await sent(client, server, actarray.CMD_POS), [{ joint: 1, position: 0.5 }]);
    await arm.home();
    assert.deepEqual(await sent(client, server, actarray.CMD_HOME), [{ joint: -1 }]);
    await fails(() => arm.moveTo(-1, 0.5), InvalidValue, /joint is -1, not a whole number from 0 to/);
    await fails(() => arm.moveAllTo([0, NaN]), InvalidValue, /position is nan, not a finite number/);
  });
});

test('a battery tells what it knows, and a radio its levels in their unit', async () => {
  const say = (peer: Peer): void => {
    const valid = power.MASK_VOLTS | power.MASK_CHARGING;
    peer.data(power.DATA_STATE, { valid, volts: 12.5, percent: 0, joules: 0, watts: 0, charging: 7 }, { timestamp: 1 });
    const link = wifi.Link.make({ mac: cString('a'), level: -40, noise: -90, encrypt: 1 });
    peer.data(wifi.DATA_STATE, wifi.Data.make({ links: [link], qualType: wifi.QUAL_DBM, maxlevel: -1 }), { timestamp: 1 });
  };
  await withClient(serving([], say), async (client) => {
    const [battery, radio] = [await client.power(0), await client.wifi(0)];
    await client.read();
    const unknown = { percent: undefined, joules: undefined, watts: undefined };
    assert.deepEqual(battery.state, { volts: 12.5, ...unknown, charging: Charging.YES, time: 1 });
    const [link] = radio.links;
    assert.deepEqual([link?.mac, link?.level, link?.noise, link?.encrypted, radio.state.maxLevel], ['a', -40, -90, true, -1]);
  });
});
