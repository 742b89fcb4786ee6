// Tables of the page of engines are sorted by a click, or a key, on the head of a column; a second one turns the order round.
(() => {
  'use strict';
  if (!document.getElementById('engines')) return;
  // A number before words; within words, the alphabet. "cannot" and a dash come last.
  const key = (text) => {
    const found = text.match(/-?\d+(\.\d+)?(e[-+]?\d+)?/i);
    return found && /^[(-]?[\d.]/.test(text) ? [0, Math.abs(Number(found[0])), ''] : [/^(–|cannot)$/.test(text) ? 2 : 1, 0, text];
  };
  const order = (a, b) => a[0] - b[0] || a[1] - b[1] || a[2].localeCompare(b[2]);
  for (const table of document.querySelectorAll('table')) {
    const heads = [...table.querySelectorAll('thead th')];
    const body = table.tBodies[0];
    if (!heads.length || heads[0].textContent.trim() !== 'engine') continue;
    heads.forEach((head, column) => {
      const button = document.createElement('button');
      button.className = 'sort';
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener('click', () => {
        const turn = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
        for (const other of heads) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', turn > 0 ? 'ascending' : 'descending');
        const rows = [...body.rows].map((row) => [key(row.cells[column].textContent.trim()), row]);
        rows.sort(([a], [b]) => a[0] - b[0] || turn * order(a, b));
        body.append(...rows.map(([, row]) => row));
      });
    });
  }
})();
