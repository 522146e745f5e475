// The experiment scenarios/perimeter with a person in a browser: she joins, walks in, and is in the results.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { results, startBrowser, startScenario, watch } from './program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'perimeter-'));
const file = join(folder, 'results.json');
let scenario;
let browser;
let human;
let observer;

before(async () => {
  scenario = await startScenario('scenarios/perimeter/perimeter.py', ['--seconds', '600', '--results', file]);
  browser = await startBrowser();
  human = await watch(browser, scenario.page);
  observer = await watch(browser, scenario.page);
});

after(async () => {
  await browser?.close();
  await scenario?.stop();
  rmSync(folder, { recursive: true });
});

test('who joins begins outside the fence', async () => {
  const { page } = human;
  await page.getByTestId('join').click();
  await page.getByTestId('answer').fill('Ada');
  await page.keyboard.press('Enter');
  await scenario.says(/Ada joined/);
  await observer.page.waitForFunction(() => {
    const pose = window.playhouse.robots.includes('Ada') && window.playhouse.pose('Ada');
    return pose && Math.hypot(pose.x - 5, pose.y - 11) < 0.5;
  });
});

test('she walks in through a gap, until she has what is in the middle or a robot has her', async () => {
  const { page } = human;
  await page.keyboard.down('d');
  await observer.page.waitForFunction(() => window.playhouse.pose('Ada').y < 7);
  await observer.page.getByTestId('tilt').click();
  await observer.page.waitForFunction(() => !window.playhouse.gliding);
  await observer.page.screenshot({ path: join(results, 'perimeter-observer.png') });
  await page.screenshot({ path: join(results, 'perimeter-human.png') });
  const isIn = observer.page.waitForFunction(() => window.playhouse.pose('Ada').y < 0.3).catch(() => undefined);
  await Promise.race([isIn, scenario.says(/Ada (was caught|reached)/)]);
  await page.keyboard.up('d');
  await page.keyboard.down('s');
  await scenario.says(/Ada (was caught by guard\d|reached the cargo)/);
  await page.keyboard.up('s');
});

test('the results have her', async () => {
  assert.deepEqual(human.errors, []);
  assert.deepEqual(observer.errors, []);
  await browser.close();
  assert.equal(await scenario.stop(), 130);
  const { score, events } = JSON.parse(readFileSync(file, 'utf8'));
  const scored = events.filter(({ event }) => event === 'was caught' || event === 'reached the cargo');
  assert.ok(scored.length >= 1);
  assert.equal(score.people.Ada.caught + score.people.Ada.reached, scored.length);
  assert.equal(score.guards + score.intruders, scored.length);
  assert.equal(events[0].event, 'joined');
  // Her page is closed before the experiment ends, so that she may have been seen to leave.
  assert.deepEqual(events.filter((event) => !scored.includes(event)).slice(1).map(({ event }) => event).filter((event) => event !== 'left'), []);
});
