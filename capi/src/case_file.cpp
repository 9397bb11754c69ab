// SPDX-License-Identifier: BSD-3-Clause
// Reading case files. The text is parsed as TOML first; then every key must be known and every value right.
// Keys are gone through in the order of their lines, so that the first fault in the file is the one reported.
#include "case_file.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "options/nearest.hpp"
#include "options/number_text.hpp"
#include "record.hpp"
#include "text_file.hpp"
#include "toml.hpp"
#include "toml_scan.hpp"
#include "traces.hpp"
#include "utf8.hpp"

namespace hfrac::capi {
namespace {

using KeyAndNode = std::pair<std::string_view, const toml::node*>;

// toml++ sorts tables by name.
std::vector<KeyAndNode> entries_by_line(const toml::table& table) {
  std::vector<KeyAndNode> entries;
  for (const auto& [key, node] : table) entries.emplace_back(key.str(), &node);
  std::stable_sort(entries.begin(), entries.end(), [](const KeyAndNode& a, const KeyAndNode& b) {
    return a.second->source().begin.line < b.second->source().begin.line;
  });
  return entries;
}

std::vector<std::string_view> section_names() {
  std::vector<std::string_view> names;
  for (const auto& info : option_table()) {
    const std::string_view key = info.key;
    const std::string_view section = key.substr(0, key.find('.'));
    if (names.empty() || names.back() != section) names.push_back(section);
  }
  return names;
}

bool is_known_section(std::string_view name) {
  const auto names = section_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string did_you_mean(std::string_view nearest) {
  return nearest.empty() ? "." : "; did you mean " + std::string(nearest) + "?";
}

std::string unknown_section_text(std::string_view name) {
  auto names = section_names();
  names.insert(names.end(), {"well", "joint", "title"});
  return printable(name) + " is not a known section" + did_you_mean(nearest_name(name, names));
}

const char* type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a real number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

const char* wanted_name(ValueType type) {
  switch (type) {
    case ValueType::real:
      return "a number";
    case ValueType::integer:
      return "an integer";
    case ValueType::choice:
      return "a word in quotes";
  }
  return "";
}

// Keys beside schedule_file.
struct RecordKey {
  const char* name;
  double usual, least, most;
  bool above;  // `least` itself is not allowed
  const char* range;
};
constexpr RecordKey thickness_key{"schedule_thickness", 0.0, 0.0, 1e6, true, "above 0 to 1e6 m"};
constexpr RecordKey tolerance_key{"schedule_tolerance", 0.01, 0.0, 0.5, false, "0 to 0.5"};

class CaseReader {
 public:
  // `notes` may be nullptr.
  CaseReader(const std::string& path, const CaseDefinition& base, std::vector<std::string>* notes)
      : full_path_(path), path_(printable(path, 400)), result_(base), notes_(notes) {}

  CaseDefinition read(const toml::table& root) {
    const toml::node* wells = nullptr;
    for (const auto& [name, node] : entries_by_line(root)) {
      if (name == "title") {
        read_title(*node);
      } else if (name == "well") {
        wells = node;
      } else if (name == "joint") {
        read_joints(*node);
      } else {
        read_section(name, *node);
      }
    }
    // Last, because the centre of the model is a well's default place.
    if (wells != nullptr) read_wells(*wells);
    return std::move(result_);
  }

 private:
  [[noreturn]] void refuse(const toml::node& at, const std::string& fault) const {
    throw Error(ErrorKind::case_file, path_ + ":" + std::to_string(at.source().begin.line) + ": " + fault);
  }

  void read_title(const toml::node& node) {
    if (!node.is_string()) refuse(node, std::string("title must be a text, not ") + type_name(node) + ".");
    const std::string title = *node.value<std::string>();
    constexpr std::size_t longest = 127;
    if (title.size() > longest) {
      refuse(node, "title has " + std::to_string(title.size()) + " bytes; at most " +
                       std::to_string(longest) + " fit.");
    }
    if (title.find('\0') != std::string::npos) refuse(node, "title holds a character 0.");
    result_.title = title;
  }

  void read_section(std::string_view section, const toml::node& node) {
    const toml::table* table = node.as_table();
    if (!is_known_section(section)) {
      const bool is_section = table != nullptr || node.is_array_of_tables();
      refuse(node, is_section ? unknown_section_text(section) : unknown_key_text(printable(section)));
    }
    const std::string name(section);
    if (table == nullptr)
      refuse(node, name + " is a section, not a value; write [" + name + "] and its keys below.");
    for (const auto& [key, value] : entries_by_line(*table)) {
      const std::string full = name + "." + printable(key);
      if (full == "packing.file") {
        result_.packing_file = packing_file(text_of(*value, full));
        continue;
      }
      const OptionInfo* info = find_option(full);
      if (info == nullptr) refuse(*value, unknown_key_text(full));
      read_value(result_.options, *info, full, *value);
    }
  }

  // From wherever the definition is used: run folders hold case files of their own.
  [[nodiscard]] std::string packing_file(const std::string& given) const {
    return given.empty() ? given
                         : std::filesystem::absolute(beside(full_path_, given)).lexically_normal().string();
  }

  // One value, the type of which must fit: an integer will do for a real number, nothing else is converted.
  template <class Values, class Info>
  void read_value(Values& values, const Info& info, const std::string& key, const toml::node& node) const {
    const bool fits = info.type == ValueType::choice    ? node.is_string()
                      : info.type == ValueType::integer ? node.is_integer()
                                                        : node.is_number();
    if (!fits) refuse(node, key + " must be " + wanted_name(info.type) + ", not " + type_name(node) + ".");
    try {
      if (info.type == ValueType::choice) {
        set_word(values, info, key, printable(*node.value<std::string_view>()));
      } else if (node.is_integer()) {
        set_integer(values, info, key, *node.value<std::int64_t>());
      } else {
        set_real(values, info, key, *node.value<double>());
      }
    } catch (const Error& error) {
      refuse(node, error.what());
    }
  }

  // The tables of a list.
  std::vector<const toml::table*> tables_of(const toml::node& node, const std::string& name) const {
    const std::string wrong =
        name + " must be a list of tables; write [[" + name + "]] above each one's keys.";
    const toml::array* list = node.as_array();
    if (list == nullptr) refuse(node, wrong);
    std::vector<const toml::table*> tables;
    for (const toml::node& item : *list) {
      if (item.as_table() == nullptr) refuse(item, wrong);
      tables.push_back(item.as_table());
    }
    return tables;
  }

  void read_wells(const toml::node& node) {
    result_.wells.clear();
    result_.schedule.clear();
    for (const toml::table* table : tables_of(node, "well")) {
      const std::string name = "well[" + std::to_string(result_.wells.size()) + "]";
      result_.wells.push_back(read_well(*table, name));
      if (const toml::node* schedule = table->get("schedule")) read_schedule(*schedule, name);
      read_record_of(*table, name);
    }
  }

  // A number of the keys of a record, which are no options: they end with the case file.
  double record_number(const toml::table& table, const std::string& well, const RecordKey& key) const {
    const toml::node* node = table.get(key.name);
    if (node == nullptr) return key.usual;
    const std::string name = well + "." + key.name;
    if (!table.contains("schedule_file"))
      refuse(*node, name + " is for a schedule_file, which " + well + " does not have.");
    if (!node->is_number()) refuse(*node, name + " must be a number, not " + type_name(*node) + ".");
    const double value = *node->value<double>();
    const bool low = key.above ? value <= key.least : value < key.least;
    if (low || !(value <= key.most))
      refuse(*node, name + " = " + number_text(value) + " is outside " + key.range + ".");
    return value;
  }

  // The schedule of the well read last, if it is a record.
  void read_record_of(const toml::table& table, const std::string& name) {
    RecordWishes wishes;
    wishes.thickness = record_number(table, name, thickness_key);
    const double share = record_number(table, name, tolerance_key);
    const toml::node* file = table.get("schedule_file");
    if (file == nullptr) return;
    if (table.contains("schedule"))
      refuse(*file, name + " has both schedule_file and schedule; give one of them.");
    WellOptions& well = result_.wells.back();
    if (well.control == WellControl::ramp)
      refuse(*file,
             name + " has control = \"ramp\", which no schedule_file has; it is \"pressure\" or \"rate\".");
    const bool by_rate = well.control == WellControl::rate;
    wishes.rate = by_rate ? Wish::must : Wish::none;
    wishes.pressure = by_rate ? Wish::none : Wish::must;
    const std::string path = beside(full_path_, text_of(*file, name + ".schedule_file"));
    const Record record = read_record(path, wishes);
    const auto entries = thinned(record, well.control, share);
    if (!by_rate && !table.contains("pressure")) well.pressure = entries.front().value;
    for (ScheduleEntry entry : entries) {
      entry.well = static_cast<std::int64_t>(result_.wells.size()) - 1;
      result_.schedule.push_back(entry);
    }
    if (notes_ != nullptr)
      notes_->push_back(name + ": the " + std::to_string(record.time.size()) + " rows of " +
                        printable(path, 400) + ", " + number_text(record.time.front()) + " to " +
                        number_text(record.time.back()) + " s, gave " + std::to_string(entries.size()) +
                        " entries of its schedule, within " + rounded_text(100.0 * share) + " % of the " +
                        (by_rate ? "volume" : "range of pressure"));
  }

  // Entries of the well read last.
  void read_schedule(const toml::node& node, const std::string& well) {
    std::size_t number = 0;
    for (const toml::table* table : tables_of(node, "well.schedule")) {
      const std::string name = well + ".schedule[" + std::to_string(number++) + "]";
      ScheduleEntry entry;
      entry.well = static_cast<std::int64_t>(result_.wells.size()) - 1;
      bool timed = false, driven = false;
      for (const auto& [key, value] : entries_by_line(*table)) {
        if (key == "time") {
          timed = true;
          read_value(entry, *find_schedule_value("time"), name + ".time", *value);
        } else if (key == "pressure" || key == "rate") {
          if (driven) refuse(*value, name + " has both pressure and rate; give one of them.");
          driven = true;
          entry.control =
              static_cast<std::int64_t>(key == "rate" ? WellControl::rate : WellControl::pressure);
          read_value(entry, *find_schedule_value("value"), name + "." + std::string(key), *value);
        } else if (key == "fluid") {
          read_value(entry, *find_schedule_value("fluid"), name + ".fluid", *value);
        } else {
          refuse(*value, "well.schedule." + printable(key) +
                             " is not a known key; it is time, pressure, rate or fluid.");
        }
      }
      if (!timed || !driven)
        refuse(*table,
               name + (timed ? " has neither pressure nor rate; it needs one of them." : " has no time."));
      result_.schedule.push_back(entry);
    }
  }

  void read_joints(const toml::node& node) {
    result_.joints.clear();
    for (const toml::table* table : tables_of(node, "joint")) {
      const std::string name = "joint[" + std::to_string(result_.joints.size()) + "]";
      JointOptions joint;
      const toml::node* file = table->get("file");
      for (const auto& [key, value] : entries_by_line(*table)) {
        if (value == file) continue;
        const JointInfo* info = find_joint_value(key);
        if (info == nullptr) refuse(*value, unknown_item_key_text("joint", printable(key)));
        read_value(joint, *info, name + "." + info->key, *value);
      }
      for (const char* key : {"x1", "y1", "x2", "y2"}) {
        if (file != nullptr && table->contains(key))
          refuse(*table, name + " has both file and " + key + "; the ends of its joints are in the file.");
        if (file == nullptr && !table->contains(key))
          refuse(*table, name + " has no " + key + "; a joint needs both its ends, or a file of them.");
      }
      if (file == nullptr) {
        result_.joints.push_back(joint);
      } else {
        const auto set = read_traces(beside(full_path_, text_of(*file, name + ".file")), joint);
        result_.joints.insert(result_.joints.end(), set.begin(), set.end());
      }
    }
  }

  std::string text_of(const toml::node& node, const std::string& name) const {
    if (!node.is_string()) refuse(node, name + " must be a text, not " + type_name(node) + ".");
    return *node.value<std::string>();
  }

  WellOptions read_well(const toml::table& table, const std::string& name) const {
    WellOptions well;
    well.x = 0.5 * result_.options.model_width;
    well.y = 0.5 * result_.options.model_height;
    for (const auto& [key, value] : entries_by_line(table)) {
      if (key == "schedule" || key == "schedule_file" || key == thickness_key.name ||
          key == tolerance_key.name)
        continue;
      const WellOptionInfo* info = find_well_option(key);
      if (info == nullptr) refuse(*value, unknown_item_key_text("well", printable(key)));
      read_value(well, *info, name + "." + info->key, *value);
    }
    const auto has = [&](const char* key) { return table.contains(key); };
    if (!has("radius")) refuse(table, name + " has no radius; a well needs radius, and pressure or rate.");
    const bool driven = well.wellbore > 0 && std::any_of(result_.wells.begin(), result_.wells.end(),
                                                         [&](const WellOptions& first) {
                                                           return first.wellbore == well.wellbore;
                                                         });
    if (driven && !has("pressure") && !has("rate") && !has("schedule_file"))
      return well;  // by the wellbore's first
    if (!has("control")) {
      if (has("pressure") == has("rate")) {
        refuse(
            table,
            name + (has("rate")
                        ? " has both pressure and rate; say which with control = \"pressure\" or \"rate\"."
                    : has("schedule_file")
                        ? " has neither pressure nor rate; say with control = \"pressure\" or \"rate\" which "
                          "column of its schedule_file drives it."
                        : " has neither pressure nor rate; it needs one of them."));
      }
      well.control = has("rate")            ? WellControl::rate
                     : has("ramp_per_step") ? WellControl::ramp
                                            : WellControl::pressure;
    }
    const bool by_rate = well.control == WellControl::rate;
    if (!has(by_rate ? "rate" : "pressure") && !has("schedule_file")) {
      refuse(table, name + (by_rate ? " has control = \"rate\" but no rate."
                                    : " has no pressure, which its control needs."));
    }
    if (well.control == WellControl::ramp && !has("ramp_per_step")) {
      refuse(table, name + " has control = \"ramp\" but no ramp_per_step.");
    }
    return well;
  }

  std::string full_path_, path_;  // as it is, and as it is shown
  CaseDefinition result_;
  std::vector<std::string>* notes_;
};

[[noreturn]] void refuse_line(const std::string& path, std::size_t line, const std::string& fault) {
  throw Error(ErrorKind::case_file, printable(path, 400) + ":" + std::to_string(line) + ": " + fault);
}

// The first `count` lines of a text.
std::string_view first_lines(std::string_view text, std::size_t count) {
  std::size_t end = 0;
  for (; count > 0 && end < text.size(); --count) end = std::min(text.find('\n', end), text.size() - 1) + 1;
  return text.substr(0, end);
}

bool is_fault(std::string_view text) {
  try {
    (void)toml::parse(text);
  } catch (const TomlFault&) {
    return true;
  } catch (const toml::parse_error&) {
  }
  return false;
}

// The line at which the parser met what it takes for impossible: the first that is enough for it to do so.
std::size_t line_of_fault(std::string_view text) {
  std::size_t good = 0, bad = 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (is_fault(first_lines(text, middle)) ? bad : good) = middle;
  }
  return bad;
}

std::string fault_text(std::string_view text, std::size_t line) {
  const std::string_view before = first_lines(text, line - 1);
  const std::string_view here = first_lines(text, line).substr(before.size());
  const auto control = std::find_if(here.begin(), here.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7f;
  });
  if (control == here.end()) return "not valid TOML: something stands here that no key or value begins with.";
  return "not valid TOML: the line holds the control character " +
         std::to_string(static_cast<unsigned char>(*control)) + "; remove it.";
}

toml::table parse(const std::string& path, const std::string& text) {
  if (const std::size_t line = line_of_stray_character(text)) {
    refuse_line(path, line,
                "not a case file: a quote or a character beyond ASCII stands where a case file has none.");
  }
  try {
    return toml::parse(std::string_view(text));
  } catch (const TomlFault&) {
    const std::size_t line = line_of_fault(text);
    refuse_line(path, line, fault_text(text, line));
  } catch (const toml::parse_error& error) {
    refuse_line(path, error.source().begin.line,
                "not valid TOML: " + printable(error.description(), 300) + ".");
  }
}

// Adds the lines of a table's values, named as in the engine's sentences.
void add_lines(KeyLines& lines, const std::string& name, const toml::table& table) {
  for (const auto& [key, value] : table)
    lines[name + "." + std::string(key.str())] = value.source().begin.line;
}

void add_items(KeyLines& lines, const std::string& name, const toml::array* items, std::size_t first) {
  for (std::size_t k = 0; items != nullptr && k < items->size(); ++k) {
    const std::string item = name + "[" + std::to_string(first + k) + "]";
    lines[item] = (*items)[k].source().begin.line;
    if (const toml::table* table = (*items)[k].as_table()) add_lines(lines, item, *table);
  }
}

// Joints of a file of traces have the line of the table that names it.
void add_joints(KeyLines& lines, const std::string& path, const toml::array* items) {
  std::size_t number = 0;
  for (std::size_t k = 0; items != nullptr && k < items->size(); ++k) {
    const toml::table* table = (*items)[k].as_table();
    if (table == nullptr) continue;
    const auto file = (*table)["file"].value<std::string>();
    const std::size_t count = file ? read_traces(beside(path, *file), {}).size() : 1;
    for (std::size_t end = number + count; number < end; ++number) {
      const std::string item = "joint[" + std::to_string(number) + "]";
      lines[item] = table->source().begin.line;
      add_lines(lines, item, *table);
    }
  }
}

}  // namespace

KeyLines lines_of_keys(const std::string& path) {
  const toml::table root = parse(path, read_text_file(path));
  const auto all = CaseReader(path, {}, nullptr).read(root).schedule;
  KeyLines lines;
  for (const auto& [section, node] : root)
    if (const toml::table* table = node.as_table()) add_lines(lines, std::string(section.str()), *table);
  add_joints(lines, path, root["joint"].as_array());
  const toml::array* wells = root["well"].as_array();
  add_items(lines, "well", wells, 0);
  std::size_t entries = 0;  // the engine counts those of all wells in one list
  for (std::size_t k = 0; wells != nullptr && k < wells->size(); ++k) {
    const toml::table* well = (*wells)[k].as_table();
    const toml::array* schedule = well == nullptr ? nullptr : (*well)["schedule"].as_array();
    add_items(lines, "schedule", schedule, entries);
    // Entries of a record have the line that names it.
    const toml::node* file = well == nullptr ? nullptr : well->get("schedule_file");
    for (; entries < all.size() && all[entries].well == static_cast<std::int64_t>(k); ++entries) {
      if (file == nullptr) continue;
      const std::string entry = "schedule[" + std::to_string(entries) + "]";
      const bool by_rate = WellControl{all[entries].control} == WellControl::rate;
      for (const char* value : {"", ".time", ".value", by_rate ? ".rate" : ".pressure"})
        lines[entry + value] = file->source().begin.line;
    }
  }
  return lines;
}

std::string with_place(const std::string& path, const KeyLines& lines, std::string_view sentence) {
  const auto of_a_key = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_.[]").find(c) != std::string_view::npos;
  };
  std::string place = printable(path, 400);
  for (std::size_t at = 0; at < sentence.size();) {
    std::size_t end = at;
    while (end < sentence.size() && of_a_key(sentence[end])) ++end;
    std::string_view word = sentence.substr(at, end - at);
    while (word.ends_with('.')) word.remove_suffix(1);
    const auto found = lines.find(word);
    if (found != lines.end()) {
      place.append(":").append(std::to_string(found->second));
      break;
    }
    at = end + 1;
  }
  return place + ": " + std::string(sentence);
}

std::string unknown_item_key_text(std::string_view list, std::string_view name) {
  std::vector<std::string_view> names;
  const auto add = [&](const auto& table) {
    for (const auto& info : table) names.emplace_back(info.key);
  };
  if (list == "well") add(well_option_table());
  if (list == "joint") add(joint_table());
  if (list == "schedule") add(schedule_table());
  const std::string_view nearest = nearest_name(name, names);
  const std::string prefix = std::string(list) + ".";
  return prefix + std::string(name) + " is not a known key" +
         did_you_mean(nearest.empty() ? "" : prefix + std::string(nearest));
}

CaseDefinition load_case(const std::string& path, const CaseDefinition& base,
                         std::vector<std::string>* notes) {
  CaseReader reader(path, base, notes);
  return reader.read(parse(path, read_text_file(path)));
}

std::optional<NamedRecord> record_of_case(const std::string& path) {
  const toml::table root = parse(path, read_text_file(path));
  const toml::array* wells = root["well"].as_array();
  for (std::size_t k = 0; wells != nullptr && k < wells->size(); ++k) {
    const toml::table* well = (*wells)[k].as_table();
    const auto file =
        well == nullptr ? std::optional<std::string>() : (*well)["schedule_file"].value<std::string>();
    if (file) return NamedRecord{beside(path, *file), (*well)[thickness_key.name].value_or(0.0)};
  }
  return std::nullopt;
}

}  // namespace hfrac::capi
