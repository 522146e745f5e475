// What a person sees of what clients draw: in the frame of the robot, from above and tilted, for who comes late as well.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { once } from 'node:events';
import { connect } from 'node:net';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { inflateSync } from 'node:zlib';
import { pictures, results, serve, startBrowser, watch } from './program.mjs';

const [kPlayer, kSimulation, kGraphics2d] = [1, 31, 55];
const [kCommand, kRequest] = [2, 3];
const [kClear, kPolygon] = [1, 4];

let program;
let browser;
let viewer;
let page;
let client;

before(async () => {
  program = await serve(join(dirname(fileURLToPath(import.meta.url)), 'drawings.cfg'));
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
  client = connect(program.port, '127.0.0.1');
  for (const interf of [kSimulation, kGraphics2d]) client.write(message(kPlayer, kRequest, 3, words(0, 0, interf, 0, 1, 0, 0)));
  client.on('data', () => {}); // answers are not looked at
  await once(client, 'connect');
});

after(async () => {
  client?.destroy();
  await browser?.close();
  await program?.stop();
});

const words = (...numbers) => Buffer.concat(numbers.map((number) => Buffer.from(Uint32Array.of(number).buffer).swap32()));
const doubles = (...numbers) => Buffer.concat(numbers.map((number) => Buffer.from(Float64Array.of(number).buffer).swap64()));

/** A message of Player to the first device of an interface. */
function message(interf, type, subtype, body = Buffer.alloc(0)) {
  return Buffer.concat([words(0, 0, interf, 0, type, subtype, 0, 0, 0, body.length), body]);
}

/** A filled red square from 0.5 m to 1.5 m ahead of the robot. */
function square() {
  const red = words(255, 255, 0, 0);
  return Buffer.concat([words(4, 4), doubles(0.5, -0.5, 1.5, -0.5, 1.5, 0.5, 0.5, 0.5), red, red, words(1)]);
}

/** The color of the page at a place on the floor: red, green, blue. */
async function colorAt(on, x, y) {
  const at = await on.evaluate(([x, y]) => window.playhouse.pixelAt(x, y), [x, y]);
  const png = await on.screenshot({ clip: { x: Math.round(at.x), y: Math.round(at.y), width: 1, height: 1 } });
  const packed = [];
  for (let chunk = 8; chunk < png.length; chunk += 12 + png.readUInt32BE(chunk)) {
    if (png.toString('latin1', chunk + 4, chunk + 8) === 'IDAT') packed.push(png.subarray(chunk + 8, chunk + 8 + png.readUInt32BE(chunk)));
  }
  return [...inflateSync(Buffer.concat(packed)).subarray(1, 4)]; // behind the filter of the row
}

const isRed = ([red, green, blue]) => red > 200 && green < 60 && blue < 60;
const waitForDrawings = (on, names) =>
  on.waitForFunction((names) => JSON.stringify(window.playhouse.drawings.map(([name]) => name)) === names, JSON.stringify(names));

async function expectRed(on, x, y, red = true) {
  await pictures(on, 2);
  const color = await colorAt(on, x, y);
  assert.equal(isRed(color), red, `${color} at ${x}, ${y}`);
}

test('a drawing is where the client made it, in the frame of the robot', async () => {
  await expectRed(page, -2, 1, false);
  client.write(message(kGraphics2d, kCommand, kPolygon, square()));
  await waitForDrawings(page, ['r']);
  await expectRed(page, -2, 1);
  await expectRed(page, -2.4, 1.4);
  await expectRed(page, -2, 1.8, false);
  await page.screenshot({ path: join(results, 'drawings.png') });
});

test('it moves and turns with the robot', async () => {
  const name = Buffer.from('r\0\0\0');
  client.write(message(kSimulation, kRequest, 2, Buffer.concat([words(2, 2), name, doubles(1, -1, 0)])));
  await page.waitForFunction(() => Math.hypot(window.playhouse.drawn('r').x - 1, window.playhouse.drawn('r').y + 1) < 0.01);
  await expectRed(page, 2, -1);
  await expectRed(page, -2, 1, false);
});

test('who comes late sees it, from above and tilted, and may hide it', async () => {
  const late = await watch(browser, program.page);
  await waitForDrawings(late.page, ['r']);
  await expectRed(late.page, 2, -1);
  await late.page.getByTestId('tilt').click();
  await late.page.waitForFunction(() => !window.playhouse.gliding);
  await expectRed(late.page, 2.2, -1.2);
  await late.page.screenshot({ path: join(results, 'drawings-tilted.png') });
  await late.page.keyboard.press('j');
  await expectRed(late.page, 2.2, -1.2, false);
  assert.deepEqual(late.errors, []);
  await late.page.close();
});

test('it goes when the client clears it', async () => {
  client.write(message(kGraphics2d, kCommand, kClear));
  await waitForDrawings(page, []);
  await expectRed(page, 2, -1, false);
  assert.deepEqual(viewer.errors, []);
});
