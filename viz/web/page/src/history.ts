// history.csv as columns of numbers, read on where the last reading ended.
import { fetchHistory, fetchRecord } from './server';

export interface Line {
  times: readonly number[];
  values: readonly number[];
}

/** In place of a column's name: pressures of a field's record, which has times of its own. */
export const measured = 'measured';

export class History {
  private columns = new Map<string, number[]>();
  private header: string[] = [];
  private bytes = 0;
  private record: Line | null = null;
  rows = 0;

  column(name: string): readonly number[] {
    return this.columns.get(name) ?? [];
  }

  /** A column, or what was measured, over its times. */
  line(name: string): Line {
    if (name === measured) return this.record ?? { times: [], values: [] };
    return { times: this.column('time_s'), values: this.column(name) };
  }

  names(): readonly string[] {
    return this.header;
  }

  /** Reads what was added; true if there was something. */
  async update(): Promise<boolean> {
    const text = await fetchHistory(this.bytes);
    if (text === null) {
      this.clear();
      return true;
    }
    if (!text) return false;
    if (!this.record) {
      const rows = (await fetchRecord()).split('\n').slice(1).filter(Boolean).map((row) => row.split(',').map(Number));
      this.record = { times: rows.map(([time]) => time), values: rows.map(([, pressure]) => pressure) };
    }
    this.bytes += new TextEncoder().encode(text).length;
    const lines = text.split('\n');
    if (!this.header.length) {
      this.header = (lines.shift() ?? '').split(',');
      for (const name of this.header) this.columns.set(name, []);
    }
    const columns = this.header.map((name) => this.columns.get(name) as number[]);
    for (const line of lines) {
      if (!line) continue;
      const cells = line.split(',');
      columns.forEach((column, i) => column.push(cells[i] ? Number(cells[i]) : NaN));
      ++this.rows;
    }
    return true;
  }

  clear(): void {
    this.columns.clear();
    this.header = [];
    this.bytes = 0;
    this.rows = 0;
    this.record = null;
  }

  /** The row of the last step that had ended by `time`; -1 if there is none. */
  rowAt(time: number, times = this.column('time_s')): number {
    let low = 0;
    let high = times.length;
    const reach = time * (1 + 1e-9) + 1e-300;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (times[middle] <= reach) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
}
