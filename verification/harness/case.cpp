#include "verification/harness/case.hpp"

#include <algorithm>

namespace sunder::verification {

std::vector<std::filesystem::path> case_files(const CaseFolders& folders) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folders.cases))
    if (entry.is_regular_file() && entry.path().filename().string().ends_with(".case.toml"))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [&](const auto& a, const auto& b) { return case_id(a, folders) < case_id(b, folders); });
  return files;
}

std::vector<Setting> settings(const Case& verification_case) {
  std::vector<Setting> result(1);
  if (!verification_case.sweep) return result;
  const Sweep& sweep = *verification_case.sweep;
  if (!sweep.product) {
    result.resize(sweep.keys.front().second.size());
    for (const auto& [key, values] : sweep.keys)
      for (std::size_t i = 0; i < result.size(); ++i) result[i].emplace_back(key, values[i]);
    return result;
  }
  for (const auto& [key, values] : sweep.keys) {  // the last key runs fastest
    std::vector<Setting> longer;
    for (const Setting& setting : result)
      for (const Literal& value : values) {
        longer.push_back(setting);
        longer.back().emplace_back(key, value);
      }
    result = std::move(longer);
  }
  return result;
}

const Reference* find_reference(const Case& verification_case, std::string_view name) {
  for (const Reference& reference : verification_case.references)
    if (reference.name == name) return &reference;
  return nullptr;
}

const Check* find_check(const Case& verification_case, std::string_view name) {
  for (const Check& check : verification_case.checks)
    if (check.name == name) return &check;
  return nullptr;
}

std::string_view word(Tier tier) {
  switch (tier) {
    case Tier::quick:
      return "quick";
    case Tier::full:
      return "full";
    case Tier::long_:
      return "long";
  }
  return "";
}

std::string_view word(ReferenceClass kind) {
  switch (kind) {
    case ReferenceClass::exact:
      return "exact";
    case ReferenceClass::high_precision:
      return "high-precision";
    case ReferenceClass::cross_code:
      return "cross-code";
    case ReferenceClass::published:
      return "published";
    case ReferenceClass::self:
      return "self";
  }
  return "";
}

std::string_view word(CheckKind kind) {
  switch (kind) {
    case CheckKind::value:
      return "value";
    case CheckKind::order:
      return "order";
    case CheckKind::invariant:
      return "invariant";
    case CheckKind::bound:
      return "bound";
    case CheckKind::pin:
      return "pin";
    case CheckKind::refused:
      return "refused";
  }
  return "";
}

std::string_view word(Norm norm) {
  switch (norm) {
    case Norm::relative:
      return "relative";
    case Norm::absolute:
      return "absolute";
    case Norm::l2:
      return "L2";
    case Norm::maximum:
      return "max";
    case Norm::area:
      return "area";
    case Norm::path_distance:
      return "path-distance";
    case Norm::event_time:
      return "event-time";
  }
  return "";
}

std::string_view word(Basis basis) {
  switch (basis) {
    case Basis::round_off:
      return "round-off";
    case Basis::discretisation:
      return "discretisation";
    case Basis::uncertainty:
      return "uncertainty";
    case Basis::specification:
      return "specification";
    case Basis::physics:
      return "physics";
  }
  return "";
}

}  // namespace sunder::verification
