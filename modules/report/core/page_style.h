// Style and script of the report page.
#pragma once

#include <string_view>

namespace bole::report {

inline constexpr std::string_view page_style = R"css(
:root { --ink: #1d2327; --soft: #5f6b73; --line: #d8dee2; --wash: #f4f6f7; --blue: #1f5f8b; }
* { box-sizing: border-box; }
body { margin: 0; background: #fff; color: var(--ink); font: 15px/1.5 "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2.2rem 1.5rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; letter-spacing: -.01em; }
h2 { font-size: 1.25rem; margin: 2.4rem 0 .7rem; padding-bottom: .25rem; border-bottom: 2px solid var(--ink); }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
.facts { color: var(--soft); margin: 0 0 1.1rem; }
.facts span { margin-right: 1.4em; white-space: nowrap; }
.facts b { color: var(--ink); font-weight: 600; }
.note { color: var(--soft); }
.cards { display: flex; flex-wrap: wrap; gap: .7rem; }
.card { flex: 1 1 8rem; background: var(--wash); border-left: 3px solid var(--blue); padding: .55rem .8rem; color: var(--soft); line-height: 1.3; }
.card b { font-size: 1.5rem; color: var(--ink); font-variant-numeric: tabular-nums; }
.card span { color: var(--ink); }
table { border-collapse: collapse; width: 100%; font-size: .9rem; }
th { text-align: left; font-weight: 600; border-bottom: 1px solid var(--ink); padding: .25rem .5rem; vertical-align: bottom; background: #fff; }
td { border-bottom: 1px solid var(--line); padding: .2rem .5rem; vertical-align: top; }
th.n, td.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
#plot td:nth-child(3) { white-space: nowrap; }
#signature { break-inside: avoid; } #signature td { height: 3rem; } #signature th { width: 33%; }
#evaluation table { margin-bottom: 1rem; table-layout: fixed; } #evaluation > table th:first-child { width: 46%; }
.sortable th { cursor: pointer; position: sticky; top: 0; }
.sortable th:hover { color: var(--blue); }
.sortable th.up::after { content: " \25B4"; } .sortable th.down::after { content: " \25BE"; }
.figures { display: flex; flex-wrap: wrap; gap: 1.6rem 2%; }
figure { margin: 0; flex: 0 0 100%; }
figure.half { flex-basis: 49%; }
figure img { display: block; max-width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: .87rem; margin-top: .4rem; }
figcaption b { color: var(--ink); }
details { margin: .3rem 0; } summary { cursor: pointer; }
details table { margin: .3rem 0 .8rem; }
code { background: var(--wash); padding: .1em .35em; font: .85em/1.6 "DejaVu Sans Mono", Consolas, monospace; }
ul { padding-left: 1.2rem; }
@media (max-width: 40rem) { figure.half { flex-basis: 100%; } table { display: block; overflow-x: auto; } }
@media print {
  @page { size: A4; margin: 15mm; }
  body { font-size: 9.5pt; } main { max-width: none; padding: 0; }
  .screen { display: none; }
  h2 { break-after: avoid; } h3 { break-after: avoid; }
  .figures { display: block; } figure { margin-bottom: 7mm; } figure.half { display: inline-block; width: 48%; margin-right: 1.5%; vertical-align: top; }
  tr, figure, .card { break-inside: avoid; } thead { display: table-header-group; }
  .sortable th { position: static; }
  .card { background: none; border: 1px solid var(--line); border-left: 3px solid var(--blue); }
  figure img { max-height: 235mm; }
}
)css";

// Sorts a table by the column whose heading was clicked, numbers as numbers; opens all details for printing.
inline constexpr std::string_view page_script = R"js(
for (const table of document.querySelectorAll('table.sortable')) {
  const body = table.tBodies[0];
  [...table.tHead.rows[0].cells].forEach((head, column) => head.addEventListener('click', () => {
    const down = head.classList.contains('up');
    for (const other of table.tHead.rows[0].cells) other.classList.remove('up', 'down');
    head.classList.add(down ? 'down' : 'up');
    const key = row => row.cells[column].textContent.replace('\u2212', '-').replace('\u2265', '');
    const compare = (a, b) => {
      const x = parseFloat(key(a)), y = parseFloat(key(b));
      if (isNaN(x) || isNaN(y)) return isNaN(x) === isNaN(y) ? key(a).localeCompare(key(b)) : isNaN(x) ? 1 : -1;
      return x - y;
    };
    const rows = [...body.rows].sort(compare);
    if (down) rows.reverse();
    body.append(...rows);
  }));
}
addEventListener('beforeprint', () => { for (const d of document.querySelectorAll('details')) d.open = true; });
)js";

}  // namespace bole::report
