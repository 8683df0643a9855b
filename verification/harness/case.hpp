#pragma once
/// One verification case as a person wrote it: the claim, what is run, what the answer is compared with, and why the
/// tolerance is what it is. The written form is verification/cases/README.md.

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::verification {

/// A value of a scene key or of a study's parameter, as written.
struct Literal {
  std::string text;                  ///< in TOML notation
  std::optional<double> number;      ///< where it is a number
  std::vector<double> numbers;       ///< where it is a list of numbers, or of such lists (flattened)
  std::optional<std::string> words;  ///< where it is a string
};
using Setting = std::vector<std::pair<std::string, Literal>>;  ///< dotted key and value

enum class Tier { quick, full, long_ };  ///< < 2 s, < 60 s, longer [CPU s]

/// How much a reference is worth, best first.
enum class ReferenceClass {
  exact,           ///< a closed form or a law
  high_precision,  ///< computed to more digits than the tolerance by an independent method
  cross_code,      ///< another program
  published,       ///< printed or measured, with an uncertainty
  self,            ///< our own earlier value: tells change, verifies nothing
};

struct Reference {
  std::string name;
  ReferenceClass kind = ReferenceClass::exact;
  std::string expression;         ///< empty where `values` are given; may use the setting's keys and exact functions
  std::vector<double> values;     ///< a number, a list, or points one after the other
  std::vector<double> abscissae;  ///< of a curve; else empty
  std::string unit;
  std::string source;        ///< key of reference-data/bibliography.bib, or words
  std::string locator;       ///< equation, table, page
  double uncertainty = 0.0;  ///< in `unit`, or a fraction where `uncertainty_is_relative`
  bool uncertainty_is_relative = false;
  int line = 0;
};

enum class CheckKind { value, order, invariant, bound, pin, refused };

enum class Norm {
  relative,       ///< |q - r| / scale; scale = |r| unless given
  absolute,       ///< |q - r|
  l2,             ///< √(Σ (q - r)²) / √(Σ r²) over a list or a curve
  maximum,        ///< max |q - r| / max |r|
  area,           ///< |∫ q - ∫ r| / ∫ |r| over the abscissa
  path_distance,  ///< Hausdorff distance of two polylines [m]
  event_time,     ///< |t_q - t_r|: the first time at which the curve reaches the threshold [s]
};

/// What a tolerance follows from.
enum class Basis { round_off, discretisation, uncertainty, specification, physics };

/// Where in a sweep a check applies.
struct Where {
  enum class Kind { every, last, standard, index } kind = Kind::every;
  int index = 0;
};

struct KnownLimit {
  std::string reason;
  std::string expires;  ///< ISO date; from then on the failure counts again
};

struct Check {
  std::string name;
  CheckKind kind = CheckKind::value;
  std::string quantity;   ///< an expression in the run's quantities: "tips[0].K_I / sqrt(pi * 0.5)"
  std::string abscissa;   ///< of a curve: its abscissa in the run's quantities; else empty
  std::string reference;  ///< name of a reference; empty for a bound, an invariant, a pin, a refusal
  Norm norm = Norm::relative;
  std::optional<double> scale;    ///< > 0
  std::vector<double> tolerance;  ///< one, or one a setting: error ≤ tolerance
  Basis basis = Basis::round_off;
  std::string reason;
  Where where;
  bool gates = true;                        ///< false: printed beside ours, without a verdict
  std::string law;                          ///< invariant: what is conserved or symmetric, and why
  double target = 0.0;                      ///< invariant: the value that the quantity keeps
  std::optional<double> at_least, at_most;  ///< bound
  std::string message;                      ///< refused: what the message must contain
  std::string over;                         ///< order: the key that is refined
  bool over_counts = false;                 ///< order: `over` is a number of divisions, h = 1 / value
  std::vector<double> expected;             ///< order: one, or one a series
  double window = 0.0;                      ///< order: |p - expected| ≤ window
  double floor = 0.0;                       ///< order: errors up to this are round-off
  std::optional<double> threshold;          ///< event_time
  std::optional<KnownLimit> known_limit;
  int line = 0;
};

struct Negative {
  std::string fault;                ///< name given to planted_fault in the solver
  std::vector<std::string> checks;  ///< must turn red
};

struct Sweep {
  std::vector<std::pair<std::string, std::vector<Literal>>> keys;
  bool product = false;             ///< every combination; otherwise the lists go side by side
  std::string error;                ///< the check whose error the figure shows over CPU time; may be empty
  std::optional<int> standard;      ///< index of the setting that is the program's default
  std::vector<std::string> series;  ///< keys whose values tell the curves of the figure apart
};

/// A sweep that climbs until the program gives up: every rung is right, or refused with one of these words.
struct Ladder {
  std::vector<std::string> refusals;
};

struct Needs {
  int cores = 1;
  double memory = 0.0;  ///< [GiB]
};

struct Case {
  std::string id;  ///< path below the folder of cases, without ".case.toml"
  std::filesystem::path file;
  int version = 1;  ///< a new one starts a new history
  std::string title, requirement, why, family;
  Tier tier = Tier::quick;
  std::vector<std::string> modules;  ///< parts that the run may touch; any other must have zero calls
  std::string study = "scene";
  std::filesystem::path scene;  ///< empty where the study needs none
  Setting overrides;            ///< scene keys
  Setting parameters;           ///< of the study
  std::optional<Sweep> sweep;
  std::optional<Ladder> ladder;
  Needs needs;
  std::vector<Reference> references;
  std::vector<Check> checks;
  std::vector<Negative> negatives;
};

/// A case that does not follow the schema; what() is "file:line: key: what is wrong, what is accepted".
class CaseError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CaseFolders {
  std::filesystem::path cases;           ///< verification/cases
  std::filesystem::path reference_data;  ///< reference-data
};

/// Reads one `*.case.toml`. Throws CaseError.
[[nodiscard]] Case read_case(const std::filesystem::path& file, const CaseFolders& folders);

/// Every `*.case.toml` below the folder, in the order of their ids.
[[nodiscard]] std::vector<std::filesystem::path> case_files(const CaseFolders& folders);

/// The id of a case file: its path below the folder, without the ending.
[[nodiscard]] std::string case_id(const std::filesystem::path& file, const CaseFolders& folders);

/// The settings of a case in the order in which they run: one, empty, where it has no sweep. Keys that begin with
/// "parameters." are the study's, all others are scene keys.
[[nodiscard]] std::vector<Setting> settings(const Case& verification_case);

const Reference* find_reference(const Case& verification_case, std::string_view name);
const Check* find_check(const Case& verification_case, std::string_view name);

/// The word of an enumerator, as it stands in case files and records.
std::string_view word(Tier);
std::string_view word(ReferenceClass);
std::string_view word(CheckKind);
std::string_view word(Norm);
std::string_view word(Basis);

}  // namespace sunder::verification
