// SPDX-License-Identifier: BSD-3-Clause
#include "apps/compare/report/html.h"

namespace latchwork::compare {

/// The colours of the agents can be told apart by people who see red and green alike, and stand out
/// from the paper by 3 to 1 or more; each has a mark of its own besides.
std::string_view PageStyle() {
  return R"css(:root {
  color-scheme: light dark;
  --paper: #fff; --ink: #1b1e25; --soft: #5a6170; --rule: #d5d9e0; --panel: #f5f6f8;
  --wall: #9aa1ae; --bad: #b3261e;
  --a0: #0063a8; --a1: #c34a00; --a2: #007a5c; --a3: #a8327e; --a4: #806600; --a5: #5b4bd1;
  --a6: #4d5560; --a7: #007f9c;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14161b; --ink: #e8eaee; --soft: #a2a9b6; --rule: #363c48; --panel: #1d2027;
    --wall: #626a79; --bad: #ff8a80;
    --a0: #6bb8f2; --a1: #f98b4a; --a2: #35c9a0; --a3: #ee8ac8; --a4: #e0c24c; --a5: #aaa0ff;
    --a6: #c0c6d0; --a7: #5fd3ea;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", "Liberation Sans", sans-serif; }
main { max-width: 74rem; margin: 0 auto; padding: 2rem 1rem 4rem; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0 0 .75rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 3rem 0 .5rem; padding-top: .75rem;
  border-top: 1px solid var(--rule); }
h3 { font-size: 1rem; margin: 1.75rem 0 .5rem; }
p, ul, dl { max-width: 46rem; margin: 0 0 .75rem; }
ul { padding-left: 1.25rem; }
.lead { font-size: 1.125rem; }
.note, figcaption small, .none { color: var(--soft); }
.note, .none { font-size: .875rem; }
.verdicts { display: grid; gap: 1rem; margin: 1.5rem 0;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); }
.verdicts > div { background: var(--panel); border-radius: .5rem; padding: .875rem 1rem; }
.verdicts h3 { margin: 0 0 .375rem; }
.verdicts ul { margin: 0; padding-left: 1.125rem; }
.key { display: inline-block; vertical-align: -1px; margin-right: .375em; }
.keys { display: flex; flex-wrap: wrap; gap: .25rem 1.25rem; list-style: none; padding: 0;
  max-width: none; }
.scroll { overflow-x: auto; margin: 0 0 1rem; }
table { border-collapse: collapse; font-size: .8125rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); padding-bottom: .375rem; }
th, td { padding: .25rem .5rem; text-align: right; vertical-align: top; white-space: nowrap;
  border-bottom: 1px solid var(--rule); }
th { font-weight: 600; }
thead th { vertical-align: bottom; border-bottom-color: var(--soft); }
thead th:first-child, th[scope=rowgroup], tbody td:first-child { padding-left: 0; }
td { font-weight: 400; }
tr.group:not(:first-child) > * { border-top: 2px solid var(--rule); }
.l { text-align: left; }
.zero { color: var(--soft); }
.found { font-weight: 700; }
.charts { display: grid; gap: 1.5rem 2rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 19rem), 1fr)); }
figure { margin: 0; min-width: 0; break-inside: avoid; }
figcaption { font-size: .875rem; margin-bottom: .25rem; }
svg.chart { display: block; width: 100%; height: auto; max-width: 30rem; }
svg text { fill: var(--ink); font-size: 11px; }
svg text.soft { fill: var(--soft); }
.axis { stroke: var(--soft); stroke-width: 1; fill: none; }
.grid { stroke: var(--rule); stroke-width: 1; fill: none; }
.mark { stroke: var(--paper); stroke-width: .75; }
.run { opacity: .55; }
.fail { stroke: var(--bad); stroke-width: 1.6; fill: none; }
.box { fill: none; stroke: var(--ink); stroke-width: 1.25; }
.median { stroke: var(--ink); stroke-width: 2.5; }
.curve { fill: none; stroke-width: 1.75; stroke-linejoin: round; }
.a1.curve { stroke-dasharray: 7 2.5; }
.a2.curve { stroke-dasharray: 3 2; }
.a3.curve { stroke-dasharray: 9 2 2 2; }
.a4.curve { stroke-dasharray: 1.5 2; }
.a5.curve { stroke-dasharray: 12 3; }
.a6.curve { stroke-dasharray: 5 2 1.5 2 1.5 2; }
.a7.curve { stroke-dasharray: 2 4; }
.plan { color: var(--wall); }
.plan text { fill: var(--soft); }
svg text.floor { font-size: 26px; fill: var(--soft); }
.way { fill: none; stroke-width: 1.4px; stroke-opacity: .5; stroke-linejoin: round;
  stroke-linecap: round; vector-effect: non-scaling-stroke; }
.way.end { stroke-opacity: 1; stroke: var(--bad); stroke-width: 1.6px; }
.defs { position: absolute; width: 0; height: 0; }
code { font-family: ui-monospace, "Liberation Mono", monospace; font-size: .8125rem;
  overflow-wrap: anywhere; }
details { margin: 0 0 .5rem; }
summary { cursor: pointer; }
.commands { list-style: none; padding: 0; max-width: none; }
.commands li { padding: .375rem 0; border-bottom: 1px solid var(--rule); }
.commands code { display: block; }
dt { font-weight: 600; }
dd { margin: 0 0 .5rem; overflow-wrap: anywhere; }
.mark.a0 { fill: var(--a0); } .curve.a0, .way.a0 { stroke: var(--a0); }
.mark.a1 { fill: var(--a1); } .curve.a1, .way.a1 { stroke: var(--a1); }
.mark.a2 { fill: var(--a2); } .curve.a2, .way.a2 { stroke: var(--a2); }
.mark.a3 { fill: var(--a3); } .curve.a3, .way.a3 { stroke: var(--a3); }
.mark.a4 { fill: var(--a4); } .curve.a4, .way.a4 { stroke: var(--a4); }
.mark.a5 { fill: var(--a5); } .curve.a5, .way.a5 { stroke: var(--a5); }
.mark.a6 { fill: var(--a6); } .curve.a6, .way.a6 { stroke: var(--a6); }
.mark.a7 { fill: var(--a7); } .curve.a7, .way.a7 { stroke: var(--a7); }
@media print {
  :root {
    color-scheme: light;
    --paper: #fff; --ink: #000; --soft: #444; --rule: #bbb; --panel: #fff; --wall: #9aa1ae;
    --bad: #b3261e;
    --a0: #0063a8; --a1: #c34a00; --a2: #007a5c; --a3: #a8327e; --a4: #806600; --a5: #5b4bd1;
    --a6: #4d5560; --a7: #007f9c;
  }
  @page { margin: 14mm; }
  body { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  .scroll { overflow: visible; }
  table { font-size: 7.5pt; }
  th, td { padding: .15rem .35rem; }
  thead { display: table-header-group; }
  thead th { white-space: normal; }
  tr, .verdicts > div { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .verdicts > div { border: 1px solid var(--rule); }
}
)css";
}

}  // namespace latchwork::compare
