// What counts as a drag: a pointer that is held down, and the keys on what can be dragged until it
// is left.

import type { Lab } from '../state/lab';

const DRAGGED = '.handle, input[type=range]';

export function watchDrags(lab: Lab): void {
  /** What a finger on a slider has found; a slider takes the place of the finger at once, even where that goes on to scroll the page. */
  let found: Lab['state'] | null = null;
  document.addEventListener(
    'pointerdown',
    ({ target, pointerType }) => {
      found =
        pointerType === 'touch' && target instanceof Element && target.matches('input[type=range]')
          ? lab.state
          : null;
      lab.hold();
    },
    true,
  );
  document.addEventListener('pointercancel', () => {
    if (found !== null && found.problem !== lab.state.problem) lab.take(found.problem, found.view);
    else if (found !== null && found.view.time !== lab.state.view.time)
      lab.setTime(found.view.time ?? lab.motion.begin);
    found = null;
  });
  for (const kind of ['pointerup', 'pointercancel', 'focusout'] as const)
    document.addEventListener(kind, () => lab.release());
  document.addEventListener(
    'keydown',
    ({ target, key }) => {
      if (key !== 'Tab' && target instanceof Element && target.matches(DRAGGED)) lab.hold();
    },
    true,
  );
}
