// Takes the pictures of the documentation: npm run picture [FILE] (default docs/images/viewer.png).

import { mkdirSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { startBrowser, startProgram, ticks, watch } from './program.mjs';

const file = resolve(process.argv[2] ?? '../docs/images/viewer.png');
const scheme = process.argv[3] ?? 'light';
mkdirSync(dirname(file), { recursive: true });

const program = await startProgram('worlds/cave.world', ['--speed', '4']);
const browser = await startBrowser();
const { page } = await watch(browser, program.page, { viewport: { width: 1440, height: 900 }, colorScheme: scheme });
await page.waitForFunction(() => window.playhouse.tick > 350, null, { timeout: 120000 });
await page.getByTestId('speed').selectOption('1');
await page.locator('[data-robot=coral]').click();
await page.keyboard.press('f');
await ticks(page, 40);
await page.evaluate(() => document.activeElement?.blur());
await page.mouse.move(720, 120);
await page.screenshot({ path: file });
await browser.close();
await program.stop();
console.log(file);
