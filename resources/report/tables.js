// Sorts a table by the column whose heading was clicked, numbers as numbers; opens details for printing, but for long lists.
(() => {
  'use strict';
  for (const table of document.querySelectorAll('table.sortable')) {
    const body = table.tBodies[0];
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      head.tabIndex = 0;
      const sort = () => {
        const down = head.classList.contains('up');
        for (const other of table.tHead.rows[0].cells) {
          other.classList.remove('up', 'down');
          other.removeAttribute('aria-sort');
        }
        head.classList.add(down ? 'down' : 'up');
        head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        const key = row => row.cells[column].textContent.replace('\u2212', '-').replace('\u2265', '').trim();
        const compare = (a, b) => {
          const x = parseFloat(key(a)), y = parseFloat(key(b));
          if (isNaN(x) || isNaN(y)) return isNaN(x) === isNaN(y) ? key(a).localeCompare(key(b)) : isNaN(x) ? 1 : -1;
          return x - y;
        };
        const rows = [...body.rows].sort(compare);
        if (down) rows.reverse();
        body.append(...rows);
      };
      head.addEventListener('click', sort);
      head.addEventListener('keydown', event => { if (event.key === 'Enter') sort(); });
    });
  }
  addEventListener('beforeprint', () => { for (const d of document.querySelectorAll('details')) if (d.querySelectorAll('tr').length <= 40) d.open = true; });
})();
