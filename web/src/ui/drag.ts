// What counts as a drag: a pointer that is held down, and the keys on what can be dragged until it is left.

import type { Lab } from '../state/lab';

const DRAGGED = '.handle, input[type=range]';

export function watchDrags(lab: Lab): void {
  document.addEventListener('pointerdown', () => lab.hold(), true);
  for (const kind of ['pointerup', 'pointercancel', 'focusout'] as const) document.addEventListener(kind, () => lab.release());
  document.addEventListener(
    'keydown',
    ({ target, key }) => {
      if (key !== 'Tab' && target instanceof Element && target.matches(DRAGGED)) lab.hold();
    },
    true,
  );
}
