#include "solver/simulation/reservoir_response.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

#include "solver/numerics/planted_fault.hpp"
#include "solver/reservoir/added_mass.hpp"
#include "solver/reservoir/face_impulse.hpp"
#include "solver/reservoir/face_water.hpp"
#include "solver/reservoir/rigid_face.hpp"
#include "solver/scene/scene_error.hpp"

namespace sunder::simulation {
namespace {

using Complex = std::complex<double>;
using results::Quantity;

Quantity pair(Complex z) {
  return Quantity::List{z.real(), z.imag()};
}

/// Force and base pressure of a rigid face at one frequency; nothing where they are infinite.
struct Sample {
  Complex force, base_pressure;
  bool infinite = false;
};

/// What the response is asked of.
class RigidFaceWater {
 public:
  explicit RigidFaceWater(const scene::Scene& scene)
      : scene_(scene),
        water_{.density = scene.reservoir->density,
               .sound_speed = scene.reservoir->sound_speed,
               .reflection_coefficient = scene.reservoir->reflection_coefficient},
        depth_(*scene.reservoir->depth) {
    reservoir::check(water_);
    if (!scene.response->face_elements) return;
    face_ = reservoir::uniform_face(depth_, *scene.response->face_elements, scene.response->face_order);
    if (scene.reservoir->model == scene::ReservoirModel::compressible)
      modes_ = reservoir::face_modes(reservoir::pressure_mesh(face_, depth_), water_);
  }

  Sample at(double omega) const {
    switch (scene_.reservoir->model) {
      case scene::ReservoirModel::hydrostatic:
        break;
      case scene::ReservoirModel::westergaard:
        return at_once(7.0 / 12.0, 7.0 / 8.0);
      case scene::ReservoirModel::incompressible:
        return series(0.0, 0.0);
      case scene::ReservoirModel::compressible:
        if (scene_.response->face_elements) return discretised(omega);
        return series(omega * depth_ / water_.sound_speed, reservoir::bottom_damping(water_));
    }
    return at_once(0.0, 0.0);
  }

  Quantity impulse(const std::vector<double>& times) const {
    const double crossing = depth_ / water_.sound_speed;
    if (scene_.response->face_elements) {
      std::vector<double> force = reservoir::face_impulse(modes_, times);
      for (double& f : force) f /= water_.density * water_.sound_speed * depth_;
      return Quantity(force);
    }
    std::vector<double> force;
    for (const double t : times) {
      const double damping = reservoir::bottom_damping(water_);
      if (damping > 0.0 && t > crossing && !numerics::planted_fault("simulation/closed-form-beyond-its-time"))
        throw scene::SceneError(scene::place_of(scene_, "response") + "times: " + std::to_string(t) +
                                " s; over an absorbing bottom there is a closed form up to depth / sound_speed = " +
                                std::to_string(crossing) + " s only; accepted: times up to that, or face_elements");
      force.push_back(damping > 0.0 ? reservoir::absorbing_face_impulse(t / crossing, damping)
                                    : reservoir::rigid_face_impulse(t / crossing));
    }
    return Quantity(force);
  }

 private:
  Sample at_once(double force, double base_pressure) const {
    if (!scene_.response->face_elements) return {force, base_pressure};
    const Eigen::MatrixXd mass = reservoir::westergaard_mass(face_, depth_, water_.density);
    return {mass.sum() / (water_.density * depth_ * depth_), base_pressure};
  }

  Sample series(double kappa, double damping) const {
    const reservoir::RigidFaceResponse response = reservoir::rigid_face_response(kappa, damping);
    if (response.status == reservoir::SeriesStatus::root_not_found)
      throw scene::SceneError(scene::place_of(scene_, "response") +
                              "frequencies: no eigenvalue of the depth was found at omega H / c = " +
                              std::to_string(kappa) + "; accepted: lower frequencies, or face_elements");
    Sample sample{response.force, response.base_pressure, response.status == reservoir::SeriesStatus::infinite};
    if (scene_.response->face_elements)  // incompressible
      sample.force =
          reservoir::incompressible_mass(face_, depth_, water_.density).sum() / (water_.density * depth_ * depth_);
    return sample;
  }

  Sample discretised(double omega) const {
    const reservoir::FaceResponse response = reservoir::face_response(modes_, Complex(0.0, omega));
    if (response.infinite) return {0.0, 0.0, true};
    return {response.mass.sum() / (water_.density * depth_ * depth_),
            response.pressure.row(0).sum() / (water_.density * depth_)};
  }

  const scene::Scene& scene_;
  reservoir::Water water_;
  double depth_;
  reservoir::Face face_;
  reservoir::FaceModes modes_;
};

}  // namespace

void add_reservoir_response(const scene::Scene& scene, Ledger& ledger, results::RunSummary& summary) {
  Ledger::Visit visit(ledger, "reservoir", "response");
  const scene::Response& wanted = *scene.response;
  const bool compressible = scene.reservoir->model == scene::ReservoirModel::compressible;
  if (scene.reservoir->model == scene::ReservoirModel::hydrostatic)
    throw scene::SceneError(scene::place_of(scene, "reservoir") +
                            "model: \"hydrostatic\" does not answer to motion; accepted: westergaard, incompressible, "
                            "compressible");
  if (!compressible && !wanted.times.empty())
    throw scene::SceneError(scene::place_of(scene, "response") +
                            "times: this reservoir answers at once, its impulse response is a mass times an impulse; "
                            "accepted: model = \"compressible\"");
  try {
    const RigidFaceWater water(scene);
    Quantity::List force, base_pressure;
    for (const double omega : wanted.frequencies) {
      const Sample sample = water.at(omega);
      if (sample.infinite) {
        summary.status = "stopped: the response is infinite at " + std::to_string(omega) +
                         " rad/s, a natural frequency of the reservoir with a rigid bottom";
        return;
      }
      force.push_back(pair(sample.force));
      base_pressure.push_back(pair(sample.base_pressure));
    }
    if (!wanted.frequencies.empty()) {
      summary.quantities["force"] = std::move(force);
      summary.quantities["base_pressure"] = std::move(base_pressure);
    }
    if (!wanted.times.empty()) summary.quantities["impulse_force"] = water.impulse(wanted.times);
  } catch (const std::invalid_argument& error) {
    throw scene::SceneError(scene::place_of(scene, "response") + error.what());
  }
}

}  // namespace sunder::simulation
