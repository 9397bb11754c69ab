// Keys of the page. Letters work in either case; a button that has the focus is pressed by space as anywhere else.
import { find } from './dom';

/** By the key's name, single letters in lower case; `by` is larger with shift. */
export type Actions = Record<string, (by: number) => void>;

export function listenToKeys(actions: Actions): void {
  window.addEventListener('keydown', (event) => {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.tagName === 'SELECT') return;
    if (find<HTMLDialogElement>('keys').open) return;
    const action = actions[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action || (event.key === ' ' && (target.tagName === 'BUTTON' || target.tagName === 'INPUT'))) return;
    event.preventDefault();
    action(event.shiftKey ? 10 : 1);
  });
}
