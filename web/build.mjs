// Builds a page into one HTML file, which fetches nothing: its TypeScript and styles stand where the script was.
//
// Usage: node build.mjs PAGE.html OUT.html

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { build } from 'esbuild';

const [page, out] = process.argv.slice(2);
const html = readFileSync(page, 'utf8');
const script = /<script type="module" src="\/([^"]+)"><\/script>/;
const entry = html.match(script)?.[1];
if (!out || !entry || !html.includes('</head>')) throw new Error(`${page} has no head or no module script, or OUT is missing`);
const { outputFiles } = await build({
  entryPoints: [entry],
  bundle: true,
  minify: true,
  target: 'es2021',
  define: { 'process.env.NODE_ENV': '"production"' },
  outdir: '.', // nothing is written: styles become an output of their own
  write: false,
  logLevel: 'warning',
});
const textOf = (kind) => outputFiles.find(({ path }) => path.endsWith(kind)).text;
if (textOf('.js').includes('<!--')) throw new Error('<!-- in a script hides its end from browsers');
mkdirSync(dirname(out), { recursive: true });
// The replacements are functions: in a text, `$&` would have a meaning.
writeFileSync(
  out,
  html
    .replace('</head>', () => `  <style>${textOf('.css')}</style>\n  </head>`)
    .replace(script, () => `<script type="module">${textOf('.js')}</script>`),
);
