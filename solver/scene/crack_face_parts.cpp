// The tables of what acts on crack faces, and of the crack with a given motion.
#include <cmath>

#include "solver/scene/parts.hpp"

namespace sunder::scene {
namespace {

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

Table<Fracture> fracture_table() {
  using fracture::Extraction;
  return {"fracture",
          "[fracture]",
          "how the numbers at crack tips are read",
          {choice(&Fracture::extraction,
                  Choices<Extraction>{{"reciprocity", Extraction::reciprocity},
                                      {"energy-projection", Extraction::energy_projection},
                                      {"crack-opening-displacement", Extraction::crack_opening_displacement},
                                      {"m-integral", Extraction::m_integral},
                                      {"pointwise-stress", Extraction::pointwise_stress}},
                  {.name = "extraction", .meaning = "of K_I and K_II; all but the last converge alike"})}};
}
Table<Contact> contact_table() {
  return {"contact",
          "[contact]",
          "crack faces that touch; absent: they may interpenetrate",
          {choice(&Contact::model,
                  Choices<ContactModel>{{"penalty", ContactModel::penalty}, {"exact", ContactModel::exact}},
                  {.name = "model", .meaning = "springs that stiffen, or complementarity on the condensed faces"}),
           key(&Contact::initial_stiffness,
               {.name = "initial_stiffness", .unit = "N/m³", .range = positive(), .meaning = "first penalty"}),
           key(&Contact::growth_factor, {.name = "growth_factor",
                                         .range = {.low = 1.0, .low_open = true},
                                         .meaning = "of the penalty, until the penetration is within its tolerance"}),
           key(&Contact::penetration_tolerance, {.name = "penetration_tolerance",
                                                 .unit = "m",
                                                 .range = positive(),
                                                 .meaning = "largest penetration accepted"}),
           key(&Contact::friction_coefficient, {.name = "friction_coefficient",
                                                .range = at_least(0.0),
                                                .meaning = "Coulomb, with the memory of where the faces stuck"})}};
}

Table<CrackWater> crack_water_table() {
  return {
      "crack_water",
      "[crack_water]",
      "water in the cracks, from the reservoir; at rest both models are the hydrostatic pressure of the mouth; absent: "
      "dry",
      {choice(&CrackWater::model,
              Choices<CrackWaterModel>{{"uniform", CrackWaterModel::uniform}, {"moving", CrackWaterModel::moving}},
              {.name = "model", .meaning = "the mouth's pressure along the crack, or flow with cavitation"}),
       key(&CrackWater::minimum_aperture, {.name = "minimum_aperture",
                                           .unit = "m",
                                           .range = positive(),
                                           .meaning = "a rough crack never closes fully"}),
       choice(&CrackWater::aperture,
              Choices<ApertureRule>{{"larger", ApertureRule::larger}, {"sum", ApertureRule::sum}},
              {.name = "aperture", .meaning = "the water's gap: larger or sum of opening (≥ 0) and minimum_aperture"}),
       key(&CrackWater::relative_roughness,
           {.name = "relative_roughness", .range = {.low = 0.0, .high = 0.5, .low_open = true}, .meaning = "k / (2w)"}),
       key(&CrackWater::density, {.name = "density", .unit = "kg/m³", .range = positive(), .meaning = "of water"}),
       key(&CrackWater::dynamic_viscosity,
           {.name = "dynamic_viscosity", .unit = "Pa s", .range = positive(), .meaning = "of water"})}};
}

Table<Propagation> propagation_table() {
  return {
      "propagation",
      "[propagation]",
      "cracks that grow; absent: they keep their length",
      {key(&Propagation::fracture_toughness,
           {.name = "fracture_toughness", .unit = "Pa √m", .range = positive(), .required = true, .meaning = "K_IC"}),
       key(&Propagation::increment,
           {.name = "increment", .unit = "m", .range = positive(), .meaning = "length of one growth"}),
       choice(&Propagation::criterion,
              Choices<PropagationCriterion>{{"max-hoop-stress", PropagationCriterion::max_hoop_stress}},
              {.name = "criterion", .meaning = "direction of growth"}),
       choice(&Propagation::per_step,
              Choices<fracture::GrowthPerStep>{{"one-increment", fracture::GrowthPerStep::one_increment},
                                               {"until-arrest", fracture::GrowthPerStep::until_arrest}},
              {.name = "per_step", .meaning = "in time: growth of a tip in one time step"}),
       key(&Propagation::max_speed,
           {.name = "max_speed", .unit = "m/s", .range = positive(), .meaning = "in time: of a tip"}),
       key(&Propagation::notches,
           {.name = "notches", .meaning = "at rest: the cracks as given are sawn, their faces never meet"}),
       key(&Propagation::steps,
           {.name = "steps", .range = between(1, 100000), .meaning = "at rest: growths before the run ends"}),
       key(&Propagation::until_length, {.name = "until_length",
                                        .unit = "m",
                                        .range = positive(),
                                        .meaning = "at rest: end once a crack is as long"}),
       key(&Propagation::together, {.name = "together",
                                    .range = {.low = 0.0, .high = 1.0, .low_open = true},
                                    .meaning = "at rest: tips with this share of the largest K_eq grow at once"})}};
}

std::shared_ptr<const Table<March>> march_table() {
  return std::make_shared<const Table<March>>(Table<March>{
      "crack_line.march",
      "crack_line.march = { time_step = …, duration = … }",
      "a history with a moving front",
      {key(&March::time_step,
           {.name = "time_step", .unit = "s", .range = positive(), .required = true, .meaning = "time step"}),
       key(&March::duration,
           {.name = "duration", .unit = "s", .range = positive(), .required = true, .meaning = "of the history"}),
       choice(&March::initially, Choices<Filling>{{"full", Filling::full}, {"empty", Filling::empty}},
              {.name = "initially", .meaning = "water in the crack at the start"}),
       key(&March::history_every, {.name = "history_every",
                                   .range = at_least(1),
                                   .meaning = "steps from one row of history.csv to the next"})}});
}

void check_crack_line(const Node& node, CrackLine& line, const std::string& path, Findings& findings) {
  const std::size_t nodes = static_cast<std::size_t>(line.segments) + 1;
  const auto check_length = [&](const char* name, const std::vector<double>& values, bool one_is_enough) {
    const std::size_t n = values.size();
    if (n == 2 || n == nodes || (n == 1 && one_is_enough)) return;
    findings.add(node.find(name)->origin, path + "." + name,
                 "has " + std::to_string(n) + " values; accepted: " + (one_is_enough ? "1 (everywhere), " : "") +
                     "2 (at both ends) or " + std::to_string(nodes) + " (segments + 1)");
  };
  check_length("aperture", line.aperture, false);
  if (node.has("opening_rate")) check_length("opening_rate", line.opening_rate, true);
  if (!(std::abs(line.rise) <= line.length))
    findings.add(node.find("rise")->origin, path + ".rise", "accepted: -length … length");
  if ((line.tip == Tip::closed) == line.downstream_head.has_value())
    findings.add(node.origin, path, "accepted: either `downstream_head` or `tip = \"closed\"`, one of them");
}

Table<CrackLine> crack_line_table(const std::shared_ptr<const Table<March>>& march) {
  return {
      "crack_line",
      "[crack_line]",
      "analysis = \"crack-water\": a crack with given motion and no solid",
      {key(&CrackLine::length,
           {.name = "length", .unit = "m", .range = positive(), .required = true, .meaning = "of the crack"}),
       key(&CrackLine::segments,
           {.name = "segments", .range = at_least(1), .required = true, .meaning = "line segments of equal length"}),
       key(&CrackLine::aperture, {.name = "aperture",
                                  .unit = "m",
                                  .range = positive(),
                                  .required = true,
                                  .meaning = "at both ends, linear between, or at each of segments + 1 nodes"}),
       key(&CrackLine::opening_rate,
           {.name = "opening_rate", .unit = "m/s", .meaning = "everywhere, at both ends, or at each node"}),
       key(&CrackLine::rise, {.name = "rise",
                              .unit = "m",
                              .meaning = "height gained from the upstream mouth to the far end; at most the length"}),
       key(&CrackLine::upstream_head,
           {.name = "upstream_head", .unit = "m", .range = at_least(0.0), .meaning = "head of water at the mouth"}),
       key(&CrackLine::downstream_head,
           {.name = "downstream_head", .unit = "m", .range = at_least(0.0), .meaning = "at the far end"}),
       choice(&CrackLine::tip, Choices<Tip>{{"open", Tip::open}, {"closed", Tip::closed}},
              {.name = "tip", .meaning = "closed: no flow through the far end"}),
       table_key(&CrackLine::march, march,
                 {.name = "march", .meaning = "a history; absent: the profile of an instant"}),
       choice(&CrackLine::quadrature,
              Choices<WaterQuadrature>{{"exact", WaterQuadrature::exact}, {"midpoint", WaterQuadrature::midpoint}},
              {.name = "quadrature", .meaning = "of the pressure gradient along a segment"}),
       choice(&CrackLine::search,
              Choices<WaterSearch>{{"bisection", WaterSearch::bisection},
                                   {"itp", WaterSearch::itp},
                                   {"toms748", WaterSearch::toms748},
                                   {"newton", WaterSearch::newton},
                                   {"prefix", WaterSearch::prefix}},
              {.name = "search", .meaning = "how the flux is found"}),
       key(&CrackLine::tolerance, {.name = "tolerance",
                                   .range = {.low = 0.0, .high = 1.0, .high_open = true},
                                   .meaning = "of the flux, relative to its bracket; 0: to round-off"})},
      check_crack_line};
}

}  // namespace

std::vector<Part> crack_face_parts() {
  const auto march = march_table();
  return {one_part<Fracture>(&Scene::fracture, fracture_table()), one_part<Contact>(&Scene::contact, contact_table()),
          one_part<CrackWater>(&Scene::crack_water, crack_water_table()),
          one_part<Propagation>(&Scene::propagation, propagation_table()),
          one_part<CrackLine>(&Scene::crack_line, crack_line_table(march), {reference_of(*march)})};
}

}  // namespace sunder::scene
