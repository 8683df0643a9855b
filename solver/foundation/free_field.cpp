#include "solver/foundation/free_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "solver/numerics/planted_fault.hpp"
#include "solver/numerics/quadrature.hpp"
#include "solver/sbfem/edge_element.hpp"

namespace sunder::foundation {

SampledMotion::SampledMotion(std::vector<double> acceleration, double step)
    : acceleration_(std::move(acceleration)), velocity_(acceleration_.size(), 0.0), step_(step) {
  if (!(step > 0.0)) throw std::invalid_argument("step of a motion = " + std::to_string(step) + " s, accepted is > 0");
  for (std::size_t i = 0; i < acceleration_.size(); ++i) {
    if (!std::isfinite(acceleration_[i]))
      throw std::invalid_argument("sample " + std::to_string(i) + " of a motion is not finite");
    if (i > 0) velocity_[i] = velocity_[i - 1] + 0.5 * step_ * (acceleration_[i - 1] + acceleration_[i]);
  }
}

double SampledMotion::acceleration(double t) const {
  const double place = t / step_, last = static_cast<double>(acceleration_.size()) - 1.0;
  if (!(place >= 0.0 && place <= last)) return 0.0;
  const auto i = static_cast<std::size_t>(std::min(place, std::max(last - 1.0, 0.0)));
  if (acceleration_.size() == 1) return acceleration_[0];
  const double part = place - static_cast<double>(i);
  return acceleration_[i] + part * (acceleration_[i + 1] - acceleration_[i]);
}

double SampledMotion::velocity(double t) const {
  const double place = t / step_, last = static_cast<double>(acceleration_.size()) - 1.0;
  if (!(place > 0.0) || acceleration_.size() < 2) return 0.0;
  if (place >= last) return velocity_.back();
  const auto i = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(i);
  return velocity_[i] + step_ * part * (acceleration_[i] + 0.5 * part * (acceleration_[i + 1] - acceleration_[i]));
}

FreeField::FreeField(const sbfem::Boundary& line, const material::Isotropic& rock, SampledMotion horizontal,
                     SampledMotion vertical, double time_step)
    : depths_(-line.nodes.row(1).transpose()),
      horizontal_(std::move(horizontal)),
      vertical_(std::move(vertical)),
      time_step_(time_step) {
  material::check(rock);
  if (!(rock.density > 0.0)) throw std::invalid_argument("density of the rock = 0, accepted is > 0: no wave travels");
  if (!(time_step > 0.0)) throw std::invalid_argument("time_step must be > 0");
  if (!(depths_.minCoeff() >= 0.0)) throw std::invalid_argument("the line of the rock lies above the free surface");
  c_s_ = material::shear_wave_speed(rock);
  c_p_ = material::longitudinal_wave_speed(rock);
  impedance_s_ = rock.density * c_s_;
  impedance_p_ = rock.density * c_p_;
  lateral_ = rock.poisson_ratio / (1.0 - rock.poisson_ratio);
  delay_ = static_cast<int>(std::ceil(depths_.maxCoeff() / c_s_ / time_step * (1.0 - 1e-12)));

  for (const sbfem::EdgeElement& edge : sbfem::edge_elements(line)) {
    const numerics::QuadratureRule gauss = numerics::gauss_legendre(edge.order() + 3);
    for (Eigen::Index q = 0; q < gauss.points.size(); ++q) {
      const sbfem::EdgePoint place = sbfem::at(edge, gauss.points[q]);
      // Counter-clockwise seen from inside: the normal out of the rock inside is the tangent turned by -90°.
      points_.push_back({.depth = -place.position.y(),
                         .nodes = {edge.nodes.begin(), edge.nodes.end()},
                         .normal_x = gauss.weights[q] * place.tangent.y() * place.shape,
                         .normal_y = -gauss.weights[q] * place.tangent.x() * place.shape});
    }
  }
}

Eigen::Vector2d FreeField::surface(int n) const {
  const double t = (n - delay_) * time_step_;
  return {horizontal_.acceleration(t), vertical_.acceleration(t)};
}

void FreeField::at(int n, Eigen::Ref<Eigen::VectorXd> acceleration, Eigen::Ref<Eigen::VectorXd> force) const {
  const bool rising_only = numerics::planted_fault("foundation/rising-wave-only");
  const double t = (n - delay_) * time_step_;
  const auto motion = [&](const SampledMotion& a, double travel) {
    return 0.5 * (a.acceleration(t + travel) + (rising_only ? 0.0 : a.acceleration(t - travel)));
  };
  for (Eigen::Index i = 0; i < depths_.size(); ++i) {
    acceleration[2 * i] = motion(horizontal_, depths_[i] / c_s_);
    acceleration[2 * i + 1] = motion(vertical_, depths_[i] / c_p_);
  }
  force.setZero();
  if (numerics::planted_fault("foundation/free-field-traction")) return;
  for (const Point& point : points_) {
    const double s = point.depth / c_s_, p = point.depth / c_p_;
    const double shear = -0.5 * impedance_s_ * (horizontal_.velocity(t + s) - horizontal_.velocity(t - s));
    const double upright = -0.5 * impedance_p_ * (vertical_.velocity(t + p) - vertical_.velocity(t - p));
    for (std::size_t j = 0; j < point.nodes.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      force[2 * point.nodes[j]] += lateral_ * upright * point.normal_x[i] + shear * point.normal_y[i];
      force[2 * point.nodes[j] + 1] += shear * point.normal_x[i] + upright * point.normal_y[i];
    }
  }
}

}  // namespace sunder::foundation
