'use strict';
// Sorts every table by its headings, fills the long ones when they are opened, and filters the ledger.
(() => {
  const root = document.documentElement;
  root.classList.add('scripted');

  // The number that a cell stands for: decimal, fraction or the middle of a ball; NaN where it is none.
  const number = (text) => {
    const fraction = /^(-?\d+)\/(\d+)$/.exec(text);
    if (fraction) return fraction[1] / fraction[2];
    const ball = /^\[(\S+) \+\/- \S+\]$/.exec(text);
    const digits = ball ? ball[1] : text;
    if (/^-?inf$/.test(digits)) return digits === 'inf' ? Infinity : -Infinity;
    return digits.trim() === '' ? NaN : Number(digits);
  };
  const missing = (text) => text === '' || text === '-' || text === 'nan' || text === 'none';
  const content = (cell) => {
    const marked = cell.querySelector('data');
    return marked ? marked.value : cell.textContent.trim();
  };
  // Texts in the order of their letters, and the numbers in them by size: (9) before (10).
  const pieces = (text) => text.toLowerCase().split(/(\d+)/).map((piece, i) => (i % 2 ? Number(piece) : piece));
  const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
  const comparePieces = (a, b) => {
    const unlike = a.findIndex((piece, i) => i >= b.length || piece !== b[i]);
    return unlike < 0 ? a.length - b.length : unlike >= b.length ? 1 : compare(a[unlike], b[unlike]);
  };

  // Missing cells stay last in both directions, and equal ones in their order.
  const sort = (table, column, sign) => {
    const numeric = table.tHead.rows[0].cells[column].classList.contains('n');
    const body = table.tBodies[0];
    const keyed = Array.from(body.rows, (row) => {
      const text = content(row.cells[column]);
      const key = numeric ? number(text) : pieces(text);
      return { row, key, last: missing(text) || (numeric && Number.isNaN(key)) };
    });
    const order = numeric ? compare : comparePieces;
    keyed.sort((a, b) => (a.last || b.last ? a.last - b.last : sign * order(a.key, b.key)));
    body.remove(); // rows move many times faster outside of the document
    body.append(...keyed.map(({ row }) => row));
    table.append(body);
  };
  const press = (button) => {
    const heading = button.parentElement;
    const sorted = heading.getAttribute('aria-sort') === 'ascending' ? 'descending' : 'ascending';
    for (const other of heading.parentElement.cells) other.removeAttribute('aria-sort');
    heading.setAttribute('aria-sort', sorted);
    sort(heading.closest('table'), heading.cellIndex, sorted === 'ascending' ? 1 : -1);
  };
  document.addEventListener('click', (event) => {
    const button = event.target.closest('th button');
    if (button) press(button);
  });

  // A long table has its first rows in the page and all of them in the link that downloads it.
  const fill = (details) => {
    const address = details.querySelector('a.download').href;
    const lines = decodeURIComponent(address.slice(address.indexOf(',') + 1)).split('\n');
    const table = details.querySelector('table');
    const numeric = Array.from(table.tHead.rows[0].cells, (cell) => cell.classList.contains('n'));
    const body = document.createElement('tbody');
    for (const line of lines.filter((text) => text !== '' && !text.startsWith('#')).slice(1)) {
      const row = body.insertRow();
      line.split('\t').forEach((text, column) => {
        const cell = row.insertCell();
        cell.textContent = text;
        if (numeric[column]) cell.className = 'n';
      });
    }
    table.tBodies[0].replaceWith(body);
  };
  for (const details of document.querySelectorAll('details.table')) {
    details.addEventListener('toggle', () => fill(details), { once: true });
  }

  const controls = document.getElementById('ledger-controls');
  const verdicts = Array.from(controls.querySelectorAll('[name=verdict]'));
  const scope = controls.querySelector('[name=scope]');
  const search = controls.querySelector('[name=search]');
  const rows = Array.from(document.querySelectorAll('#ledger-table tbody tr'));
  const texts = new Map(rows.map((row) => [row, row.textContent.toLowerCase()]));
  const filter = () => {
    const wanted = new Set(verdicts.filter((box) => box.checked).map((box) => box.value));
    const part = search.value.trim().toLowerCase();
    let shown = 0;
    for (const row of rows) {
      const { verdict, scope: belongs } = row.dataset;
      const inside = scope.value === '' || scope.value === belongs;
      row.hidden = !(wanted.has(verdict) && inside && texts.get(row).includes(part));
      shown += !row.hidden;
    }
    controls.querySelector('output').textContent = `${shown} of ${rows.length} rows`;
  };
  controls.addEventListener('input', filter);
  document.addEventListener('click', (event) => {
    const link = event.target.closest('a[href="#ledger"]');
    if (!link || link.closest('nav')) return;
    const { verdict = '', scope: belongs = '', search: part = '' } = link.dataset;
    for (const box of verdicts) box.checked = verdict === '' || box.value === verdict;
    scope.value = belongs;
    search.value = part;
    filter();
  });
  filter();
})();
