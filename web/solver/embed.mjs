// Puts the solver into the page of `bumpfoil designer`.
//
// Usage: node embed.mjs PAGE SCRIPT MODULE OUT

import { readFileSync, writeFileSync } from 'node:fs';

const [page, script, module, out] = process.argv.slice(2);
let html = readFileSync(page, 'utf8');
for (const [placeholder, file] of [['@bumpfoil-solver-script@', script], ['@bumpfoil-solver-module@', module]]) {
  const parts = html.split(placeholder);
  if (parts.length !== 2) throw new Error(`${page} has ${placeholder} ${parts.length - 1} times`);
  html = parts.join(readFileSync(file).toString('base64'));
}
writeFileSync(out, html);
