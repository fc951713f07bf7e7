// How a page looks: one style sheet for light and dark screens and for paper.
#pragma once

namespace stream_recon::html {

inline constexpr const char* kPageStyle = R"css(
:root {
  color-scheme: light dark;
  --ink: #1d2329; --soft: #5c6670; --faint: #8b949e; --rule: #dfe3e8; --paper: #fbfbfa;
  --card: #ffffff; --accent: #1f6f8b; --wash: #1f6f8b24; --band: #1d232909; --warn: #b3541e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e4e7ea; --soft: #a3acb5; --faint: #7d8791; --rule: #2d343b; --paper: #14181c;
    --card: #1a1f24; --accent: #5fb3cf; --wash: #5fb3cf2e; --band: #ffffff0a; --warn: #e39a63;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; padding: 2.5rem 1.5rem 3rem; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif;
  font-variant-numeric: tabular-nums;
}
main { max-width: 1080px; margin: 0 auto; }
h1 { margin: 0; font-size: 1.75rem; font-weight: 650; letter-spacing: -0.01em; line-height: 1.25;
  overflow-wrap: anywhere; }
h2 { margin: 0 0 0.75rem; font-size: 1rem; font-weight: 650; }
.kicker { margin: 0 0 0.25rem; color: var(--soft); font-size: 0.85rem; }
.note { margin: 0.75rem 0 0; color: var(--warn); }
.tiles { display: grid; grid-template-columns: repeat(4, 1fr); gap: 1rem; margin: 1.75rem 0; }
.tile { padding: 0.9rem 1.1rem; background: var(--card); border: 1px solid var(--rule);
  border-radius: 10px; }
.tile b { display: block; font-size: 1.5rem; font-weight: 600; line-height: 1.3;
  white-space: nowrap; }
.tile span { color: var(--soft); font-size: 0.85rem; }
section { margin-top: 1rem; padding: 1.1rem 1.25rem 1.2rem; background: var(--card);
  border: 1px solid var(--rule); border-radius: 10px; break-inside: avoid; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; margin-top: 1rem; }
.pair > section { margin-top: 0; min-width: 0; }
figure { margin: 0; }
figure img { display: block; width: 100%; height: auto; }
figcaption { color: var(--soft); font-size: 0.85rem; text-align: center; }
.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem 1.5rem; }
.pictures .wide { grid-column: 1 / -1; }
svg { display: block; width: 100%; height: auto; }
svg text { fill: var(--soft); font-size: 12px; }
svg .axis { stroke: var(--faint); fill: none; }
svg .grid { stroke: var(--rule); fill: none; }
svg .band { fill: var(--band); }
svg .area { fill: var(--wash); }
svg .line { fill: none; stroke: var(--accent); stroke-width: 1.6; stroke-linejoin: round; }
svg .level { fill: none; stroke: var(--warn); stroke-dasharray: 5 4; }
svg .level-text { fill: var(--warn); }
table { width: 100%; border-collapse: collapse; }
th, td { padding: 0.3rem 0; border-top: 1px solid var(--rule); text-align: left;
  font-weight: 400; vertical-align: baseline; }
tr:first-child > th, tr:first-child > td { border-top: 0; }
thead th { color: var(--soft); font-size: 0.85rem; }
tbody:not(:first-child) tr:first-child > * { border-top: 1px solid var(--rule); }
tbody th { color: var(--soft); padding-right: 1rem; }
.number { text-align: right; white-space: nowrap; padding-left: 1.25rem; }
.bar { width: 42%; padding-left: 0.5rem; }
.bar i { display: block; height: 0.7rem; min-width: 2px; border-radius: 3px;
  background: var(--accent); }
.hash, code { font: 0.92em/1.5 ui-monospace, "SFMono-Regular", Menlo, Consolas, "DejaVu Sans Mono",
  monospace; }
code { display: block; overflow-wrap: anywhere; }
.hint { margin: 0.5rem 0 0; color: var(--soft); font-size: 0.85rem; }
footer { margin-top: 1.5rem; color: var(--soft); font-size: 0.85rem; }
@media (max-width: 960px) { .charts { grid-template-columns: 1fr; } }
@media (max-width: 640px) {
  body { padding: 1.5rem 0.75rem 2rem; }
  .tiles { grid-template-columns: 1fr 1fr; }
  .pair, .pictures { grid-template-columns: 1fr; }
}
@media print {
  :root { color-scheme: light; --ink: #000; --soft: #444; --faint: #777; --rule: #ccc;
    --paper: #fff; --card: #fff; --accent: #1f6f8b; --wash: #1f6f8b24; --band: #00000009;
    --warn: #9a4313; }
  body { padding: 0; font-size: 10.5pt; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

}  // namespace stream_recon::html
