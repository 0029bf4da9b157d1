const mostTicks = 5;

/** Round numbers between two, so many at most. */
export function roundTicks(least: number, most: number, count = mostTicks): number[] {
  if (!(most > least)) return [least];
  const rough = (most - least) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 2.5, 5, 10].find((digit) => digit * power >= rough * (1 - 1e-9)) ?? 10) * power;
  const first = Math.ceil(least / step - 1e-9);
  return Array.from({ length: Math.max(0, Math.floor(most / step + 1e-9) - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** A number beside its tick. */
export function tickText(number: number): string {
  return String(Number(number.toPrecision(6))).replace('-', '−');
}
