// SPDX-FileCopyrightText: the Scree authors
// SPDX-License-Identifier: MIT
//
// What every report page does beside being read: sorts tables, filters their rows, copies commands. Without it all of
// the page is still there.

'use strict';

const page = {
  /** The cell's key in a column: numbers by value (none sorts last in both directions), words as people order them. */
  key(row, column, numeric) {
    const cell = row.cells[column];
    if (!numeric) return cell.textContent.trim();
    return 'v' in cell.dataset ? Number(cell.dataset.v) : null;
  },

  sort(table, column) {
    const head = table.tHead.rows[table.tHead.rows.length - 1].cells[column];
    const numeric = head.classList.contains('number');
    // Numbers are first looked at from the largest, words from A; the third click brings back the first order.
    const order = numeric ? ['descending', 'ascending', 'none'] : ['ascending', 'descending', 'none'];
    const next = order[(order.indexOf(head.getAttribute('aria-sort')) + 1) % 3];
    for (const other of head.parentNode.cells) other.setAttribute('aria-sort', 'none');
    head.setAttribute('aria-sort', next);

    const body = table.tBodies[0];
    const rows = [...body.rows];
    rows.forEach((row, index) => { if (!('place' in row.dataset)) row.dataset.place = index; });
    const place = (a, b) => a.dataset.place - b.dataset.place;
    const direction = next === 'descending' ? -1 : 1;
    const collator = new Intl.Collator('en', {numeric: true});
    rows.sort((a, b) => {
      if (next === 'none') return place(a, b);
      const x = page.key(a, column, numeric), y = page.key(b, column, numeric);
      if (x === null || y === null) return (x === null) - (y === null) || place(a, b);
      return direction * (numeric ? x - y : collator.compare(x, y)) || place(a, b);
    });
    body.append(...rows);
  },

  /** True when the text holds every word of the query, in any order and case. */
  matches(text, query) {
    const lower = text.toLowerCase();
    return query.toLowerCase().split(/\s+/).every((word) => lower.includes(word));
  },

  filter(input) {
    const table = document.getElementById(input.getAttribute('aria-controls'));
    let shown = 0;
    for (const row of table.tBodies[0].rows) {
      row.hidden = !page.matches(row.textContent, input.value.trim());
      if (!row.hidden) ++shown;
    }
    input.parentNode.querySelector('output').value = `${shown} of ${table.tBodies[0].rows.length}`;
  },

  /** Pages opened as files may not use the clipboard's own interface in every browser: a selection always works. */
  async copy(button) {
    const text = button.parentNode.querySelector('pre');
    try {
      await navigator.clipboard.writeText(text.textContent);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(text);
      button.textContent = document.execCommand('copy') ? 'Copied' : 'Selected';
    }
    setTimeout(() => { button.textContent = 'Copy'; }, 1500);
  },
};

document.addEventListener('click', (event) => {
  const sorter = event.target.closest('thead th button');
  if (sorter) page.sort(sorter.closest('table'), sorter.parentNode.cellIndex);
  const copier = event.target.closest('.code button');
  if (copier) page.copy(copier);
});
document.addEventListener('input', (event) => {
  if (event.target.matches('.filter input')) page.filter(event.target);
});
