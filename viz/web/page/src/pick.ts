// What lies under the pointer: a joint's contact or a crack if one is near, else a disc, else a pore. All are looked at in turn,
// which takes milliseconds even for a million discs.
import { Moment, Settings } from './paint';
import { Grid, Series } from './server';

export interface Pick {
  series: Series;
  index: number;
}

export function pick(
  moment: Moment, settings: Settings, x: number, y: number, reach: number,
): Pick | null {
  const { cracks, discs, flow, bonds, joints } = moment;
  if (settings.joints && joints) {
    const index = nearestLine(joints, x, y, reach);
    if (index >= 0) return { series: 'joints', index };
  }
  if (settings.cracks && cracks) {
    const index = nearestLine(cracks, x, y, reach);
    if (index >= 0) return { series: 'cracks', index };
  }
  if (settings.bonds && bonds) {
    const state = bonds.values('state');
    const index = nearestLine(bonds, x, y, reach / 2, (i) => state[i] === 0);
    if (index >= 0) return { series: 'bonds', index };
  }
  if (settings.discs) {
    const [position, radius] = [discs.positions, discs.values('radius_m')];
    for (let i = 0; i < discs.points; ++i) {
      const [dx, dy] = [position[2 * i] - x, position[2 * i + 1] - y];
      if (dx * dx + dy * dy <= radius[i] * radius[i]) return { series: 'discs', index: i };
    }
  }
  if (flow) {
    const index = poreAround(flow, x, y);
    if (index >= 0) return { series: 'flow', index };
  }
  return null;
}

function nearestLine(grid: Grid, x: number, y: number, reach: number, counts = (_: number) => true): number {
  const [position, first, corner] = [grid.positions, grid.values('#first'), grid.values('#corner')];
  let nearest = -1;
  let least = reach * reach;
  for (let i = 0; i < grid.cells; ++i) {
    const [a, b] = [2 * corner[first[i]], 2 * corner[first[i] + 1]];
    const [dx, dy] = [position[b] - position[a], position[b + 1] - position[a + 1]];
    const along = ((x - position[a]) * dx + (y - position[a + 1]) * dy) / (dx * dx + dy * dy || 1);
    const share = Math.min(1, Math.max(0, along));
    const distance = (position[a] + share * dx - x) ** 2 + (position[a + 1] + share * dy - y) ** 2;
    if (distance <= least && counts(i)) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

function poreAround(grid: Grid, x: number, y: number): number {
  const [position, first, corner] = [grid.positions, grid.values('#first'), grid.values('#corner')];
  for (let i = 0; i < grid.cells; ++i) {
    let inside = false;
    for (let j = first[i], before = first[i + 1] - 1; j < first[i + 1]; before = j++) {
      const [ax, ay] = [position[2 * corner[j]], position[2 * corner[j] + 1]];
      const [bx, by] = [position[2 * corner[before]], position[2 * corner[before] + 1]];
      if (ay > y !== by > y && x < ((bx - ax) * (y - ay)) / (by - ay) + ax) inside = !inside;
    }
    if (inside) return i;
  }
  return -1;
}

/** The corners x y x y ... of a cell. */
export function cornersOf(grid: Grid, cell: number): number[] {
  const [position, first, corner] = [grid.positions, grid.values('#first'), grid.values('#corner')];
  const corners: number[] = [];
  for (let j = first[cell]; j < first[cell + 1]; ++j)
    corners.push(position[2 * corner[j]], position[2 * corner[j] + 1]);
  return corners;
}
