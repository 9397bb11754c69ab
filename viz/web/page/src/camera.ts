// Where to look: the whole model, the cracks, the well, the farthest tip, one fracture.
import { Moment } from './paint';
import { cornersOf } from './pick';
import { Grid, RunIndex } from './server';
import { View } from './view';

/** What there is to look at. */
export interface Sight {
  index: RunIndex | null;
  moment: Moment | null;
  /** Of the discs [m]. */
  meanRadius: number;
}

export class Camera {
  private framed = false;

  constructor(private view: View, private sight: () => Sight, private moved: () => void) {}

  /** Another run: its model is not known yet. */
  clear(): void {
    this.framed = false;
  }

  /** The first time the model is known: all of it. */
  frame(): void {
    if (this.framed) return;
    const { index, moment } = this.sight();
    const model = index?.summary?.model;
    this.view.setHome(model ? [0, 0, model.width_m, model.height_m] : boundsOf(moment?.discs ?? null));
    this.view.fit();
    this.framed = true;
  }

  atAll(): void {
    this.view.fit();
    this.moved();
  }

  atCracks(cells?: readonly number[]): void {
    const { moment, meanRadius } = this.sight();
    const cracks = moment?.cracks;
    if (!cracks?.cells) return this.atWell();
    const all = cells ?? Array.from({ length: cracks.cells }, (_, i) => i);
    this.look(grown(boundsOf(cracks, all), 3 * meanRadius));
  }

  atFracture(fracture: number): void {
    const cracks = this.sight().moment?.cracks;
    if (!cracks) return;
    const numbers = cracks.values('fracture');
    const cells: number[] = [];
    for (let i = 0; i < cracks.cells; ++i) if (numbers[i] === fracture) cells.push(i);
    if (cells.length) this.atCracks(cells);
  }

  atWell(): void {
    const { index, meanRadius } = this.sight();
    const well = index?.summary?.wells?.[0];
    if (well) this.around(well.x_m, well.y_m, Math.max(3 * well.radius_m, 12 * meanRadius));
  }

  atTip(): void {
    const { index, moment, meanRadius } = this.sight();
    const cracks = moment?.cracks;
    const well = index?.summary?.wells?.[0];
    if (!cracks?.cells || !well) return this.atCracks();
    let [far, x, y] = [-1, 0, 0];
    for (let cell = 0; cell < cracks.cells; ++cell)
      for (let corners = cornersOf(cracks, cell), j = 0; j < corners.length; j += 2) {
        const distance = Math.hypot(corners[j] - well.x_m, corners[j + 1] - well.y_m);
        if (distance > far) [far, x, y] = [distance, corners[j], corners[j + 1]];
      }
    this.around(x, y, 14 * meanRadius);
  }

  private around(x: number, y: number, reach: number): void {
    this.look([x - reach, y - reach, x + reach, y + reach], 0);
  }

  private look(bounds: readonly number[], margin = 0.08): void {
    if (!bounds.every(Number.isFinite)) return;
    this.view.fit(bounds, margin);
    this.moved();
  }
}

/** Left, bottom, right, top of the points of a grid, or of some of its cells. */
function boundsOf(grid: Grid | null, cells?: readonly number[]): number[] {
  const bounds = [Infinity, Infinity, -Infinity, -Infinity];
  const add = (x: number, y: number) => {
    bounds[0] = Math.min(bounds[0], x);
    bounds[1] = Math.min(bounds[1], y);
    bounds[2] = Math.max(bounds[2], x);
    bounds[3] = Math.max(bounds[3], y);
  };
  if (grid && cells) for (const cell of cells) for (let c = cornersOf(grid, cell), j = 0; j < c.length; j += 2) add(c[j], c[j + 1]);
  else if (grid) for (let i = 0; i < grid.points; ++i) add(grid.positions[2 * i], grid.positions[2 * i + 1]);
  return bounds;
}

function grown(bounds: readonly number[], by: number): number[] {
  return [bounds[0] - by, bounds[1] - by, bounds[2] + by, bounds[3] + by];
}
