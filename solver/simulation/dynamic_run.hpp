#pragma once
/// A dynamic run under way: rest, steps, growth, and what is remembered of them. Private to run_dynamic.cpp,
/// dynamic_growth.cpp, dynamic_output.cpp and dynamic_checkpoint.cpp.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/fracture/propagation.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/simulation/checkpoint.hpp"
#include "solver/simulation/dynamic_options.hpp"
#include "solver/simulation/dynamic_record.hpp"
#include "solver/simulation/dynamic_step.hpp"
#include "solver/simulation/field_snapshot.hpp"
#include "solver/simulation/growth.hpp"
#include "solver/simulation/run.hpp"
#include "solver/simulation/surroundings.hpp"

namespace sunder::simulation {

class DynamicRun {
 public:
  DynamicRun(const scene::Scene& scene, const Body& body, const RunOptions& options, numerics::ThreadPool& pool,
             Ledger& ledger, results::RunSummary& summary);

  /// Runs to the end, or to where the summary's status says.
  void go();

 private:
  // Each is false where the run cannot go on; the summary's status then says why.
  bool begin();
  bool step(long long number);
  bool grow_cracks();
  bool grow_tip(std::size_t crack, const mesh::Point& to);
  bool take_body(Growth growth, DynamicBody& before);

  void make_step(const FaceMemory& memory);
  /// The part of the scene that asked for the equations between the faces: contact before water before the crack.
  const char* face_part() const { return scene_.contact ? "contact" : scene_.crack_water ? "crackwater" : "crack"; }
  void charge_faces();
  void charge_parts();
  void observe(StepRecord& record) const;
  CrackRecord observe_crack(std::size_t crack, Eigen::Index first_pair) const;
  FaceMemory remembered(const DynamicBody& before) const;
  bool held_closed(std::size_t crack) const;
  // dynamic_checkpoint.cpp
  bool has_checkpoints() const;
  bool wants_checkpoint(long long number) const;
  std::string identity() const;
  void note_felt();
  void keep();
  void go_on();
  Eigen::VectorXd laws() const;
  CrackMemory crack_memory() const;
  void go_on_with_cracks(const CrackMemory& kept);
  [[noreturn]] void refuse_checkpoint(const std::string& fault) const;

  void note_event(std::size_t crack, const std::string& what, const mesh::Point& place);
  results::Quantity profile_of(std::size_t crack, Eigen::Index first_pair) const;
  void note_profiles();
  void write_fields();
  void finish();
  void stop(const std::string& why) { summary_.status = "stopped: " + why; }
  std::string time_text() const;

  const scene::Scene& scene_;
  const RunOptions& options_;
  numerics::ThreadPool& pool_;
  Ledger& ledger_;
  results::RunSummary& summary_;

  // the body between two growth events
  DynamicBody body_;
  std::unique_ptr<Surroundings> around_;
  std::vector<Mouth> mouths_;
  CrackWaters waters_;
  StepOptions step_options_;
  faces::FaceStepOptions face_options_;
  std::unique_ptr<DynamicStep> step_;
  int crest_ = 0;

  // where it is
  long long number_ = 0;  // of the last accepted step
  MotionState state_, next_;
  StepLoad start_, end_;
  std::vector<Eigen::VectorXd> media_before_;
  Eigen::VectorXd released_;  // what held the new faces together; empty but in the step after a growth event
  std::vector<fracture::SpeedAllowance> allowances_;
  std::vector<double> felt_;  // by the media in all steps, where checkpoints are wanted
  std::string identity_;      // likewise
  std::vector<GrownTip> grown_;

  // what is remembered
  EnergyAccount energy_;
  std::unique_ptr<DynamicRecord> record_;
  StepRecord now_;
  std::vector<std::vector<mesh::Point>> paths_;
  results::Quantity::List events_, profiles_;
  std::unique_ptr<results::FieldFile> fields_;  // where the scene asks for fields
  std::optional<FieldGeometry> drawn_;          // of the present body
  std::string end_event_;                       // an end that is no failure: the body is cut through
};

}  // namespace sunder::simulation
