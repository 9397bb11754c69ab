// What has been clicked: kept by its number, so that it is found again at every moment, with its values in the panel
// and its outline in the picture.
import { Standing } from './annotations';
import { Moment } from './paint';
import { showSelection } from './panels';
import { cornersOf, Pick } from './pick';
import { fetchValues, Grid, Series } from './server';
import { textOf } from './status';

const idOf: Record<Series, string> = { discs: 'disc_id', bonds: 'bond_id', cracks: 'crack_id', flow: 'domain_id', joints: 'contact_id' };
const oneOf: Record<Series, string> = { discs: 'Disc', bonds: 'Bond', cracks: 'Crack', flow: 'Pore', joints: 'Contact of a joint' };

export class Selection {
  private selected: { series: Series; id: number } | null = null;

  constructor(private moment: () => Moment | null) {
    showSelection('', null);
  }

  clear(): void {
    this.select(null);
  }

  select(found: Pick | null): void {
    const ids = found && this.gridOf(found.series)?.values(idOf[found.series]);
    this.selected = found && { series: found.series, id: ids?.length ? ids[found.index] : found.index };
    void this.refresh();
  }

  /** The values at this moment into the panel. */
  async refresh(): Promise<void> {
    const { selected } = this;
    const moment = this.moment();
    if (!selected || !moment) return showSelection('', null);
    const title = `${oneOf[selected.series]} ${selected.id}`;
    const file = moment.snapshot.files[selected.series];
    const place = this.place();
    if (place < 0 || !file) {
      const why = selected.series === 'cracks' ? 'Not broken yet at this moment.' : 'Its layer is off, or it is not in this moment.';
      return showSelection(title, [], why);
    }
    try {
      const values = await fetchValues(file, selected.series === 'discs' ? 'points' : 'cells', place);
      if (this.selected === selected && this.moment() === moment)
        showSelection(title, values.filter(({ name }) => name !== idOf[selected.series]));
    } catch (error) {
      if (this.selected === selected) showSelection(title, [], textOf(error));
    }
  }

  outline(): Standing['selected'] {
    const place = this.place();
    const one = this.selected && this.gridOf(this.selected.series);
    if (place < 0 || !one || !this.selected) return null;
    if (this.selected.series === 'discs') {
      const at = one.positions;
      return { circle: [at[2 * place], at[2 * place + 1], one.values('radius_m')[place]] };
    }
    const corners = cornersOf(one, place);
    return this.selected.series === 'flow' ? { polygon: corners } : { line: corners };
  }

  private gridOf(series: Series): Grid | null {
    return this.moment()?.[series] ?? null;
  }

  /** Of the selected item in the grid of this moment; -1: it is not there (yet). */
  private place(): number {
    if (!this.selected) return -1;
    const one = this.gridOf(this.selected.series);
    const ids = one?.values(idOf[this.selected.series]);
    if (!one || !ids) return -1;
    if (ids.length) return ids.indexOf(this.selected.id as never);
    return this.selected.id < Math.max(one.points, one.cells) ? this.selected.id : -1;
  }
}
