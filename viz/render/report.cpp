// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <array>

#include "failure.h"
#include "number_text.h"
#include "report_style.h"
#include "report_tables.h"
#include "run/json_file.hpp"
#include "run/text.hpp"

namespace hfrac::viz {
namespace {

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
  static constexpr std::array<Picture, 5> wanted = {
      {{"history.svg", "Pressure, rate, cracks, fracture, fluid and energy against time."},
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
  page += "<h2 id=\"wells\">Wells</h2>\n" + well_table(summary);
  page += "<h2 id=\"balances\">Balances, per metre of thickness</h2>\n" + balance_tables(summary);
  page += how_to(summary);
  page += "<h2 id=\"case\">The case</h2>\n<pre>" + escaped(definition) + "</pre>\n";
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace hfrac::viz
