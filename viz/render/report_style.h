// SPDX-License-Identifier: BSD-3-Clause
// How the report looks. Colours are the variables of html.h, so pictures and page agree, light and dark.
#pragma once

namespace hfrac::viz {

inline constexpr const char* report_style = R"css(
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 3rem 1.5rem 5rem; }
header { border-bottom: 1px solid var(--grid); padding-bottom: 1.5rem; margin-bottom: 2rem; }
h1 { font-size: 2rem; line-height: 1.2; letter-spacing: -0.01em; margin: 0 0 0.3rem; }
h2 { font-size: 1.3rem; margin: 3rem 0 1rem; }
p, figcaption { color: var(--faint); margin: 0.3rem 0 0; }
.numbers { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 1rem; margin: 2rem 0 0; }
.numbers div { border: 1px solid var(--grid); border-radius: 8px; padding: 0.8rem 1rem; }
.numbers b { display: block; font-size: 1.4rem; font-weight: 600; font-variant-numeric: tabular-nums; }
.numbers span { color: var(--faint); font-size: 0.85rem; }
figure { margin: 0 0 2rem; }
figure img, figure video, figure svg { display: block; width: 100%; height: auto; border: 1px solid var(--grid);
  border-radius: 8px; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 320px), 1fr)); gap: 1.5rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin-top: 0.8rem; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.35rem 1.5rem 0.35rem 0; border-bottom: 1px solid var(--grid);
  white-space: nowrap; }
td:not(.number) { white-space: normal; overflow-wrap: anywhere; }
th { font-weight: 500; color: var(--faint); }
td.number, th.number { text-align: right; padding-right: 1.1rem; }
th.number { white-space: normal; vertical-align: bottom; }
pre { background: color-mix(in srgb, var(--grid) 45%, var(--paper)); border-radius: 8px; padding: 1rem 1.2rem;
  overflow-x: auto; font: 13px/1.5 ui-monospace, "DejaVu Sans Mono", monospace; }
summary { cursor: pointer; color: var(--faint); }
@media print { main { max-width: none; padding: 0; } video, .screen { display: none; } }
)css";

}  // namespace hfrac::viz
