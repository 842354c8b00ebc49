// SPDX-License-Identifier: MIT-0
#pragma once

namespace grade {

/// The colours are those of the book.
inline constexpr const char* page_style = R"css(
:root { color-scheme: light dark; --paper: #fffefb; --ink: #22211f; --soft: #635f58; --line: #e2ddd2; --accent: #9c3a1f; --bar: #0b63b0; --back: #ece8de; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #17171a; --ink: #dedad2; --soft: #a39d93; --line: #35353b; --accent: #f09a78; --bar: #66b0f5; --back: #2d2d33; }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, sans-serif; }
main { max-width: 70rem; margin: 0 auto; padding: 1.5rem 1rem 4rem; }
h1 { font-size: 1.7rem; margin: 0; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .5rem; }
p { margin: .3rem 0; color: var(--soft); }
a { color: var(--accent); }
.wide { overflow-x: auto; }
.wide:focus-visible { outline: 2px solid var(--accent); }
table { border-collapse: collapse; min-width: 100%; }
th, td { padding: .35rem .8rem .35rem 0; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; font-weight: 400; }
thead th { color: var(--soft); font-size: .85rem; }
.number, .students td { font-variant-numeric: tabular-nums; white-space: nowrap; }
.bar { width: 35%; min-width: 6rem; }
.bar svg { display: block; width: 100%; height: .7rem; margin-top: .45rem; background: var(--back); border-radius: 2px; }
.bar rect { fill: var(--bar); }
.verdicts { list-style: none; display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; margin: 0 0 .5rem; padding: 0; font-size: .85rem; }
.verdict { color: var(--soft); font-size: .72rem; margin-left: .3rem; }
.students tbody th { position: sticky; left: 0; background: var(--paper); max-width: 14rem; overflow-wrap: anywhere; }
@media (max-width: 40rem) { .bar { display: none; } main { padding: 1rem .8rem 3rem; } }
)css";

}  // namespace grade
