// Takes the pictures of the designer and of a report for the README, out of the pages themselves, in Chromium.
//
// Usage: node scripts/page_pictures.mjs BUILD_FOLDER REPORT    (after `make designer` and `make demo`: build/release
// results/demo/report.html)

import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [build, report] = process.argv.slice(2).map((path) => resolve(path));
const web = resolve(build, 'web');
const { chromium } = createRequire(`${web}/package.json`)('playwright-core');
const browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });

async function opened(path, height) {
  const page = await browser.newPage({ viewport: { width: 1366, height } });
  await page.goto(pathToFileURL(path).href);
  return page;
}

const designer = await opened(`${web}/filled/designer.html`, 800);
await designer.waitForFunction(() => document.documentElement.dataset.answered === '1');
const friction = designer.locator('[data-key="friction.coefficient"] input').last();
await friction.fill('0.2');
await friction.press('Enter');
await designer.waitForFunction(() => document.documentElement.dataset.answered === '2' && document.documentElement.dataset.drawn);
await designer.waitForTimeout(500); // the last charts
await designer.evaluate(() => window.scrollTo(0, 0));
await designer.screenshot({ path: 'docs/images/designer.png' });

const page = await opened(report, 860);
await page.waitForFunction(() => document.querySelectorAll('canvas, svg').length > 3);
await page.waitForTimeout(1000); // the last charts
await page.screenshot({ path: 'docs/images/report.png' });
await browser.close();
