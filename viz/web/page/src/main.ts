// hfrac in the browser. The page is served by `hfrac view DIR` and asks nobody else.
import './style.css';
import { App } from './app';
import { find, make } from './dom';

try {
  new App();
} catch (error) {
  const notice = find('notice');
  notice.replaceChildren(
    make('strong', {}, 'The page cannot start'),
    make('span', {}, error instanceof Error ? error.message : String(error)),
  );
  notice.hidden = false;
}
