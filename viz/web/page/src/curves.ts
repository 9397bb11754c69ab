// The two charts below the picture, and the lists from which their curves are chosen.
import { Chart, Curve, curvesOf } from './chart';
import { find, make } from './dom';
import { History } from './history';

export class Curves {
  private curves: Curve[] = [];
  private plots: { select: HTMLSelectElement; chart: Chart; usual: string }[];

  constructor(private history: History, private time: () => number, seek: (time: number) => void) {
    this.plots = [['a', ''], ['b', 'cracks']].map(([name, usual]) => ({
      select: find<HTMLSelectElement>(`chart-${name}`),
      chart: new Chart(find(`plot-${name}`), seek),
      usual,
    }));
    for (const { select } of this.plots) select.addEventListener('change', () => this.draw());
  }

  draw(): void {
    const curves = curvesOf(this.history);
    const others = curves.map(({ id }) => id).join() !== this.curves.map(({ id }) => id).join();
    this.curves = curves;
    if (others) this.offer(curves);
    for (const { select, chart } of this.plots) {
      const curve = this.curves.find(({ id }) => id === select.value);
      chart.draw(this.history, curve, this.time());
    }
  }

  private offer(curves: Curve[]): void {
    for (const { select, usual } of this.plots) {
      const first = curves[0]?.id ?? '';
      const before = select.value || usual || first;
      select.replaceChildren(...curves.map(({ id, name }) => make('option', { value: id }, name)));
      select.value = curves.some(({ id }) => id === before) ? before : first;
    }
  }
}
