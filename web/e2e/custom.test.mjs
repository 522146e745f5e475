// What custom models measure, in the page: npm run e2e (PLAYHOUSE_PROGRAM=path of the program).

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chooseRobot, results, startBrowser, startProgram, watch } from './program.mjs';

const root = resolve(fileURLToPath(import.meta.url), '../../..');
const libraries = mkdtempSync(join(tmpdir(), 'playhouse_custom_'));

let program;
let browser;
let shown;

before(async () => {
  for (const name of ['geiger', 'barrier']) {
    const source = join(root, 'examples/custom', `${name}.cc`);
    execFileSync('c++', ['-std=c++20', '-ffp-contract=off', '-shared', '-fPIC', '-I', root, '-o', join(libraries, `${name}.so`), source]);
  }
  process.env.PLAYHOUSE_PATH = libraries;
  program = await startProgram('examples/custom/yard.world');
  browser = await startBrowser();
  shown = await watch(browser, program.page);
});

after(async () => {
  await browser?.close();
  await program?.stop();
  rmSync(libraries, { recursive: true });
});

test('the panel of a robot shows what its custom sensor measures, once it is looked at', async () => {
  const { page } = shown;
  await chooseRobot(page, 'rover');
  const readings = page.getByTestId('readings').first();
  await page.waitForFunction(() => Number(document.querySelector('[data-testid=readings] tr:nth-child(2) td')?.textContent) > 0);
  assert.match(await readings.textContent(), /^reading 0\d+reading 1\d+reading 21$/, 'counts, counts in all, and one source in reach');
  assert.ok((await page.getByRole('heading', { name: 'geiger' }).count()) > 0, 'under the name of its library');
  await page.screenshot({ path: join(results, 'custom.png') });
});

test('the page met no error', () => {
  assert.deepEqual(shown.errors, []);
});
