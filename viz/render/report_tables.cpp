// SPDX-License-Identifier: BSD-3-Clause
#include "report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include "colour.h"
#include "failure.h"
#include "number_text.h"
#include "run/text.hpp"

namespace hfrac::viz {

namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

struct NamedColour {
  const char* name;
  Colour Palette::*colour;
};

// The palette's members that occur in charts.
constexpr std::array<NamedColour, 12> chart_colours = {{{"--paper", &Palette::paper},
                                                        {"--ink", &Palette::ink},
                                                        {"--faint", &Palette::faint_ink},
                                                        {"--frame", &Palette::frame},
                                                        {"--grid", &Palette::grid},
                                                        {"--tension", &Palette::tension},
                                                        {"--shear", &Palette::shear},
                                                        {"--well", &Palette::well},
                                                        {"--bond", &Palette::bond},
                                                        {"--water", &Palette::water},
                                                        {"--pull", &Palette::pull},
                                                        {"--push", &Palette::push}}};

}  // namespace

std::string data_address(const std::string& kind, const std::string& content) {
  std::string text = "data:" + kind + ";base64,";
  append_base64(text, std::as_bytes(std::span(content)));
  return text;
}

std::string inline_svg(const std::string& svg) {
  const std::size_t root = svg.find("<svg ");
  if (root == std::string::npos) return {};
  std::string text = svg.substr(root);
  replace_all(text, " xmlns=\"http://www.w3.org/2000/svg\"", " role=\"img\"");
  for (const NamedColour& named : chart_colours) {
    for (const char* attribute : {"fill", "stroke"})
      replace_all(text, fmt::format("{}=\"{}\"", attribute, hexadecimal(light_palette().*named.colour)),
                  fmt::format("{}=\"var({})\"", attribute, named.name));
  }
  return text;
}

std::string colour_variables(bool dark) {
  const Palette& colours = dark ? dark_palette() : light_palette();
  std::string text;
  for (const NamedColour& named : chart_colours) {
    text.append(named.name).append(": ").append(hexadecimal(colours.*named.colour)).append("; ");
  }
  return text;
}

std::string name_table(const Rows& rows) {
  std::string text = "<table class=\"names\">\n";
  for (const auto& [name, value] : rows) {
    text.append("<tr><th>").append(escaped(name)).append("</th><td>").append(escaped(value));
    text.append("</td></tr>\n");
  }
  return text + "</table>\n";
}

namespace {

using json = nlohmann::ordered_json;

constexpr double per_mega = 1e-6;
constexpr double degrees_per_radian = 180 / std::numbers::pi;

std::string shown(double value, const std::string& unit = "") {
  if (!std::isfinite(value)) return "\xE2\x80\x93";
  return value_text(value) + (unit.empty() ? "" : " " + unit);
}

std::string shown_count(double value) {
  return std::isfinite(value) ? count_text(std::llround(value)) : "\xE2\x80\x93";
}

// Rows of numbers under heads; the first row are the heads.
std::string number_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<div class=\"scroll\"><table>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const char* tag = i == 0 ? "th" : "td";
    text += "<tr>";
    for (const std::string& cell : rows[i]) {
      text.append("<").append(tag).append(" class=\"number\">").append(escaped(cell));
      text.append("</").append(tag).append(">");
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

std::string tile(const std::string& value, const std::string& name) {
  return "<div><b>" + escaped(value) + "</b><span>" + escaped(name) + "</span></div>\n";
}

std::vector<json> list_at(const json& summary, const char* name) {
  const json* list = member(summary, name);
  if (list == nullptr || !list->is_array()) return {};
  return list->get<std::vector<json>>();
}

}  // namespace

std::string key_numbers(const json& summary) {
  const double time = number_at(summary, "state.time_s");
  return "<div class=\"numbers\">\n" + tile(shown_count(number_at(summary, "state.crack_count")), "cracks") +
         tile(shown(number_at(summary, "longest_fracture.length_m"), "m"), "longest fracture") +
         tile(shown(number_at(summary, "longest_fracture.width_m") * millimetres_per_metre, "mm"),
              "its largest width") +
         tile(std::isfinite(time) ? time_text(time) : shown(time), "of model time") +
         tile(shown_count(number_at(summary, "state.disc_count")), "discs") +
         tile(shown_count(number_at(summary, "state.bond_count")), "bonds") + "</div>\n";
}

std::string warning_list(const json& summary) {
  std::string text;
  for (const json& one : list_at(summary, "warnings"))
    text += "<li>" + escaped(text_at(one, "text")) + "</li>\n";
  return text.empty() ? text : "<h2 id=\"warnings\">Warnings</h2>\n<ul>\n" + text + "</ul>\n";
}

std::string fracture_table(const json& summary) {
  std::vector<std::vector<std::string>> rows = {{"fracture", "cracks", "in tension", "length (m)",
                                                 "extent (m)", "reach (m)", "wings", "azimuth (\xC2\xB0)",
                                                 "mean aperture (mm)", "largest (mm)", "volume (m\xC2\xB2)",
                                                 "mean pressure (MPa)"}};
  for (const json& one : list_at(summary, "fractures")) {
    rows.push_back(
        {std::to_string(rows.size()), shown_count(number_at(one, "crack_count")),
         shown_count(number_at(one, "tensile_cracks")), shown(number_at(one, "length_m")),
         shown(number_at(one, "extent_m")), shown(number_at(one, "reach_m")),
         shown_count(number_at(one, "wings")), shown(number_at(one, "azimuth_rad") * degrees_per_radian),
         shown(number_at(one, "mean_aperture_m") * millimetres_per_metre),
         shown(number_at(one, "largest_aperture_m") * millimetres_per_metre),
         shown(number_at(one, "volume_m2")), shown(number_at(one, "mean_pressure_Pa") * per_mega)});
  }
  if (rows.size() == 1) return "<p>No fracture.</p>\n";
  return number_table(rows);
}

std::string joint_table(const json& summary) {
  const auto of = [&](const char* name) { return number_at(summary, std::string("joints.") + name); };
  if (!std::isfinite(of("length_m"))) return "";
  Rows rows = {{"length", shown(of("length_m"), "m")},
               {"slipped by more than " + shown(of("slip_counted_m") * millimetres_per_metre, "mm"),
                shown(of("slipped_length_m"), "m")},
               {"open", shown(of("open_length_m"), "m")},
               {"largest slip", shown(of("largest_slip_m") * millimetres_per_metre, "mm")}};
  std::size_t well = 0;
  for (const json& one : list_at(summary, "wells")) {
    rows.emplace_back("injectivity of well " + std::to_string(++well) + " in the last step",
                      shown(number_at(one, "injectivity_m2_per_Pa_s"), "m\xC2\xB2/(Pa s)"));
  }
  return "<h2 id=\"joints\">Smooth joints</h2>\n" + name_table(rows);
}

std::string well_table(const json& summary) {
  std::vector<std::vector<std::string>> rows = {{"well", "x (m)", "y (m)", "radius (m)", "pressure (MPa)",
                                                 "rate (m\xC2\xB2/s)", "injected (m\xC2\xB2)"}};
  for (const json& one : list_at(summary, "wells")) {
    rows.push_back({std::to_string(rows.size()), shown(number_at(one, "x_m")), shown(number_at(one, "y_m")),
                    shown(number_at(one, "radius_m")), shown(number_at(one, "pressure_Pa") * per_mega),
                    shown(number_at(one, "rate_m2_per_s")), shown(number_at(one, "injected_volume_m2"))});
  }
  return rows.size() > 1 ? number_table(rows) : "";
}

std::string balance_tables(const json& summary) {
  const auto balance = [&](const char* name) { return number_at(summary, std::string("balance.") + name); };
  const auto energy = [&](const char* name) { return shown(balance(name) * per_mega, "MJ/m"); };
  const Rows fluid = {{"injected", shown(balance("injected_volume_m2"), "m\xC2\xB2")},
                      {"stored", shown(balance("stored_volume_m2"), "m\xC2\xB2")},
                      {"leaked off", shown(balance("leaked_volume_m2"), "m\xC2\xB2")},
                      {"in fractures", shown(number_at(summary, "fracture_volume_m2"), "m\xC2\xB2")},
                      {"missing", shown(balance("fluid_error_m2"), "m\xC2\xB2")}};
  const Rows energies = {
      {"work of the fluid", energy("fluid_work_J_per_m")},
      {"work of the boundary", energy("boundary_work_J_per_m")},
      {"in bonds", energy("bond_elastic_J_per_m")},
      {"in contacts", energy("contact_elastic_J_per_m")},
      {"kinetic", energy("kinetic_J_per_m")},
      {"damped", energy("damping_J_per_m")},
      {"friction", energy("friction_J_per_m")},
      {"new cracks", energy("fracture_J_per_m")},
      {"missing",
       std::isnan(balance("energy_error_J_per_m")) ? "not checked" : energy("energy_error_J_per_m")}};
  return "<div class=\"pair\"><div><h3>Fluid</h3>" + name_table(fluid) + "</div><div><h3>Energy</h3>" +
         name_table(energies) + "</div></div>\n";
}

std::string version_table(const json& summary) {
  return name_table({{"hfrac", text_at(summary, "versions.hfrac")},
                     {"build", text_at(summary, "versions.build")},
                     {"stresses", text_at(summary, "stress_convention")},
                     {"state hash", text_at(summary, "state_hash")}});
}

}  // namespace hfrac::viz
