// The laboratory in a notebook: a module for anywidget, with the page in it. The state of the page and the trait `link` of
// the model are the same text.

const PAGE = 'PAGE';

/** What the page sends. */
const messageOf = ({ data }) =>
  typeof data === 'object' && data !== null ? data.littlewood : undefined;

function render({ model, el }) {
  const frame = document.createElement('iframe');
  frame.title = 'Littlewood’s hoop: the laboratory';
  frame.allow = 'clipboard-write';
  frame.style.cssText = 'border: 0; width: 100%; display: block;';
  const resize = () => {
    frame.style.height = `${model.get('height')}px`;
  };
  let shown = null;
  let ready = false;
  const show = () => {
    const link = model.get('link');
    if (!ready || link === shown) return;
    shown = link;
    frame.contentWindow.postMessage({ littlewood: { link } }, '*');
  };
  const hear = (event) => {
    if (event.source !== frame.contentWindow) return;
    const message = messageOf(event);
    if (message?.ready) {
      ready = true;
      shown = null;
      show();
    } else if (typeof message?.link === 'string') {
      shown = message.link;
      model.set('link', message.link);
      model.save_changes();
    }
  };
  window.addEventListener('message', hear);
  model.on('change:link', show);
  model.on('change:height', resize);
  resize();
  frame.srcdoc = PAGE;
  el.append(frame);
  return () => {
    window.removeEventListener('message', hear);
    model.off('change:link', show);
    model.off('change:height', resize);
  };
}

export default { render };
