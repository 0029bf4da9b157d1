// The page of `bumpfoil designer` in Chromium, as people use it.

import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { due, largestDifference, loopsOfProgram, reference, run, withFolder } from './support.mjs';

const modules = createRequire(join(process.env.BUMPFOIL_WEB, 'package.json'));
const { chromium } = modules('playwright-core');
let folder;
let file;
let browser;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'bumpfoil-designer-'));
  file = join(folder, 'designer.html');
  run('designer', '-o', file);
  browser = await chromium.launch({ executablePath: process.env.BUMPFOIL_CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

async function answers(page) {
  return Number(await page.evaluate(() => document.documentElement.dataset.answered ?? 0));
}

/** Does something to the case, and waits until that is answered. */
async function answered(page, act) {
  const count = await answers(page);
  await act();
  await page.waitForFunction((before) => Number(document.documentElement.dataset.answered) > before, count);
}

/** The page, and everything that goes wrong or out while it is shown. */
async function withPage(check, { fragment = '', ...options } = {}) {
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 }, ...options });
  const page = await context.newPage();
  const faults = [];
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('console', (message) => faults.push(message.text()));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(request.url());
  });
  await page.goto(pathToFileURL(file).href + fragment);
  await page.waitForFunction(() => document.documentElement.dataset.answered);
  await check(page);
  assert.deepEqual(faults, []);
  await context.close();
}

const field = (page, key) => page.locator(`[data-key="${key}"] input:not([type="range"])`);
const slider = (page, key) => page.locator(`[data-key="${key}"] input[type="range"]`);
const tile = (page, key) => page.locator(`.tile[data-key="${key}"] strong`).textContent();

async function type(page, key, text) {
  await answered(page, async () => {
    await field(page, key).fill(text);
    await field(page, key).press('Tab');
  });
}

function textOf(page) {
  return page.locator('.editor').inputValue();
}

test('the file is smaller than 6 MB', () => {
  const { size } = statSync(file);
  console.log(`designer.html: ${(size / 1e6).toFixed(2)} MB`);
  assert.ok(size < 6e6);
});

test('in the browser, too, loops are those of the program', () =>
  withPage(async (page) => {
    const csv = await page.evaluate(async (text) => (await window.bumpfoilAsk({ what: 'csv', text })).csv, reference);
    const difference = largestDifference(loopsOfProgram(reference), csv);
    console.log(`in Chromium loops differ by ${difference.toExponential(1)} of the largest force`);
    assert.ok(difference <= due);
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
  }));

test('the four reference loops answer a slider within 100 ms', () =>
  withPage(async (page) => {
    const times = [];
    for (let i = 0; i < 40; i += 1) {
      await answered(page, () =>
        slider(page, 'friction.coefficient').evaluate((one, value) => {
          one.value = String(value);
          one.dispatchEvent(new Event('input', { bubbles: true }));
        }, 0.11 + 0.01 * (i % 10)),
      );
      times.push(Number(await page.evaluate(() => document.documentElement.dataset.took)));
    }
    const settled = times.slice(20).sort((a, b) => a - b);
    const median = settled[settled.length >> 1];
    console.log(`from a change to the loops drawn: ${times[0]} ms at first, ${median} ms then (median), ${settled[settled.length - 1]} ms at most`);
    // Target: 100 ms. Machines that run other tests at the same time take longer.
    assert.ok(median < 1000, `${median} ms`);
  }));

test('a change answers everywhere, with the design before beside it, and is undone', () =>
  withPage(async (page) => {
    await type(page, 'friction.coefficient', '0.2');
    assert.equal(await tile(page, 'max_force_N'), '964.4 N');
    assert.match(await page.locator('.tile[data-key="max_force_N"] .change').textContent(), /^\+30\.4 % /);
    assert.match(await textOf(page), /coefficient = 0\.2 {15}# at both of its interfaces/);
    assert.equal((await textOf(page)).replace('coefficient = 0.2', 'coefficient = 0.1'), reference);
    await answered(page, () => page.getByRole('button', { name: 'Undo' }).click());
    assert.equal(await textOf(page), reference);
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
    await answered(page, () => page.keyboard.press('Control+Shift+z'));
    assert.equal(await tile(page, 'max_force_N'), '964.4 N');
  }));

test('a slider is dragged in one step', () =>
  withPage(async (page) => {
    const one = slider(page, 'bearing.radial_clearance');
    await one.focus();
    await answered(page, () => one.press('ArrowRight'));
    await answered(page, () => one.press('ArrowRight'));
    assert.notEqual(await textOf(page), reference);
    while (await page.getByRole('button', { name: 'Undo' }).isEnabled()) {
      await answered(page, () => page.getByRole('button', { name: 'Undo' }).click());
    }
    assert.equal(await textOf(page), reference);
  }));

test('faults stand beside their fields in the words of the program', () =>
  withPage(async (page) => {
    await type(page, 'bearing.radial_clearance', '31.8 N');
    const fault = page.locator('[data-key="bearing.radial_clearance"] .fault');
    assert.match(await fault.textContent(), /is a force where a length is due/);
    assert.equal(await field(page, 'bearing.radial_clearance').getAttribute('aria-invalid'), 'true');
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
    await type(page, 'bearing.radial_clearance', '20 um');
    assert.equal(await fault.textContent(), '');
    assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
    await page.getByRole('tab', { name: 'Case file' }).click();
    await answered(page, () => page.locator('.editor').fill(reference.replace('[cycle]', '[cycle]\nparsnips = 1')));
    assert.match(await page.locator('.general-faults').textContent(), /Line \d+: cycle\.parsnips = 1: is no known key/);
  }));

test('units are changed without changing the bearing', () =>
  withPage(async (page) => {
    await answered(page, () => page.getByLabel('Unit of Radial clearance').selectOption('mm'));
    assert.equal(await field(page, 'bearing.radial_clearance').inputValue(), '0.0318');
    assert.match(await textOf(page), /radial_clearance = "0\.0318 mm" {4}#/);
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
  }));

test('a link holds the design', () =>
  withPage(async (page) => {
    await type(page, 'friction.coefficient', '0.25');
    await page.getByRole('button', { name: 'Copy link' }).click();
    await page.waitForFunction(() => location.hash.startsWith('#case='));
    const fragment = await page.evaluate(() => location.hash);
    const text = await textOf(page);
    await withPage(async (other) => assert.equal(await textOf(other), text), { fragment });
  }));

test('the case is saved and opened as it is', () =>
  withPage(async (page) => {
    await type(page, 'bump_foil.pitch', '4.7 mm');
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save case' }).click();
    const saved = readFileSync(await (await download).path(), 'utf8');
    assert.equal(saved, reference.replace('pitch = "4.572 mm"', 'pitch = "4.7 mm"'));
    await answered(page, () => page.locator('input[type="file"]').setInputFiles({ name: 'case.toml', mimeType: 'text/plain', buffer: Buffer.from(reference) }));
    assert.equal(await textOf(page), reference);
  }));

test('vibrations about a load are those of the program', () =>
  withPage(async (page) => {
    await page.getByRole('tab', { name: 'Vibration' }).click();
    const drawn = async (act) => {
      const count = Number((await page.locator('.vibration').getAttribute('data-answered')) ?? 0);
      await act();
      await page.waitForFunction((before) => Number(document.querySelector('.vibration').dataset.answered ?? 0) > before, count);
    };
    await drawn(() => Promise.resolve());
    const load = page.getByLabel('along Y, N');
    await drawn(async () => {
      await load.fill('-80');
      await load.press('Tab');
    });
    assert.match(await page.locator('.vibration > .note').textContent(), /the journal stands at x = .* µm/);
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

test('a hundred bearings are those of the program', () =>
  withPage(async (page) => {
    await answered(page, () => page.locator('[data-key="cycle.steps"] input[type="range"]').evaluate((one) => {
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
    await answered(page, () => page.locator('.editor').evaluate((one, text) => {
      one.value = text;
      one.dispatchEvent(new Event('input', { bubbles: true }));
    }, reference.replace(/^title = .*/m, 'title = "A </script> in a title"')));
    await type(page, 'friction.coefficient', '0.2');
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save report' }).click();
    const report = join(folder, 'report.html');
    await (await download).saveAs(report);
    const other = await page.context().newPage();
    const faults = [];
    other.on('pageerror', (error) => faults.push(String(error)));
    other.on('console', (message) => faults.push(message.text()));
    await other.goto(pathToFileURL(report).href);
    await other.waitForFunction(() => document.documentElement.dataset.drawn);
    assert.match(await other.locator('h1').textContent(), /A <\/script> in a title/);
    assert.match(await other.locator('.about').first().textContent(), /2 runs compared · solver newton · bumpfoil /);
    const row = other.locator('tr[data-key="max_force_N"]').first();
    assert.match(await row.textContent(), /739\.3.*964\.4/);
    assert.deepEqual(faults, []);
    await other.close();
  }));

test('charts out of sight are drawn when one comes to them', () =>
  withPage(async (page) => {
    await type(page, 'friction.coefficient', '0.2');
    const plot = page.locator('#view-loads .plot').last();
    await plot.locator('svg').waitFor({ state: 'attached' });
    const [drawn, label] = [await plot.innerHTML(), await plot.locator('..').getAttribute('aria-label')];
    await type(page, 'friction.coefficient', '0.3');
    assert.equal(await plot.innerHTML(), drawn);
    assert.notEqual(await plot.locator('..').getAttribute('aria-label'), label);
    await plot.scrollIntoViewIfNeeded();
    await page.waitForFunction(([one, before]) => one.innerHTML !== before, [await plot.elementHandle(), drawn]);
  }));

test('tables of lists are added, changed and taken out one by one', () =>
  withPage(
    async (page) => {
      // A table alone, as people wrote it before there were lists.
      await answered(page, () => page.locator('.editor').evaluate((one, text) => {
        one.value = `${text}\n[bearing.sleeve_waviness]\nharmonic = 3\namplitude = "2 um"\n`;
        one.dispatchEvent(new Event('input', { bubbles: true }));
      }, reference));
      const waves = page.locator('[data-table="bearing.sleeve_waviness"]');
      assert.match(await waves.locator('summary').textContent(), /\(1\)$/);
      await waves.locator('summary').click();
      const before = await tile(page, 'max_force_N');
      await type(page, 'bearing.sleeve_waviness[1].amplitude', '4 um');
      assert.notEqual(await tile(page, 'max_force_N'), before);
      await answered(page, () => waves.getByRole('button', { name: /^Add/ }).click());
      await type(page, 'bearing.sleeve_waviness[2].harmonic', '2');
      assert.match(await textOf(page), /\[\[bearing\.sleeve_waviness\]\]\nharmonic = 3\namplitude = "4 um"\n\n\[\[bearing\.sleeve_waviness\]\]\nharmonic = 2\namplitude = "5 um"\n$/);
      await type(page, 'bearing.sleeve_waviness[2].harmonic', '-2');
      assert.match(await page.locator('[data-key="bearing.sleeve_waviness[2].harmonic"] .fault').textContent(), /give a whole number from 1/);
      assert.equal(await page.locator('.general-faults').textContent(), '');
      await answered(page, () => waves.getByRole('button', { name: 'Take out: Waviness of the sleeve 2' }).click());
      await answered(page, () => waves.getByRole('button', { name: 'Take out: Waviness of the sleeve 1' }).click());
      assert.equal((await textOf(page)).trim(), reference.trim());
      assert.equal(await tile(page, 'max_force_N'), '739.3 N');
      await answered(page, () => page.locator('[data-table="bump_foil.shim"] summary').click().then(() => page.getByRole('button', { name: /^Add: Shim/ }).click()));
      assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
    },
    { viewport: { width: 1366, height: 2000 } },
  ));

test('of radius and diameter one is given', () =>
  withPage(async (page) => {
    // With the charts of loads out of sight.
    await page.getByRole('tab', { name: 'Table' }).click();
    await type(page, 'bearing.diameter', '40 mm');
    assert.match(await textOf(page), /^diameter = "40 mm"$/m);
    assert.doesNotMatch(await textOf(page), /^radius/m);
    assert.equal(await field(page, 'bearing.radius').inputValue(), '20');
    await type(page, 'bearing.radius', '19.05 mm');
    assert.doesNotMatch(await textOf(page), /^diameter/m);
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
  }));

test('the page fits from 768 px up and has no serious fault for those who cannot see it', async () => {
  for (const width of [768, 1366, 1920]) {
    await withPage(
      async (page) => {
        for (const tab of await page.getByRole('tab').all()) {
          await tab.click();
          const excess = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
          assert.ok(excess <= 0, `${excess} px too wide at ${width}: ${await tab.textContent()}`);
        }
      },
      { viewport: { width, height: 900 } },
    );
  }
  for (const colorScheme of ['light', 'dark']) {
    await withPage(
      async (page) => {
        await page.addScriptTag({ content: readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8') });
        for (const tab of await page.getByRole('tab').all()) {
          await tab.click();
          const { violations, passes } = await page.evaluate(() => globalThis.axe.run({ exclude: [['.plot'], ['.round > *'], ['.unwrapped > *']] }));
          assert.ok(passes.length > 20);
          const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
          assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
        }
      },
      { colorScheme },
    );
  }
});
