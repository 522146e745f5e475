// The page of a server without a world, in a browser: PLAYHOUSE_PROGRAM=path of the program.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { McapIndexedReader } from '@mcap/core';
import { decompress } from 'fzstd';
import { openPage, results, serve, startBrowser, startProgram } from './program.mjs';

const recording = join(mkdtempSync(join(tmpdir(), 'devices-')), 'lab.mcap');
let robot; // a world, as the real robot
let relay;
let browser;
let page;
const errors = [];

/** The devices of another server, as of a robot. */
function relayOf(port) {
  const file = join(mkdtempSync(join(tmpdir(), 'devices-')), 'relay.cfg');
  const devices = ['position2d:0', 'laser:0', 'sonar:0', 'simulation:0'];
  const remote = devices.map((device) => `"127.0.0.1:${port}:${device}"`).join(' ');
  writeFileSync(file, `driver\n(\n  name "passthrough"\n  requires [ ${remote} ]\n  provides [ ${devices.map((d) => `"${d}"`).join(' ')} ]\n)\n`);
  return file;
}

/** The number in a row of a card's table. */
function value(device, name) {
  return page.evaluate(([device, name]) => {
    const rows = [...document.querySelectorAll(`.card[data-device="${device}"] tr`)];
    const row = rows.find(({ cells }) => cells[0].textContent === name);
    return row ? Number.parseFloat(row.cells[1].textContent) : undefined;
  }, [device, name]);
}

const choose = (device) => page.locator(`#list [data-device="${device}"]`).click();
const card = (device) => page.locator(`.card[data-device="${device}"]`);
const fills = (device) => page.waitForFunction((d) => document.querySelectorAll(`.card[data-device="${d}"] tr`).length > 0, device);

before(async () => {
  robot = await startProgram('worlds/simple.world');
  relay = await serve(relayOf(robot.port), ['--port', '0', '--record', recording]);
  browser = await startBrowser();
  page = await openPage(browser, { viewport: { width: 1280, height: 800 } });
  page.on('pageerror', (error) => errors.push(error.message));
  await page.goto(relay.page);
  await page.locator('#list [data-device="position2d:0"]').waitFor();
});

after(async () => {
  await browser?.close();
  await relay?.stop();
  await robot?.stop();
});

test('the devices are listed, and a chosen one shows its values', async () => {
  assert.equal(await page.locator('#list button').count(), 4);
  await choose('position2d:0');
  await fills('position2d:0');
  assert.equal(typeof (await value('position2d:0', 'pos.px')), 'number');
  await choose('laser:0');
  await page.waitForFunction(() => /m of \d+ ranges/.test(document.querySelector('.card[data-device="laser:0"] td')?.textContent ?? ''));
});

test('a person drives the robot of the other server, which stops when driving ends', async () => {
  const heading = await value('position2d:0', 'pos.pa');
  await page.getByTestId('drive').click();
  await page.waitForFunction(() => document.querySelector('[data-testid=drive]').getAttribute('aria-pressed') === 'true');
  await page.keyboard.down('ArrowLeft');
  await page.waitForFunction(() => {
    const rows = [...document.querySelectorAll('.card[data-device="position2d:0"] tr')];
    return Number.parseFloat(rows.find(({ cells }) => cells[0].textContent === 'vel.pa').cells[1].textContent) > 0.1;
  });
  await page.screenshot({ path: join(results, 'devices.png') });
  await page.keyboard.up('ArrowLeft');
  await page.getByTestId('drive').click();
  await page.waitForFunction(() => {
    const rows = [...document.querySelectorAll('.card[data-device="position2d:0"] tr')];
    return Number.parseFloat(rows.find(({ cells }) => cells[0].textContent === 'vel.pa').cells[1].textContent) === 0;
  });
  assert.notEqual(await value('position2d:0', 'pos.pa'), heading);
});

test('an observer is offered no stick, and told why', async (t) => {
  const guests = join(mkdtempSync(join(tmpdir(), 'devices-')), 'guests.txt');
  writeFileSync(guests, 'admin the-admin-1 Ada\nobserver watcher-001\n');
  const guarded = await serve(relayOf(robot.port), ['--port', '0', '--guests', guests]);
  t.after(() => guarded.stop()); // also after a failure: who waits for it would wait for ever
  const observer = await openPage(browser, {});
  await observer.goto(`${guarded.page}#watcher-001`);
  await observer.locator('#list [data-device="position2d:0"]').click();
  await observer.getByTestId('observes').waitFor();
  assert.equal(await observer.getByTestId('drive').count(), 0);
  await observer.goto('about:blank');
  await observer.goto(`${guarded.page}#the-admin-1`);
  await observer.locator('#list [data-device="position2d:0"]').click();
  await observer.getByTestId('drive').waitFor();
  await observer.close();
});

test('the server says who is connected, and this page is one of them', async () => {
  await page.waitForFunction(() => /1 client/.test(document.querySelector('#server')?.textContent ?? ''));
  await page.waitForFunction(() => /2 devices/.test(document.querySelector('#server')?.textContent ?? ''));
});

test('a device that is no longer watched is closed', async () => {
  await card('laser:0').locator('header button').click();
  await page.waitForFunction(() => /position2d:0/.test(document.querySelector('#server')?.textContent ?? ''));
  assert.equal(await card('laser:0').count(), 0);
});

test('the recording is read by the library of its format, and has what the page showed', async () => {
  const shown = await value('position2d:0', 'pos.pa');
  assert.match(await page.getByTestId('recording').textContent(), /lab\.mcap\d+ messages/);
  await relay.stop();
  const file = readFileSync(recording);
  const reader = await McapIndexedReader.Initialize({
    readable: { size: async () => BigInt(file.length), read: async (offset, size) => file.subarray(Number(offset), Number(offset + size)) },
    decompressHandlers: { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) },
  });
  const channels = [...reader.channelsById.values()];
  assert.ok(channels.every(({ messageEncoding }) => messageEncoding === 'json'));
  const topics = channels.map(({ topic }) => topic.replace(/^\/\d+/, '')).sort();
  assert.deepEqual(topics, ['/laser/0/scan', '/position2d/0/state', '/sonar/0/ranges']);
  const last = new Map();
  let before = 0n;
  for await (const { channelId, logTime, data } of reader.readMessages()) {
    assert.ok(logTime >= before);
    before = logTime;
    last.set(reader.channelsById.get(channelId).topic.split('/')[2], JSON.parse(new TextDecoder().decode(data)));
  }
  assert.ok(Math.abs(Number(before) / 1e6 - statSync(recording).mtimeMs) < 60000, 'by the clock that files have');
  assert.equal(last.get('position2d').pos.pa.toFixed(3), shown.toFixed(3), 'it has stood still since');
  assert.equal(last.get('laser').ranges.length, 180);
  const schema = [...reader.schemasById.values()].find(({ name }) => name === 'laser.data.scan');
  assert.equal(JSON.parse(new TextDecoder().decode(schema.data)).properties.ranges.type, 'array');
});

test('after a restart of the server the page shows the same devices again', async () => {
  const { port } = new URL(relay.page);
  const clients = relay.port; // it has ended before
  await page.waitForFunction(() => document.querySelector('.dot').dataset.state === 'lost');
  relay = await serve(relayOf(robot.port), ['--port', String(clients)], port);
  await page.waitForFunction(() => document.querySelector('.dot').dataset.state === 'live');
  await fills('position2d:0');
  assert.deepEqual(errors, []);
});
