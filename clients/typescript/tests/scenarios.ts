/**
 * Repeats the programs behind the recorded sessions with this library: scenarios NAME HOST:PORT.
 * clients/python/tests/test_replay.py plays back the recorded answers and compares what the client sends;
 * clients/python/tests/scenarios.py is the Python counterpart.
 */

import { common, laser, map, ranger } from '../src/generated/index.js';
import { connect, Mode, Rule, type Client } from '../src/index.js';
import { main, mustRefuse } from './must.js';

async function reads(client: Client, count: number): Promise<void> {
  for (let i = 0; i < count; ++i) await client.read();
}

async function printPosition(client: Client): Promise<void> {
  await client.position2d(0);
  await client.setMode(Mode.PULL);
  await client.setReplaceRule(Rule.ACCEPT);
  await reads(client, 3);
}

async function printDefaults(client: Client): Promise<void> {
  await client.position2d(0);
  await reads(client, 2);
}

async function checkPosition(client: Client): Promise<void> {
  const robot = await client.position2d(0);
  await reads(client, 23);
  await robot.setOdometry({ x: 0.1, y: -0.2, a: Math.PI });
  await reads(client, 10);
  await robot.setOdometry({ x: 0, y: 0, a: 0 });
  await robot.setMotorPower(true);
  await robot.drive(0.1);
  await robot.drive(-0.1);
  await robot.drive(0, 0, 0.1);
  await robot.drive(0, 0, -0.1);
  await robot.drive(0, (-25 * Math.PI) / 180);
  await robot.drive(0, (25 * Math.PI) / 180);
  await robot.drive(0, (45 * Math.PI) / 180, 0.1);
  await robot.drive(0, (-45 * Math.PI) / 180, -0.1);
  await robot.stop();
  await robot.setMotorPower(false);
  await robot.setOdometry({ x: 0, y: 0, a: 0 });
}

async function checkLaser(client: Client): Promise<void> {
  const scanner = await client.laser(0);
  await reads(client, 20);
  const config: laser.Config = {
    minAngle: -Math.PI / 2, maxAngle: Math.PI / 2, resolution: 100, maxRange: 0, rangeRes: 1, intensity: 1, scanningFrequency: 10,
  };
  await mustRefuse(scanner.setConfig(config), 'this configuration');
}

async function checkRanger(client: Client): Promise<void> {
  const scanner = await client.ranger(1);
  await reads(client, 60);
  await scanner.request(ranger.REQ_GET_GEOM);
  await reads(client, 3);
}

async function askMap(client: Client): Promise<void> {
  const device = await client.device('map', 0);
  await device.request(map.REQ_GET_INFO);
  await device.request(map.REQ_GET_DATA, { col: 0, row: 0, width: 20, height: 10 });
  await device.request(map.REQ_GET_DATA, { col: 495, row: 0, width: 50, height: 3 });
  await mustRefuse(device.request(map.REQ_GET_VECTOR), 'lines');
}

async function askSimulation(client: Client): Promise<void> {
  const simulator = await client.simulation(0);
  await simulator.pose('r0');
  await simulator.setPose('r0', { x: -6, y: -6, a: 0.5 });
  await mustRefuse(simulator.pose('nosuch'), 'a name that no model has');
  await simulator.pose3d('r0');
}

async function askProperties(client: Client): Promise<void> {
  const lights = await client.device('dio', 0);
  const stream = await client.device('opaque', 1);
  await lights.getInt('skip_lines');
  await lights.setInt('skip_lines', 7);
  await lights.getInt('skip_lines');
  await lights.getDouble('max_diff_pixels');
  await lights.setDouble('max_diff_pixels', 0.25);
  await lights.getDouble('max_diff_pixels');
  await lights.getInt('max_diff_pixels');
  await mustRefuse(lights.getInt('nope'), 'a property that it has not');
  await lights.hasCapability(common.REQ_CAPABILITIES);
  await stream.getString('ip');
  await stream.setString('ip', '127.0.0.2');
  await stream.getString('ip');
  await mustRefuse(stream.getBool('nobool'), 'a property that it has not');
}

function session(act: (client: Client) => Promise<void>, mode: Mode = Mode.PULL): (address: string) => Promise<void> {
  return async (address) => {
    const client = await connect(address, { mode });
    await act(client);
    await client.close();
  };
}

await main(
  {
    '05_playerprint_position2d': session(printPosition),
    '06_playerprint_defaults': session(printDefaults),
    '10_cxxtest_position2d': session(checkPosition),
    '11_cxxtest_laser': session(checkLaser),
    '12_cxxtest_ranger': session(checkRanger),
    '13_raw_map': session(askMap, Mode.PUSH),
    '14_raw_simulation': session(askSimulation, Mode.PUSH),
    '15_raw_properties': session(askProperties, Mode.PUSH),
  },
  'scenarios NAME HOST:PORT',
);
