import { describe, expect, it } from 'vitest';
import { Design } from '../src/designer/design';
import { converted, readQuantity, writeQuantity } from '../src/designer/quantity';
import { inList, outlineOf, withCount, without, withValue, writtenValue } from '../src/designer/toml';

const text = `title = "a # no comment"  # one
[bearing]
radius = "19.05 mm"   # inner
list = ["1 um", # first
  "2 um"]
[[bearing.wave]]
amplitude = 1
[[bearing.wave]]
amplitude = 2
[montecarlo]
bump_height = { distribution = "normal", std = "5 um" }
`;

describe('case files', () => {
  it('say what is written where', () => {
    const written = (path: string): string | undefined => writtenValue(text, outlineOf(text), path);
    expect(written('title')).toBe('"a # no comment"');
    expect(written('bearing.list')).toBe('["1 um", # first\n  "2 um"]');
    expect(written('bearing.wave[2].amplitude')).toBe('2');
    expect(written('montecarlo.bump_height.std')).toBe('"5 um"');
    expect(written('bearing.length')).toBeUndefined();
    const inPads = '[[pad]]\narc = "90 deg"\n[[pad]]\n[pad.bump_foil]\nthickness = "0.1 mm"\n';
    expect(writtenValue(inPads, outlineOf(inPads), 'pad[2].bump_foil.thickness')).toBe('"0.1 mm"');
  });

  it('are changed in one place alone', () => {
    expect(withValue(text, 'bearing.radius', '"2 cm"')).toBe(text.replace('"19.05 mm"', '"2 cm"'));
    expect(withValue(text, 'montecarlo.bump_height.std', '1')).toBe(text.replace('"5 um"', '1'));
    expect(withValue(text, 'bearing.wave[1].phase', '3')).toBe(text.replace('amplitude = 1\n', 'amplitude = 1\nphase = 3\n'));
    expect(withValue(text, 'montecarlo.bump_height.mean', '0')).toBe(text.replace('um" }', 'um", mean = 0 }'));
    expect(withValue(text, 'friction.coefficient', '0.1')).toBe(`${text}\n[friction]\ncoefficient = 0.1\n`);
    expect(without(text, 'bearing.radius')).toBe(text.replace(/radius.*\n/, ''));
    expect(without(text, 'bearing.wave[2]')).toBe(text.replace('[[bearing.wave]]\namplitude = 2\n', ''));
  });

  it('hold lists of tables in three ways', () => {
    const alone = '[bearing]\n[bearing.wave] # one\namplitude = 1\n';
    const one = new Design(alone);
    expect([one.count('bearing.wave'), one.written('bearing.wave[1].amplitude')]).toEqual([1, '1']);
    one.set('bearing.wave[1].amplitude', '2');
    one.set('bearing.wave[1].phase', '3');
    expect(one.text).toBe('[bearing]\n[bearing.wave] # one\namplitude = 2\nphase = 3\n');
    expect(inList(alone, 'bearing.wave')).toBe(alone.replace('[bearing.wave]', '[[bearing.wave]]'));
    one.remove('bearing.wave[1]');
    expect(one.text).toBe('[bearing]\n');
    const many = new Design(text);
    expect([many.count('bearing.wave'), many.isInline('bearing.wave'), inList(text, 'bearing.wave')]).toEqual([2, false, text]);
    many.remove('bearing.wave[1]');
    expect([many.count('bearing.wave'), many.written('bearing.wave[1].amplitude')]).toEqual([1, '2']);
    const inline = new Design('[bearing]\nwave = [{ amplitude = 1 }, { amplitude = 2 }]\n');
    expect([inline.count('bearing.wave'), inline.isInline('bearing.wave')]).toEqual([2, true]);
    inline.set('bearing.wave[2].amplitude', '3');
    inline.set('bearing.wave[2].phase', '4');
    expect(inline.text).toBe('[bearing]\nwave = [{ amplitude = 1 }, { amplitude = 3, phase = 4 }]\n');
  });

  it('hold as many tables of a list as are counted', () => {
    expect(withCount('a = 1\n', 'foil.strip', 2)).toBe('a = 1\n\n[[foil.strip]]\n\n[[foil.strip]]\n');
    expect(withCount('[foil.strip]\nb = 1\n', 'foil.strip', 2)).toBe('[[foil.strip]]\nb = 1\n\n[[foil.strip]]\n');
    const three = '[[foil.strip]]\nb = 1\n[[foil.strip]]\nb = 2\n[[foil.strip]]\nb = 3\n[gas]\nc = 4\n';
    expect(withCount(three, 'foil.strip', 1)).toBe('[[foil.strip]]\nb = 1\n[gas]\nc = 4\n');
    expect(withCount(three, 'foil.strip', 0)).toBe('[gas]\nc = 4\n');
    const design = new Design('[bump_foil]\nstrips = 2\n[[bump_foil.strip]]\n[[bump_foil.strip]]\nstagger = 0.5\n');
    design.set('bump_foil.strips', '3');
    expect(design.count('bump_foil.strip')).toBe(3);
    design.set('bump_foil.strips', '1');
    expect(design.text.trim()).toBe('[bump_foil]\nstrips = 1');
    design.set('bump_foil.strips', '4');
    expect(design.count('bump_foil.strip')).toBe(0);
  });

  it('are read as far as they are right', () => {
    expect(writtenValue('a = 1\nb = [', outlineOf('a = 1\nb = ['), 'a')).toBe('1');
    expect(writtenValue('a = 1\nb = [\n1,\n2,\n', outlineOf('a = 1\nb = [\n1,\n2,\n'), 'a')).toBe('1');
    expect(outlineOf('a = "open').values.size).toBe(0);
    expect(outlineOf('\n\n]').values.size).toBe(0);
  });
});

describe('designs', () => {
  it('give the other coefficient of friction what both had', () => {
    const design = new Design('[friction]\ncoefficient = 0.1 # both\n');
    design.set('friction.bump_sleeve', '0.3');
    expect(design.text).toBe('[friction]\ntop_bump = 0.1\nbump_sleeve = 0.3\n');
    design.set('friction.top_bump', '0.2');
    expect(design.text).toBe('[friction]\ntop_bump = 0.2\nbump_sleeve = 0.3\n');
    design.set('friction.coefficient', '0.4');
    expect(design.text).toBe('[friction]\ncoefficient = 0.4\n');
    design.undo();
    expect(design.written('friction.top_bump')).toBe('0.2');
  });

  it('undo what was dragged as one step', () => {
    const design = new Design('x = 1');
    design.set('x', '2', true);
    design.set('x', '3', true);
    design.change(design.text, false);
    design.set('x', '4');
    design.undo();
    expect(design.text).toBe('x = 3');
    design.undo();
    expect(design.text).toBe('x = 1');
    expect(design.canUndo).toBe(false);
    design.redo();
    design.set('x', '5');
    expect(design.canRedo).toBe(false);
  });
});

describe('quantities', () => {
  it('are read, written and converted', () => {
    const units = { m: { m: 1, um: 1e-6, mm: 1e-3 } };
    expect(readQuantity('"31.8 um"')).toEqual({ number: 31.8, unit: 'um' });
    expect(readQuantity('"um"')).toBeUndefined();
    expect(writeQuantity({ number: 2, unit: '' })).toBe('2');
    expect(converted({ number: 31.8, unit: 'um' }, 'mm', 'm', units)).toEqual({ number: 0.0318, unit: 'mm' });
  });
});

describe('a table within one of a list', () => {
  const text = '[[pad]]\nlobe = "1 um"\n\n[[pad]]\n\n[[pad]]\nlobe = "3 um"\n';

  it('is given by dotted keys, where its pad is', () => {
    const thicker = withValue(text, 'pad[1].bump_foil.thickness', '"0.1 mm"');
    expect(thicker).toBe(text.replace('"1 um"', '"1 um"\nbump_foil.thickness = "0.1 mm"'));
    expect(withValue(thicker, 'pad[1].bump_foil.pitch', '1')).toContain('"0.1 mm"\nbump_foil.pitch = 1\n');
    expect(withValue(text, 'pad[2].lobe', '"2 um"')).toBe(text.replace('[[pad]]\n\n', '[[pad]]\nlobe = "2 um"\n\n'));
    expect(without(thicker, 'pad[1].bump_foil.thickness')).toBe(text);
  });
});
