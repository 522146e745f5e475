// Robots that come and go in the page: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { check, chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let page;
let other;
let errors;

const robots = (on = page) => on.evaluate(() => window.playhouse.robots);
const pose = (name, on = page) => on.evaluate((robot) => window.playhouse.pose(robot), name);
const by = (id, on = page) => on.getByTestId(id);
const selected = (name) => page.waitForFunction((robot) => document.querySelector('#panel').dataset.robot === robot, name);

before(async () => {
  program = await startProgram('web/e2e/yard.world', ['--paused']);
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

test('a robot is added in the middle of the picture and selected, for every viewer', async () => {
  await by('add').click();
  assert.deepEqual(await page.locator('[data-add]').allTextContents(), ['crate', 'beacon', 'pioneer2dx', 'mate', 'drifter']);
  await page.locator('[data-add=pioneer2dx]').click();
  await selected('guest~2');
  assert.deepEqual(await robots(), ['guest', 'mate', 'drifter', 'guest~2']);
  await other.waitForFunction(() => window.playhouse.robots.includes('guest~2'));
  assert.deepEqual(await pose('guest~2', other), await pose('guest~2'));
  const devices = await page.locator('#panel [data-device]').evaluateAll((all) => all.map((one) => one.dataset.device));
  assert.deepEqual(devices.slice(0, 1), ['position2d:3']);
  assert.ok(devices.includes('laser:3'));
});

test('a copy stands beside the selected robot', async () => {
  await chooseRobot(page, 'mate');
  await by('copy').click();
  await selected('mate~2');
  const [was, is] = [await pose('mate'), await pose('mate~2')];
  assert.ok(Math.hypot(was.x - is.x, was.y - is.y) > 0.4);
});

test('a robot that came drives and is seen by those that were there', async () => {
  await by('pause').click();
  await page.keyboard.down('w');
  const start = await pose('mate~2');
  await page.waitForFunction((from) => {
    const now = window.playhouse.pose('mate~2');
    return Math.hypot(now.x - from.x, now.y - from.y) > 0.3;
  }, start);
  await page.keyboard.up('w');
});

test('a removed robot is gone, and who is selected stays', async () => {
  await chooseRobot(other, 'drifter');
  await chooseRobot(page, 'guest');
  await page.keyboard.press('Delete');
  await page.waitForFunction(() => !window.playhouse.robots.includes('guest') && document.querySelector('#panel').hidden);
  await other.waitForFunction(() => !window.playhouse.robots.includes('guest'));
  assert.equal(await other.locator('#panel').getAttribute('data-robot'), 'drifter');
  const at = await pose('drifter', other);
  await other.waitForFunction((from) => {
    const now = window.playhouse.pose('drifter');
    return Math.hypot(now.x - from.x, now.y - from.y) > 0.1;
  }, at);
  await other.screenshot({ path: join(results, 'edited.png') });
});

test('a robot is carried on while others come and go', async () => {
  await by('pause').click();
  await page.waitForFunction(() => window.playhouse.paused);
  const at = await page.evaluate(() => window.playhouse.pixel('mate'));
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 20, at.y);
  await chooseRobot(other, 'guest~2');
  await other.keyboard.press('Delete');
  await page.waitForFunction(() => !window.playhouse.robots.includes('guest~2'));
  await page.mouse.move(at.x + 60, at.y);
  await page.mouse.up();
  await page.waitForFunction((x) => window.playhouse.pixel('mate').x > x + 40, at.x);
});

test('the world as it stands is saved as a file that runs, and has who is there now', async () => {
  const coming = page.waitForEvent('download');
  await by('save').click();
  const download = await coming;
  assert.equal(download.suggestedFilename(), 'yard.saved.world');
  const file = join(results, 'yard.saved.world');
  await download.saveAs(file);
  const checked = await check(file);
  assert.equal(checked.code, 0, checked.said);
  const saved = await startProgram(file, ['--paused']);
  const { page: again, errors: faults } = await watch(browser, saved.page, {}, 0);
  assert.deepEqual(await robots(again), await robots());
  for (const name of await robots()) assert.deepEqual(await pose(name, again), await pose(name));
  await again.close();
  await saved.stop();
  assert.deepEqual(faults, []);
});

test('nothing went wrong in either page', () => {
  assert.deepEqual(errors, [[], []]);
});
