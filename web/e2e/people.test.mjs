// People in a world: one joins through a page and walks, another page only watches, robots wander about them.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let human;
let observer;

const poseOf = (page, name) => page.evaluate((who) => window.playhouse.pose(who), name);
const has = (page, name) => page.waitForFunction((who) => window.playhouse.robots.includes(who), name);

before(async () => {
  program = await startProgram('worlds/room.world', ['--engine', 'arena']);
  browser = await startBrowser();
  human = await watch(browser, program.page);
  observer = await watch(browser, program.page);
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('somebody joins by name, sees through their own eyes and is seen by others', async () => {
  const { page } = human;
  await page.getByTestId('join').click();
  await page.getByTestId('answer').fill('Ada');
  await page.keyboard.press('Enter');
  await has(page, 'Ada');
  await has(observer.page, 'Ada');
  await page.waitForFunction(() => window.playhouse.eye !== null);
  const { z } = await page.evaluate(() => window.playhouse.eye);
  assert.ok(Math.abs(z - 0.93 * 1.75) < 0.02, `eyes at ${z} m`);
  assert.equal(await page.getByTestId('join').textContent(), 'Leave');
});

test('they walk ahead and aside by keys, which the observer sees', async () => {
  const { page } = human;
  const before = await poseOf(observer.page, 'Ada');
  await page.keyboard.down('s');
  await observer.page.waitForFunction((x) => window.playhouse.pose('Ada').x < x - 0.6, before.x);
  await page.keyboard.up('s');
  await page.screenshot({ path: join(results, 'people-human.png') });
  await page.keyboard.down('d');
  await observer.page.waitForFunction((y) => window.playhouse.pose('Ada').y < y - 0.4, before.y);
  await observer.page.getByTestId('tilt').click();
  await observer.page.waitForFunction(() => !window.playhouse.gliding);
  await observer.page.screenshot({ path: join(results, 'people-observer.png') });
  await page.keyboard.up('d');
});

test('what they say stands above them', async () => {
  const { page } = human;
  await page.keyboard.press('Enter');
  await page.getByTestId('say').fill('hello robots');
  await page.keyboard.press('Enter');
  await observer.page.waitForFunction(() => window.playhouse.bubbles.some(([who, text]) => who === 'Ada' && text === 'hello robots'));
});

test('their panel tells how they walk, not of wheels', async () => {
  const titles = await human.page.locator('#panel h3').allTextContents();
  assert.ok(titles.some((title) => title.startsWith('Walking')), titles.join());
  assert.ok(!titles.some((title) => title.startsWith('Wheels')), titles.join());
});

test('nobody is offered to drive another person', async () => {
  const { page } = observer;
  const driven = page.locator('#drive');
  await page.locator('#robots li', { hasText: 'Ada' }).click();
  await page.waitForFunction(() => document.querySelector('#panel').dataset.robot === 'Ada');
  assert.equal(await driven.isVisible(), false, 'keys of a person who is driven by somebody else');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.locator('#notice').isVisible(), false);
  await page.locator('#robots li', { hasNotText: 'Ada' }).first().click();
  await driven.waitFor({ state: 'visible' });
  await page.keyboard.press('Escape');
});

test('who only watches has no body and cannot speak', async () => {
  const before = await observer.page.evaluate(() => window.playhouse.robots.length);
  await observer.page.keyboard.press('Enter');
  assert.equal(await observer.page.getByTestId('say').isVisible(), false);
  assert.equal(await observer.page.evaluate(() => window.playhouse.robots.length), before);
});

test('Esc looks from above again, and who closes the page is gone', async () => {
  const { page } = human;
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => window.playhouse.eye === null);
  assert.deepEqual(human.errors, []);
  await page.close();
  await observer.page.waitForFunction(() => !window.playhouse.robots.includes('Ada'));
  assert.deepEqual(observer.errors, []);
});

/** A finger that pushes the stick ahead until it is lifted. */
async function pushAhead(page) {
  const { x, y, width } = await page.locator('#stick').boundingBox();
  const touch = await page.context().newCDPSession(page);
  const at = (up) => [{ x: x + width / 2, y: y + width / 2 - up }];
  await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: at(0) });
  await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: at(width / 3) });
  return () => touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
}

test('on a phone somebody walks without the panel, and speaks', async () => {
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  const { page, errors } = await watch(browser, program.page, phone);
  await page.getByTestId('join').tap();
  await page.getByTestId('answer').fill('Bo');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.playhouse.eye !== null);
  await page.locator('#panel button[aria-label=Close]').tap();
  const from = await poseOf(page, 'Bo');
  const lift = await pushAhead(page);
  await page.waitForFunction(({ x, y }) => {
    const now = window.playhouse.pose('Bo');
    return Math.hypot(now.x - x, now.y - y) > 0.3;
  }, from);
  await lift();
  await page.getByTestId('say').tap();
  await page.getByTestId('say').fill('hello from a phone');
  await page.keyboard.press('Enter');
  await observer.page.waitForFunction(() => {
    const said = Object.fromEntries(window.playhouse.bubbles);
    return said.Bo === 'hello from a phone';
  });
  await page.locator('#chat li').filter({ hasText: 'hello from a phone' }).waitFor();
  await page.screenshot({ path: join(results, 'people-phone.png') });
  assert.deepEqual(errors, []);
});
