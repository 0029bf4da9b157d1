// Bearings of several pads: each is drawn where it is, and its bumps and forces are told by its name.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { before, test } from 'node:test';
import { assertFits, axeFindings, folder, moveTo, near, padsFile, plotsIn, quantity, report, rowsOf, run, saved, summaryOf, withReport } from './support.mjs';

const steps = 20;
const pads = [1, 2, 3];

before(() => {
  const set = (...pairs) => pairs.flatMap((pair) => ['--set', pair]);
  const command = (name, ...rest) => run([name, padsFile, '-o', join(folder, name), ...rest, ...set(`cycle.steps=${steps}`)]);
  command('cycle');
  command('path', ...set('path.centre=["0 um", "-40 um"]', 'path.semi_axes=["10 um", "5 um"]', 'path.orbits=2', 'path.steps=12'));
  command(
    'vibration',
    ...set('vibration.loads=[["0 N", "-50 N"]]', 'vibration.directions=["+X", "+Y"]', 'vibration.amplitudes=["1 um"]', 'vibration.frequencies=["200 Hz"]', 'vibration.steps=6'),
  );
  command('sweep', '--over', 'pad[2].lobe=0 um:20 um:10 um');
  command('montecarlo', ...set('montecarlo.samples=40', 'montecarlo.bump_height.std=10 um', 'montecarlo.friction_top_bump.std=0.01', 'cycle.directions=["+X"]'));
  run(['cycle', padsFile, '-o', join(folder, 'shimmed'), ...set('cycle.steps=4', 'cycle.directions=["+X"]', 'bump_foil.shim=[{ from = 3, to = 4, thickness = "12 um" }]')]);
  run([
    'equilibrium', join(dirname(padsFile), 'running_pads.toml'), '-o', join(folder, 'equilibrium'),
    ...set('film.columns_per_pitch=4', 'film.rows=6', 'equilibrium.loads=[["10 N", "0 N"], ["50 N", "0 N"]]', 'pad[2].weld_edge=trailing'),
  ]);
  report('running.html', 'equilibrium');
  report('shimmed.html', 'shimmed');
  report('ensemble.html', 'montecarlo');
  report('pads.html', 'cycle');
  report('others.html', 'path', 'vibration', 'sweep');
});

/** Points of each piece of a path on a drawing. */
async function piecesOf(path) {
  const data = await path.getAttribute('d');
  return data.split('M').slice(1).map((piece) => piece.replace('Z', '').split('L').map((point) => point.split(' ').map(Number)));
}

test('each pad is drawn round where it is, from its weld', () =>
  withReport('pads.html', async (page) => {
    const centre = 240;
    const welds = await piecesOf(page.locator('.round path[stroke-width="3.4"]'));
    const angles = welds.map(([[x, y]]) => (Math.atan2(centre - y, x - centre) * 180) / Math.PI);
    // Clockwise from 180 degrees in thirds of a turn; that of pad 2 is at the other end of its 110 degrees.
    [180, 60 - 110, -60].forEach((angle, pad) => assert.ok(Math.abs(Math.cos(((angles[pad] - angle) * Math.PI) / 180) - 1) < 1e-5, `weld of pad ${pad + 1} at ${angles[pad]}`));
    for (const pad of pads) assert.equal(await page.locator('.round .part-name', { hasText: `pad ${pad}` }).count(), 1);
    // Along +X the journal touches pad 2, and no other: from its surface to the foils it is the thickness of lines.
    const journal = page.locator('.round circle').nth(1);
    const [x, y, radius] = await Promise.all(['cx', 'cy', 'r'].map(async (name) => Number(await journal.getAttribute(name))));
    const foils = await piecesOf(page.locator('.round .top-foil'));
    assert.equal(foils.length, pads.length);
    // Six pieces lead to each crest; before the first one nothing bears.
    const apart = foils.map((points) => Math.min(...points.slice(6).map(([px, py]) => Math.hypot(px - x, py - y) - radius)));
    assert.ok(Math.abs(apart[1] - 2.2) < 2, `pad 2 is ${apart[1]} away`);
    assert.ok(apart[0] > 3.5 && apart[2] > 3.5, `${apart}`);
  }));

test('shims lie under the bumps that they lift', () =>
  withReport('shimmed.html', async (page) => {
    const flat = page.locator('.unwrapped');
    assert.equal(await flat.locator('rect.shim').count(), pads.length);
    assert.match(await flat.locator('rect.shim title').first().textContent(), /^Shim of 12\.0* ?µm$/);
    const shim = await flat.locator('rect.shim').first().boundingBox();
    const number = (bump) => flat.locator('text', { hasText: new RegExp(`^${bump}$`) }).first().boundingBox();
    for (const [bump, is] of [[2, false], [3, true], [4, true], [5, false]]) {
      const { x, width } = await number(bump);
      assert.equal(x + width / 2 > shim.x && x + width / 2 < shim.x + shim.width, is, `bump ${bump}`);
    }
  }));

test('pads are laid flat one after the other, and bumps are told by them', () =>
  withReport('pads.html', async (page) => {
    const flat = page.locator('.unwrapped');
    for (const pad of pads) assert.equal(await flat.locator('.part-name', { hasText: `weld of pad ${pad}` }).count(), 1);
    assert.equal((await flat.locator('text', { hasText: /^1$/ }).count()), pads.length);
    const foils = await piecesOf(flat.locator('.top-foil'));
    const [ends, begins] = [foils.map((points) => points.at(-1)[0]), foils.map((points) => points[0][0])];
    assert.ok(ends[0] < begins[1] && ends[1] < begins[2], `${begins} ${ends}`);
    await flat.focus();
    for (let bump = 0; bump < 8 + 3; bump += 1) await page.keyboard.press('ArrowRight');
    const words = await page.locator('.bump-values').textContent();
    assert.match(words, /^Bump 3 of pad 2: load .* foot 3 of pad 2 /);
    near(quantity(words.split('load ')[1].split(',')[0], 'N'), summaryOf('cycle').cycles[0].bump_loads_N[8 + 2], 6e-3, words);
    // By the pointer, too.
    await flat.evaluate((svg, x) => {
      const { left, width } = svg.getBoundingClientRect();
      svg.dispatchEvent(new PointerEvent('pointermove', { clientX: left + (x * width) / svg.viewBox.baseVal.width }));
    }, begins[2] + 3);
    assert.match(await page.locator('.bump-values').textContent(), /^Bump 1 of pad 3: /);
  }));

test('loads and forces of pads are those of the results', () =>
  withReport('pads.html', async (page) => {
    const { cycles } = summaryOf('cycle');
    for (const pad of pads) {
      const [unit, ...cells] = await page.locator(`.results tr[data-key=pad_force_${pad}_N] td`).allTextContents();
      cells.forEach((cell, i) => {
        const expected = Math.hypot(cycles[i].pad_forces_x_N[pad - 1], cycles[i].pad_forces_y_N[pad - 1]);
        near(quantity(`${cell} ${unit}`, 'N'), expected, 1e-3, `pad ${pad}, cycle ${i + 1}`);
      });
      assert.equal(cells.length, cycles.length);
    }
    // Pad 2 takes all of +X, at every increment.
    const drawn = rowsOf((await saved(page, 'Forces of the pads, +X', 'CSV')).bytes.toString());
    const rows = rowsOf(readFileSync(join(folder, 'cycle', 'cycle.csv'), 'utf8')).filter((row) => Number(row.direction_deg) === 0);
    assert.equal(drawn.length, 2 * steps + 1);
    assert.ok(Number(drawn[steps].pad_force_2_N) > 100);
    drawn.forEach((row, i) => {
      assert.deepEqual([Number(row.pad_force_1_N), Number(row.pad_force_3_N)], [0, 0]);
      near(Number(row.pad_force_2_N), Math.hypot(rows[i].force_x_N, rows[i].force_y_N), 1e-6, `increment ${i}`);
    });
    const loads = page.getByRole('region', { name: 'Bump loads, +X', exact: true });
    const most = cycles[0].bump_loads_N.indexOf(Math.max(...cycles[0].bump_loads_N));
    assert.match(await loads.locator('.chart').getAttribute('aria-label'), new RegExp(` N on bump ${(most % 8) + 1} of pad 2$`));
    await (await plotsIn(loads)).locator('text', { hasText: '2.1' }).first().waitFor();
    const contacts = page.getByRole('region', { name: 'Contact states along the path', exact: true });
    await (await plotsIn(contacts)).locator('text', { hasText: '3.5' }).first().waitFor();
  }));

test('the largest stress is at a place of a pad', () =>
  withReport('pads.html', async (page) => {
    const { cycles } = summaryOf('cycle');
    const places = await page.locator('[data-key=max_stress_top_foil_Pa] .place').allTextContents();
    assert.equal(places.length, cycles.length);
    cycles.forEach(({ max_stress_top_foil_at: { place, bump, pad } }, i) => {
      if (bump !== null) assert.equal(pad, 1 + Math.floor((bump - 1) / 8));
      const where = bump === null ? place : `${place} of bump ${1 + ((bump - 1) % 8)}`;
      assert.ok(places[i].startsWith(`${where} of pad ${pad}, increment `), places[i]);
    });
  }));

test('the case says what each pad has', () =>
  withReport('pads.html', async (page) => {
    const words = await page.locator('#cycle-case .case').allTextContents();
    assert.equal(words.filter((table) => /^Pad [123]/.test(table)).length, pads.length);
    assert.ok(words.some((table) => /^Pad 2Welded attrailing/.test(table)), String(words));
    assert.ok(words.some((table) => /^Bump foil of the pad.*Thickness127 µm/.test(table)), String(words));
  }));

test('the page fits, moves, and is accessible', () =>
  withReport('pads.html', async (page) => {
    const before = await page.locator('.round').innerHTML();
    await moveTo(page, 5);
    assert.notEqual(await page.locator('.round').innerHTML(), before);
    assert.doesNotMatch(await page.locator('.round, .unwrapped').evaluateAll((all) => all.map((one) => one.innerHTML).join('')), /NaN|undefined/);
    assert.deepEqual(await axeFindings(page), []);
    await assertFits(page);
  }));

test('paths, vibrations and sweeps of pads are shown', () =>
  withReport('others.html', async (page) => {
    for (const kind of ['path', 'vibration', 'sweep']) assert.ok((await page.locator(`[id^=${kind}-] .chart`).count()) > 0, kind);
    // What each pad takes at most is said, and is the highest of what is drawn along the path.
    const { max_pad_forces_N: expected } = summaryOf('path').cycles[0];
    const most = Math.max(...expected);
    const told = async (title) => (await page.getByRole('group', { name: `Table: ${title}`, exact: true }).locator('td').allTextContents()).map(Number);
    const drawn = rowsOf((await saved(page, 'Forces of the pads', 'CSV')).bytes.toString());
    const highest = await told('Maximum force of each pad');
    assert.equal(highest.length, pads.length);
    pads.forEach((pad, i) => {
      assert.ok(Math.abs(highest[i] - expected[i]) < 1e-3 * most, `pad ${pad}: ${highest[i]}, not ${expected[i]}`);
      const along = Math.max(...drawn.map((row) => Number(row[`pad_force_${pad}`])));
      assert.ok(Math.abs(along - expected[i]) < 1e-6 * most, `pad ${pad} along the path: ${along}, not ${expected[i]}`);
    });
    const ofVibrations = summaryOf('vibration').vibrations.flatMap((one) => one.max_pad_forces_N);
    const shown = await told('Maximum force of each pad, by vibration');
    assert.equal(shown.length, ofVibrations.length);
    shown.forEach((force, i) => assert.ok(Math.abs(force - ofVibrations[i]) < 1e-3 * Math.max(...ofVibrations), `${force}, not ${ofVibrations[i]}`));
  }));

test('films of pads lie one after the other, each from its weld', () =>
  withReport('running.html', async (page) => {
    const panelOf = (name) => page.getByRole('region', { name, exact: true });
    const shownIn = async (name) => rowsOf((await saved(page, name, 'CSV')).bytes.toString());
    await page.getByRole('combobox', { name: 'Load to +X shown' }).selectOption('(50, 0) N');
    const state = summaryOf('equilibrium').states[1];
    const film = await shownIn('Film thickness and sag of the top foil');
    assert.equal(film.length, 3 * 33);
    const thin = film.reduce((least, row) => (Number(row.film_thickness_m) < Number(least.film_thickness_m) ? row : least));
    near(Number(thin.film_thickness_m), state.h_min_m, 1e-6, 'minimum thickness');
    assert.equal(Number(thin.pad), state.h_min_pad);
    near(Number(thin.theta_deg), state.h_min_theta_deg, 1e-5, 'its place');
    assert.match(await panelOf('Film thickness and sag of the top foil').locator('.subject').textContent(), new RegExp(`° from the weld of pad ${state.h_min_pad} `));
    const pressure = await shownIn('Pressure over the unwrapped pads');
    assert.equal(pressure.length, 7 * film.length);
    near(Math.max(...pressure.map((row) => Number(row.pressure_Pa))), state.p_max_Pa, 1e-6, 'maximum pressure');
    await (await plotsIn(panelOf('Pressure over the unwrapped pads'))).locator('text', { hasText: 'pad 3' }).first().waitFor();
    // No line leads from pad to pad.
    const lines = await piecesOf(panelOf('Film around the journal').locator('path[stroke-width="2.4"]:not([stroke-dasharray])'));
    assert.deepEqual(lines.map((points) => points.length), [33, 33, 33]);
    // Pad 2 runs the other way: its weld is at its end, the gap before that of pad 3.
    const welds = (await piecesOf(panelOf('Film around the journal').locator('path[stroke-width="3.4"]').nth(1)))[0];
    const angle = (Math.atan2(240 - welds[0][1], welds[0][0] - 240) * 180) / Math.PI;
    assert.ok(Math.abs(Math.cos(((angle - (-60 + 240 - 8)) * Math.PI) / 180) - 1) < 1e-5, `weld of pad 2 at ${angle}`);
    for (const pad of pads) assert.equal(await panelOf('Bearing in operation').locator('.part-name', { hasText: `pad ${pad}` }).count(), 1);
    assert.match(await panelOf('Bump loads').locator('.subject').textContent(), new RegExp(` N on bump ${((state.highest_loaded_bump - 1) % 8) + 1} of pad ${Math.ceil(state.highest_loaded_bump / 8)}; `));
    // What each pad takes.
    await page.getByRole('combobox', { name: 'Quantity: Pressure and force' }).selectOption('Forces of the pads');
    const drawn = (await shownIn('Pressure and force')).at(-1);
    for (const pad of pads) near(Number(drawn[`pad_force_${pad}`]), Math.hypot(state.pad_forces_x_N[pad - 1], state.pad_forces_y_N[pad - 1]), 1e-5, `pad ${pad}`);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
    assert.deepEqual(await axeFindings(page), []);
    await assertFits(page);
  }));

test('of an ensemble, bumps are told by their pads', () =>
  withReport('ensemble.html', async (page) => {
    const spread = page.getByRole('region', { name: 'Bump loads', exact: true });
    const { mean_N: mean } = summaryOf('montecarlo').bump_loads['+X'];
    const most = mean.indexOf(Math.max(...mean));
    assert.match(await spread.locator('.chart').getAttribute('aria-label'), new RegExp(`most on bump ${(most % 8) + 1} of pad ${Math.floor(most / 8) + 1}, `));
    const heights = page.getByRole('region', { name: 'Sensitivity to bump heights', exact: true });
    assert.match(await heights.locator('.chart').getAttribute('aria-label'), /most on 2\.\d /);
    const rows = rowsOf((await saved(page, 'Sensitivity to bump heights', 'CSV')).bytes.toString());
    const expected = summaryOf('montecarlo').sensitivities['+X'].max_force.bump_height;
    assert.deepEqual(rows.map(({ factor }) => factor), expected.map((_, bump) => `${Math.floor(bump / 8) + 1}.${(bump % 8) + 1}`));
    rows.forEach((row, bump) => near(Number(row.max_force), expected[bump], 1e-6, row.factor));
    assert.equal(await page.locator('.round .part-name', { hasText: 'pad 3' }).count(), 1);
  }));
