import { expect, test } from 'vitest';
import { afterwards, inTwoSteps } from '../src/ui/afterwards';

test('what waits is done once, in the second step of a change, and at once without one', () => {
  const done: string[] = [];
  const table = (): void => void done.push('table');
  const foils = (): void => void done.push('foils');
  const rest = inTwoSteps(() => {
    done.push('loops');
    for (const work of [table, foils, table]) afterwards(work);
  });
  expect(done).toEqual(['loops']);
  rest();
  expect(done).toEqual(['loops', 'table', 'foils']);
  afterwards(foils);
  expect(done).toEqual(['loops', 'table', 'foils', 'foils']);
});

test('a change that fails leaves nothing waiting', () => {
  const done: string[] = [];
  expect(() => inTwoSteps(() => { throw new Error('no'); })).toThrow('no');
  afterwards(() => void done.push('table'));
  expect(done).toEqual(['table']);
});
