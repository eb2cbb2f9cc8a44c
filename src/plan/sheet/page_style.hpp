// The style of a run sheet as a page: black on white, boxes to tick, each bench on its own paper.
#pragma once

#include <string_view>

namespace changeover {

/// Added to the other style for sheets with a column for each of many slots.
inline constexpr std::string_view wide_page_style = R"(
  @page { size: A4 landscape; }
  body { max-width: 80rem; }
)";

inline constexpr std::string_view page_style = R"(
  @page { size: A4; margin: 14mm 12mm; }
  * { box-sizing: border-box; }
  body { margin: 2rem auto; max-width: 60rem; padding: 0 1rem; color: #000; background: #fff;
         font: 14px/1.4 "Helvetica Neue", Helvetica, Arial, "Liberation Sans", sans-serif; }
  h1 { font-size: 1.6rem; margin: 0 0 .25rem; }
  h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
  p { margin: .25rem 0; }
  dl { display: flex; flex-wrap: wrap; gap: .5rem 2.25rem; margin: .75rem 0; padding: .6rem 0;
       border-top: 2px solid #000; border-bottom: 1px solid #000; }
  dt { font-size: .75rem; }
  dd { margin: 0; font-size: 1.15rem; font-weight: 600; font-variant-numeric: tabular-nums; }
  .small { font-size: .85em; }
  table { width: 100%; border-collapse: collapse; }
  thead { display: table-header-group; }
  tr { break-inside: avoid; }
  th { text-align: left; font-size: .75rem; border-bottom: 2px solid #000; vertical-align: bottom; }
  th, td { padding: .3rem .5rem; }
  th:first-child, td:first-child { padding-left: 0; }
  td { border-bottom: 1px solid #999; vertical-align: top; }
  .n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
  .in { font-weight: 600; }
  .part.in, .part .in { border: 1.5px solid #000; border-radius: .2em; padding: 0 .2em; }
  .part { white-space: nowrap; }
  .part:not(:last-child)::after { content: " \00b7"; }
  .part.in::after { content: none !important; }
  .wide { white-space: normal; }
  .lines .part { display: block; width: fit-content; }
  .lines .part::after { content: none !important; }
  .lines .wide { padding-left: 1em; text-indent: -1em; }
  .lines .part.in { margin: 1px 0; padding: 0 .2em; text-indent: 0; }
  .lines .name { text-indent: 0; }
  .name { white-space: nowrap; }
  .lines .flow .part { display: inline; padding: 0; }
  .lines .flow .part:not(.in):not(:last-child)::after { content: " \00b7" !important; }
  .box { display: inline-block; width: 1em; height: 1em; border: 1.5px solid #000;
         vertical-align: -.12em; }
  .verdict { white-space: nowrap; width: 1%; }
  .notes { width: 30%; min-width: 45mm; }
  .bench { break-before: page; }
  .many .setup { width: 40%; }
  .many .notes { width: 10%; min-width: 22mm; }
  .compact { font-size: .85em; }
  .two { columns: 2; column-gap: 8mm; }
  .compact td { border-bottom: 1px solid #999; padding: .15rem .3rem; }
  .compact .notes { width: 18%; min-width: 20mm; }
  @media print { body { margin: 0; max-width: none; padding: 0; font-size: 9pt; line-height: 1.25; }
                 dl { gap: .5rem 1.4rem; } dd { font-size: 11pt; }
                 h2 { break-after: avoid; } }
  @media screen and (max-width: 40rem) {
    body { margin: 1rem auto; }
    .two { columns: 1; }
    .compact { font-size: 1em; }
    .steps, .steps tbody { display: block; }
    .steps thead { display: none; }
    .steps tr { display: flex; flex-wrap: wrap; gap: .15rem 1rem; padding: .5rem 0;
                border-bottom: 1px solid #999; }
    .steps td { display: block; padding: 0; border: 0; text-align: left; width: auto; }
    .steps td.step { font-weight: 600; }
    .steps td { flex-basis: 100%; }
    .steps td.verdict, .steps td.step, .steps td.n { flex-basis: auto; }
    .steps td:empty { display: none; }
    .steps .part { display: inline !important; padding: 0; }
    .steps .part.in { padding: 0 .2em; }
    .steps .part:not(.in):not(:last-child)::after { content: " \00b7" !important; }
    .steps td[data-head]::before { content: attr(data-head) ": "; font-weight: 400; }
    .steps td.step::before { content: "Step "; font-weight: 600; }
    th, td { padding: .3rem .25rem; }
    .n { white-space: normal; } }
)";

}  // namespace changeover
