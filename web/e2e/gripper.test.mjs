// What a person sees of grippers: how they stand, what they hold, and that it stays when the robot goes.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let viewer;
let page;

const told = (what) => page.getByTestId(what).textContent();

before(async () => {
  program = await startProgram('worlds/gripper.world', ['--speed', '8']);
  browser = await startBrowser();
  viewer = await watch(browser, program.page);
  page = viewer.page;
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('a gripper is told as it stands, and what it feels while somebody uses it, which to look at it is not', async () => {
  await chooseRobot(page, 'r0');
  await page.waitForFunction(() => document.querySelector('[data-testid=paddles]')?.textContent === 'open');
  assert.deepEqual(await Promise.all(['lift', 'holds', 'beams', 'contacts'].map(told)), ['down', 'nothing', 'nobody uses it', 'nobody uses it']);
  await chooseRobot(page, 'collector');
  await page.waitForFunction(() => ['none', 'inner', 'outer', 'inner, outer'].includes(document.querySelector('[data-testid=beams]').textContent));
});

test('a puck that was taken up is named, and stays where the robot is removed', async () => {
  await chooseRobot(page, 'collector');
  await page.waitForFunction(() => document.querySelector('[data-testid=holds]').textContent.startsWith('puck'));
  const puck = await told('holds');
  await page.waitForFunction(() => document.querySelector('[data-testid=paddles]').textContent === 'closed, 68 %');
  assert.equal(await told('contacts'), 'left, right');
  await page.screenshot({ path: join(results, 'gripper.png') });
  await page.getByTestId('remove').click();
  await page.waitForFunction(() => !window.playhouse.robots.includes('collector'));
  assert.ok(await page.evaluate((name) => window.playhouse.pose(name), puck));
  assert.deepEqual(viewer.errors, []);
});
