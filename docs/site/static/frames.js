// The frames of the laboratory follow the light or the dark of the page around them.
(() => {
  'use strict';
  const frames = [...document.querySelectorAll('iframe[data-link]')];
  if (frames.length === 0) return;
  let shown = 'auto';
  const follow = () => {
    const theme = document.body.dataset.theme ?? 'auto';
    if (theme === shown) return;
    shown = theme;
    for (const frame of frames) {
      const page = frame.src.split('#')[0];
      frame.src = `${page}#${frame.dataset.link}&theme=${theme}`;
    }
  };
  follow();
  new MutationObserver(follow).observe(document.body, { attributes: true, attributeFilter: ['data-theme'] });
})();
