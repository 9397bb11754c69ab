// Asks the program for news of the run for as long as the page is open.
import { fetchRun, RunIndex } from './server';
import { showNotice, showStatus, textOf } from './status';

const pollSeconds = { running: 1, ended: 4 };

/** `news` gets every answer; `empty` says whether the page has nothing to show yet. */
export async function watch(news: (index: RunIndex) => Promise<void>, empty: () => boolean): Promise<never> {
  let over = false;
  for (;;) {
    const begin = performance.now();
    try {
      const index = await fetchRun();
      over = index.summary !== null && !index.running;
      await news(index);
      document.body.dataset.lost = '';
    } catch (error) {
      document.body.dataset.lost = 'yes';
      showStatus('no answer', 'lost');
      if (empty()) showNotice('The server does not answer', `Is hfrac view still running? (${textOf(error)})`);
    }
    // A long list of snapshots takes time to read; do not keep the server busy with it.
    const took = (performance.now() - begin) / 1000;
    const pause = over ? pollSeconds.ended : pollSeconds.running;
    await new Promise((resolve) => setTimeout(resolve, 1000 * (pause + 4 * took)));
  }
}
