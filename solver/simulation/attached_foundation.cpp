#include "solver/simulation/attached_foundation.hpp"

#include <algorithm>
#include <numeric>

#include "solver/convolution/make_convolution.hpp"
#include "solver/foundation/rock_weights.hpp"
#include "solver/simulation/built_parts.hpp"
#include "solver/simulation/foundation_line.hpp"
#include "solver/simulation/response_cache.hpp"

namespace sunder::simulation {

const bool built::foundation = true;

namespace {

using Eigen::Index;

/// Everything the weights depend on. The program's own numerics are in the words: change them with the method.
CacheKey key_of(const FoundationLine& line, const material::Isotropic& rock, const StepPlan& plan,
                const foundation::RockWeightOptions& options) {
  CacheKey key("half-plane, plane strain, trapezoidal quadrature, 1");
  key.add(line.boundary.nodes);
  for (const int order : line.boundary.orders) key.add(static_cast<long long>(order));
  for (const double value : {rock.youngs_modulus, rock.poisson_ratio, rock.density, plan.time_step}) key.add(value);
  key.add(plan.steps);
  key.add(options.stiffness.tolerance);
  key.add(static_cast<long long>(options.oversampling));
  return key;
}

struct Found {
  convolution::WeightSequence weights;
  std::vector<std::string> warnings;
  std::string failure;
};

Found weights_of(const FoundationLine& line, const material::Isotropic& rock, const StepPlan& plan,
                 const std::filesystem::path& cache, numerics::ThreadPool& pool, Ledger& ledger) {
  const foundation::RockWeightOptions options{.pool = &pool};
  const CacheKey key = key_of(line, rock, plan, options);
  Found found;
  if (!cache.empty()) {
    CachedWeights cached = read_weights(cache, key);
    if (cached.weights) {
      ledger.count("foundation_cache_hits");
      found.weights = std::move(*cached.weights);
      return found;
    }
    if (!cached.fault.empty()) found.warnings.push_back("foundation cache: " + cached.fault + "; it was built anew");
  }
  foundation::RockWeights made = foundation::rock_weights(rock_beyond(line, rock), plan.time_step, plan.steps, options);
  ledger.count("stiffness_steps", made.path.steps + made.path.rejected);
  if (made.path.status != foundation::StiffnessStatus::converged) {
    found.failure = "the stiffness of the unbounded rock did not come out; use larger or more even foundation elements";
    return found;
  }
  found.weights = std::move(made.weights);
  if (!cache.empty()) {
    const std::string fault = write_weights(cache, key, found.weights);
    if (!fault.empty()) found.warnings.push_back("foundation cache: not written: " + fault);
  }
  return found;
}

/// -W * k + t_ff at the end of every step.
Eigen::MatrixXd wave_load(const foundation::FreeField& field, const convolution::WeightSequence& weights,
                          const StepPlan& plan, numerics::ThreadPool& pool) {
  const Index n = weights.size;
  const convolution::MadeConvolution made = convolution::make_convolution(weights, plan.steps, {.pool = &pool});
  convolution::Convolution& rock = *made.convolution;
  Eigen::MatrixXd load(n, plan.steps + 1);
  Eigen::VectorXd difference(n), history(n), pull(n);
  for (long long step = 0; step <= plan.steps; ++step) {
    field.at(static_cast<int>(step), difference, pull);
    const Eigen::Vector2d surface = field.surface(static_cast<int>(step));
    for (Index i = 0; i < n; i += 2) difference.segment<2>(i) = surface - difference.segment<2>(i);
    rock.history_force(history);
    load.col(step) = pull - history;
    load.col(step).noalias() -= rock.instantaneous_mass() * difference;
    rock.append(difference);
  }
  return load;
}

/// Places of the line's degrees of freedom in ascending order of the body's.
std::vector<int> ascending_order(const std::vector<int>& dofs) {
  std::vector<int> order(dofs.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return dofs[a] < dofs[b]; });
  return order;
}

void reorder(convolution::WeightSequence& weights, const std::vector<int>& order) {
  for (Index j = 0; j < weights.values.cols(); ++j) {
    const Eigen::MatrixXd reordered = weights.dense(j)(order, order);
    weights.values.col(j) = reordered.reshaped();
  }
}

}  // namespace

AttachedFoundation attach_foundation(const Body& body, const SurfaceMotion& motion, const StepPlan& plan,
                                     const std::filesystem::path& cache, numerics::ThreadPool& pool, Ledger& ledger) {
  AttachedFoundation attached;
  const material::Isotropic& rock = body.materials[body.rock];
  if (rock.density == 0.0) return attached;
  Ledger::Visit visit(ledger, "foundation", "response");
  const FoundationLine line = foundation_line(body);
  Found found = weights_of(line, rock, plan, cache, pool, ledger);
  attached.failure = std::move(found.failure);
  if (!attached.failure.empty()) return attached;
  const int n = found.weights.size;
  visit.add_entries(found.weights.values.size());

  const foundation::FreeField field(line.boundary, rock, {motion.horizontal, motion.step},
                                    {motion.vertical, motion.step}, plan.time_step);
  RisingWave& wave = attached.wave;
  wave.delay = field.delay();
  const std::vector<int> order = ascending_order(line.dofs);
  for (const int place : order) wave.dofs.push_back(line.dofs[place]);
  wave.surface.resize(2, plan.steps + 1);
  for (long long step = 0; step <= plan.steps; ++step) wave.surface.col(step) = field.surface(static_cast<int>(step));
  const bool moves = !motion.horizontal.empty() || !motion.vertical.empty();
  const Eigen::MatrixXd load =
      moves ? wave_load(field, found.weights, plan, pool) : Eigen::MatrixXd::Zero(n, plan.steps + 1);
  wave.load = load(order, Eigen::all);
  reorder(found.weights, order);

  attached.medium = std::make_unique<AttachedMedium>();
  attached.medium->name = "foundation";
  attached.medium->dofs = wave.dofs;
  attached.medium->convolution =
      convolution::make_convolution(std::move(found.weights), plan.steps, {.pool = &pool}).convolution;
  attached.medium->driven_by = DrivenBy::relative;
  attached.medium->worker = "convolution";
  attached.medium->warnings = std::move(found.warnings);
  return attached;
}

}  // namespace sunder::simulation
