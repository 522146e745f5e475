// What the page says of a robot's battery.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { chooseRobot, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let page;

const shown = (id) => page.getByTestId(id).textContent();
const level = () => page.getByTestId('battery').evaluate((meter) => meter.value);

before(async () => {
  program = await startProgram('web/e2e/battery.world');
  browser = await startBrowser();
  ({ page } = await watch(browser, program.page));
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('a battery is shown with what it holds, its power, and that it is charged', async () => {
  await chooseRobot(page, 'docked');
  await page.waitForFunction(() => document.querySelector('[data-testid=charging]')?.textContent === 'charging');
  assert.match(await shown('stored'), /^\d+ J of 2\.00 kJ$/);
  assert.equal(await shown('watts'), '-4.0 W');
  const before = await level();
  assert.ok(before > 0.2 && before < 0.9, `${before}`);
  await page.waitForFunction((value) => document.querySelector('[data-testid=battery]').value > value, before);
});

test('a battery drains while its robot is in use, and one without end is full', async () => {
  await chooseRobot(page, 'away');
  await page.waitForFunction(() => document.querySelector('[data-testid=stored]')?.textContent.startsWith('4'));
  assert.equal(await shown('charging'), '');
  assert.equal(await shown('watts'), '1.0 W');
  await chooseRobot(page, 'mains');
  await page.waitForFunction(() => document.querySelector('[data-testid=stored]')?.textContent === 'without end');
  assert.equal(await level(), 1);
});

test('a robot without a battery has no word of one', async () => {
  await chooseRobot(page, 'bare');
  await page.waitForFunction(() => document.querySelector('[data-testid=selected]')?.textContent === 'bare');
  assert.equal(await page.getByTestId('battery').count(), 0);
});
