// Builds a page into one HTML file, which fetches nothing: its TypeScript and styles stand where the script was.
//
// Usage: node build.mjs PAGE.html OUT.html

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { build } from 'esbuild';

const [page, out] = process.argv.slice(2);
const html = readFileSync(page, 'utf8');
const script = /<script type="module" src="\/([^"]+)"><\/script>/;
const { outputFiles } = await build({
  entryPoints: [html.match(script)[1]],
  bundle: true,
  minify: true,
  target: 'es2021',
  define: { 'process.env.NODE_ENV': '"production"' },
  outdir: '.',
  write: false,
  logLevel: 'warning',
});
const textOf = (kind) => outputFiles.find(({ path }) => path.endsWith(kind)).text;
mkdirSync(dirname(out), { recursive: true });
// By functions: a text with $ in it would be a pattern.
writeFileSync(
  out,
  html
    .replace('</head>', () => `  <style>${textOf('.css')}</style>\n  </head>`)
    .replace(script, () => `<script type="module">${textOf('.js')}</script>`),
);
