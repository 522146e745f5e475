/**
 * Uses radio, camera, speech, IMU and drivers on a map of the real server through this library:
 * robots radio|camera|voice|inertia|course|guest HOST:PORT, with worlds/radio.world, camera.world, radio.world, outdoor.world or
 * navigate.cfg respectively. Prints what fails and exits with 1. Run by clients/python/tests/test_server.py.
 */

import { imu, wifi } from '../src/generated/index.js';
import { connect, covarianceOfDeviations, InvalidValue, NoData, type Client, type Map, type Pose } from '../src/index.js';
import { main, mustBe, mustRefuse } from './must.js';

/** Whether a value is not there before the first data. */
function isMissing(look: () => unknown): boolean {
  try {
    look();
    return false;
  } catch (error) {
    if (error instanceof NoData) return true;
    throw error;
  }
}

/** Reads until this holds. */
async function readUntil(client: Client, done: () => boolean): Promise<void> {
  while (!done()) await client.read();
}

/** Network address of the radio with the best link to this one. */
async function nearest(client: Client): Promise<string> {
  const air = await client.device('wifi', 0);
  await air.nextData();
  const link = air.latest(wifi.DATA_STATE)?.links[0];
  mustBe(link !== undefined, 'a radio hears another one');
  mustBe(link.level < 0 && link.noise === -100, 'levels are in dBm');
  return Buffer.from(link.ip).toString();
}

async function useRadios(client: Client, other: Client): Promise<void> {
  const radio = await (await client.robot('r0')).opaque();
  const receiver = await (await other.robot('r1')).opaque();
  await radio.send('to all');
  await radio.sendTo(await nearest(client), '\0to one');
  await radio.sendTo('', '');
  const heard: string[] = [];
  for await (const message of receiver.updates()) {
    heard.push(Buffer.from(message).toString());
    if (heard.length === 3) break;
  }
  mustBe(heard.join('|') === 'to all|\0to one|', 'messages come whole and in order');
  mustBe(radio.takeMessages().length === 0, 'nobody hears itself');
  await mustRefuse(radio.sendTo('10.0.9.9', 'x'), 'an address that no radio has');
  await mustRefuse(radio.sendTo('', 'x'.repeat(2305)), 'a message that is too long');
}

async function useCameras(client: Client): Promise<void> {
  const robot = await client.robot('r0');
  const [color, depth, mount] = [await robot.camera(), await robot.camera(1), await robot.ptz()];
  await readUntil(client, () => color.hasData && depth.hasData && mount.hasData);
  const { image } = color;
  mustBe(image.width === 160 && image.height === 120 && !image.isJpeg, 'the picture is 160 x 120 and raw');
  mustBe(image.pixel(159, 119).length === 3, 'a pixel in colors has three values');
  mustBe(depth.image.pixel(40, 59)[0]! > 50, 'the floor before the robot is more than 5 cm away');
  mustBe((await mount.geometry()).pose.x === 0.12, "the camera is 12 cm before the robot's middle");
  const before = mount.view;
  await mount.look(before.pan + 0.25, before.tilt);
  await readUntil(client, () => Math.abs(mount.view.pan - before.pan - 0.25) <= 0.001);
  await mount.setVelocityControl(true);
  await mount.turn(-0.5);
  await readUntil(client, () => mount.view.pan <= before.pan);
  mustBe(mount.view.panSpeed < 0, 'it turns to the right');
  await mount.turn(0);
}

async function useVoices(client: Client, other: Client): Promise<void> {
  const [talker, listener] = [await client.robot('r0'), await other.robot('r1')];
  const [voice, own, ears] = [await talker.speech(), await listener.speech(), await listener.speechRecognition()];
  await own.say('my own voice');
  await voice.say('marco');
  await voice.say('schön');
  const heard: string[] = [];
  for await (const text of ears.updates()) {
    heard.push(text);
    if (text === 'schön') break;
  }
  mustBe(heard.length <= 2 && !heard.includes('my own voice'), 'a robot hears others and not itself');
}

async function useInertia(client: Client): Promise<void> {
  const robot = await client.robot('r0');
  const [base, unit] = [await robot.position3d(), await robot.imu()];
  const [receiver, lidar] = [await robot.gps(), await robot.pointcloud3d()];
  mustBe(isMissing(() => unit.inertia) && isMissing(() => unit.attitude), 'there are no data before the first');
  await unit.send(imu.DATA_EULER);
  const has = (): boolean => base.hasData && unit.latest(imu.DATA_EULER) !== undefined && receiver.hasData && lidar.hasData;
  await readUntil(client, has);
  mustBe(Math.abs(unit.inertia.acceleration[2] - 9.81) < 1, 'it feels gravity');
  mustBe(Math.abs(unit.attitude.roll) < 0.2, 'it is level');
  mustBe(isMissing(() => unit.velocity) && isMissing(() => unit.quaternion), 'of what is not sent there are no data');
  mustBe(Math.abs(receiver.fix.latitude - 50.7747) < 0.001 && receiver.fix.quality > 0, 'it is in Aachen');
  mustBe(lidar.points[0]?.color[3] === 255, 'points are opaque');
  await base.setOdometry({ x: 5, y: 6, z: 0, roll: 0, pitch: 0, yaw: 0 });
  await readUntil(client, () => Math.abs(base.state.pose.x - 5) <= 1);
  const fault = await base.drive(Infinity).catch((error: unknown) => error);
  mustBe(fault instanceof InvalidValue, 'a number that is not finite is an error');
  await base.drive(0.2);
  await readUntil(client, () => base.state.velocity.x >= 0.1);
  await unit.send(imu.DATA_FULLSTATE);
  await readUntil(client, () => unit.latest(imu.DATA_FULLSTATE) !== undefined);
  await unit.resetOrientation();
}

function distance(a: Pose, b: Pose): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

async function checkMap(plan: Map, start: Pose): Promise<void> {
  const [grid, cells] = [await plan.grid(), await plan.cells()];
  mustBe(Math.abs(grid.cellSize - 0.1) < 1e-6, 'cells have sides of 0.1 m');
  mustBe(cells.length === grid.height && cells.every((row) => row.length === grid.width), 'the map is whole');
  const [cell, rock] = [grid.cellOf(start.x, start.y), grid.cellOf(-7.9, -7.9)];
  mustBe(cell !== undefined && cells[cell.row]?.[cell.column] === -1, 'a robot stands where nothing else is');
  mustBe(rock !== undefined && cells[rock.row]?.[rock.column] === 1, 'there is rock around the cave');
}

async function useDriversOnAMap(client: Client): Promise<void> {
  const simulator = await client.simulation(0);
  const start = await simulator.pose('r0');
  const goal = { x: 6, y: 4, a: 1.5 };
  await checkMap(await client.map(0), start);
  const robot = await client.robot('r0');
  const [place, planner] = [await robot.localize(), await robot.planner()];
  await place.setPose(start, covarianceOfDeviations(0.2, 0.2, 0.1));
  await planner.goTo(goal);
  await readUntil(client, () => planner.hasData && planner.state.pose.x >= start.x + 0.5);
  await planner.stop();
  const { waypoints, length } = await planner.path();
  mustBe(distance(waypoints.at(-1)!, goal) === 0 && length > distance(start, goal), 'a path leads to the goal');
  mustBe(planner.state.valid && !planner.arrived, 'it is on its way');
  mustBe(distance(place.pose, await simulator.pose('r0')) < 0.3, 'it knows where it is');
  mustBe((await place.particles()).length >= 100, 'there are particles');
  await mustRefuse(place.setPose(start, { xx: -1, yy: 0, aa: 0, xy: 0, ya: 0, xa: 0 }), 'an invalid covariance');
  await planner.resume();
  await readUntil(client, () => planner.arrived);
  mustBe(distance(await simulator.pose('r0'), goal) < 0.6, 'it is at the goal');
  mustBe((await planner.whyRefused()) === '', 'it was not refused');
  await planner.goTo({ x: 999, y: 0, a: 0 });
  while ((await planner.whyRefused()) === '') await client.read();
  mustBe((await planner.whyRefused()) === 'no path to (999, 0): the goal is off the map', 'it says why');
}

/** Uses the server with two connections. */
function withClients(use: (client: Client, other: Client) => Promise<void>): (address: string) => Promise<void> {
  return async (address) => {
    const [client, other] = [await connect(address), await connect(address)];
    await use(client, other);
    await client.close();
    await other.close();
  };
}

async function useToken(address: string): Promise<void> {
  const why = await connect(address, { token: 'no-such-token' }).then(
    () => '',
    (error: unknown) => String(error),
  );
  mustBe(why.includes('the token is refused'), 'a wrong token is refused');
  const client = await connect(address, { token: 'driver-token-1' });
  const robot = await client.position2d(0);
  await robot.drive(0.3);
  await readUntil(client, () => robot.hasData && robot.velocity.x > 0.2);
  await client.close();
}

await main(
  {
    radio: withClients(useRadios),
    camera: withClients(useCameras),
    voice: withClients(useVoices),
    inertia: withClients(useInertia),
    course: withClients(useDriversOnAMap),
    guest: useToken,
  },
  'robots radio|camera|voice|inertia|course|guest HOST:PORT',
);
