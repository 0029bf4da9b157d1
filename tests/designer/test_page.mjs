// The page of `bumpfoil designer` in Chromium, as people use it: its case, its loops, its file.

import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { answered, field, file, modules, slide, slider, textOf, tile, type, withPage, withSharedPage, write } from './page.mjs';
import { due, largestDifference, loopsOfProgram, reference } from './support.mjs';

test('the file is smaller than 4 MB', () => {
  const { size } = statSync(file);
  console.log(`designer.html: ${(size / 1e6).toFixed(2)} MB`);
  assert.ok(size < 4e6);
});

test('in the browser, too, loops are those of the program', () =>
  withSharedPage(async (page) => {
    const csv = await page.evaluate(async (text) => (await window.bumpfoilAsk({ what: 'csv', text })).csv, reference);
    const difference = largestDifference(loopsOfProgram(reference), csv);
    console.log(`in Chromium loops differ by ${difference.toExponential(1)} of the largest force`);
    assert.ok(difference <= due);
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
    // Two workers share the directions, one or more, and the page joins what they answer.
    for (const directions of [['+Y'], ['-X', '+Y', '+X']]) {
      await write(page, reference.replace(/^directions = .*$/m, `directions = ${JSON.stringify(directions)}`));
      // Behind them are those of the design before.
      const buttons = page.locator('.numbers [role="group"] button');
      const names = (await buttons.allTextContents()).map((name) => name.replace('−', '-'));
      assert.deepEqual(names.slice(0, directions.length), directions);
      await buttons.getByText('+Y').click();
      assert.equal(await tile(page, 'max_force_N'), '851.3 N');
    }
  }));

test('the four reference loops answer a slider within 100 ms', () =>
  withPage(async (page) => {
    const times = [];
    for (let i = 0; i < 15; i += 1) {
      await slide(page, 'friction.coefficient', String(0.11 + 0.01 * (i % 10)));
      times.push(Number(await page.evaluate(() => document.documentElement.dataset.took)));
    }
    const settled = times.slice(5).sort((a, b) => a - b);
    const median = settled[settled.length >> 1];
    console.log(`from a change to the loops drawn: ${times[0]} ms at first, ${median} ms then (median), ${settled[settled.length - 1]} ms at most`);
    // Target: 100 ms. Machines that run other tests at the same time take longer.
    assert.ok(median < 1000, `${median} ms`);
  }));

test('a change answers everywhere, with the design before beside it, and is undone', () =>
  withSharedPage(async (page) => {
    await type(page, 'friction.coefficient', '0.2');
    assert.equal(await tile(page, 'max_force_N'), '964.4 N');
    assert.match(await page.locator('.tile[data-key="max_force_N"] .change').textContent(), /^\+30\.4 % /);
    assert.match(await textOf(page), /coefficient = 0\.2 {15}# at both interfaces/);
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

test('errors stand beside their fields in the words of the program', () =>
  withSharedPage(async (page) => {
    await type(page, 'bearing.radial_clearance', '31.8 N');
    const error = page.locator('[data-key="bearing.radial_clearance"] .error');
    assert.match(await error.textContent(), /is a force, expected a length/);
    assert.equal(await field(page, 'bearing.radial_clearance').getAttribute('aria-invalid'), 'true');
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
    await type(page, 'bearing.radial_clearance', '20 um');
    assert.equal(await error.textContent(), '');
    assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
    await page.getByRole('tab', { name: 'Case file' }).click();
    await answered(page, () => page.locator('.editor').fill(reference.replace('[cycle]', '[cycle]\nparsnips = 1')));
    assert.match(await page.locator('.general-errors').textContent(), /Line \d+: cycle\.parsnips = 1: unknown key/);
  }));

test('decimal commas are understood, and lists without brackets', () =>
  withSharedPage(async (page) => {
    const error = (key) => page.locator(`[data-key="${key}"] .error`).textContent();
    const clearance = field(page, 'bearing.radial_clearance');
    await clearance.fill('31,8 um');
    await clearance.press('Tab');
    assert.equal(await clearance.inputValue(), '31.8');
    assert.equal(await textOf(page), reference);
    await type(page, 'bearing.radial_clearance', '1,5');
    assert.match(await textOf(page), /^radial_clearance = "1\.5 um" /m);
    await type(page, 'bearing.radial_clearance', '1,500 um');
    assert.match(await error('bearing.radial_clearance'), /write one number with a decimal point, without separators/);
    assert.equal(await clearance.inputValue(), '1,500 um');
    await type(page, 'bearing.radial_clearance', '31.8 um');
    await type(page, 'bump_foil.height_errors', '1 um, 2 um');
    assert.match(await textOf(page), /^height_errors = \["1 um", "2 um"\]/m);
    assert.match(await error('bump_foil.height_errors'), /one value per bump, 26 in all/);
    await type(page, 'bump_foil.height_errors', Array.from({ length: 26 }, (_, i) => `${i % 3},5`).join('; ').concat(' um'));
    assert.equal(await error('bump_foil.height_errors'), '');
    assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
    // What is no list stays a text: the fields around it are not touched.
    await type(page, 'bump_foil.height_errors', '[1 um 2');
    assert.match(await error('bump_foil.height_errors'), /does not begin|has digits|is no|unit/);
    assert.equal(await page.locator('.general-errors').textContent(), '');
  }));

test('units are changed without changing the bearing', () =>
  withSharedPage(async (page) => {
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
  withSharedPage(async (page) => {
    await type(page, 'bump_foil.pitch', '4.7 mm');
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Save case' }).click();
    const saved = readFileSync(await (await download).path(), 'utf8');
    assert.equal(saved, reference.replace('pitch = "4.572 mm"', 'pitch = "4.7 mm"'));
    await answered(page, () => page.locator('input[type="file"]').setInputFiles({ name: 'case.toml', mimeType: 'text/plain', buffer: Buffer.from(reference) }));
    assert.equal(await textOf(page), reference);
  }));

test('tables of lists are added, changed and taken out one by one', () =>
  withPage(
    async (page) => {
      // A table alone, as people wrote it before there were lists.
      await write(page, `${reference}\n[bearing.sleeve_waviness]\nharmonic = 3\namplitude = "2 um"\n`);
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
      assert.match(await page.locator('[data-key="bearing.sleeve_waviness[2].harmonic"] .error').textContent(), /give a whole number from 1/);
      assert.equal(await page.locator('.general-errors').textContent(), '');
      await answered(page, () => waves.getByRole('button', { name: 'Remove: Waviness of the sleeve 2' }).click());
      await answered(page, () => waves.getByRole('button', { name: 'Remove: Waviness of the sleeve 1' }).click());
      assert.equal((await textOf(page)).trim(), reference.trim());
      assert.equal(await tile(page, 'max_force_N'), '739.3 N');
      await answered(page, () => page.locator('[data-table="bump_foil.shim"] summary').click().then(() => page.getByRole('button', { name: /^Add: Shim/ }).click()));
      assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
    },
    { viewport: { width: 1366, height: 2000 } },
  ));

test('of radius and diameter one is given, and the taper has a slider, too', () =>
  withSharedPage(async (page) => {
    // With the charts out of sight.
    await page.getByRole('tab', { name: 'Case file' }).click();
    await type(page, 'bearing.diameter', '40 mm');
    assert.match(await textOf(page), /^diameter = "40 mm"$/m);
    assert.doesNotMatch(await textOf(page), /^radius/m);
    assert.equal(await field(page, 'bearing.radius').inputValue(), '20');
    await slide(page, 'bearing.diameter', '36');
    assert.match(await textOf(page), /^diameter = "36 mm"$/m);
    await type(page, 'bearing.radius', '19.05 mm');
    assert.doesNotMatch(await textOf(page), /^diameter/m);
    assert.equal(await field(page, 'bearing.diameter').inputValue(), '38.1');
    assert.equal(await slider(page, 'bearing.diameter').inputValue(), '38');
    assert.equal(await tile(page, 'max_force_N'), '739.3 N');
    await slide(page, 'bearing.taper', '10');
    assert.match(await textOf(page), /^taper = "10 um" /m);
    // What goes along X and Y has a slider of each.
    await slide(page, 'width.tilt[2]', '0.2');
    assert.match(await textOf(page), /^\[width\]\ntilt = \["0 mrad", "0\.2 mrad"\]$/m);
    await slide(page, 'width.tilt[1]', '-0.1');
    assert.match(await textOf(page), /^tilt = \["-0\.1 mrad", "0\.2 mrad"\]$/m);
    await answered(page, async () => {
      await field(page, 'width.tilt[2]').evaluate((one) => {
        one.value = '';
        one.dispatchEvent(new Event('change', { bubbles: true }));
      });
    });
    assert.doesNotMatch(await textOf(page), /^tilt/m);
    assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
  }));

test('fields are found by key, title and unit, and groups fold', () =>
  withSharedPage(async (page) => {
    const search = page.getByRole('searchbox');
    const shown = () => page.locator('.field:visible').evaluateAll((fields) => fields.map((one) => one.dataset.key));
    await search.fill('radial clear');
    assert.deepEqual(await shown(), ['bearing.radial_clearance']);
    await search.fill('TILT');
    assert.deepEqual(await shown(), ['width.tilt[1]', 'width.tilt[2]']);
    await search.fill('gpa');
    assert.deepEqual(await shown(), ['bump_foil.youngs_modulus', 'bump_foil.yield_stress', 'top_foil.youngs_modulus', 'top_foil.yield_stress']);
    // What the case has none of is found by what could be added.
    await search.fill('lobe');
    assert.deepEqual(await page.locator('.form .group:visible').evaluateAll((groups) => groups.map((one) => one.dataset.table)), ['pad']);
    await search.fill('');
    assert.ok((await shown()).includes('bearing.radius') && !(await shown()).includes('width.tilt[1]'));
    await page.getByRole('button', { name: 'Fold all' }).click();
    assert.deepEqual(await shown(), []);
  }));

test('bumps are given one by one, by a law or all alike', () =>
  withSharedPage(async (page) => {
    await page.locator('[data-table="bumps"] summary').click();
    const cell = (title, bump) => page.getByLabel(`${title}, bump ${bump}, mm`);
    const way = page.getByLabel('Pitch: how it is given');
    await answered(page, () => way.selectOption('linear'));
    assert.match(await textOf(page), /^pitch = \{ start = "4\.572 mm", end = "4\.572 mm", law = "linear" \}/m);
    await answered(page, async () => {
      await cell('Pitch', 26).fill('4.4');
      await cell('Pitch', 26).press('Tab');
    });
    assert.match(await textOf(page), /^pitch = \{ start = "4\.572 mm", end = "4\.4 mm", law = "linear" \}/m);
    assert.equal(await cell('Pitch', 1).inputValue(), '4.572');
    assert.equal(await cell('Pitch', 11).inputValue(), '4.5032');
    await answered(page, () => way.selectOption('one'));
    assert.equal(await textOf(page), reference);
    // A section gives way to the column that is changed.
    await write(page, `${reference}\n[[bump_foil.section]]\nfrom = 1\nto = 5\nthickness = "0.127 mm"\n`);
    assert.equal(await cell('Thickness', 5).inputValue(), '0.127');
    await answered(page, async () => {
      await cell('Thickness', 6).fill('0,11');
      await cell('Thickness', 6).press('Tab');
    });
    const sheet = Array.from({ length: 26 }, (_, i) => `"${i < 5 ? 0.127 : i === 5 ? 0.11 : 0.102} mm"`).join(', ');
    assert.ok((await textOf(page)).includes(`\nthickness = [${sheet}]`), await textOf(page));
    assert.doesNotMatch(await textOf(page), /^\[\[bump_foil\.section\]\]/m);
    assert.equal(await page.locator('.general-errors').textContent(), '');
    assert.notEqual(await tile(page, 'max_force_N'), '739.3 N');
  }));
test('a bump foil is split into strips, each with fields of its own, as many as are counted', () =>
  withSharedPage(async (page) => {
    // One direction: every change is computed over the whole width.
    const alongX = reference.replace(/^directions = .*$/m, 'directions = ["+X"]');
    await write(page, alongX);
    // Strips that differ need a top foil that varies over the width, staggered ones room for one bump less.
    await slide(page, 'width.modes', '3');
    await slide(page, 'bump_foil.bumps', '25');
    const strips = page.locator('[data-table="bump_foil.strip"]').first();
    await strips.locator('summary').click();
    await answered(page, () => strips.getByRole('button', { name: 'Add: Strip' }).click());
    assert.match(await textOf(page), /^strips = 2 /m);
    assert.equal((await textOf(page)).match(/^\[\[bump_foil\.strip\]\]$/gm).length, 2);
    await slide(page, 'bump_foil.strips', '3');
    const alike = await tile(page, 'max_force_N');
    await type(page, 'bump_foil.strip[2].thickness', '0.2 mm');
    assert.match(await textOf(page), /^\[\[bump_foil\.strip\]\]\n\n\[\[bump_foil\.strip\]\]\nthickness = "0\.2 mm"\n\n\[\[bump_foil\.strip\]\]$/m);
    const stiffer = await tile(page, 'max_force_N');
    // A third of the width is (0.2/0.102)^3 as stiff: 3.2 times the force, had the take-up been the same.
    assert.deepEqual([alike, stiffer], ['739.3 N', '2.209 kN']);
    await slide(page, 'bump_foil.strip[2].stagger', '0.5');
    assert.match(await textOf(page), /^stagger = 0\.5$/m);
    assert.notEqual(await tile(page, 'max_force_N'), stiffer);
    await type(page, 'bump_foil.strip[3].height_errors', '-900 um');
    assert.match(await page.locator('[data-key="bump_foil.strip[3].height_errors"] .error').textContent(), /is more than the rise of the bump/);
    assert.equal(await page.locator('.general-errors').textContent(), '');
    await answered(page, () => strips.getByRole('button', { name: 'Remove: Strip' }).click());
    assert.equal((await textOf(page)).trim(), `${alongX.trim().replace('strips = 1 ', 'strips = 3 ').replace(/^bumps = 26$/m, 'bumps = 25')}\n\n[width]\nmodes = 3`);
  }));

test('a bearing of pads is shown and changed pad by pad', () =>
  withSharedPage(async (page) => {
    await answered(page, () => page.locator('input[type="file"]').setInputFiles(join(process.env.BUMPFOIL_EXAMPLES, 'gen3-three-pad.toml')));
    await page.locator('[data-table="pad"] > summary').click();
    const before = await tile(page, 'max_force_N');
    await type(page, 'pad[2].lobe', '25 um');
    const pads = (await textOf(page)).split(/^\[\[pad\]\]/m);
    assert.match(pads[2], /^lobe = "25 um"/m);
    assert.match(pads[1], /^lobe = "10 um"/m);
    await page.locator('[data-table="pad[3]"] .own-foils summary').click();
    await type(page, 'pad[3].bump_foil.thickness', '0.12 mm');
    assert.match((await textOf(page)).split(/^\[\[pad\]\]/m)[3], /^bump_foil\.thickness = "0\.12 mm"$/m);
    assert.equal(await page.locator('.general-errors').textContent(), '');
    await page.locator('.numbers [role="group"] button').getByText('−X').click();
    assert.notEqual(await tile(page, 'max_force_N'), before);
  }));

/** What a tab shows is judged when it is there. */
async function settled(page, tab) {
  const title = await tab.textContent();
  if (title === 'Running' || title === 'Rotor') await page.waitForFunction((view) => document.querySelector(view).dataset.answered, `.${title.toLowerCase()}`);
}

test('the page fits from 390 px up, with its results in sight, and passes the checks of accessibility', () =>
  withPage(async (page) => {
    // A coarse mesh, on which the tests need not wait.
    await write(page, `${reference}\n[film]\ncolumns_per_pitch = 4\nrows = 6\n`);
    for (const [width, height] of [[2560, 1300], [1366, 768], [768, 900], [390, 844]]) {
      await page.setViewportSize({ width, height });
      // The narrowest has the least room for any of them.
      const tabs = await page.getByRole('tab').all();
      for (const tab of width === 390 ? tabs : tabs.slice(0, 1)) {
        await tab.click();
        await settled(page, tab);
        const excess = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(excess <= 0, `${excess} px too wide at ${width}: ${await tab.textContent()}`);
      }
      await page.getByRole('tab', { name: 'Loops' }).click();
      await page.evaluate(() => window.scrollTo(0, 0));
      const numbers = await page.locator('#view-loops .tile').last().boundingBox();
      const chart = await page.locator('#view-loops .plot').first().boundingBox();
      assert.ok(numbers.y + numbers.height < chart.y && chart.y + 0.7 * chart.height < height, `at ${width} the chart begins ${chart.y} px down`);
    }
    const side = page.locator('.side-body');
    assert.equal(await side.isVisible(), false);
    await page.getByRole('button', { name: 'The case' }).click();
    assert.equal(await side.isVisible(), true);
    await page.getByRole('button', { name: 'The case' }).click();
    // All that is there at first, in light and dark, which differ by their colours alone; then what each tab shows. What
    // passes is only counted.
    await page.setViewportSize({ width: 1366, height: 768 });
    await page.addScriptTag({ content: readFileSync(modules.resolve('axe-core/axe.min.js'), 'utf8') });
    const judge = async (part, least, rules) => {
      const { violations, passes } = await page.evaluate(([include, runOnly]) => {
        const exclude = [['.plot'], ['.round > *'], ['.unwrapped > *']];
        return globalThis.axe.run({ include: [[include]], exclude }, { resultTypes: ['violations'], ...(runOnly && { runOnly }) });
      }, [part, rules]);
      assert.ok(passes.length >= least, `${passes.length} rules`);
      assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
    };
    await judge('html', 21);
    await page.emulateMedia({ colorScheme: 'dark' });
    await judge('html', 1, ['color-contrast', 'link-in-text-block']);
    await page.emulateMedia({ colorScheme: 'light' });
    const [, ...tabs] = await page.getByRole('tab').all();
    for (const tab of tabs) {
      await tab.click();
      await judge('[role="tabpanel"]:not([hidden])', 5);
    }
  }));
