import type { EChartsType } from 'echarts/core';
import type { Chart, Point } from './chart';

export interface NearestPoint {
  series: number;
  index: number;
}

/** The point of some curves, in the numbers of the axes, that is next to a place on the chart, if it is near enough. */
export function nearestPoint(chart: Chart, curves: Point[][], x: number, y: number, within: number): NearestPoint | undefined {
  // Axes are linear: two points tell where all others are.
  const [x0, y0] = chart.pixel(0, 0, 0);
  const [x1, y1] = chart.pixel(0, 1, 1);
  let found: NearestPoint | undefined;
  let least = within ** 2;
  curves.forEach((points, series) =>
    points.forEach(([px, py], index) => {
      const distance = (x0 + px * (x1 - x0) - x) ** 2 + (y0 + py * (y1 - y0) - y) ** 2;
      if (!(distance < least)) return;
      least = distance;
      found = { series, index };
    }),
  );
  return found;
}

/** Shows the tip of the point under the pointer, and reports clicks on points. */
export function followPointer(
  chart: () => Chart,
  instance: EChartsType,
  curves: () => Point[][],
  choose: (point: NearestPoint) => void,
): void {
  const area = instance.getZr();
  area.on('mousemove', ({ offsetX, offsetY }) => {
    const point = nearestPoint(chart(), curves(), offsetX, offsetY, 40);
    if (point) instance.dispatchAction({ type: 'showTip', seriesIndex: point.series, dataIndex: point.index });
    else instance.dispatchAction({ type: 'hideTip' });
  });
  area.on('globalout', () => instance.dispatchAction({ type: 'hideTip' }));
  area.on('click', ({ offsetX, offsetY }) => {
    const point = nearestPoint(chart(), curves(), offsetX, offsetY, 60);
    if (point) choose(point);
  });
}
