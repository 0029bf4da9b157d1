// What the page of `bumpfoil designer` shows and saves beside loops: vibrations, running bearings, ensembles, reports, charts out of sight.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { answered, answeredIn, field, folder, slide, slider, textOf, type, withPage, write } from './page.mjs';
import { reference, run, withFolder } from './support.mjs';

test('vibrations about a load are those of the program', () =>
  withPage(async (page) => {
    await page.getByRole('tab', { name: 'Vibration' }).click();
    await answeredIn(page, '.vibration');
    const load = page.locator('.vibration').getByLabel('along Y, N');
    await answeredIn(page, '.vibration', async () => {
      await load.fill('-80,0');
      await load.press('Tab');
    });
    assert.match(await page.locator('.vibration > .note').textContent(), /the journal is at x = .* µm/);
    for (const [title, columns] of [['Stiffness', ['kxx_N_per_m', 'kyy_N_per_m']], ['Loss factor', ['loss_factor_x', 'loss_factor_y']]]) {
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name: `${title}: save the data as CSV` }).click();
      const [, ...rows] = readFileSync(await (await download).path(), 'utf8').trim().split('\r\n').map((line) => line.split(',').map(Number));
      assert.equal(rows.length, 8);
      withFolder((place) => {
        const amplitudes = [rows[2][0], rows[7][0]];
        run('vibration', process.env.BUMPFOIL_CASE, '-o', join(place, 'v'), '--set', 'vibration.loads=[["0 N", "-80 N"]]', 'vibration.directions=["+X", "+Y"]', `vibration.amplitudes=[${amplitudes.join(', ')}]`, 'vibration.frequencies=["1 Hz"]', 'vibration.steps=25');
        const [header, ...expected] = readFileSync(join(place, 'v', 'coefficients.csv'), 'utf8').trim().split('\n').map((line) => line.split(','));
        [rows[2], rows[7]].forEach((row, i) =>
          columns.forEach((column, axis) => {
            const due = Number(expected[i][header.indexOf(column)]);
            // Files of charts have seven digits.
            assert.ok(Math.abs(row[1 + axis] - due) <= 1e-6 * due, `${column} at ${row[0]} m: ${row[1 + axis]}, not ${due}`);
          }),
        );
      });
    }
    await type(page, 'friction.coefficient', '0.2');
    await page.waitForFunction(() => document.querySelectorAll('.vibration .legend li').length === 8);
  }));

test('the running bearing is that of the program, beside the design before', () =>
  withPage(async (page) => {
    const view = page.locator('.running');
    // A coarse mesh, on which the tests need not wait.
    await write(page, `${reference}\n[film]\ncolumns_per_pitch = 4\nrows = 6\n`);
    await page.getByRole('button', { name: 'Compare from here' }).click();
    await page.getByRole('tab', { name: 'Running' }).click();
    await page.waitForFunction(() => document.querySelector('.running').dataset.answered === '1');
    assert.match(await view.locator('> .note').first().textContent(), /^45000 rpm, load \(50, 0\) N: the journal runs at x = .*, on the mesh of the case\.$/);
    // About the point, on a coarse mesh: over speed and over load.
    await page.waitForFunction(() => document.querySelector('.running').dataset.curves === '1');
    const curveOf = async (title) => {
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name: `${title}: save the data as CSV` }).click();
      return readFileSync(await (await download).path(), 'utf8').trim().split('\r\n').slice(1).map((line) => line.split(',').map(Number));
    };
    const [overSpeed, overLoad] = [await curveOf('Over speed'), await curveOf('Over load')];
    withFolder((place) => {
      const listed = { speeds: overSpeed.map((row) => `"${row[2]} rpm"`), loads: overLoad.map((row) => `["${row[0]} N", "0 N"]`) };
      // States depend on those before them: the same lists.
      for (const [curve, speeds, loads] of [[overSpeed, listed.speeds, ['["50 N", "0 N"]']], [overLoad, ['"45000 rpm"'], listed.loads]]) {
        run('equilibrium', process.env.BUMPFOIL_CASE, '-o', join(place, 'e'), '--force', '--set', 'film.columns_per_pitch=4', 'film.rows=5', 'equilibrium.paths=one', `equilibrium.speeds=[${speeds}]`, `equilibrium.loads=[${loads}]`);
        const { states } = JSON.parse(readFileSync(join(place, 'e', 'summary.json'), 'utf8'));
        assert.equal(states.length, 6);
        for (const [i, { h_min_m }] of states.entries()) assert.ok(Math.abs(curve[i].at(-1) - h_min_m) <= 1e-6 * h_min_m, `${curve[i]}: not ${h_min_m}`);
      }
    });
    assert.match(await view.locator('> .note').last().textContent(), /^On the coarse mesh over speed all states are stable; over load unstable at .*\(50, 0\) N.*the history of the bearing decides/);
    await answeredIn(page, '.running', async () => {
      await view.getByLabel('Speed, rpm').fill('40000');
      await view.getByLabel('Speed, rpm').press('Tab');
    });
    const shown = async (key) => (await view.locator(`tr[data-key="${key}"] td:not(.unit)`).allTextContents()).map((text) => text.replace('−', '-'));
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Pressure over the unwrapped foil: save the data as CSV' }).click();
    const pressures = readFileSync(await (await download).path(), 'utf8').trim().split('\r\n').slice(1).map((line) => Number(line.split(',')[2]));
    let state;
    withFolder((place) => {
      run('equilibrium', process.env.BUMPFOIL_CASE, '-o', join(place, 'e'), '--set', 'film.columns_per_pitch=4', 'film.rows=6', 'equilibrium.speeds=["40000 rpm"]', 'equilibrium.loads=[["50 N", "0 N"]]');
      [state] = JSON.parse(readFileSync(join(place, 'e', 'summary.json'), 'utf8')).states;
    });
    assert.ok(Math.abs(Math.max(...pressures) - state.p_max_Pa) <= 1e-6 * state.p_max_Pa);
    for (const [key, size] of [['h_min_m', 1e-6], ['torque_N_m', 1e-3], ['kxx_stuck_N_per_m', 1e6], ['attitude_angle_deg', 1]]) {
      const [value] = await shown(key);
      assert.ok(Math.abs(Number(value) * size - state[key]) <= 5e-4 * Math.abs(state[key]), `${key}: ${value}, not ${state[key]}`);
    }
    // What is no number is said, and what was there comes back.
    await view.getByLabel('Speed, rpm').fill('fast');
    await view.getByLabel('Speed, rpm').press('Tab');
    assert.match(await view.locator('> .note').first().textContent(), /as numbers/);
    await answeredIn(page, '.running', async () => {
      await view.getByLabel('Speed, rpm').fill('40000');
      await view.getByLabel('Speed, rpm').press('Tab');
    });
    assert.match(await view.locator('> .note').first().textContent(), /^40000 rpm, load \(50, 0\) N: the journal runs at x = /);
    // Another design: the one before stays beside it.
    await answeredIn(page, '.running', () => type(page, 'bearing.radial_clearance', '25 um'));
    const [before, now, difference] = await shown('h_min_m');
    assert.ok(Math.abs(Number(before) * 1e-6 - state.h_min_m) <= 5e-4 * state.h_min_m);
    assert.ok(Math.abs(Number(now) - Number(before) - Number(difference)) < 0.01, `${now} - ${before} is not ${difference}`);
    assert.ok((await view.locator('.legend li').allTextContents()).includes('baseline film thickness'));
    // What fails, and what is refused, is told in the words of the program.
    await answeredIn(page, '.running', async () => {
      await view.getByLabel('Load along X, N').fill('5000');
      await view.getByLabel('Load along X, N').press('Tab');
    });
    assert.match(await view.locator('.remarks').textContent(), /load \(5000, 0\) N: touchdown: the film is thinner than the contact threshold film\.h_floor; last state/);
    await answeredIn(page, '.running', () => page.locator('[data-key="solver.name"] select').selectOption('events', { force: true }));
    assert.match(await view.locator('.remarks').textContent(), /solver\.name = events: cannot solve contacts under a film; set name = "newton"/);
    // A case that says where it runs is run there, and one with tolerances has a spread of films.
    await answeredIn(page, '.running', () => write(page, `${reference}\n[film]\ncolumns_per_pitch = 4\nrows = 6\n[equilibrium]\nspeeds = ["30000 rpm"]\npositions = [["5 um", "0 um"]]\n[montecarlo]\nradial_clearance = { distribution = "normal", std = "1 um" }\n`));
    assert.match(await view.locator('> .note').first().textContent(), /^30000 rpm, position \(5, 0\) µm: the journal runs at x = 5\.00 µm, y = 0/);
    await page.waitForFunction(() => /^[48] of 40 bearings/.test(document.querySelector('.spread > .note').textContent));
    assert.match(await page.locator('.spread .subject').textContent(), /^mean [\d.]+ µm ± .*30000 rpm, position \(5, 0\) µm/);
    console.log(`running bearing: ${await view.getAttribute('data-took')} ms to the last quick answer`);
  }));

test('a case of a running bearing opens with it, and needs no cycle', () =>
  withPage(async (page) => {
    await write(page, readFileSync(join(process.env.BUMPFOIL_EXAMPLES, 'misaligned.toml'), 'utf8'));
    assert.equal(await page.getByRole('tab').first().textContent(), 'Running');
    assert.equal(await page.getByRole('tab', { selected: true }).textContent(), 'Running');
    await page.waitForFunction(() => document.querySelector('.running').dataset.answered);
    assert.equal(await page.locator('.tile[data-key="stable"] strong:visible').textContent(), 'stable');
    assert.equal(await field(page, 'width.tilt[1]').inputValue(), '0.131');
    assert.match(await page.getByRole('region', { name: 'Bearing in 3D' }).locator('.subject').textContent(), /film and displacements ×\d+/);
    await page.getByRole('tab', { name: 'Loops' }).click();
    assert.equal(await page.locator('.numbers [role="group"] button').first().textContent(), '+X');
  }));

test('the rotor is that of the program, quickly at first, beside the design before', () =>
  withPage(async (page) => {
    const view = page.locator('.rotor');
    const told = () => view.locator('> .note').textContent();
    const shown = (key) => view.locator(`.tile[data-key="${key}"] strong`).textContent();
    const more = (key) => view.locator(`.tile[data-key="${key}"] .change`).textContent();
    // Until the exact answer is there: it begins to compute before a change is through.
    const settles = async (act) => {
      await act();
      await page.waitForFunction(() => document.querySelector('.rotor').getAttribute('aria-busy') === 'false');
    };
    const typeSpeed = (speed) => settles(async () => {
      await view.getByLabel('Speed, rpm').fill(speed);
      await view.getByLabel('Speed, rpm').press('Tab');
    });
    const mesh = '\n[film]\ncolumns_per_pitch = 6\nrows = 8\n';
    await write(page, reference + mesh);
    await settles(() => page.getByRole('tab', { name: 'Rotor' }).click());
    // A case without a rotor has one that is assumed, and it is put into the case as it is.
    assert.match(await told(), /^The case has no rotor\. A rotor of 2 kg is assumed: half of it on each of two equal bearings/);
    const assumed = await shown('onset');
    assert.match(assumed, /^1\d{4}(\.\d)? rpm$/);
    await settles(() => answered(page, () => view.getByRole('button', { name: 'Add this rotor to the case' }).click()));
    assert.match(await textOf(page), /\[rotor\]\nmass = "2 kg"\n$/);
    assert.equal(await told(), 'Rotor of 2 kg. On the mesh of the case.');
    assert.equal(await shown('onset'), assumed);
    assert.ok(await view.getByRole('button', { name: 'Add this rotor to the case' }).isHidden());
    // Speeds of the case, and one that is none of them.
    const stability = 'speeds = ["11000 rpm", "12000 rpm", "13000 rpm"]';
    const text = `${reference}${mesh}[rotor]\nmass = "3 kg"\n[stability]\n${stability}\n`;
    await settles(() => write(page, text));
    await settles(() => page.getByRole('button', { name: 'Compare from here' }).click());
    assert.equal(await view.getByLabel('Speed, rpm').inputValue(), '13000');
    await typeSpeed('12500');
    let summary;
    withFolder((place) => {
      writeFileSync(join(place, 'case.toml'), text);
      run('stability', join(place, 'case.toml'), '-o', join(place, 's'), '--set', `stability.${stability.replace(' = ', '=').replace('"13000', '"12500 rpm", "13000')}`);
      summary = JSON.parse(readFileSync(join(place, 's', 'summary.json'), 'utf8'));
    });
    const number = (words) => Number(words.replace('−', '-').split(' ')[0]);
    for (const kind of ['sliding', 'stuck']) {
      await view.getByRole('button', { name: kind === 'stuck' ? 'Full stick' : 'Contacts sliding' }).click();
      const { speed_rad_per_s: onset } = summary.onsets.find((one) => one.contacts === kind && !one.by_coefficients);
      const due = (onset * 30) / Math.PI;
      assert.ok(Math.abs(number(await shown('onset')) - due) <= 1e-5 * due, `${await shown('onset')}, not ${due}`);
      const at = summary.speeds[2];
      assert.ok(Math.abs(at.speed_rad_per_s - (12500 * Math.PI) / 30) < 1e-6);
      const own = at.motions.filter((one) => one.contacts === kind);
      const [rotor] = own.filter((one) => !one.of_foils).sort((a, b) => b.real_rad_per_s - a.real_rad_per_s);
      assert.ok(Math.abs(number(await shown('log_decrement')) - rotor.log_decrement) <= 6e-3 * Math.abs(rotor.log_decrement));
      assert.ok(Math.abs(number(await shown('frequency')) - rotor.imag_rad_per_s / (2 * Math.PI)) <= 6e-4 * rotor.imag_rad_per_s);
      assert.equal(await shown('direction'), rotor.direction);
      assert.equal((await more('log_decrement')).split(',')[0], rotor.real_rad_per_s > 0 ? 'grows' : 'decays');
      assert.equal(await shown('foils'), own.some((one) => one.of_foils && one.real_rad_per_s > 0) ? 'grow' : 'decay');
      assert.ok(Math.abs(number(await shown('h_min')) * 1e-6 - at.h_min_m) <= 6e-3 * at.h_min_m);
    }
    // Another design, of which a quick answer comes before the exact one; the one before stays beside it.
    const quick = Number(await view.getAttribute('data-quick'));
    await settles(() => slide(page, 'rotor.mass', '5'));
    assert.ok(Number(await view.getAttribute('data-quick')) > quick);
    assert.match(await told(), /^Rotor of 5\.0\d* kg\. On the mesh of the case\.$/);
    assert.match(await more('log_decrement'), /% vs\. baseline$/);
    assert.match(await view.getByRole('region', { name: 'Campbell diagram' }).locator('.legend').textContent(), /baseline/);
    const times = [];
    for (let i = 0; i < 5; i += 1) {
      const count = Number(await view.getAttribute('data-quick'));
      await slide(page, 'bearing.radial_clearance', String(28 + i));
      await page.waitForFunction((before) => Number(document.querySelector('.rotor').dataset.quick) > before, count);
      times.push(Number(await view.getAttribute('data-took')));
    }
    console.log(`rotor: quick answers after ${times.sort((a, b) => a - b)[2]} ms (median), ${times[4]} ms at most`);
    // What is not found is told, and no number stands for it.
    await settles(() => write(page, text.replace('"3 kg"', '"2000 kg"')));
    assert.match(await view.locator('.remarks').textContent(), /11000 rpm: no equilibrium found: .*the 3 speeds after it were not computed/);
    for (const key of ['onset', 'log_decrement', 'frequency', 'direction', 'foils', 'h_min']) assert.equal(await shown(key), '–', key);
    assert.doesNotMatch(await view.innerText(), /NaN|undefined|Infinity/);
    // A warning is told once, whatever answers have it.
    await settles(() => write(page, text.replace('[top_foil]', '[top_foil]\nformed_radius = "19 mm"')));
    const remarks = await view.locator('.remarks li').allTextContents();
    assert.equal(remarks.filter((one) => one.includes('formed tighter than the bearing')).length, 1, remarks.join());
    await view.getByLabel('Speed, rpm').fill('fast');
    await view.getByLabel('Speed, rpm').press('Tab');
    assert.equal(await told(), 'Enter the speed as a number.');
    // What the program refuses is told in its words.
    await typeSpeed('-12000');
    assert.match(await view.locator('.remarks').textContent(), /has another sign than the first/);
  }));

test('a hundred bearings are those of the program', () =>
  withPage(async (page) => {
    await answered(page, () => slider(page, 'cycle.steps').evaluate((one) => {
      one.value = '20';
      one.dispatchEvent(new Event('input', { bubbles: true }));
    }));
    await page.getByRole('tab', { name: 'Ensemble' }).click();
    await answered(page, () => page.getByRole('button', { name: 'Add tolerances' }).click());
    await page.waitForFunction(() => document.querySelector('.ensemble').dataset.done === '100');
    const stated = await page.locator('.ensemble .panel', { hasText: 'Maximum force' }).locator('.subject').textContent();
    const text = await textOf(page);
    withFolder((place) => {
      writeFileSync(join(place, 'case.toml'), text);
      run('montecarlo', join(place, 'case.toml'), '-o', join(place, 'm'), '--samples', '100');
      const { mean, p5, p95 } = JSON.parse(readFileSync(join(place, 'm', 'summary.json'), 'utf8')).statistics['+X'].max_force_N;
      const four = (number) => Number(number.toPrecision(4)).toFixed(1);
      assert.ok(stated.startsWith(`mean ${four(mean)} N ± `), `${stated}; mean ${mean}`);
      assert.ok(stated.includes(`5 % below ${four(p5)} N, 5 % above ${four(p95)} N`), `${stated}; ${p5} to ${p95}`);
    });
    await page.getByRole('group', { name: 'Direction of the bearings' }).getByRole('button', { name: '−Y' }).click();
    assert.notEqual(await page.locator('.ensemble .panel', { hasText: 'Maximum force' }).locator('.subject').textContent(), stated);
  }));

test('what is shown is saved as a report', () =>
  withPage(async (page) => {
    await write(page, reference.replace(/^title = .*/m, 'title = "A </script> in a title"'));
    await type(page, 'friction.coefficient', '0.2');
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save report' }).click();
    const report = join(folder, 'report.html');
    await (await download).saveAs(report);
    const other = await page.context().newPage();
    const errors = [];
    other.on('pageerror', (error) => errors.push(String(error)));
    other.on('console', (message) => errors.push(message.text()));
    await other.goto(pathToFileURL(report).href);
    await other.waitForFunction(() => document.documentElement.dataset.drawn);
    assert.match(await other.locator('h1').textContent(), /A <\/script> in a title/);
    assert.match(await other.locator('.about').first().textContent(), /2 runs compared · solver newton · bumpfoil /);
    const row = other.locator('tr[data-key="max_force_N"]').first();
    assert.match(await row.textContent(), /739\.3.*964\.4/);
    assert.deepEqual(errors, []);
    await other.close();
  }));

test('charts out of sight are drawn when one comes to them', () =>
  withPage(async (page) => {
    await type(page, 'friction.coefficient', '0.2');
    const plot = page.locator('#view-loops .plot').last();
    await plot.locator('svg').waitFor({ state: 'attached' });
    const [drawn, label] = [await plot.innerHTML(), await plot.locator('..').getAttribute('aria-label')];
    await type(page, 'friction.coefficient', '0.3');
    assert.equal(await plot.innerHTML(), drawn);
    assert.notEqual(await plot.locator('..').getAttribute('aria-label'), label);
    await plot.scrollIntoViewIfNeeded();
    await page.waitForFunction(([one, before]) => one.innerHTML !== before, [await plot.elementHandle(), drawn]);
  }));
