// Recordings as tools that know MCAP read them, here by its own library: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { McapIndexedReader, McapStreamReader } from '@mcap/core';
import { decompress } from 'fzstd';
import { results, startBrowser, watch } from './program.mjs';

const root = resolve(fileURLToPath(import.meta.url), '../../..');
const program = process.env.PLAYHOUSE_PROGRAM ?? join(root, 'build/playhouse');
const unpack = { decompressHandlers: { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) } };

let folder;
let file;
let path;

before(() => {
  folder = mkdtempSync(join(tmpdir(), 'recording-'));
  path = join(folder, 'cave.mcap');
  execFileSync(program, ['run', 'worlds/cave.world', '--fast', '--headless', '--port', '0', '--duration', '30', '--record', path], { cwd: root, stdio: 'ignore' });
  file = readFileSync(path);
});

after(() => rmSync(folder, { recursive: true }));

const open = () =>
  McapIndexedReader.Initialize({
    readable: { size: async () => BigInt(file.length), read: async (offset, size) => file.subarray(Number(offset), Number(offset + size)) },
    ...unpack,
  });

async function messagesOf(reader, options) {
  const messages = [];
  for await (const message of reader.readMessages(options)) messages.push(message);
  return messages;
}

/** Reads a message of ROS 2: numbers aligned to their size, behind a head of four bytes. */
class Cdr {
  constructor(bytes) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset + 4, bytes.byteLength - 4);
    this.at = 0;
  }
  number(type, size) {
    this.at = Math.ceil(this.at / size) * size;
    const value = this.view[`get${type}`](this.at, true);
    this.at += size;
    return value;
  }
  u32() {
    return this.number('Uint32', 4);
  }
  text() {
    const size = this.u32();
    const bytes = new Uint8Array(this.view.buffer, this.view.byteOffset + this.at, size - 1);
    this.at += size;
    return new TextDecoder().decode(bytes);
  }
}

test('the summary lists channels with schemas, and what is in the file', async () => {
  const reader = await open();
  assert.equal(reader.header.profile, 'ros2');
  assert.equal(reader.footer.summaryOffsetStart > reader.footer.summaryStart, true);
  const topics = [...reader.channelsById.values()].map((channel) => channel.topic);
  assert.equal(new Set(topics).size, topics.length);
  for (const topic of ['/tf', '/playhouse/checks', '/playhouse/states']) assert.ok(topics.includes(topic), topic);
  assert.ok(topics.some((topic) => topic.endsWith('/scan')));
  assert.ok(topics.some((topic) => topic.endsWith('/position')));
  for (const channel of reader.channelsById.values()) {
    assert.equal(channel.messageEncoding, 'cdr');
    assert.equal(reader.schemasById.get(channel.schemaId).encoding, 'ros2msg');
  }
  const [format, start, ...others] = reader.attachmentIndexes.map((entry) => entry.name);
  assert.match(format, /^playhouse recording \d+$/);
  assert.deepEqual([start, ...others], ['start.run']);
  const counted = [...reader.statistics.channelMessageCounts.values()].reduce((a, b) => a + b);
  assert.equal(reader.statistics.messageCount, counted);
  assert.equal((await messagesOf(reader)).length, Number(counted));
  assert.equal(reader.statistics.messageEndTime, 30_000_000_000n);
});

test('there are poses in every tick in which somebody moved, and in the one before of who stood', async () => {
  const poses = await messagesOf(await open(), { topics: ['/tf'] });
  const all = poses.map((each) => each.logTime);
  assert.deepEqual(all, [...all].sort((a, b) => Number(a - b)));
  const times = [...new Set(all)];
  assert.ok(times.every((time) => all.filter((each) => each === time).length <= 2));
  const ticks = Array.from({ length: 301 }, (_, n) => BigInt(n) * 100_000_000n);
  assert.deepEqual(times, ticks.filter((tick) => times.includes(tick)));
  assert.ok(times.length > 290);
  const first = new Cdr(poses[0].data);
  assert.ok(first.u32() > 13);
  assert.deepEqual([first.number('Int32', 4), first.u32()], [0, 0]);
  assert.equal(first.text(), 'world');
  assert.notEqual(first.text(), '');
  for (let i = 0; i < 3; ++i) assert.ok(Math.abs(first.number('Float64', 8)) < 20);
  const q = [0, 1, 2, 3].map(() => first.number('Float64', 8));
  assert.ok(Math.abs(Math.hypot(...q) - 1) < 1e-12);
});

test('what cameras see are Images of ROS', async () => {
  const seen = join(folder, 'camera.mcap');
  execFileSync(program, ['run', 'worlds/camera.world', '--fast', '--headless', '--port', '0', '--duration', '1', '--record', seen, '--record-only', 'camera'], { cwd: root, stdio: 'ignore' });
  const bytes = readFileSync(seen);
  const reader = await McapIndexedReader.Initialize({
    readable: { size: async () => BigInt(bytes.length), read: async (offset, size) => bytes.subarray(Number(offset), Number(offset + size)) },
    ...unpack,
  });
  const images = await messagesOf(reader, { topics: ['/r0/color/image'] });
  assert.equal(images.length, 10);
  const channel = [...reader.channelsById.values()].find((each) => each.topic === '/r0/color/image');
  assert.equal(reader.schemasById.get(channel.schemaId).name, 'sensor_msgs/msg/Image');
  const cdr = new Cdr(images.at(-1).data);
  assert.deepEqual([cdr.u32(), cdr.u32(), cdr.text()], [1, 0, 'r0/color_optical']);
  assert.deepEqual([cdr.u32(), cdr.u32(), cdr.text()], [120, 160, 'rgb8']);
  assert.deepEqual([cdr.number('Uint8', 1), cdr.u32(), cdr.u32()], [0, 480, 160 * 120 * 3]);
  const colors = new Set();
  for (let k = 0; k < 160 * 120; ++k) colors.add([0, 1, 2].map(() => cdr.number('Uint8', 1)).join());
  assert.ok(colors.has('255,0,0'), [...colors].join(' '));
});

test('scans are LaserScans of ROS', async () => {
  const reader = await open();
  const channel = [...reader.channelsById.values()].find((each) => each.topic.endsWith('/scan'));
  assert.equal(reader.schemasById.get(channel.schemaId).name, 'sensor_msgs/msg/LaserScan');
  const [scan] = await messagesOf(reader, { topics: [channel.topic] });
  const cdr = new Cdr(scan.data);
  cdr.u32(), cdr.u32();
  assert.equal(`/${cdr.text()}`, channel.topic.replace(/scan$/, '0'));
  const [from, to, step] = [0, 1, 2].map(() => cdr.number('Float32', 4));
  cdr.u32(), cdr.u32();
  const [least, most] = [cdr.number('Float32', 4), cdr.number('Float32', 4)];
  const ranges = Array.from({ length: cdr.u32() }, () => cdr.number('Float32', 4));
  assert.ok(Math.abs(from + (ranges.length - 1) * step - to) < 1e-4);
  assert.ok(ranges.every((range) => (range >= least && range < most) || range === Infinity));  // REP 117
});

test('a file that is cut is read from the front up to its last whole chunk', () => {
  const reader = new McapStreamReader({ ...unpack, noMagicPrefix: false });
  reader.append(file.subarray(0, (file.length * 3) / 4));
  let records = 0;
  while (reader.nextRecord()) ++records;
  assert.ok(records > 1000);
});

/** Where each frame is in a tick, by the recording: what was told last of it. */
async function recordedPoses(tick) {
  const poses = {};
  for (const message of await messagesOf(await open(), { topics: ['/tf'], endTime: BigInt(tick) * 100_000_000n })) {
    const cdr = new Cdr(message.data);
    for (let count = cdr.u32(); count > 0; --count) {
      cdr.u32(), cdr.u32(), cdr.text();
      const name = cdr.text();
      poses[name] = [0, 1].map(() => cdr.number('Float64', 8));
      for (let i = 0; i < 5; ++i) cdr.number('Float64', 8);
    }
  }
  return poses;
}

test('replay shows the run in the page, at any moment of it, and lets nobody change it', async () => {
  const child = spawn(program, ['replay', path, '--web', '0', '--paused'], { stdio: ['ignore', 'ignore', 'pipe'] });
  const exit = new Promise((done) => child.once('exit', (code) => done(code)));
  const browser = await startBrowser();
  try {
    const url = await new Promise((found, fail) => {
      let said = '';
      child.once('exit', (code) => fail(new Error(`the program ended with ${code}:\n${said}`)));
      child.stderr.on('data', (bytes) => {
        said += bytes;
        const place = said.match(/web page: (http:\S+)/);
        if (place) found(place[1]);
      });
    });
    const { page, errors } = await watch(browser, url, {}, 0);
    const slider = page.getByTestId('past');
    await slider.waitFor({ state: 'visible' });
    assert.deepEqual([await slider.getAttribute('min'), await slider.getAttribute('max')], ['0', '300']);
    const tickIs = (tick) => page.waitForFunction((wanted) => window.playhouse.tick === wanted, tick);
    const assertPlaces = async (tick) => {
      await tickIs(tick);
      const recorded = await recordedPoses(tick);
      for (const robot of ['azure', 'amber']) {
        const shown = await page.evaluate((name) => window.playhouse.pose(name), robot);
        const [x, y] = [shown.x ?? shown[0], shown.y ?? shown[1]];
        assert.ok(Math.hypot(x - recorded[robot][0], y - recorded[robot][1]) < 0.002, `${robot} at ${tick}: ${x} ${y}, ${recorded[robot]}`);
      }
    };
    await slider.focus();
    await page.keyboard.press('End');
    await assertPlaces(300);
    await page.keyboard.press('ArrowLeft');
    await assertPlaces(290);
    await page.keyboard.press('Home');
    await tickIs(0);
    await page.screenshot({ path: join(results, 'replay.png') });
    for (const id of ['add', 'save', 'join']) assert.equal(await page.getByTestId(id).isVisible(), false, id);
    assert.equal(await page.getByTestId('pause').isEnabled(), true);

    await page.locator('#robots [data-robot="azure"]').click();
    await page.keyboard.press('Delete');
    await page.getByText('This is a recording: nothing in it can be changed').first().waitFor();
    assert.equal(await page.locator('#drive').isVisible(), false);
    assert.ok(await page.evaluate(() => window.playhouse.robots.includes('azure')));

    await page.getByTestId('pause').click();
    await page.waitForFunction(() => window.playhouse.tick > 3);
    assert.deepEqual(errors, []);
  } finally {
    await browser.close();
    child.kill('SIGTERM');
    assert.equal(await exit, 143);
  }
});
