// What the page says of itself: the state of the run in a chip at the top, a notice over the picture when there is
// nothing to see, and a sign that it is busy.
import { find, make } from './dom';
import { RunIndex } from './server';

/** Silence after which a run that never ended is said to be silent [s]. */
const silence = 120;

type Kind = 'waiting' | 'running' | 'done' | 'failed' | 'lost';

export function showStatus(words: string, kind: Kind, title = ''): void {
  const chip = find('status');
  chip.textContent = words.length > 40 ? `${words.slice(0, 38)}…` : words;
  chip.dataset.kind = kind;
  chip.title = title || words;
}

/** What has become of the run, as far as its files tell. */
export function showStateOf({ there, summary, running, age_s }: RunIndex): void {
  if (!there) return showStatus('folder is gone', 'lost');
  if (!summary) return showStatus('waiting', 'waiting');
  if (!running) {
    const failed = summary.ended?.startsWith('failed') || summary.ended === 'interrupted';
    return showStatus(failed ? String(summary.ended) : 'finished', failed ? 'failed' : 'done', summary.ended);
  }
  if (age_s > silence)
    return showStatus(`silent for ${Math.round(age_s / 60)} min`, 'failed', 'The run has not ended, but writes nothing. Was it killed?');
  showStatus('running', 'running');
}

export function showNotice(head: string, body: string): void {
  const notice = find('notice');
  notice.replaceChildren(make('strong', {}, head), make('span', {}, body));
  notice.hidden = false;
}

export function hideNotice(): void {
  find('notice').hidden = true;
}

export function textOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
