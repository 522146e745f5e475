// A world with guests: an admin, a human and an observer, each by a link of their own.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { openPage, results, startBrowser, startProgram, watch } from './program.mjs';

const folder = mkdtempSync(join(tmpdir(), 'guests-'));
let program;
let browser;
let admin;
let human;
let observer;

const paused = (page, wanted) => page.waitForFunction((is) => window.playhouse.paused === is, wanted);

before(async () => {
  const file = join(folder, 'guests.txt');
  writeFileSync(file, 'admin  the-teacher  Ada\nhuman  the-pupil-7  Bob\nobserver *\n');
  program = await startProgram('worlds/room.world', ['--engine', 'arena', '--guests', file]);
  browser = await startBrowser();
  admin = await watch(browser, `${program.page}#the-teacher`);
  human = await watch(browser, `${program.page}#the-pupil-7`);
  observer = await watch(browser, program.page);
});

after(async () => {
  await browser?.close();
  await program?.stop();
  rmSync(folder, { recursive: true });
});

test('the bar offers what the role allows', async () => {
  assert.equal(await admin.page.getByTestId('pause').isDisabled(), false);
  assert.equal(await human.page.getByTestId('pause').isDisabled(), true);
  assert.equal(await human.page.getByTestId('join').isVisible(), true);
  assert.equal(await observer.page.getByTestId('pause').isDisabled(), true);
  assert.equal(await observer.page.getByTestId('join').isVisible(), false);
  await admin.page.getByTestId('pause').click();
  await paused(observer.page, true);
  await observer.page.keyboard.press(' ');
  await observer.page.getByText('Only an admin may do that in this world.').waitFor();
  assert.equal(await observer.page.evaluate(() => window.playhouse.paused), true);
  await admin.page.getByTestId('pause').click();
  await paused(observer.page, false);
});

test('somebody with a name in the file joins under it, and is not asked for another', async () => {
  const { page } = human;
  await page.getByTestId('join').click();
  assert.equal(await page.locator('#ask').isVisible(), false);
  await observer.page.waitForFunction(() => window.playhouse.robots.includes('Bob'));
});

test('an admin sees who is there, mutes them and sends them out', async () => {
  const { page } = admin;
  await page.getByTestId('people').click();
  const bob = page.locator('[data-person=Bob]');
  await bob.getByTestId('mute').click();
  await bob.getByText('human, muted').waitFor();
  await page.screenshot({ path: join(results, 'guests.png') });
  await human.page.keyboard.press('Enter');
  await human.page.getByTestId('say').fill('hello');
  await human.page.keyboard.press('Enter');
  await human.page.getByText('an admin has muted you').waitFor();
  await bob.getByTestId('kick').click();
  await human.page.getByText('The program says: an admin has sent you out').waitFor();
  await page.waitForFunction(() => !window.playhouse.robots.includes('Bob'));
  // From that address without a token, too: else he were back as an observer.
  await observer.page.getByText('The program says: an admin has sent you out').waitFor();
  await human.page.reload();
  await human.page.getByText('The program says: an admin has sent you out').waitFor();
});

test('a wrong link says so', async () => {
  const page = await openPage(browser);
  await page.goto(`${program.page}#not-a-token`);
  await page.getByText('The program says: open the page by the link').waitFor();
  await page.close();
});
