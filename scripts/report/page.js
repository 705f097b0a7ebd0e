'use strict';
// Filters the table of claims, by its controls and by links to it.
(() => {
  document.documentElement.classList.add('scripted');
  const controls = document.getElementById('claims-controls');
  const verdicts = [...controls.querySelectorAll('[name=verdict]')];
  const scope = controls.querySelector('[name=scope]');
  const search = controls.querySelector('[name=search]');
  const claims = Array.from(document.querySelectorAll('#claims-table tbody'), ({ rows: [heading, ...rows] }) => ({
    heading, rows: rows.map((row) => ({ row, text: `${heading.textContent} ${row.textContent}`.toLowerCase() })) }));
  const count = claims.reduce((sum, { rows }) => sum + rows.length, 0);
  const filter = () => {
    const wanted = new Set(verdicts.filter((box) => box.checked).map((box) => box.value));
    const part = search.value.trim().toLowerCase();
    let shown = 0;
    for (const { heading, rows } of claims) {
      const before = shown;
      for (const { row, text } of rows) {
        const inside = scope.value === '' || scope.value === row.dataset.scope;
        row.hidden = !(wanted.has(row.dataset.verdict) && inside && text.includes(part));
        shown += !row.hidden;
      }
      heading.hidden = shown === before;
    }
    controls.querySelector('output').textContent = `${shown} of ${count} rows`;
  };
  controls.addEventListener('input', filter);
  document.addEventListener('click', (event) => {
    const { verdict = '', scope: belongs = '', search: part = '' } = event.target.closest('main a[href="#claims"]')?.dataset ?? {};
    if (!event.target.closest('main a[href="#claims"]')) return;
    for (const box of verdicts) box.checked = verdict === '' || box.value === verdict;
    scope.value = belongs;
    search.value = part;
    filter();
  });
  filter();
})();
