// What a person sees of what models say and carry: bubbles and pennants in the picture, and the panel.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { connect } from 'node:net';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

const kWelcome = 'Welcome, and please mind the robots that come from the left';

let program;
let browser;
let viewer;
let page;

before(async () => {
  program = await startProgram('web/e2e/speech.world');
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

/** A message of Player: interface and index, type, subtype, body. */
function message(interf, index, type, subtype, body) {
  const head = Buffer.alloc(40);
  [0, 0, interf, index, type, subtype].forEach((word, k) => head.writeUInt32BE(word, 4 * k));
  head.writeUInt32BE(body.length, 36);
  return Buffer.concat([head, body]);
}

/** A Player client that has speech:index say something. */
async function say(index, text) {
  const client = connect(program.port, '127.0.0.1');
  const open = Buffer.alloc(28);
  [0, 0, 12, index, 1, 0, 0].forEach((word, k) => open.writeUInt32BE(word, 4 * k));
  const raw = Buffer.from(`${text}\0`);
  const counts = Buffer.alloc(8);
  counts.writeUInt32BE(raw.length, 0);
  counts.writeUInt32BE(raw.length, 4);
  const padding = Buffer.alloc((4 - (raw.length % 4)) % 4);
  client.write(Buffer.concat([message(1, 0, 3, 3, open), message(12, index, 2, 1, Buffer.concat([counts, raw, padding]))]));
  await new Promise((answered) => client.on('data', (bytes) => bytes.length > 32 && answered()));
  return client;
}

const bubbles = () => page.evaluate(() => Object.fromEntries(window.playhouse.bubbles));
const waitForBubble = (name, text) =>
  page.waitForFunction(([who, what]) => (Object.fromEntries(window.playhouse.bubbles)[who] ?? '') === what, [name, text]);

test('what a world file has a model say is there for whoever comes, and flags are counted', async () => {
  await waitForBubble('host', kWelcome);
  await page.waitForFunction(() => JSON.stringify(window.playhouse.tokens) === '[["depot",3],["store",12]]');
  await chooseRobot(page, 'host');
  assert.equal(await page.getByTestId('says').textContent(), kWelcome);
  assert.ok(await page.getByTestId('flags').isHidden());
});

test('what a client has a robot say appears, changes and goes, for a viewer who comes late as well', async () => {
  await chooseRobot(page, 'guest');
  assert.ok(await page.getByTestId('says').isHidden());
  const client = await say(1, 'schön hier');
  await waitForBubble('guest', 'schön hier');
  assert.equal(await page.getByTestId('says').textContent(), 'schön hier');
  await page.screenshot({ path: join(results, 'speech.png') });
  const late = await watch(browser, program.page);
  await late.page.waitForFunction(() => Object.fromEntries(window.playhouse.bubbles).guest === 'schön hier');
  await late.page.getByTestId('tilt').click();
  await late.page.waitForFunction(() => !window.playhouse.gliding && Object.fromEntries(window.playhouse.bubbles).guest === 'schön hier');
  await late.page.screenshot({ path: join(results, 'speech-tilted.png') });
  assert.deepEqual(late.errors, []);
  await late.page.close();
  (await say(1, '')).destroy();
  client.destroy();
  await waitForBubble('guest', '');
  assert.ok(await page.getByTestId('says').isHidden());
});

test('what a robot said goes with it, and the others go on speaking', async () => {
  (await say(1, 'farewell')).destroy();
  await waitForBubble('guest', 'farewell');
  await chooseRobot(page, 'guest');
  await page.getByTestId('remove').click();
  await page.waitForFunction(() => !window.playhouse.robots.includes('guest'));
  await waitForBubble('host', kWelcome); // what robots say comes a message after the list of them
  assert.deepEqual(await bubbles(), { host: kWelcome });
});

test('who comes later reads what was said before, also of who is gone', async () => {
  const late = await watch(browser, program.page);
  await late.page.locator('#chat li[data-who="guest"]').filter({ hasText: 'farewell' }).waitFor();
  const lines = await late.page.locator('#chat li').allTextContents();
  assert.deepEqual(lines.map((line) => line.replace(/^[\d:.]+/, '')), [`host${kWelcome}`, 'guestschön hier', 'guestfarewell']);
  await late.page.screenshot({ path: join(results, 'speech-late.png') });
  await late.page.close();
});

test('speech and flags can be hidden', async () => {
  await page.keyboard.press('b');
  await page.waitForFunction(() => window.playhouse.bubbles.length === 0 && window.playhouse.tokens.length === 0);
  await page.keyboard.press('b');
  await waitForBubble('host', kWelcome);
  assert.deepEqual(viewer.errors, []);
});
