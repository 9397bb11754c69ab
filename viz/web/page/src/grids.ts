// The grids fetched last, kept in memory up to a limit, so that playing back and forth asks once. What is
// under way is shared: two wishes for one file are one request.
import { fetchGrid, Grid } from './server';

const limit = 400e6; // bytes

const kept = new Map<string, Grid>(); // the one used last at the end
const underWay = new Map<string, Promise<Grid>>();
let held = 0;

/** `arrays` empty: all of them. */
export async function grid(file: string, arrays: readonly string[] = []): Promise<Grid> {
  const key = `${file}?${[...arrays].sort().join(',')}`;
  const found = kept.get(key);
  if (found) {
    kept.delete(key);
    kept.set(key, found);
    return found;
  }
  let request = underWay.get(key);
  if (!request) {
    request = fetchGrid(file, arrays)
      .then((fetched) => {
        kept.set(key, fetched);
        held += fetched.message.byteLength;
        for (const [oldest, old] of kept) {
          if (held <= limit || kept.size <= 4) break;
          kept.delete(oldest);
          held -= old.message.byteLength;
        }
        return fetched;
      })
      .finally(() => underWay.delete(key));
    underWay.set(key, request);
  }
  return request;
}

/** Another run is in the folder: its files may have the same names. */
export function forgetGrids(): void {
  kept.clear();
  held = 0;
}
