// What detectors find, in the page: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { join } from 'node:path';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

let program;
let browser;
let shown;

before(async () => {
  program = await startProgram('worlds/detectors.world');
  browser = await startBrowser();
  shown = await watch(browser, program.page);
  await chooseRobot(shown.page, 'r0');
});

after(async () => {
  await browser?.close();
  await program?.stop();
});

test('a selected robot shows what its detectors find, by name, place and level', async () => {
  const { page } = shown;
  const lists = page.getByTestId('detections');
  await page.waitForFunction(() => /anne|bert/.test(document.querySelector('[data-testid=detections]')?.textContent ?? ''));
  assert.equal(await lists.count(), 3);
  assert.match(await lists.first().innerText(), /(anne|bert)\s+\d+\.\d+ m\s+-?\d+°?.*\s+\d+ dB/);
  await page.waitForFunction(() => /lamp/.test(document.querySelectorAll('[data-testid=detections]')[2].textContent));
  await page.waitForFunction(() => /finds nothing/.test(document.querySelectorAll('[data-testid=detections]')[2].textContent));
  await page.screenshot({ path: join(results, 'detectors.png') });
});

test('the page met no error', () => {
  assert.deepEqual(shown.errors, []);
});
