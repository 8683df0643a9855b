#pragma once
/// An unbounded medium (reservoir, foundation) attached to the body's faces, as the step in time visits it.

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/convolution/convolution.hpp"
#include "solver/numerics/meter.hpp"
#include "solver/numerics/thread_pool.hpp"
#include "solver/scene/scene.hpp"
#include "solver/simulation/body.hpp"
#include "solver/simulation/ledger.hpp"

namespace sunder::simulation {

/// Which acceleration of its degrees of freedom a medium answers to.
enum class DrivenBy {
  total,     ///< relative to inertial space, ground motion included: water
  relative,  ///< relative to the free field: ground
};

struct AttachedMedium {
  std::string name;       ///< the part: "reservoir", "foundation"
  std::vector<int> dofs;  ///< (n) of the body, 2·node + component, ascending; R acts on the medium, the body feels -R
  std::unique_ptr<convolution::Convolution> convolution;
  DrivenBy driven_by = DrivenBy::total;
  std::string worker = {};                 ///< the part that works in each step: "convolution" where there is a history
  mutable numerics::Meter work = {};       ///< of the convolution in each step; a constant medium is metered too
  std::vector<std::string> warnings = {};  ///< words for the run's summary
  std::optional<double> memory_error = {};  ///< stated, of the kernel's sum; absent where the convolution is exact
};

/// Steps of equal length: a medium's convolution holds the weights of `steps` of them.
struct StepPlan {
  double time_step = 0.0;  ///< [s], > 0
  long long steps = 0;     ///< >= 0; 0: only the instantaneous mass is asked for
};

/// The water of the scene's [reservoir] on its boundary: x of every node whose edge is wet. `hydrostatic` moves no
/// water and has no medium: nullptr. `westergaard` and `incompressible` are an instantaneous mass without history.
/// Throws scene::SceneError at [reservoir] where the face is not one vertical line or the level is not on it.
[[nodiscard]] std::unique_ptr<AttachedMedium> attach_reservoir(const scene::Scene& scene, const Body& body,
                                                               const StepPlan& plan, numerics::ThreadPool& pool,
                                                               Ledger& ledger);

/// w (n), in the order of that medium's dofs: the pressure that its forces R make at a height of the face is w · R
/// [Pa], beside the pressure at rest. Zero above the level. Throws as `attach_reservoir`.
[[nodiscard]] Eigen::VectorXd reservoir_pressure_weights(const scene::Scene& scene, const Body& body, double height);

}  // namespace sunder::simulation
