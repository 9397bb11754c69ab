// history.csv as columns of numbers, read on where the last reading ended.
import { fetchHistory } from './server';

export class History {
  private columns = new Map<string, number[]>();
  private header: string[] = [];
  private bytes = 0;
  rows = 0;

  column(name: string): readonly number[] {
    return this.columns.get(name) ?? [];
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
  }

  /** The row of the last step that had ended by `time`; -1 if there is none. */
  rowAt(time: number): number {
    const times = this.column('time_s');
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
