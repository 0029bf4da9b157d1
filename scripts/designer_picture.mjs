// Takes the picture of the designer for the README, out of the page itself, in Chromium.
//
// Usage: node scripts/designer_picture.mjs BUILD_FOLDER    (after `make designer`: build/release)

import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const web = resolve(process.argv[2], 'web');
const { chromium } = createRequire(`${web}/package.json`)('playwright-core');
const browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
const page = await browser.newPage({ viewport: { width: 1366, height: 800 } });
await page.goto(pathToFileURL(`${web}/filled/designer.html`).href);
await page.waitForFunction(() => document.documentElement.dataset.answered === '1');
const friction = page.locator('[data-key="friction.coefficient"] input').last();
await friction.fill('0.2');
await friction.press('Enter');
await page.waitForFunction(() => document.documentElement.dataset.answered === '2' && document.documentElement.dataset.drawn);
await page.waitForTimeout(500); // the last charts
await page.locator('.side').evaluate((side) => side.scrollTo(0, 0));
await page.screenshot({ path: 'docs/images/designer.png' });
await browser.close();
