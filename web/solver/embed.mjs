// Puts the solver, its module compressed by gzip, and the page of `bumpfoil report` into the page of `bumpfoil designer`.
//
// Usage: node embed.mjs PAGE SCRIPT MODULE REPORT OUT

import { readFileSync, writeFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const [page, script, module, report, out] = process.argv.slice(2);
let html = readFileSync(page, 'utf8');
const parts = {
  '@bumpfoil-solver-script@': readFileSync(script),
  '@bumpfoil-solver-module@': gzipSync(readFileSync(module), { level: 9 }),
  '@bumpfoil-report-page@': readFileSync(report),
};
for (const [placeholder, bytes] of Object.entries(parts)) {
  const around = html.split(placeholder);
  if (around.length !== 2) throw new Error(`${page} has ${placeholder} ${around.length - 1} times`);
  html = around.join(bytes.toString('base64'));
}
writeFileSync(out, html);
