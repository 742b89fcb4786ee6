// What is shown instead of a blank page when something has gone wrong that no field can mend.

import { make } from '../dom';

let shown = false;

/** Shows the message, with a button that loads the page anew. */
export function showDefect(message: string): void {
  if (shown) return;
  shown = true;
  const again = make('button', { type: 'button', id: 'reload' }, 'Reload');
  again.addEventListener('click', () => location.reload());
  const anew = make('button', { type: 'button' }, 'Start with figure 3');
  anew.addEventListener('click', () => {
    history.replaceState(null, '', location.pathname + location.search);
    location.reload();
  });
  const box = make(
    'div',
    {
      class: 'defect',
      role: 'alertdialog',
      'aria-labelledby': 'defect-title',
      'aria-modal': 'true',
    },
    make('h2', { id: 'defect-title' }, 'Internal error'),
    make(
      'p',
      {},
      'This is an error of the laboratory, not of your input. The address still has the motion.',
    ),
    make('pre', {}, message),
    make('p', {}, again, ' ', anew),
  );
  document.body.append(box);
  again.focus();
}

/** Shows every error that is caught nowhere else. */
export function watch(): void {
  window.addEventListener('error', (event) => {
    // A browser says this when sizes settle in the next frame. It is no error.
    if (!event.message.startsWith('ResizeObserver loop'))
      showDefect(String(event.error ?? event.message));
  });
  window.addEventListener('unhandledrejection', (event) => showDefect(String(event.reason)));
}
