// Puts the solver, and the page of `bumpfoil report`, into the page of `bumpfoil designer`.
//
// Usage: node embed.mjs PAGE SCRIPT MODULE REPORT OUT

import { readFileSync, writeFileSync } from 'node:fs';

const [page, script, module, report, out] = process.argv.slice(2);
let html = readFileSync(page, 'utf8');
const parts = { '@bumpfoil-solver-script@': script, '@bumpfoil-solver-module@': module, '@bumpfoil-report-page@': report };
for (const [placeholder, file] of Object.entries(parts)) {
  const around = html.split(placeholder);
  if (around.length !== 2) throw new Error(`${page} has ${placeholder} ${around.length - 1} times`);
  html = around.join(readFileSync(file).toString('base64'));
}
writeFileSync(out, html);
