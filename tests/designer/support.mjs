// What the tests of the designer share.
//
// Environment: BUMPFOIL_PROGRAM, BUMPFOIL_CASE, BUMPFOIL_EXAMPLES, BUMPFOIL_CHROMIUM, BUMPFOIL_WEB (with node_modules), and
// BUMPFOIL_SOLVER, the folder with solver.cjs and solver.wasm.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const { BUMPFOIL_PROGRAM: program, BUMPFOIL_CASE: caseFile } = process.env;
export const reference = readFileSync(caseFile, 'utf8');

export function withFolder(use) {
  const folder = mkdtempSync(join(tmpdir(), 'bumpfoil-designer-'));
  try {
    return use(folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** Runs the program. @return what it says */
export function run(...args) {
  const done = spawnSync(program, [...args, '--quiet'], { encoding: 'utf8' });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout;
}

/** cycle.csv of the program. */
export function loopsOfProgram(text) {
  return withFolder((folder) => {
    writeFileSync(join(folder, 'case.toml'), text);
    run('cycle', join(folder, 'case.toml'), '-o', join(folder, 'results'));
    return readFileSync(join(folder, 'results', 'cycle.csv'), 'utf8');
  });
}

/** What `bumpfoil cycle` finds wrong with a case, one line each. */
export function errorsOfProgram(text) {
  return withFolder((folder) => {
    const file = join(folder, 'case.toml');
    writeFileSync(file, text);
    const { status, stderr } = spawnSync(program, ['cycle', file, '-o', join(folder, 'results'), '--quiet'], { encoding: 'utf8' });
    assert.ok(status === 0 || stderr !== '', `status ${status}`);
    return status === 0 ? [] : stderr.trim().split('\n').map((line) => line.replace(/^.*case\.toml: ?/, ''));
  });
}

function columnsOf(csv) {
  const [header, ...lines] = csv.trim().split('\n');
  const rows = lines.map((line) => line.split(','));
  return Object.fromEntries(header.split(',').map((name, i) => [name, rows.map((row) => row[i])]));
}

/** Of all loops of both: the largest difference of forces over the largest force. */
export function largestDifference(expected, found) {
  const [a, b] = [columnsOf(expected), columnsOf(found)];
  let [difference, most] = [0, 0];
  for (const name of ['force_x_N', 'force_y_N', 'force_direct_N', 'force_cross_N']) {
    assert.ok(a[name].length > 100 && a[name].length === b[name].length, name);
    a[name].forEach((text, i) => {
      difference = Math.max(difference, Math.abs(Number(text) - Number(b[name][i])));
      most = Math.max(most, Math.abs(Number(text)));
    });
  }
  for (const name of ['direction_deg', 'increment', 'branch', 'displacement_m']) assert.deepEqual(b[name], a[name]);
  assert.ok(most > 100, `forces up to ${most} N`);
  return difference / most;
}

/** Largest difference of loops between the program and the designer, over the largest force. */
export const due = 1e-9;
