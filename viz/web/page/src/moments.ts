// The moment on the screen and how it gets there: which files and arrays are fetched, and that of several wishes the
// last one is fulfilled.
import { viewsOf } from './fields';
import { find } from './dom';
import { forgetGrids, grid } from './grids';
import { Moment, Settings } from './paint';
import { Grid, RunIndex, Snapshot } from './server';
import { hideNotice, showNotice, textOf } from './status';

/** Above this many discs only the arrays that are shown are fetched, and pores only if asked for. */
const manyDiscs = 200000;

export class Moments {
  /** What is shown. */
  now: Moment | null = null;
  /** What colour scales follow: the last moment, or the one shown. */
  reference: Moment | null = null;
  private wish = 0;

  constructor(private settings: Settings, private index: () => RunIndex | null, private shown: (moment: Moment) => void) {}

  clear(): void {
    ++this.wish;  // what is still being fetched is of the run that is gone
    find('busy').hidden = true;
    forgetGrids();
    this.now = this.reference = null;
  }

  /** Whether the run has so many discs that not everything is fetched. */
  many(): boolean {
    const state = this.index()?.summary?.state as { disc_count?: number } | undefined;
    return (this.now?.discs.points ?? state?.disc_count ?? 0) > manyDiscs;
  }

  async show(number: number): Promise<void> {
    const snapshots = this.index()?.snapshots ?? [];
    const snapshot = snapshots[number];
    if (!snapshot) return;
    const wish = ++this.wish;
    const busy = setTimeout(() => (find('busy').hidden = wish !== this.wish), 300);
    try {
      const last = snapshots[snapshots.length - 1];
      const reference = this.settings.range === 'last' && last !== snapshot ? this.load(last) : null;
      const moment = await this.load(snapshot);
      const referenceMoment = reference ? await reference : moment;
      if (wish !== this.wish) return;
      this.now = moment;
      this.reference = referenceMoment;
      hideNotice();
      this.shown(moment);
      const next = snapshots[number + 1];
      if (next && moment.discs.points < manyDiscs) void this.load(next).catch(() => undefined);
    } catch (error) {
      if (wish === this.wish) showNotice('This moment cannot be shown', textOf(error));
    } finally {
      clearTimeout(busy);
      if (wish === this.wish) find('busy').hidden = true;
    }
  }

  private async load(snapshot: Snapshot): Promise<Moment> {
    const { files } = snapshot;
    const many = this.many();
    const field = viewsOf('discs').find(({ name }) => name === this.settings.discColour);
    const chosen = many ? ['radius_m', field?.array ?? this.settings.discColour] : [];
    const wanted = (file: string | undefined, on: boolean, arrays: string[] = []): Promise<Grid | null> =>
      file && on ? grid(file, arrays) : Promise.resolve(null);
    const [discs, cracks, flow, bonds, joints] = await Promise.all([
      wanted(files.discs, true, chosen),
      wanted(files.cracks, true),
      wanted(files.flow, this.settings.pores, many ? ['pressure_Pa', 'domain_id'] : []),
      wanted(files.bonds, this.settings.bonds, many ? ['state', 'normal_force_N', 'bond_id'] : []),
      wanted(files.joints, true),
    ]);
    const pressureNote = this.index()?.summary?.stress_convention === 'effective' ? 'above the formation’s' : undefined;
    return { snapshot, discs: discs as Grid, cracks, flow, bonds, joints, pressureNote };
  }
}
