// What axe-core finds on pages of the site, in light and dark: one line each, "PAGE, SCHEME: RULE: ELEMENT".
//
// Usage: axe_of_site.mjs FOLDER PAGE ...
// Environment: BUMPFOIL_CHROMIUM, and BUMPFOIL_WEB, the folder with node_modules.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const modules = createRequire(join(process.env.BUMPFOIL_WEB, 'package.json'));
const { chromium } = modules('playwright-core');
const axe = readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8');
const [, , folder, ...names] = process.argv;
const browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
// Light and dark differ by their colours alone. What passes is only counted.
const schemes = [['light', { resultTypes: ['violations'] }, 10], ['dark', { resultTypes: ['violations'], runOnly: ['color-contrast', 'link-in-text-block'] }, 1]];
for (const [colorScheme, options, least] of schemes) {
  const page = await browser.newPage({ colorScheme, viewport: { width: 1366, height: 768 } });
  for (const name of names) {
    await page.goto(pathToFileURL(resolve(folder, name)).href);
    await page.evaluate(axe);
    // Formulas are by far the most elements; readers of the screen have them as MathML, in which axe sees no text.
    const { violations, passes } = await page.evaluate((given) => globalThis.axe.run({ exclude: [['.katex'], ['th:has(.katex)']] }, given), options);
    if (passes.length < least) console.log(`${name}, ${colorScheme}: axe looked at ${passes.length} rules only`);
    for (const { id, nodes } of violations) for (const { html } of nodes) console.log(`${name}, ${colorScheme}: ${id}: ${html.slice(0, 200)}`);
  }
}
await browser.close();
