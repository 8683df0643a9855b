#include "solver/simulation/growth_record.hpp"

#include <algorithm>
#include <cmath>

namespace sunder::simulation {
namespace {

using results::Quantity;

Quantity place(const mesh::Point& x) {
  return Quantity::List{x.x(), x.y()};
}

std::vector<results::Column> columns(std::size_t tips) {
  std::vector<results::Column> all{{"growths", "-"}, {"load_factor", "-"}, {"conjugate_displacement", "J/m"}};
  for (std::size_t i = 0; i < tips; ++i) {
    const std::string tip = "tip_" + std::to_string(i) + "_";
    all.push_back({tip + "length", "m"});
    all.push_back({tip + "x", "m"});
    all.push_back({tip + "y", "m"});
    all.push_back({tip + "K_I", "Pa sqrt(m)"});
    all.push_back({tip + "K_II", "Pa sqrt(m)"});
    all.push_back({tip + "kink_angle", "rad"});
  }
  return all;
}

std::string event_words(const Growth& growth) {
  if (growth.event == crack::TipEvent::reached_crack) return "reached a crack";
  const std::string boundary = boundary_at(growth.body.polygons, growth.tip);
  return boundary.empty() ? "reached the boundary" : "reached boundary " + boundary;
}

}  // namespace

GrowthRecord::GrowthRecord(const scene::Scene& scene, const Body& body)
    : scene_(scene), history_(columns(body.polygons.cracks.size())), tips_(body.polygons.cracks.size()) {
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    const int polygon = body.polygons.cracks[tip].tip_polygon;
    tips_[tip].path = {body.polygons.polygons[static_cast<std::size_t>(polygon)].scaling_centre};
  }
}

void GrowthRecord::add_state(const Body& body, const StaticState& state, std::span<const TipResult> tips,
                             std::span<const fracture::GrowthDecision> decisions, double load_factor) {
  if (tips.empty() || !std::isfinite(load_factor)) return;
  std::vector<double> release_rates(tips_.size(), -1.0);
  // Work of the loads at factor f is ½ f² · (-2 Π), so -2 Π f is the displacement that goes with the factor.
  std::vector<double> row{static_cast<double>(growths_), load_factor, -2.0 * load_factor * state.potential_energy()};
  row.resize(history_.columns().size(), 0.0);
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const auto tip = static_cast<std::size_t>(tips[i].tip);
    const fracture::StressIntensityFactors& factors = tips[i].state.factors;
    TipHistory& history = tips_[tip];
    history.length.push_back(crack_length(body.polygons, tips[i].tip));
    history.K_I.push_back(factors.K_I);
    history.K_II.push_back(factors.K_II);
    history.kink_angle.push_back(decisions[i].kink_angle);
    const double values[] = {history.length.back(), tips[i].position.x(), tips[i].position.y(),
                             factors.K_I,           factors.K_II,         decisions[i].kink_angle};
    std::copy(std::begin(values), std::end(values), row.begin() + static_cast<std::ptrdiff_t>(3 + 6 * tip));
    const int polygon = body.polygons.cracks[tip].tip_polygon;
    const material::Isotropic& material =
        body.materials[static_cast<std::size_t>(body.nodes.polygon(polygon).material)];
    release_rates[tip] =
        (factors.K_I * factors.K_I + factors.K_II * factors.K_II) / material::effective_modulus(material);
  }
  // The release over the last growth by the trapezoidal rule, beside what the potential energy has lost.
  double released = 0.0;
  bool all_there = growths_ > 0;
  for (std::size_t tip = 0; tip < tips_.size(); ++tip) {
    TipHistory& history = tips_[tip];
    all_there = all_there && (history.grown == 0.0 || release_rates[tip] >= 0.0);
    released += 0.5 * history.grown * (history.release_rate + release_rates[tip]);
    history.grown = 0.0;
    history.release_rate = release_rates[tip];
  }
  if (all_there && released > 0.0) {
    energy_release_ratios_.push_back((potential_energy_ - state.potential_energy()) / released);
  }
  potential_energy_ = state.potential_energy();
  load_factors_.push_back(load_factor);
  history_.add_row(row);
}

void GrowthRecord::add_growth(int tip, const Growth& growth) {
  TipHistory& history = tips_[static_cast<std::size_t>(tip)];
  history.grown += (growth.tip - history.path.back()).norm();
  history.path.push_back(growth.tip);
  ++growths_;
  if (growth.event == crack::TipEvent::advanced) return;
  events_.emplace_back(Quantity::Table{
      {"tip", tip}, {"growth", growths_}, {"event", event_words(growth)}, {"position", place(growth.tip)}});
}

void GrowthRecord::add_cut_through() {
  events_.emplace_back(Quantity::Table{{"growth", growths_}, {"event", "cut in two"}});
}

void GrowthRecord::refuse(int tip, const mesh::Point& from, const std::string& reason) {
  refusal_ = "tip " + std::to_string(tip) + " at (" + std::to_string(from.x()) + ", " + std::to_string(from.y()) +
             ") cannot be lengthened: " + reason;
  events_.emplace_back(
      Quantity::Table{{"tip", tip}, {"growth", growths_}, {"event", "refused: " + reason}, {"position", place(from)}});
}

void GrowthRecord::add_quantities(const std::string& end, results::RunSummary& summary) const {
  Quantity& quantities = summary.quantities;
  quantities["growths"] = growths_;
  if (!end.empty()) quantities["end"] = end;
  quantities["load_factors"] = Quantity(load_factors_);
  if (!load_factors_.empty()) quantities["peak_load_factor"] = *std::ranges::max_element(load_factors_);
  quantities["energy_release_ratios"] = Quantity(energy_release_ratios_);
  Quantity::List cracks, growth;
  std::size_t tip = 0;
  for (const scene::Crack& crack : scene_.cracks) {
    Quantity::List path;
    if (crack.inner) {
      const std::vector<mesh::Point>& first = tips_[tip].path;
      for (auto x = first.rbegin(); x + 1 != first.rend(); ++x) path.push_back(place(*x));
    }
    for (const mesh::Point& x : crack.path) path.push_back(place(x));
    const std::vector<mesh::Point>& last = tips_[tip + (crack.inner ? 1 : 0)].path;
    for (auto x = last.begin() + 1; x != last.end(); ++x) path.push_back(place(*x));
    cracks.emplace_back(Quantity::Table{{"path", std::move(path)}});
    tip += crack.inner ? 2 : 1;
  }
  for (const TipHistory& history : tips_) {
    growth.emplace_back(Quantity::Table{{"length", Quantity(history.length)},
                                        {"K_I", Quantity(history.K_I)},
                                        {"K_II", Quantity(history.K_II)},
                                        {"kink_angle", Quantity(history.kink_angle)}});
  }
  quantities["cracks"] = std::move(cracks);
  quantities["growth"] = std::move(growth);
  quantities["events"] = events_;
  summary.history = history_;
}

}  // namespace sunder::simulation
