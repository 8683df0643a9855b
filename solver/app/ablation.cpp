#include "solver/app/ablation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace sunder::app {
namespace {

using results::Quantity;

/// Every number below `quantity`, whatever lists and tables it is in.
void each_number(const Quantity* quantity, const std::function<void(double)>& visit) {
  if (quantity == nullptr) return;
  if (const double* number = quantity->number()) visit(*number);
  if (const Quantity::List* list = quantity->list())
    for (const Quantity& entry : *list) each_number(&entry, visit);
}

void raise(std::optional<double>& largest, double value) {
  largest = largest ? std::max(*largest, value) : value;
}

std::optional<double> largest_of(const Quantity* quantity) {
  std::optional<double> largest;
  each_number(quantity, [&](double value) { raise(largest, value); });
  return largest;
}

/// The largest value of all history columns whose name begins with `prefix`.
std::optional<double> largest_in_history(const results::RunSummary& summary, const std::string& prefix) {
  std::optional<double> largest;
  if (!summary.history) return largest;
  const results::History& history = *summary.history;
  for (std::size_t c = 0; c < history.columns().size(); ++c) {
    if (history.columns()[c].name.rfind(prefix, 0) != 0) continue;
    for (std::size_t row = 0; row < history.rows(); ++row) raise(largest, history.at(row, c));
  }
  return largest;
}

std::string number_text(const std::optional<double>& value, double unit) {
  if (!value) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", *value / unit);
  return text;
}

/// "0.0612 (-2.1 %)": with the change against the whole scene.
std::string change_text(const std::optional<double>& value, const std::optional<double>& whole, double unit) {
  std::string text = number_text(value, unit);
  if (!value || !whole || *whole == 0.0) return text;
  char change[32];
  std::snprintf(change, sizeof change, " (%+.1f %%)", 100.0 * (*value - *whole) / std::abs(*whole));
  return text + change;
}

struct Shown {
  const char* heading;
  std::optional<double> Findings::*member;
  double unit;
};
constexpr Shown shown[] = {{"displacement [m]", &Findings::displacement, 1.0},
                           {"crack length [m]", &Findings::crack_length, 1.0},
                           {"K_I [MPa√m]", &Findings::K_I, 1e6},
                           {"uplift [MN/m]", &Findings::uplift, 1e6},
                           {"frequency [Hz]", &Findings::frequency, 1.0}};

/// Characters, not bytes: UTF-8 continuation bytes have no width.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - width_of(row[i]), ' ');
      line += (i == 0 ? "" : "  ") + (i == 0 ? row[i] + space : space + row[i]);
    }
    text += line + "\n";
  }
  return text;
}

void forget_cracks(scene::Scene& scene) {
  scene.cracks.clear();
  scene.fracture.reset();
  scene.contact.reset();
  scene.crack_water.reset();
  scene.propagation.reset();
}

void forget_reservoir(scene::Scene& scene) {
  scene.reservoir.reset();
  scene.crack_water.reset();
}

/// The body stands on rigid rock that moves with the record.
void make_rigid(scene::Scene& scene) {
  scene.supports.push_back({.boundary = scene.foundation->boundary, .point = {}, .fix = {true, true}});
  scene.foundation.reset();
}

}  // namespace

scene::Scene without_output(scene::Scene scene) {
  if (scene.output) {
    scene.output->fields_every = 0;
    scene.output->checkpoint_every = 0;
    scene.output->profile_times.clear();
  }
  return scene;
}

std::vector<Cut> cuts_of(const scene::Scene& whole) {
  std::vector<Cut> cuts;
  const auto cut = [&](bool there, const std::string& part, const std::function<void(scene::Scene&)>& forget) {
    if (!there) return;
    Cut made{part, without_output(whole)};
    forget(made.scene);
    cuts.push_back(std::move(made));
  };
  if (whole.analysis == scene::Analysis::response) return cuts;
  const bool moving = whole.crack_water && whole.crack_water->model == scene::CrackWaterModel::moving;
  const bool alone = whole.analysis == scene::Analysis::crack_water;
  const bool in_time = whole.analysis == scene::Analysis::dynamic;
  const bool marched = whole.crack_line && whole.crack_line->march;
  cut(moving && (in_time || (alone && !marched)), "crack water: its motion",
      [](scene::Scene& scene) { scene.crack_water->model = scene::CrackWaterModel::uniform; });
  if (alone) return cuts;
  cut(!whole.cracks.empty(), "cracks", forget_cracks);
  cut(whole.propagation.has_value(), "growth", [](scene::Scene& scene) { scene.propagation.reset(); });
  cut(whole.contact.has_value(), "contact", [](scene::Scene& scene) { scene.contact.reset(); });
  cut(whole.crack_water.has_value(), "crack water", [](scene::Scene& scene) { scene.crack_water.reset(); });
  const bool inert = whole.reservoir && whole.reservoir->model == scene::ReservoirModel::hydrostatic;
  cut(whole.reservoir && !inert && whole.analysis != scene::Analysis::static_, "reservoir: its inertia",
      [](scene::Scene& scene) { scene.reservoir->model = scene::ReservoirModel::hydrostatic; });
  cut(whole.reservoir && !inert && in_time && whole.reservoir->model == scene::ReservoirModel::compressible,
      "reservoir: its compressibility",
      [](scene::Scene& scene) { scene.reservoir->model = scene::ReservoirModel::incompressible; });
  cut(whole.reservoir.has_value(), "reservoir", forget_reservoir);
  cut(whole.foundation.has_value(), "foundation", make_rigid);
  cut(whole.foundation && whole.foundation->density > 0.0 && in_time, "foundation: its inertia",
      [](scene::Scene& scene) { scene.foundation->density = 0.0; });
  cut(whole.gravity.has_value(), "gravity", [](scene::Scene& scene) { scene.gravity.reset(); });
  cut(!whole.loads.empty(), "loads", [](scene::Scene& scene) { scene.loads.clear(); });
  cut(!whole.regions.empty(), "regions", [](scene::Scene& scene) { scene.regions.clear(); });
  cut(whole.ground_motion && whole.ground_motion->vertical, "ground motion: vertical",
      [](scene::Scene& scene) { scene.ground_motion->vertical.reset(); });
  cut(whole.ground_motion.has_value(), "ground motion", [](scene::Scene& scene) { scene.ground_motion.reset(); });
  return cuts;
}

Findings findings_of(const results::RunSummary& summary) {
  const Quantity& found = summary.quantities;
  Findings findings;
  findings.displacement = largest_of(found.find("peak_crest_displacement"));
  if (!findings.displacement) findings.displacement = largest_of(found.find("max_displacement"));
  findings.crack_length = largest_of(found.find("final_crack_length"));
  if (const Quantity* growth = found.find("growth"); growth != nullptr && growth->list() != nullptr) {
    for (const Quantity& tip : *growth->list()) {
      if (const auto length = largest_of(tip.find("length"))) raise(findings.crack_length, *length);
    }
  }
  findings.K_I = largest_of(found.find("max_K_I"));
  if (const Quantity* tips = found.find("tips"); tips != nullptr && tips->list() != nullptr) {
    for (const Quantity& tip : *tips->list()) {
      if (const auto factor = largest_of(tip.find("K_I"))) raise(findings.K_I, *factor);
    }
  }
  findings.uplift = largest_in_history(summary, "uplift_force");
  if (!findings.uplift) findings.uplift = largest_of(found.find("uplift_force"));
  if (const Quantity* frequencies = found.find("frequencies[0]")) findings.frequency = *frequencies->number();
  return findings;
}

std::string ablation_table(const std::string& name, const std::vector<AblationRun>& runs) {
  const AblationRun& whole = runs.front();
  std::vector<Shown> columns;
  for (const Shown& column : shown) {
    if (std::any_of(runs.begin(), runs.end(),
                    [&](const AblationRun& run) { return (run.findings.*column.member).has_value(); }))
      columns.push_back(column);
  }
  std::vector<std::vector<std::string>> rows = {{"left out", "CPU [s]", "its share"}};
  for (const Shown& column : columns) rows.front().push_back(column.heading);
  for (const AblationRun& run : runs) {
    char seconds[32], share[32];
    std::snprintf(seconds, sizeof seconds, "%.3g", run.seconds);
    std::snprintf(share, sizeof share, "%.0f %%", 100.0 * (whole.seconds - run.seconds) / whole.seconds);
    const bool is_whole = run.part.empty();
    rows.push_back({is_whole ? "nothing" : run.part, seconds, is_whole || !run.trouble.empty() ? "" : share});
    for (const Shown& column : columns) {
      const auto& value = run.findings.*column.member;
      rows.back().push_back(is_whole ? number_text(value, column.unit)
                                     : change_text(value, whole.findings.*column.member, column.unit));
    }
  }
  std::string text = name + ": what each part costs and changes\n\n" + aligned(rows);
  for (const AblationRun& run : runs) {
    if (!run.trouble.empty())
      text += "\n" + (run.part.empty() ? "the whole scene" : "without " + run.part) + ": " + run.trouble;
  }
  return text + (text.back() == '\n' ? "" : "\n");
}

}  // namespace sunder::app
