// Reports of running bearings in a browser: film, bumps and curves are those of equilibrium.csv and summary.json, paths are
// compared, and what was not found is told.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { assertAccessible, assertFits, assertPanelsFitPaper, folder, laptop, near, placeOf, plotsIn, quantity, report, rowsOf, run, runningFile, saved, summaryOf, withReport } from './support.mjs';

const mesh = ['film.columns_per_pitch=4', 'film.rows=6'];

function equilibrium(name, pairs, options = [], exitCode = 0) {
  return run(['equilibrium', runningFile, '-o', join(folder, name), ...[...mesh, ...pairs].flatMap((pair) => ['--set', pair]), ...options], exitCode);
}

before(() => {
  equilibrium('grid', ['equilibrium.speeds=["30000 rpm", "45000 rpm"]', 'equilibrium.loads=[["20 N", "0 N"], ["50 N", "0 N"], ["80 N", "0 N"]]']);
  equilibrium('back', ['equilibrium.loads=[["20 N", "0 N"], ["50 N", "0 N"], ["20 N", "0 N"]]', 'film.columns_per_pitch=6', 'film.rows=16']);
  equilibrium('paths', ['equilibrium.loads=[["50 N", "0 N"]]'], ['--paths']);
  equilibrium('failed', ['equilibrium.loads=[["20 N", "0 N"], ["5000 N", "0 N"]]', 'title=</script><b>x</b>'], [], 3);
  equilibrium('limits', ['top_foil.formed_radius="19.05 mm"', 'film.h_lift_off="5 um"', 'equilibrium.loads=[["50 N", "0 N"], ["20 N", "0 N"]]'], ['--limits']);
  run(['film', runningFile, '-o', join(folder, 'rigid'), ...[...mesh, 'film.closed=true', 'equilibrium.path=position_ray', 'equilibrium.loads=[]', 'equilibrium.positions=[["10 um", "0 um"], ["15 um", "0 um"]]'].flatMap((pair) => ['--set', pair])]);
  equilibrium('frequencies', ['equilibrium.loads=[["20 N", "0 N"], ["50 N", "0 N"]]', 'equilibrium.frequencies=["200 Hz", "375 Hz", "750 Hz"]']);
  equilibrium('tilted', ['equilibrium.loads=[["20 N", "0 N"]]', 'width.modes=3', 'width.tilt=["0.3 mrad", "-0.4 mrad"]']);
  for (const name of ['tilted', 'limits', 'rigid', 'grid', 'back', 'paths', 'failed', 'frequencies']) report(`${name}.html`, name);
});

const csvOf = (name) => rowsOf(readFileSync(join(folder, name, 'equilibrium.csv'), 'utf8'));
const panelOf = (page, name) => page.getByRole('region', { name, exact: true });
const shownIn = async (page, name) => rowsOf((await saved(page, name, /CSV/)).bytes.toString().replaceAll(/"\(([^"]*)\)[^"]*"/g, 'vector'));
const chooser = (page, name) => page.getByRole('combobox', { name: `${name} shown` });
const rpm = (row) => Math.round((Number(row.speed_rad_per_s) * 30) / Math.PI);

test('curves over speed and load are those of equilibrium.csv', () =>
  withReport('grid.html', async (page) => {
    for (const [panel, text, key] of [['Minimum film thickness', 'Minimum film thickness', 'h_min'], ['Journal position', 'Attitude angle (°)', 'attitude_angle'], ['Losses', 'Power loss', 'power'], ['Stiffness', 'Stiffness, xx', 'kxx']]) {
      await page.getByRole('combobox', { name: `Quantity: ${panel}` }).selectOption(text);
      const shown = await shownIn(page, panel);
      assert.equal(shown.length, 6, panel);
      const column = Object.keys(shown[0]).find((name) => name === key || name.startsWith(`${key}_`));
      const expected = csvOf('grid');
      const unit = Object.keys(expected[0]).find((name) => name === key || name.startsWith(`${key}_`));
      const sorted = (values) => values.map(Number).sort((a, b) => a - b);
      sorted(shown.map((row) => row[column])).forEach((value, i) => near(value, sorted(expected.map((row) => row[unit]))[i], 1e-5, `${panel} ${i}`));
    }
    // Over the load, a line for each speed.
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Load to +X');
    assert.deepEqual(await panelOf(page, 'Minimum film thickness').locator('.legend li').allTextContents(), ['Speed 30000 rpm', 'Speed 45000 rpm']);
  }));

test('bump loads fill their panel beside taller ones, and have the usual height alone', async () => {
  for (const [width, least, most] of [[2560, 500, 900], [1366, 200, 330]]) {
    await withReport(
      'grid.html',
      async (page) => {
        const height = async (place) => (await panelOf(page, 'Bump loads').locator(place).first().boundingBox()).height;
        await panelOf(page, 'Bump loads').locator('svg').first().scrollIntoViewIfNeeded();
        assert.ok((await height('svg')) > least && (await height('svg')) < most, `${await height('svg')} px at ${width}`);
        near(await height('svg'), await height('.chart'), 0.01, `at ${width}`);
      },
      { viewport: { width, height: 1300 } },
    );
  }
});

test('coefficients over the speed are the synchronous ones of summary.json', () =>
  withReport('grid.html', async (page) => {
    await page.getByRole('combobox', { name: 'Over', exact: true }).selectOption('Speed');
    await chooser(page, 'Load to +X').selectOption('(50, 0) N');
    const states = summaryOf('grid').states.filter((state) => state.load_x_N === 50);
    for (const [panel, text, letter, unit] of [['Synchronous stiffness', 'Stiffness K', 'k', 'N_per_m'], ['Synchronous damping', 'Damping c', 'c', 'N_s_per_m']]) {
      for (const stuck of ['', '_stuck']) {
        await page.getByRole('combobox', { name: `Quantity: ${panel}` }).selectOption(`${text}${stuck === '' ? '' : ', full stick'}`);
        const shown = await shownIn(page, panel);
        assert.equal(shown.length, 2);
        shown.forEach((row, i) => {
          assert.equal(rpm(states[i]), Number(row.speed_rpm));
          for (const axes of ['xx', 'xy', 'yx', 'yy']) near(Number(row[`${letter}${axes}${stuck}_${unit}`]), states[i].motions[0][`${letter}${axes}${stuck}_${unit}`], 1e-5, `${panel} ${axes}${stuck}`);
        });
      }
    }
    // One of them has a line for each load.
    await page.getByRole('combobox', { name: 'Quantity: Synchronous stiffness' }).selectOption('Kxy');
    assert.equal((await shownIn(page, 'Synchronous stiffness')).length, 6);
  }));

test('columns of the table are called as in equilibrium.csv and summary.json', () =>
  withReport('grid.html', async (page) => {
    const columns = Object.keys((await shownIn(page, 'Results by state'))[0]).filter((name) => !['speed_rpm', 'journal_N', 'path'].includes(name));
    assert.ok(columns.includes('attitude_angle_deg'));
    const known = { ...csvOf('grid')[0], ...summaryOf('grid').states[0] };
    for (const column of columns) assert.ok(column in known, column);
  }));

test('film, bumps and journal are those of the state looked at', () =>
  withReport('grid.html', async (page) => {
    const states = summaryOf('grid').states;
    let before = '';
    for (const [speed, load] of [[30000, 20], [45000, 80]]) {
      await chooser(page, 'Speed').selectOption(`${speed} rpm`);
      await chooser(page, 'Load to +X').selectOption(`(${load}, 0) N`);
      const index = csvOf('grid').findIndex((row) => rpm(row) === speed && Number(row.load_x_N) === load);
      const state = states[index];
      const pressure = (await shownIn(page, 'Pressure over the unwrapped foil')).map((row) => Number(row.pressure_Pa));
      near(Math.max(...pressure), state.p_max_Pa, 1e-6, 'maximum pressure');
      near(Math.min(...pressure), state.p_min_Pa, 1e-6, 'minimum pressure');
      const film = await shownIn(page, 'Film thickness and sag of the top foil');
      const thin = film.reduce((least, row) => (Number(row.film_thickness_m) < Number(least.film_thickness_m) ? row : least));
      near(Number(thin.film_thickness_m), state.h_min_m, 1e-6, 'minimum thickness');
      near(Number(thin.theta_deg), state.h_min_theta_deg, 1e-5, 'its place');
      const loads = await shownIn(page, 'Bump loads');
      const sizes = loads.map((row) => Number(row.load_N));
      near(Math.max(...sizes), state.highest_bump_load_N, 1e-6, 'highest load');
      assert.equal(sizes.indexOf(Math.max(...sizes)) + 1, state.highest_loaded_bump);
      assert.equal(sizes.filter((size) => size > 0).length, state.loaded_bumps);
      assert.match(await panelOf(page, 'Bump loads').locator('.subject').textContent(), new RegExp(`detached from ${26 - state.loaded_bumps} of 26 bumps${state.lifted_bumps_at_entry > 0 ? `, the first ${state.lifted_bumps_at_entry} at the inlet` : ' · '}`));
      const journal = (await panelOf(page, 'Bearing in operation').locator('.subject').textContent()).match(/journal at \((\S+ \S+), (\S+ \S+)\)/);
      near(quantity(journal[1], 'm'), state.x_m, 1e-2, 'x');
      near(quantity(journal[2], 'm'), state.y_m, 1e-2, 'y');
      const drawn = await panelOf(page, 'Bearing in operation').locator('svg.round').innerHTML();
      assert.notEqual(drawn, before);
      before = drawn;
      // The force that holds the journal points to where the load presses it: to +X.
      const polar = await panelOf(page, 'Film around the journal').locator('svg.round').innerHTML();
      assert.doesNotMatch(polar + drawn, /NaN|undefined/);
    }
    // In three dimensions it is turned by keys and by dragging, and goes back.
    const space = panelOf(page, 'Bearing in 3D').locator('canvas');
    const label = await space.getAttribute('aria-label');
    near(quantity(label.match(/minimum film thickness (\S+ .?m)/)[1], 'm'), states[states.length - 1].h_min_m, 1e-3, 'said of it');
    assert.match(label, /pressure on the top foil [\d.]+ to [\d.]+ kPa, ambient pressure 101\.3 kPa; film and displacements ×\d+, heights of bumps ×\d/);
    // Small, since browsers paint the same now with these roundings, now with those.
    const painted = () =>
      space.evaluate((canvas) => {
        const small = document.createElement('canvas');
        [small.width, small.height] = [24, 24];
        const context = small.getContext('2d');
        context.drawImage(canvas, 0, 0, 24, 24);
        return [...context.getImageData(0, 0, 24, 24).data];
      });
    const differs = async (from) => (await painted()).some((value, i) => Math.abs(value - from[i]) > 24);
    const until = async (from, different) => {
      for (let i = 0; (await differs(from)) !== different; i += 1) {
        assert.ok(i < 100, `it ${different ? 'stays' : 'does not come back'}`);
        await page.waitForTimeout(50);
      }
    };
    await space.scrollIntoViewIfNeeded();
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const first = await painted();
    await space.focus();
    for (const key of ['ArrowLeft', '+']) {
      await page.keyboard.press(key);
      await until(first, true);
      await page.keyboard.press('Home');
      await until(first, false);
    }
    await panelOf(page, 'Bearing in 3D').getByRole('combobox').selectOption('Film thickness');
    await until(first, true);
    const thicknesses = /film thickness on the top foil ([\d.]+) to [\d.]+ µm/.exec(await space.getAttribute('aria-label'));
    near(Number(thicknesses[1]), 1e6 * states[states.length - 1].h_min_m, 0.2, 'the mean of its thinnest facet');
    await panelOf(page, 'Bearing in 3D').getByRole('combobox').selectOption('Pressure');
    await until(first, false);
    const { x, y, width, height } = await space.boundingBox();
    await page.mouse.move(x + 0.5 * width, y + 0.5 * height);
    await page.mouse.down();
    await page.mouse.move(x + 0.7 * width, y + 0.4 * height);
    await page.mouse.up();
    await until(first, true);
  }));

test('letters in drawings of the bearing are as high as elsewhere, where these are small, too', async () => {
  for (const viewport of [laptop.viewport, { width: 390, height: 844 }]) {
    await withReport(
      'grid.html',
      async (page) => {
        for (const name of ['Film around the journal', 'Bearing in operation']) {
          const drawing = panelOf(page, name).locator('svg.round');
          await drawing.scrollIntoViewIfNeeded();
          const heights = await drawing.locator('text').evaluateAll((texts) => texts.map((one) => Number.parseFloat(getComputedStyle(one).fontSize) * one.getScreenCTM().a));
          assert.ok(heights.length >= 3, name);
          for (const height of heights) assert.ok(height > 10.9 && height < 11.1, `${name}: ${height} px`);
        }
      },
      { viewport },
    );
  }
});

test('stiffness and damping over frequency are those of coefficients.csv', () =>
  withReport('frequencies.html', async (page) => {
    const rows = rowsOf(readFileSync(join(folder, 'frequencies', 'coefficients.csv'), 'utf8'));
    assert.equal(await panelOf(page, 'Synchronous stiffness').count(), 0); // those of the files are at 200 Hz
    const section = page.getByRole('region', { name: 'Frequency-dependent coefficients' });
    await section.getByRole('combobox', { name: 'Frequencies: Load to +X' }).selectOption('(20, 0) N');
    for (const [panel, letter, unit] of [['Frequency-dependent stiffness', 'k', 'N_per_m'], ['Frequency-dependent damping', 'c', 'N_s_per_m']]) {
      for (const stuck of ['', '_stuck']) {
        await section.getByRole('combobox', { name: `Quantity: ${panel}` }).selectOption(`${letter === 'k' ? 'Stiffness K' : 'Damping c'}${stuck === '' ? '' : ', full stick'}`);
        const shown = await shownIn(page, panel);
        assert.equal(shown.length, 3);
        shown.forEach((row, i) => ['xx', 'xy', 'yx', 'yy'].forEach((axes) => near(Number(row[`${letter}${axes}${stuck}_${unit}`]), Number(rows[i][`${letter}${axes}${stuck}_${unit}`]), 1e-5, `${panel} ${axes}`)));
      }
    }
    const table = section.getByRole('region', { name: 'Coefficients by frequency' });
    assert.equal(await table.locator('tbody tr').count(), 6);
    assert.match(await table.locator('tbody tr').nth(4).textContent(), /\(50, 0\) N.*375 Hz/);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('what people read are words and units as they are written, and links lead somewhere', async () => {
  for (const name of ['frequencies', 'grid']) {
    await withReport(`${name}.html`, async (page) => {
      await page.getByRole('region', { name: 'Results by state' }).getByRole('button', { name: 'All' }).click();
      const text = await page.locator('main').innerText();
      assert.deepEqual(text.match(/\bh min\b|whirl stuck|dF_|krad|flow weld|m3/gi), null);
      const dead = await page.locator('a[href^="#"]').evaluateAll((links) => links.map((link) => link.getAttribute('href')).filter((href) => !document.getElementById(href.slice(1))));
      assert.deepEqual([...new Set(dead)], []);
      const row = (title) => page.locator('table.case tr', { has: page.getByRole('rowheader', { name: title, exact: true }) }).locator('td').innerText();
      assert.equal(await row('Speeds'), name === 'grid' ? '30000 rpm, 45000 rpm' : '45000 rpm');
      if (name === 'frequencies') {
        assert.equal(await row('Frequencies'), '200 Hz, 375 Hz, 750 Hz');
        assert.equal(await row('Loads'), '(20, 0) N, (50, 0) N');
      }
    });
  }
});

test('no row of panels is left half empty', () =>
  withReport('grid.html', async (page) => {
    const ends = await page.locator('.multiples').evaluateAll((groups) => groups.map((group) => [group.getBoundingClientRect().right, group.lastElementChild.getBoundingClientRect().right]));
    assert.ok(ends.length > 1);
    for (const [group, last] of ends) assert.ok(Math.abs(group - last) < 1, `${last} of ${group}`);
  }));

test('the way there and back shows both states at a load', () =>
  withReport('back.html', async (page) => {
    assert.deepEqual(await chooser(page, 'Load to +X').locator('option').allTextContents(), ['(20, 0) N', '(50, 0) N', '(20, 0) N, time 2']);
    const shown = await shownIn(page, 'Minimum film thickness');
    // However fine the mesh, the map has both halves of every node before it is printed or saved.
    const nodes = await shownIn(page, 'Pressure over the unwrapped foil');
    assert.ok(nodes.length > 2000);
    const shades = await page.evaluate(() => {
      window.dispatchEvent(new Event('beforeprint'));
      const parts = document.querySelectorAll('section[aria-label="Pressure over the unwrapped foil"] .plot path');
      return [...parts].filter((part) => /^(#|rgb)/.test(part.getAttribute('fill') ?? '')).length;
    });
    assert.ok(shades >= 2 * nodes.length, `${shades} parts for ${nodes.length} nodes`);
    csvOf('back').forEach((row, i) => near(Number(shown[i].h_min), Number(row.h_min_m), 1e-6, `state ${i}`));
  }));

test('paths to one state are compared', () =>
  withReport('paths.html', async (page) => {
    const rows = csvOf('paths');
    const names = rows.map((row) => row.path.replaceAll('_', ' '));
    assert.ok(new Set(names).size > 2);
    assert.deepEqual(await chooser(page, 'Path').locator('option').allTextContents(), names);
    const table = page.getByRole('region', { name: 'Results by state' });
    const heads = await table.locator('thead th').allTextContents();
    const column = heads.findIndex((head) => head.startsWith('Minimum film thickness'));
    const unit = heads[column].split(' ').pop();
    const cells = await table.locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
    cells.forEach((row, i) => near(quantity(`${row[column]} ${unit}`, 'm'), Number(rows[i].h_min_m), 1e-3, names[i]));
  }));

test('lift-off speed and load capacity are those of summary.json', () =>
  withReport('limits.html', async (page) => {
    const [speed, none, load] = summaryOf('limits').limits;
    const rows = await page.getByRole('group', { name: 'Table of limits' }).locator('tbody tr').evaluateAll((lines) => lines.map((line) => [...line.children].map((cell) => cell.textContent)));
    const lift = rows.find(([name]) => name === 'Lift-off speed under (50, 0) N');
    near(Number(lift[1].replace(' rpm', '')), (speed.speed_rad_per_s * 30) / Math.PI, 1e-5, 'lift-off speed');
    assert.deepEqual([lift[2], lift[3]], ['film thickness', '–']);
    near(quantity(lift[4], 'm'), speed.thick.h_min_m, 1e-3, 'film at the limit');
    near(quantity(rows.find(([name]) => name === 'Load capacity at 45000 rpm')[1], 'N'), load.load_N, 1e-3, 'load capacity');
    // Under 20 N the free end flutters at all speeds down to where the film is too thin.
    const [, value, bound, unstable] = rows.find(([name]) => name === 'Lift-off speed under (20, 0) N');
    assert.deepEqual([value, bound], ['none', 'stability']);
    const ends = unstable.split(' to ').map((text) => Number(text.replace(' rpm', '')));
    near(ends[0], (none.unstable[0].from_speed_rad_per_s * 30) / Math.PI, 1e-5, 'from');
    near(ends[1], 45000, 1e-5, 'to');
  }));

test('a film between walls has no foils to show', () =>
  withReport('rigid.html', async (page) => {
    await chooser(page, 'Position to +X').selectOption('(10, 0) µm');
    const [state] = summaryOf('rigid').states;
    const film = await shownIn(page, 'Film thickness');
    near(Math.min(...film.map((row) => Number(row.film_thickness_m))), state.h_min_m, 1e-6, 'minimum thickness');
    for (const name of ['Bump loads', 'Bearing in operation']) assert.equal(await panelOf(page, name).count(), 0);
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('a tilted journal is seen over the whole width, and its tilt is said', () =>
  withReport('tilted.html', async (page) => {
    assert.match(await panelOf(page, 'Bearing in 3D').locator('canvas').getAttribute('aria-label'), /; journal tilted by 500 µrad; minimum/);
    const sides = (await shownIn(page, 'Bearing in 3D')).map((row) => Math.sign(Number(row.z_m)));
    assert.equal(sides.reduce((sum, side) => sum + side, 0), 0);
    assert.ok(sides.includes(-1));
  }));

test('what was not found is told', () =>
  withReport('failed.html', async (page) => {
    assert.equal(await page.locator('h1').textContent(), '</script><b>x</b>');
    const told = await page.locator('.warnings').textContent();
    assert.match(told, /The run failed; its results are partial/);
    assert.match(told, /5000/);
    await chooser(page, 'Load to +X').selectOption('(5, 0) kN');
    for (const name of ['Pressure over the unwrapped foil', 'Bump loads', 'Bearing in operation', 'Film around the journal']) {
      assert.match(await panelOf(page, name).locator('.subject').textContent(), /no state found/);
    }
    assert.doesNotMatch(await page.locator('main').innerHTML(), /NaN|undefined/);
  }));

test('a click on a curve looks at its state, and pictures are complete', () =>
  withReport('grid.html', async (page) => {
    const panel = panelOf(page, 'Minimum film thickness');
    await chooser(page, 'Speed').selectOption('30000 rpm');
    await plotsIn(panel);
    const there = await placeOf(panel.locator('.cursor.point'));
    await chooser(page, 'Speed').selectOption('45000 rpm');
    await panel.locator('.chart').click({ position: there });
    assert.equal(await chooser(page, 'Speed').inputValue(), '30000 rpm');
    for (const name of ['Pressure over the unwrapped foil', 'Film around the journal', 'Bearing in operation']) {
      const words = (await saved(page, name, /SVG/)).bytes.toString().replace(/<[^>]*>/g, ' ');
      for (const text of [name, '30000 rpm', 'grid']) assert.ok(words.includes(text), `${name} does not say ${text}`);
      assert.doesNotMatch(words, /NaN|undefined/);
    }
  }));

test('axe finds nothing, and the page fits screens and paper', async () => {
  await withReport('grid.html', async (page) => {
    await assertAccessible(page);
    await assertFits(page);
    await assertPanelsFitPaper(page);
  });
});
