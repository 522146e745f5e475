// A person behind a slow link: their own body moves at once; others see them walk, wave and speak. An observer flies.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { startDelayingProxy } from './delaying_proxy.mjs';
import { finish, results, startBrowser, startProgram, ticks, watch } from './program.mjs';

const kDelayMs = 400; // each way

let program;
let proxy;
let browser;
let human;
let observer;

const shot = (page, name) => page.screenshot({ path: join(results, `human-${name}.png`) });
const pose = (page) => page.evaluate(() => window.playhouse.pose('Ada'));
const drawn = (page) => page.evaluate(() => window.playhouse.drawn('Ada'));

before(async () => {
  program = await startProgram('worlds/room.world', ['--engine', 'arena']);
  proxy = await startDelayingProxy(new URL(program.page).port);
  browser = await startBrowser();
  human = await watch(browser, proxy.page);
  observer = await watch(browser, program.page);
});

after(async () => {
  await browser?.close();
  proxy?.stop();
  await program?.stop();
});

test('the own body moves in the picture before the program has even heard of it', async () => {
  const { page } = human;
  await page.getByTestId('join').click();
  assert.equal(await page.getByTestId('answer').inputValue(), 'visitor2', 'a visitor is there already');
  await page.getByTestId('answer').fill('Ada');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.playhouse.eye !== null);
  proxy.delay(kDelayMs);
  proxy.hold();
  await page.evaluate(() => {
    const [from, shown] = [window.playhouse.drawn('Ada'), window.playhouse.pose('Ada')];
    window.moved = new Promise((done) => {
      const look = () => {
        const [now, told] = [window.playhouse.drawn('Ada'), window.playhouse.pose('Ada')];
        if (Math.hypot(now.x - from.x, now.y - from.y) < 0.001) return requestAnimationFrame(look);
        done({ told: Math.hypot(told.x - shown.x, told.y - shown.y) });
      };
      look();
    });
  });
  await page.keyboard.down('s');
  const { told } = await page.evaluate(() => window.moved);
  assert.ok(told < 0.001, `the program had moved it by ${told} m already`);
  proxy.release();
  const from = await pose(page);
  await page.waitForFunction(({ x, y }) => Math.hypot(window.playhouse.pose('Ada').x - x, window.playhouse.pose('Ada').y - y) > 0.5, from);
  await page.keyboard.up('s');
});

test('and is where the program has it, once it stands', async () => {
  const { page } = human;
  await page.waitForFunction(() => {
    const [shown, told] = [window.playhouse.drawn('Ada'), window.playhouse.pose('Ada')];
    return Math.hypot(shown.x - told.x, shown.y - told.y) < 0.003;
  });
  const shown = await drawn(page);
  await observer.page.waitForFunction(({ x, y }) => {
    const seen = window.playhouse.pose('Ada');
    return seen && Math.hypot(seen.x - x, seen.y - y) < 0.01;
  }, shown);
  proxy.delay(0);
});

test('others see how they wave, and read what they say with their name and the time', async () => {
  const { page } = human;
  await page.getByTestId('wave').click();
  await observer.page.locator('#chat li[data-who="Ada"]').filter({ hasText: 'waves' }).waitFor();
  await observer.page.waitForFunction(() => !window.playhouse.waving.includes('Ada')); // after a moment
  await page.keyboard.press('Enter');
  await page.getByTestId('say').fill('good morning');
  await page.keyboard.press('Enter');
  const line = observer.page.locator('#chat li[data-who="Ada"]').last();
  await line.filter({ hasText: 'good morning' }).waitFor();
  assert.match(await line.textContent(), /^\d+:\d\d\.\dAdagood morning$/);
  assert.match(await observer.page.locator('#chat li').first().textContent(), /Adawaves$/);
  assert.equal(await observer.page.getByTestId('say').isVisible(), false, 'who only watches reads');
  await shot(observer.page, 'chat');
});

test('what a person types is heard by the programs of robots', async () => {
  const { page } = human;
  let heard = '';
  const listening = finish('watch', `127.0.0.1:${program.port}`, 'speech_recognition:0', '--count', '1').then(({ said }) => (heard = said));
  for (let k = 0; heard === '' && k < 30; ++k) { // a device hears from its opening on
    await page.keyboard.press('Enter');
    await page.getByTestId('say').fill(`follow me, green ${k}`);
    await page.keyboard.press('Enter');
    await Promise.race([listening, ticks(page, 10)]);
  }
  assert.match(heard, /"follow me, green \d+"/);
});

test('a gamepad walks a person who has joined', async () => {
  const { page } = human;
  await page.bringToFront();
  await page.evaluate(() => {
    window.pad = { connected: true, axes: [0, 0, 0, 0], buttons: [] };
    navigator.getGamepads = () => [window.pad];
  });
  const walked = ({ x, y }) => Math.hypot(window.playhouse.pose('Ada').x - x, window.playhouse.pose('Ada').y - y) > 0.2;
  const from = await pose(page);
  await page.evaluate(() => (window.pad.axes = [0, 1, 0, 0])); // the stick towards the person: back
  await observer.page.waitForFunction(walked, from);
  const back = await pose(page);
  await page.evaluate(() => (window.pad.axes = [0.9, 0, 0, 0])); // aside
  await observer.page.waitForFunction(walked, back);
  await page.evaluate(() => (window.pad.connected = false));
});

test('an observer flies through the world and is nobody', async () => {
  const { page } = observer;
  const robots = await page.evaluate(() => window.playhouse.robots.length);
  await page.keyboard.press('Escape');
  await page.keyboard.press('o');
  await page.waitForFunction(() => window.playhouse.flies);
  const from = await page.evaluate(() => window.playhouse.eye);
  await page.keyboard.down('w');
  await page.waitForFunction(({ z }) => window.playhouse.eye.z < z - 0.5, from);
  await page.keyboard.up('w');
  await page.keyboard.down('q');
  const { z } = await page.evaluate(() => window.playhouse.eye);
  await page.waitForFunction((low) => window.playhouse.eye.z > low + 0.3, z);
  await page.keyboard.up('q');
  const { yaw } = await page.evaluate(() => window.playhouse.eye);
  await page.mouse.move(600, 400);
  await page.mouse.down();
  await page.mouse.move(700, 400, { steps: 4 });
  await page.mouse.up();
  assert.ok((await page.evaluate(() => window.playhouse.eye)).yaw < yaw - 0.1, 'it looks to the right');
  assert.equal(await page.evaluate(() => window.playhouse.robots.length), robots);
  await shot(page, 'flight');
});

test('the shapes that physics uses are drawn on demand, of who comes as well', async () => {
  const { page } = observer;
  await page.keyboard.press('x');
  await page.waitForFunction(() => window.playhouse.physics > 0);
  const before = await page.evaluate(() => window.playhouse.physics);
  await shot(page, 'physics');
  await human.page.getByTestId('join').click(); // leaves
  await page.waitForFunction((count) => window.playhouse.physics === count - 1, before);
  await page.keyboard.press('o');
  await page.waitForFunction(() => window.playhouse.eye === null);
  assert.deepEqual(human.errors, []);
  assert.deepEqual(observer.errors, []);
});
