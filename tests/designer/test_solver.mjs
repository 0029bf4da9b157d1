// The solver of the designer, WebAssembly, in Node.js: the same numbers as the program.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { due, errorsOfProgram, largestDifference, loopsOfProgram, reference, run, withFolder } from './support.mjs';

const { BUMPFOIL_SOLVER: folder, BUMPFOIL_EXAMPLES: examples } = process.env;
const makeSolver = createRequire(import.meta.url)(join(folder, 'solver.cjs'));
let ask;

before(async () => {
  const solver = await makeSolver({ wasmBinary: readFileSync(join(folder, 'solver.wasm')) });
  ask = (request) => JSON.parse(makeSolver.answerOf(solver, JSON.stringify(request)));
});

/** In the last digits: mathematical libraries differ. Where others of its kind are larger, `scale`, by their roundings. */
function near(found, expected, what, scale = 0) {
  assert.ok(Math.abs(found - expected) <= 1e-9 * Math.abs(expected) + 1e-15 * scale, `${what}: ${found}, not ${expected}`);
}

test('loops are those of the program', () => {
  const changed = (...pairs) => pairs.reduce((text, [from, to]) => text.replace(from, to), reference);
  const cases = {
    reference,
    frame: changed(['# model = "truss"', 'model = "frame"']),
    'rough, following events': `${changed([
      'stiffness_follows_height',
      `height_errors = [${Array.from({ length: 26 }, (_, i) => `"${((7 * i) % 11) - 5} um"`).join(', ')}]\nstiffness_follows_height`,
    ])}\n[solver]\nname = "events"\n`,
    'inch and psi': changed(['radius = "19.05 mm"', 'radius = "0.75 inch"'], ['"214 GPa"', '"31.03 Mpsi"']),
  };
  assert.equal(new Set(Object.values(cases)).size, 4);
  for (const [name, text] of Object.entries(cases)) {
    const answer = ask({ what: 'csv', text });
    assert.equal(answer.errors, undefined, JSON.stringify(answer.errors));
    const difference = largestDifference(loopsOfProgram(text), answer.csv);
    console.log(`${name}: loops differ by ${difference.toExponential(1)} of the largest force`);
    assert.ok(difference <= due, `${name}: ${difference}`);
  }
});

test('every example is understood as the program understands it', () => {
  const read = [];
  for (const name of readdirSync(examples).filter((one) => one.endsWith('.toml'))) {
    const text = readFileSync(join(examples, name), 'utf8');
    // The page has no files.
    if (/^\w*file = /m.test(text)) continue;
    assert.equal(ask({ what: 'properties', text }).errors, undefined, name);
    const { errors = [] } = ask({ what: 'cycles', text });
    const told = errors.map(({ line, message }) => (line > 0 ? `${line}: ${message}` : message));
    assert.deepEqual(told, errorsOfProgram(text), name);
    read.push(told.length > 0);
  }
  // Some are of other experiments, which have no loops for the page.
  assert.ok(read.includes(true) && read.filter((wrong) => !wrong).length >= 3, String(read));
});

test('errors are told in the words of the program', () => {
  const { errors } = ask({ what: 'cycles', text: reference.replace('= "31.8 um"', '= "31.8 N"').replace('bumps = 26', 'bumps = 0') });
  assert.deepEqual(
    errors.map(({ key, line }) => [key, reference.split('\n')[line - 1].trim().split(' ')[0]]),
    [
      ['bearing.radial_clearance', 'radial_clearance'],
      ['bump_foil.bumps', 'bumps'],
    ],
  );
  assert.match(errors[0].what, /is a force, expected a length/);
});

test('files beside the case are told to be none', () => {
  const { errors } = ask({ what: 'cycles', text: reference.replace('stiffness_follows_height', 'height_errors_file = "measured.csv"\nstiffness_follows_height') });
  assert.deepEqual(errors.map(({ what }) => what), ['cannot be read: a page has no files beside the case']);
  assert.equal(ask({ what: 'cycles', text: reference }).errors, undefined); // and goes on
});

test('properties, samples and vibrations are those of the program', () => {
  withFolder((place) => {
    const file = join(examples, 'gen1.toml');
    const expected = JSON.parse(run('properties', file, '--json'));
    const properties = ask({ what: 'properties', text: reference });
    for (const [group, numbers] of Object.entries(expected)) {
      const largest = Math.max(...Object.values(numbers));
      for (const [key, number] of Object.entries(numbers)) near(properties[group][key], number, `${group}.${key}`, largest);
    }
    const scatter = ['--set', 'montecarlo.samples=3', '--set', 'montecarlo.seed=5', '--set', 'montecarlo.bump_height={ distribution = "normal", std = "5 um" }'];
    run('montecarlo', file, '-o', join(place, 'm'), ...scatter);
    const { statistics } = JSON.parse(readFileSync(join(place, 'm', 'summary.json'), 'utf8'));
    const text = `${reference}\n[montecarlo]\nsamples = 3\nseed = 5\nbump_height = { distribution = "normal", std = "5 um" }\n`;
    const { samples: before } = ask({ what: 'samples', text, first: 0, count: 2 });
    const { quantities, samples, statistics: found, errors } = ask({ what: 'samples', text, first: 2, count: 1, before });
    assert.equal(errors, undefined, JSON.stringify(errors));
    assert.equal(samples.length, 3);
    quantities.forEach(({ key }, i) => {
      Object.values(statistics).forEach((byQuantity, direction) => {
        near(samples.reduce((sum, one) => sum + one[direction][i], 0) / 3, byQuantity[key].mean, key);
        for (const name of ['mean', 'std', 'standard_error', 'p5', 'p50', 'p99']) near(found[direction][key][name], byQuantity[key][name], `${name} of ${key}`, Math.abs(byQuantity[key].mean) + 1);
        for (const end of [0, 1]) near(found[direction][key].mean_interval_95[end], byQuantity[key].mean_interval_95[end], key);
      });
    });
    const vibration = ['--set', 'vibration.loads=[["0 N", "-50 N"]]', '--set', 'vibration.directions=["+X", "+Y"]', '--set', 'vibration.amplitudes=["2 um"]', '--set', 'vibration.frequencies=["200 Hz"]', '--set', 'vibration.steps=20'];
    run('vibration', file, '-o', join(place, 'v'), ...vibration);
    const [header, row] = readFileSync(join(place, 'v', 'coefficients.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
    const answer = ask({ what: 'vibration', text: reference, load: [0, -50], amplitudes: [2e-6], steps: 20 });
    near(answer.directions[0].stiffness[0], Number(row[header.indexOf('kxx_N_per_m')]), 'kxx');
    near(answer.directions[1].stiffness[0], Number(row[header.indexOf('kyy_N_per_m')]), 'kyy');
    near(answer.directions[1].loss_factor[0], Number(row[header.indexOf('loss_factor_y')]), 'loss factor');
  });
});

test('running bearings are those of the program', () => {
  const file = join(examples, 'running.toml');
  const text = readFileSync(file, 'utf8');
  const points = [
    [{ loads: [[50, -10]] }, ['equilibrium.loads=[["50 N", "-10 N"]]']],
    [{ positions: [[20e-6, 5e-6]] }, ['equilibrium.loads=[]', 'equilibrium.positions=[["20 um", "5 um"]]', 'equilibrium.path=position_ray']],
  ];
  for (const [point, keys] of points) {
    const { states: [state] } = ask({ what: 'equilibrium', text, speeds: [(40000 * Math.PI) / 30], ...point });
    withFolder((place) => {
      run('equilibrium', file, '-o', join(place, 'e'), '--set', 'equilibrium.speeds=["40000 rpm"]', ...keys);
      const [expected] = JSON.parse(readFileSync(join(place, 'e', 'summary.json'), 'utf8')).states;
      assert.equal(state.status, 'converged');
      assert.equal(state.loaded_bumps, expected.loaded_bumps);
      // What is a small part of the others has their roundings.
      const scales = { y_m: Math.abs(expected.x_m), force_y_N: Math.abs(expected.force_x_N), kyx_N_per_m: expected.kxx_N_per_m };
      let most = 0;
      for (const key of ['x_m', 'y_m', 'force_x_N', 'force_y_N', 'attitude_angle_deg', 'h_min_m', 'h_min_theta_deg', 'p_max_Pa', 'torque_N_m', 'power_W', 'highest_bump_load_N', 'kxx_N_per_m', 'kyx_N_per_m', 'kyy_stuck_N_per_m', 'cxx_whirl_N_s_per_m']) {
        most = Math.max(most, Math.abs(state[key] - expected[key]) / Math.max(Math.abs(expected[key]), scales[key] ?? 0));
        assert.ok(most <= 1e-9, `${key}: ${state[key]}, not ${expected[key]}`);
      }
      console.log(`${JSON.stringify(point)}: running bearings differ by ${most.toExponential(1)}`);
    });
  }
});

test('rotors are those of the program, on their mesh and on a coarser one', () => {
  const file = join(examples, 'rotor.toml');
  const speeds = [12000, 14000].map((speed) => (speed * Math.PI) / 30);
  const coarser = [4, 4];
  for (const [mesh, keys] of [[undefined, []], [coarser, ['film.columns_per_pitch=4', 'film.rows=4']]]) {
    const { run: found } = ask({ what: 'stability', text: readFileSync(file, 'utf8'), speeds, ...(mesh ? { mesh } : {}) });
    withFolder((place) => {
      run('stability', file, '-o', join(place, 's'), ...['stability.speeds=["12000 rpm", "14000 rpm"]', ...keys].flatMap((pair) => ['--set', pair]));
      const { onsets } = JSON.parse(readFileSync(join(place, 's', 'summary.json'), 'utf8'));
      assert.ok(onsets.length >= 2);
      assert.equal(found.summary.onsets.length, onsets.length);
      let most = 0;
      onsets.forEach((onset, i) => {
        const own = found.summary.onsets[i];
        for (const key of ['contacts', 'by_coefficients', 'begins', 'of_foils', 'jumps']) assert.equal(own[key], onset[key]);
        for (const key of ['speed_rad_per_s', 'whirl_ratio']) most = Math.max(most, Math.abs(own[key] / onset[key] - 1));
      });
      console.log(`rotors: onsets differ by ${most.toExponential(1)}`);
      assert.ok(most <= 1e-8);
    });
  }
});
