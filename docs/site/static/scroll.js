// Tables, listings and formulas that are wider than the screen can be reached, and scrolled, by keyboard.
(() => {
  'use strict';
  const wide = [...document.querySelectorAll('.table-wrapper, .highlight > pre, .formula > .katex-display')];
  const check = () => {
    for (const it of wide) {
      if (it.scrollWidth > it.clientWidth) it.tabIndex = 0;
      else it.removeAttribute('tabindex');
    }
  };
  check();
  window.addEventListener('resize', check);
  // Letters come after the page, and may be wider.
  document.fonts.ready.then(check);
})();
