// Growth at rest: the loads of the scene are scaled so that the crack which is driven hardest just grows.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "solver/crack/body.hpp"
#include "solver/fracture/propagation.hpp"
#include "solver/scene/scene_error.hpp"
#include "solver/simulation/analyses.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/growth_record.hpp"
#include "solver/simulation/static_state.hpp"
#include "solver/simulation/tips.hpp"

namespace sunder::simulation {
namespace {

using fracture::GrowthDecision;

/// A body at rest under the scene's loads, with what each living tip would do.
struct Equilibrium {
  Body body;
  sbfem::Formation formation;
  Supports supports{.constraints = Constraints(0), .dofs = {}};
  StaticState state;
  std::vector<TipResult> tips;
  std::vector<GrowthDecision> decisions;  ///< one for each of `tips`
  double largest_factor = 0.0;            ///< K_eq of the tip that is driven hardest [Pa √m]

  bool solved() const { return state.solution.status == numerics::FactorStatus::factorised; }
};

/// `notch_lengths`: of each crack while it is still a notch.
void solve(const scene::Scene& scene, const fracture::PropagationLaw& law, const std::vector<double>& notch_lengths,
           numerics::ThreadPool& pool, Ledger& ledger, Equilibrium& now,
           const std::optional<EarlierLoads>& earlier = {}) {
  now.supports = supports_of(scene, now.body, true);
  now.state = static_state(scene, now.body, now.formation, now.supports, pool, ledger, earlier);
  if (!now.solved()) return;
  const Ledger::Visit visit(ledger, "fracture", "tips");
  now.tips = tip_results(scene, now.body, now.formation, now.state.solution.displacement);
  for (const TipResult& tip : now.tips) {
    const bool sawn = crack_length(now.body.polygons, tip.tip) <= notch_lengths[static_cast<std::size_t>(tip.tip)];
    GrowthDecision decision;
    if (tip.status == fracture::TipStatus::ready) {
      const fracture::Faces faces = sawn ? fracture::Faces::apart : fracture::Faces::as_K_I_says;
      decision = fracture::decide_growth(tip.state.factors, faces, law);
    }
    now.largest_factor = std::max(now.largest_factor, decision.equivalent_factor);
    now.decisions.push_back(decision);
  }
}

fracture::PropagationLaw law_of(const scene::Scene& scene, const Body& body) {
  const scene::Propagation& wanted = *scene.propagation;
  const double size = crack::body_size(body.polygons);
  if (wanted.increment >= size) {  // the scene's own check knows no mesh files
    throw scene::SceneError(scene::place_of(scene, "propagation") + "increment: " + std::to_string(wanted.increment) +
                            " m is larger than the body; accepted: a number < " + std::to_string(size) + " [m]");
  }
  return {.fracture_toughness = wanted.fracture_toughness, .increment = wanted.increment};
}

/// Lengthens every tip that is driven nearly as hard as the hardest, in their order. False where one was refused.
bool grow_tips(const Equilibrium& from, const fracture::PropagationLaw& law, double together,
               numerics::ThreadPool& pool, Ledger& ledger, Equilibrium& to, std::vector<int>& same,
               GrowthRecord& record) {
  const int parts = part_count(from.body.nodes);
  to.body = from.body;
  to.formation = from.formation;
  same.resize(static_cast<std::size_t>(from.body.nodes.polygon_count()));
  for (std::size_t i = 0; i < same.size(); ++i) same[i] = static_cast<int>(i);
  for (std::size_t t = 0; t < from.tips.size(); ++t) {
    const GrowthDecision& decision = from.decisions[t];
    if (decision.equivalent_factor < together * from.largest_factor) continue;
    const int tip = from.tips[t].tip;
    if (to.body.polygons.cracks[static_cast<std::size_t>(tip)].tip_polygon < 0) continue;
    const mesh::Point target = fracture::next_tip(from.tips[t].position, tip_direction(to.body.polygons, tip),
                                                  decision.kink_angle, law.increment);
    const Ledger::Visit visit(ledger, "crack", "growth");
    Growth growth = grow(to.body, to.formation, tip, target, &pool);
    ledger.count("growths");
    if (growth.event == crack::TipEvent::refused) {
      record.refuse(tip, from.tips[t].position, growth.reason);
      return false;
    }
    std::vector<int> composed(growth.same.size(), -1);
    for (std::size_t i = 0; i < composed.size(); ++i) {
      if (growth.same[i] >= 0) composed[i] = same[static_cast<std::size_t>(growth.same[i])];
    }
    same = std::move(composed);
    ledger.count("polygons formed again", std::count(growth.same.begin(), growth.same.end(), -1));
    record.add_growth(tip, growth);
    to.body = std::move(growth.body);
    to.formation = std::move(growth.formation);
  }
  if (part_count(to.body.nodes) > parts) record.add_cut_through();
  return true;
}

/// Why the run ends here; empty where it goes on.
std::string end_of(const scene::Scene& scene, const Equilibrium& now, int step) {
  const scene::Propagation& wanted = *scene.propagation;
  if (now.tips.empty()) return "no tip left";
  if (step >= wanted.steps) return "steps";
  if (wanted.until_length) {
    for (const TipResult& tip : now.tips) {
      // As many increments as make the length, round-off or not.
      if (crack_length(now.body.polygons, tip.tip) >= (1.0 - 1e-9) * *wanted.until_length) return "until_length";
    }
  }
  return {};
}

}  // namespace

void run_propagation(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
                     Ledger& ledger, results::RunSummary& summary) {
  const fracture::PropagationLaw law = law_of(scene, body);
  static_cast<void>(supports_of(scene, body, false));  // refuses a body that floats from the beginning
  std::vector<double> notch_lengths(body.polygons.cracks.size(), 0.0);
  for (std::size_t tip = 0; tip < notch_lengths.size() && scene.propagation->notches; ++tip) {
    notch_lengths[tip] = (1.0 + 1e-9) * crack_length(body.polygons, static_cast<int>(tip));
  }
  GrowthRecord record(scene, body);
  Equilibrium now;
  now.body = body;
  {
    const Ledger::Visit visit(ledger, "sbfem", "polygons");
    now.formation = sbfem::form(body.nodes, body.materials, {.pool = &pool});
  }
  solve(scene, law, notch_lengths, pool, ledger, now);
  std::string end;
  for (int step = 0; now.solved(); ++step) {
    record.add_state(now.body, now.state, now.tips, now.decisions,
                     now.largest_factor > 0.0 ? law.fracture_toughness / now.largest_factor
                                              : std::numeric_limits<double>::infinity());
    end = end_of(scene, now, step);
    if (!end.empty()) break;
    if (options.stop != nullptr && options.stop->load()) {
      summary.status = "stopped: interrupted after " + std::to_string(step) + " growths";
      break;
    }
    if (!(now.largest_factor > 0.0)) {
      summary.status = "stopped: no crack opens under these loads: K_I is negative at every tip after " +
                       std::to_string(step) + " growths";
      break;
    }
    if (options.progress) options.progress("growth", static_cast<double>(step) / scene.propagation->steps);
    Equilibrium next;
    std::vector<int> same;
    if (!grow_tips(now, law, scene.propagation->together, pool, ledger, next, same, record)) {
      summary.status = "stopped: " + record.refusal() + " after " + std::to_string(step) + " growths";
      break;
    }
    if (!free_motions(next.body.nodes, supports_of(scene, next.body, true).constraints).empty()) {
      end = "cut in two";  // one part floats: there is no equilibrium to ask for any more
      break;
    }
    solve(scene, law, notch_lengths, pool, ledger, next, EarlierLoads{now.state.interior, same});
    now = std::move(next);
  }
  if (!now.solved()) summary.status = stopping_reason(now.body, now.state.solution);
  if (now.solved()) add_static_quantities(scene, now.body, now.formation, now.supports, now.state, ledger, summary);
  record.add_quantities(end, summary);
  summary.mesh = {
      .polygons = now.body.nodes.polygon_count(), .nodes = now.body.nodes.node_count(), .dofs = now.body.dofs()};
  if (options.final_body) options.final_body(now.body);
}

}  // namespace sunder::simulation
