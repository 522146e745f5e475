// The way back through the last minutes, in the page: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { chooseRobot, pictures, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let page;
let other;
let errors;

const tick = (on = page) => on.evaluate(() => window.playhouse.tick);
const robots = (on = page) => on.evaluate(() => window.playhouse.robots);
const pose = (name, on = page) => on.evaluate((robot) => window.playhouse.pose(robot), name);
const at = (wanted, on = page) => on.waitForFunction((t) => window.playhouse.tick === t, wanted);
const pausedIs = (wanted, on = page) => on.waitForFunction((p) => window.playhouse.paused === p, wanted);
/** Until the moment that the slider asked for is there. */
const arrived = () => page.waitForFunction(() => window.playhouse.tick === Number(document.querySelector('[data-testid=past]').value));
const past = () => page.getByTestId('past');

/** Where on the screen a part of the slider is, from 0 to 1. */
async function place(part) {
  const box = await past().boundingBox();
  return [box.x + 7 + part * (box.width - 14), box.y + box.height / 2];
}

before(async () => {
  program = await startProgram('worlds/cave.world', ['--speed', '10']);
  browser = await startBrowser();
  const one = await watch(browser, program.page, {}, 0);
  const two = await watch(browser, program.page, {}, 0);
  page = one.page;
  other = two.page;
  errors = [one.errors, two.errors];
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('the slider goes along with the time', async () => {
  await past().waitFor({ state: 'visible' });
  await page.waitForFunction(() => Number(document.querySelector('[data-testid=past]').max) > 60);
  const value = Number(await past().inputValue());
  await page.waitForFunction((before) => Number(document.querySelector('[data-testid=past]').value) > before, value);
  assert.match(await past().getAttribute('aria-valuetext'), /^\d+:\d\d\.\d$/);
});

test('dragging shows a moment to everybody, and letting go goes on from there', async () => {
  await page.screenshot({ path: join(results, 'past-now.png') });
  const was = await tick();
  const half = await past().evaluate((slider) => (Number(slider.min) + Number(slider.max)) / 2);
  await page.mouse.move(...(await place(1)));
  await page.mouse.down();
  await page.mouse.move(...(await place(0.6)), { steps: 4 });
  await page.mouse.move(...(await place(0.3)), { steps: 8 });
  await pausedIs(true);
  await page.waitForFunction((most) => window.playhouse.tick < most, half);
  await arrived();
  const there = await tick();
  await other.waitForFunction((t) => window.playhouse.tick === t && window.playhouse.paused, there);
  assert.deepEqual(await pose('azure', other), await pose('azure'));
  await page.screenshot({ path: join(results, 'past-then.png') });
  await page.mouse.up();
  await pausedIs(false);
  await page.waitForFunction((t) => window.playhouse.tick > t, there);
  assert.ok((await tick()) < was, 'it went on from there');
});

test('a paused run stays paused, and later moments wait until it goes on', async () => {
  await page.getByTestId('pause').click();
  await pausedIs(true);
  const left = await tick();
  const where = await pose('azure');
  await past().focus();
  await page.keyboard.press('Home');
  await page.waitForFunction((t) => window.playhouse.tick < t, left);
  await arrived();
  const first = await tick();
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((t) => window.playhouse.tick > t, first);
  await page.keyboard.press('ArrowLeft');
  await at(first);
  await page.keyboard.press('End');
  await at(left);
  assert.deepEqual(await pose('azure'), where, 'the moment that was left is there again');
  assert.equal(await page.evaluate(() => window.playhouse.paused), true);
  await pictures(page, 10);
  assert.equal(await page.evaluate(() => window.playhouse.paused), true);
});

test('a robot that was removed comes back, and one that came since goes', async () => {
  const start = await tick();
  await chooseRobot(page, 'azure');
  await page.getByTestId('copy').click();
  await page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'azure~2');
  await chooseRobot(page, 'azure');
  await page.keyboard.press('Delete');
  await page.waitForFunction(() => !window.playhouse.robots.includes('azure'));
  await page.getByTestId('step').click();
  await at(start + 1);
  await past().focus();
  await page.keyboard.press('Home');
  for (const each of [page, other])
    await each.waitForFunction(() => window.playhouse.robots.includes('azure') && !window.playhouse.robots.includes('azure~2'));
  await page.keyboard.press('End');
  await at(start + 1);
  assert.ok(!(await robots()).includes('azure'));
  assert.ok((await robots()).includes('azure~2'));
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.playhouse.robots.includes('azure'));
  await chooseRobot(page, 'azure');
  const devices = await page.locator('#panel [data-device]').evaluateAll((all) => all.map((one) => one.dataset.device));
  assert.ok(devices.includes('position2d:1'), devices.join(' '));
});

test('on a phone the slider has its place', async () => {
  // Three pages that draw in software at once take half a minute for a picture on a slow machine.
  await Promise.all([page.close(), other.close()]);
  const phone = await watch(browser, program.page, { viewport: { width: 390, height: 844 }, hasTouch: true, deviceScaleFactor: 2 }, 0);
  await phone.page.getByTestId('past').waitFor({ state: 'visible' });
  const box = await phone.page.locator('#clock').boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 390, `the clock is at ${box.x} and ${box.width} wide`);
  await phone.page.screenshot({ path: join(results, 'past-phone.png') });
  assert.deepEqual(phone.errors, []);
  await phone.page.close();
});

test('no page met an error', () => {
  assert.deepEqual(errors, [[], []]);
});
