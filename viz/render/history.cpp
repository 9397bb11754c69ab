// SPDX-License-Identifier: BSD-3-Clause
#include "history.h"

#include <algorithm>
#include <cmath>

#include "failure.h"
#include "run/grid_file.hpp"

namespace hfrac::viz {
namespace {

constexpr int stage_count = 5;

HistoryPoint read_point(const RunFolder& run, std::int64_t number, const SeriesFile& discs) {
  HistoryPoint point;
  point.number = number;
  point.moment.time = discs.time;
  const SeriesFile* file = file_of(run.cracks, number);
  if (file == nullptr) {
    point.moment = GridFile(discs).moment();
    return point;
  }
  const Cracks read = read_cracks(*file);
  point.moment = read.moment;
  for (const Crack& crack : read.cracks) {
    ++(crack.mode == CrackMode::shear ? point.shear_cracks : point.tensile_cracks);
  }
  return point;
}

// Strictly rising indices that end at `last`, as near to the wanted ones as that allows.
void spread(std::vector<int>& stages, int last) {
  for (std::size_t i = stages.size(); i-- > 0;) {
    const int room = static_cast<int>(stages.size() - 1 - i);
    const int above = i + 1 < stages.size() ? stages[i + 1] - 1 : last;
    stages[i] = std::min({stages[i], above, last - room});
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    stages[i] = std::max(stages[i], i == 0 ? 0 : stages[i - 1] + 1);
  }
}

std::vector<int> even_in_time(int last) {
  std::vector<int> stages;
  for (int k = 1; k <= stage_count; ++k) {
    stages.push_back(static_cast<int>(std::lround(static_cast<double>(last) * k / stage_count)));
  }
  return stages;
}

std::vector<int> even_in_growth(const std::vector<HistoryPoint>& history, int first_count, int final_count) {
  std::vector<int> stages;
  for (int k = 1; k <= stage_count; ++k) {
    const double wanted = first_count + static_cast<double>(final_count - first_count) * k / stage_count;
    const auto reached = std::find_if(history.begin(), history.end(),
                                      [&](const HistoryPoint& point) { return point.cracks() >= wanted; });
    stages.push_back(static_cast<int>(reached - history.begin()));
  }
  stages.back() = static_cast<int>(history.size()) - 1;
  return stages;
}

}  // namespace

std::vector<HistoryPoint> read_history(const RunFolder& run) {
  std::vector<HistoryPoint> history;
  extend_history(run, history);
  return history;
}

void extend_history(const RunFolder& run, std::vector<HistoryPoint>& history) {
  const auto first = history.empty() ? run.discs.begin() : run.discs.upper_bound(history.back().number);
  for (auto found = first; found != run.discs.end(); ++found) {
    history.push_back(read_point(run, found->first, found->second));
  }
}

HistoryPoint history_point(const RunFolder& run, std::int64_t number) {
  if (number < 0) number = run.discs.rbegin()->first;
  const SeriesFile* discs = file_of(run.discs, number);
  if (discs == nullptr) fail_argument("the run has no snapshot " + std::to_string(number));
  return read_point(run, number, *discs);
}

std::vector<int> growth_stages(const std::vector<HistoryPoint>& history) {
  const int last = static_cast<int>(history.size()) - 1;
  std::vector<int> stages;
  if (last < stage_count) {  // too few to choose from
    for (int i = 0; i <= last; ++i) stages.push_back(i);
    return stages;
  }
  stages = even_in_time(last);
  const int first_count = history.front().cracks();
  const int final_count = history.back().cracks();
  if (final_count <= first_count) return stages;
  bool grows = history[stages.front()].cracks() > first_count;
  for (std::size_t i = 1; i < stages.size(); ++i) {
    grows = grows && history[stages[i]].cracks() > history[stages[i - 1]].cracks();
  }
  if (grows) return stages;
  stages = even_in_growth(history, first_count, final_count);
  spread(stages, last);
  return stages;
}

}  // namespace hfrac::viz
