// The tables of the dam's surroundings, of time and of output.
#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

Table<Reservoir> reservoir_table() {
  return {
      "reservoir",
      "[reservoir]",
      "water behind the dam; in a static scene every model is standing water up to `level`",
      {key(&Reservoir::boundary, {.name = "boundary", .meaning = "wet face; with `level`"}),
       key(&Reservoir::level, {.name = "level", .unit = "m", .meaning = "y of the free surface"}),
       key(&Reservoir::depth, {.name = "depth",
                               .unit = "m",
                               .range = positive(),
                               .meaning = "analysis = \"response\", instead of boundary and level"}),
       key(&Reservoir::density, {.name = "density", .unit = "kg/m³", .range = positive(), .meaning = "of water"}),
       key(&Reservoir::sound_speed, {.name = "sound_speed", .unit = "m/s", .range = positive(), .meaning = "in water"}),
       key(&Reservoir::reflection_coefficient,
           {.name = "reflection_coefficient", .range = between(0.0, 1.0), .meaning = "of the bottom; 1: rigid"}),
       choice(&Reservoir::model,
              Choices<ReservoirModel>{{"hydrostatic", ReservoirModel::hydrostatic},
                                      {"westergaard", ReservoirModel::westergaard},
                                      {"incompressible", ReservoirModel::incompressible},
                                      {"compressible", ReservoirModel::compressible}},
              {.name = "model", .meaning = "what of the water is present"}),
       key(&Reservoir::memory_tolerance,
           {.name = "memory_tolerance",
            .range = between(0.0, 0.1),
            .meaning =
                "of the compressible water: 0 is the exact convolution; above, as a share of its kernel's sum, a "
                "sum of exponentials whose cost a step does not grow with the run"})},
      [](const Node& node, Reservoir&, const std::string& path, Findings& findings) {
        const bool face = node.has("boundary") && node.has("level");
        const bool any = node.has("boundary") || node.has("level");
        if (node.has("depth") ? any : !face)
          findings.add(node.origin, path,
                       "accepted: `boundary` and `level`, or, with analysis = \"response\", `depth` alone");
      }};
}

Table<NearField> near_field_table() {
  const auto length = [](std::optional<double> NearField::*member, const char* name, const char* meaning,
                         const char* otherwise) {
    return key(member,
               {.name = name, .unit = "m", .range = positive(), .meaning = meaning, .default_value = otherwise});
  };
  return {"foundation.near_field",
          "near_field = { width, depth, size }",
          "block of polygons between the base and the unbounded rock",
          {length(&NearField::width, "width", "beside the base, on either side", "base / 4"),
           length(&NearField::depth, "depth", "of the block", "base / 4"),
           length(&NearField::size, "size", "of its polygons away from the base", "base / 8")}};
}

Table<Foundation> foundation_table(const std::shared_ptr<const Table<NearField>>& near_field) {
  return {
      "foundation",
      "[foundation]",
      "elastic ground below a boundary",
      {key(&Foundation::boundary, {.name = "boundary", .meaning = "on which the dam stands"}),
       key(&Foundation::youngs_modulus, {.name = "youngs_modulus",
                                         .unit = "Pa",
                                         .range = positive(),
                                         .required = true,
                                         .meaning = "Young's modulus E"}),
       key(&Foundation::poisson_ratio, {.name = "poisson_ratio",
                                        .range = {.low = 0.0, .high = 0.5, .high_open = true},
                                        .required = true,
                                        .meaning = "Poisson's ratio ν"}),
       key(&Foundation::density,
           {.name = "density", .unit = "kg/m³", .range = at_least(0.0), .required = true, .meaning = "0: massless"}),
       key(&Foundation::half_width, {.name = "half_width",
                                     .unit = "m",
                                     .range = positive(),
                                     .meaning = "analysis = \"response\": of the strip, or radius of the disc"}),
       choice(&Foundation::shape,
              Choices<FoundationShape>{{"strip", FoundationShape::strip}, {"disc", FoundationShape::disc}},
              {.name = "shape", .meaning = "analysis = \"response\": what moves"}),
       table_key(&Foundation::near_field, near_field,
                 {.name = "near_field", .meaning = "block of polygons below the base"})},
      {}};
}

Table<GroundMotion> ground_motion_table() {
  return {
      "ground_motion",
      "[ground_motion]",
      "the earthquake",
      {key(&GroundMotion::horizontal,
           {.name = "horizontal",
            .required = true,
            .meaning = "table of time [s] and acceleration [m/s²], or a PEER .at2 record; relative to the scene"}),
       key(&GroundMotion::vertical, {.name = "vertical", .meaning = "likewise"}),
       key(&GroundMotion::horizontal_scale, {.name = "horizontal_scale", .meaning = "-1 reverses the component"}),
       key(&GroundMotion::vertical_scale, {.name = "vertical_scale", .meaning = "likewise"}),
       choice(&GroundMotion::baseline, Choices<Baseline>{{"none", Baseline::none}, {"parabola", Baseline::parabola}},
              {.name = "baseline",
               .meaning = "correction of both components: \"parabola\" takes off the parabola in time that leaves "
                          "the least velocity of the ground"})}};
}

constexpr double most_steps = 1e7;  // a history of ten columns is 0.8 GB then

void check_dynamics(const Node& node, Dynamics& dynamics, const std::string& path, Findings& findings) {
  if (dynamics.duration < dynamics.time_step)
    findings.add(node.find("duration")->origin, path + ".duration",
                 shown(dynamics.duration) + " is shorter than one time step; accepted: at least time_step");
  if (dynamics.duration / dynamics.time_step > most_steps)
    findings.add(node.find("duration")->origin, path + ".duration",
                 shown(dynamics.duration) + " is " + shown(dynamics.duration / dynamics.time_step) +
                     " steps; accepted: at most " + shown(most_steps) + " steps of time_step");
  if (dynamics.damping_modes[0] > dynamics.damping_modes[1])
    findings.add(node.find("damping_modes")->origin, path + ".damping_modes", "accepted: modes in ascending order");
  const Integrator integrator = dynamics.integrator;
  const std::optional<double>& radius = dynamics.spectral_radius;
  if (integrator != Integrator::newmark && !radius) {
    const std::string name = integrator == Integrator::hht_alpha ? "hht-alpha" : "generalised-alpha";
    findings.add(node.origin, path + ".spectral_radius", "is missing; the " + name + " integrator needs it");
  }
  if (integrator == Integrator::newmark && radius)
    findings.add(node.find("spectral_radius")->origin, path + ".spectral_radius", "the newmark integrator has none");
  if (integrator == Integrator::hht_alpha && radius && *radius < 0.5)
    findings.add(node.find("spectral_radius")->origin, path + ".spectral_radius",
                 shown(*radius) + " is not accepted; accepted: a number 0.5 … 1 with the hht-alpha integrator");
}

/// Two modes, or one: twice the same then.
void read_damping_modes(const Node& node, Dynamics& dynamics, const Reading& reading) {
  std::array<int, 2>& modes = dynamics.damping_modes;
  if (node.kind == Node::Kind::integer) {
    read_value(node, modes[0], reading);
  } else {
    if (node.kind != Node::Kind::list || node.list.empty() || node.list.size() > 2)
      return reading.wrong(node, "a whole number or a list of one or two");
    read_value(node.list.front(), modes[0], reading.element(0));
    if (node.list.size() == 2) return read_value(node.list[1], modes[1], reading.element(1));
  }
  modes[1] = modes[0];
}

Table<Dynamics> dynamics_table() {
  return {"dynamics",
          "[dynamics]",
          "analysis = \"dynamic\": integration in time",
          {key(&Dynamics::time_step,
               {.name = "time_step", .unit = "s", .range = positive(), .required = true, .meaning = "time step"}),
           key(&Dynamics::duration,
               {.name = "duration", .unit = "s", .range = positive(), .required = true, .meaning = "of the history"}),
           choice(&Dynamics::integrator,
                  Choices<Integrator>{{"newmark", Integrator::newmark},
                                      {"hht-alpha", Integrator::hht_alpha},
                                      {"generalised-alpha", Integrator::generalised_alpha}},
                  {.name = "integrator", .meaning = "time integrator"}),
           key(&Dynamics::spectral_radius, {.name = "spectral_radius",
                                            .range = between(0.0, 1.0),
                                            .meaning = "at infinite frequency, of the alpha integrators, which need "
                                                       "it; hht-alpha: 0.5 … 1"}),
           key(&Dynamics::damping_ratio, {.name = "damping_ratio",
                                          .range = {.low = 0.0, .high = 1.0, .high_open = true},
                                          .meaning = "Rayleigh damping, matched at damping_modes"}),
           Key<Dynamics>{{.name = "damping_modes",
                          .range = at_least(1),
                          .meaning = "counted from 1, ascending; one alone: damping proportional to the stiffness",
                          .default_value = "[1, 2]"},
                         "whole number, or list of one or two",
                         read_damping_modes}},
          check_dynamics};
}

Table<Response> response_table() {
  return {"response",
          "[response]",
          "analysis = \"response\": an unbounded domain alone",
          {key(&Response::frequencies,
               {.name = "frequencies", .unit = "rad/s", .range = at_least(0.0), .meaning = "samples in frequency"}),
           key(&Response::times, {.name = "times",
                                  .unit = "s",
                                  .range = at_least(0.0),
                                  .meaning = "samples of the acceleration unit-impulse response"}),
           key(&Response::face_elements, {.name = "face_elements",
                                          .range = at_least(1),
                                          .meaning = "of the face; absent: the analytic path where there is one"}),
           key(&Response::face_order, {.name = "face_order", .range = between(1, 64), .meaning = "order of each"})},
          [](const Node& node, Response& response, const std::string& path, Findings& findings) {
            if (response.frequencies.empty() && response.times.empty())
              findings.add(node.origin, path, "asks for nothing; accepted: `frequencies`, `times` or both");
          }};
}

Table<Output> output_table() {
  return {"output",
          "[output]",
          "fields for pictures in results.h5 (a static analysis has one snapshot, modal one a mode); absent: the "
          "summary and "
          "the history only",
          {key(&Output::fields_every,
               {.name = "fields_every", .range = at_least(0), .meaning = "steps between field snapshots; 0: none"}),
           key(&Output::profile_times, {.name = "profile_times",
                                        .unit = "s",
                                        .meaning = "analysis = \"dynamic\": pressure and opening along the cracks at "
                                                   "the steps nearest to these"}),
           key(&Output::checkpoint_every,
               {.name = "checkpoint_every",
                .range = at_least(0),
                .meaning = "analysis = \"dynamic\" without fields: steps between checkpoints, from which "
                           "`sunder run --resume` goes on to the same bits; 0: none"})}};
}

}  // namespace

std::vector<Part> shaking_parts() {
  const auto near_field = std::make_shared<const Table<NearField>>(near_field_table());
  return {one_part<Reservoir>(&Scene::reservoir, reservoir_table()),
          one_part<Foundation>(&Scene::foundation, foundation_table(near_field), {reference_of(*near_field)}),
          one_part<GroundMotion>(&Scene::ground_motion, ground_motion_table()),
          one_part<Dynamics>(&Scene::dynamics, dynamics_table()),
          one_part<Response>(&Scene::response, response_table()),
          one_part<Output>(&Scene::output, output_table())};
}

}  // namespace sunder::scene
