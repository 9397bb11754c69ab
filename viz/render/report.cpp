// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <array>

#include "failure.h"
#include "number_text.h"
#include "report_tables.h"
#include "run/json_file.hpp"
#include "run/text.hpp"

namespace hfrac::viz {
namespace {

// How the report looks. Colours are the variables of html.h, so pictures and page agree, light and dark.
constexpr const char* report_style = R"css(
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

using json = nlohmann::ordered_json;

struct Picture {
  const char* file;
  const char* caption;
};

// A figure around something, or nothing if there is nothing.
std::string figure(const std::string& content, const std::string& caption) {
  if (content.empty()) return {};
  return "<figure>" + content + "<figcaption>" + caption + "</figcaption></figure>\n";
}

std::string picture(const std::filesystem::path& folder, const Picture& wanted) {
  const std::string content = read_if_there(folder / wanted.file);
  if (content.empty()) return {};
  return figure(
      "<img alt=\"" + std::string(wanted.caption) + "\" src=\"" + data_address("image/png", content) + "\">",
      wanted.caption);
}

std::string movie(const std::filesystem::path& folder) {
  const std::string content = read_if_there(folder / "movie.mp4");
  if (content.empty()) return {};
  return "<h2 id=\"movie\" class=\"screen\">Movie</h2>\n" +
         figure("<video controls loop muted playsinline src=\"" + data_address("video/mp4", content) +
                    "\"></video>",
                "The whole run; pressure and number of cracks grow with the picture.");
}

std::string charts(const std::filesystem::path& folder) {
  static constexpr std::array<Picture, 6> wanted = {
      {{"record.svg", "Pressure of a field's record beside the computed one."},
       {"history.svg", "Pressure, rate, cracks, fracture, fluid and energy against time."},
       {"profile.svg", "Aperture of every crack against its distance from the well's wall."},
       {"rose.svg", "Directions of the cracks, by length."},
       {"events.svg", "Magnitudes of the cracks, and how many are at least as strong."},
       {"catalogue.svg", "Seismic events: cracks that broke together, their moments and magnitudes."}}};
  std::string text;
  for (const Picture& chart : wanted) {
    text += figure(inline_svg(read_if_there(folder / chart.file)), chart.caption);
  }
  return text.empty() ? text : "<h2 id=\"curves\">Curves</h2>\n" + text;
}

std::string pictures(const std::filesystem::path& folder) {
  std::string text = picture(folder, {"growth.png", "Growth of the fracture."});
  text += picture(
      folder,
      {"views.png", "Around the cracks: forces across bonds, mean stress, displacement, when cracks broke."});
  text += "<div class=\"pair\">" + picture(folder, {"aperture.png", "Cracks by aperture, close up."}) +
          picture(folder, {"pressure.png", "Fluid pressure in the pores, cracks over it."}) +
          picture(folder, {"model.png", "The particle model."}) + "</div>\n";
  return "<h2 id=\"pictures\">Pictures</h2>\n" + text;
}

std::string how_to(const json& summary) {
  return "<h2 id=\"reproduce\">How to reproduce it</h2>\n<p>Save the case below as <code>case.toml</code> "
         "and "
         "run:</p>\n<pre>hfrac run case.toml -o run\nhfrac report run</pre>\n<p>The same version gives the "
         "same "
         "numbers bit by bit, on any number of workers; its state hash is then <code>" +
         escaped(text_at(summary, "state_hash")) + "</code>.</p>\n" + version_table(summary);
}

std::string page_head(const std::string& title) {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta name=\"color-scheme\" content=\"light dark\">\n<title>" +
         escaped(title) + "</title>\n<style>\n:root { " + colour_variables(false) +
         "}\n@media (prefers-color-scheme: dark) { :root { " + colour_variables(true) + "} }" + report_style +
         "</style>\n</head>\n<body>\n<main>\n";
}

}  // namespace

std::string report_page(const std::filesystem::path& folder) {
  const json summary = read_json(folder / "summary.json");
  const std::string own_title = text_at(summary, "title");
  const std::string title = own_title.empty() ? "Hydraulic fracturing run" : own_title;
  const std::filesystem::path drawn = folder / "pictures";
  const std::string definition = read_if_there(folder / "case.toml");
  std::string page = page_head(title) + "<header>\n<h1>" + escaped(title) +
                     "</h1>\n<p>Ended: " + escaped(text_at(summary, "ended")) + "</p>\n" +
                     key_numbers(summary) + "</header>\n";
  page += warning_list(summary);
  page += pictures(drawn) + movie(drawn) + charts(drawn);
  page += "<h2 id=\"fractures\">Fractures</h2>\n" + fracture_table(summary);
  page += joint_table(summary);
  page += "<h2 id=\"wells\">Wells</h2>\n" + well_table(summary);
  page += "<h2 id=\"balances\">Balances, per metre of thickness</h2>\n" + balance_tables(summary);
  page += how_to(summary);
  page += "<h2 id=\"case\">The case</h2>\n<pre>" + escaped(definition) + "</pre>\n";
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace hfrac::viz
