#include "verification/harness/report_text.hpp"

#include <cstdio>

namespace sunder::verification {
namespace {

std::string check_text(const CheckOutcome& check) {
  std::string text = "  " + std::string(word(check.status)) + "  " + check.name + " (" + check.kind + ", " +
                     check.evidence + (check.gates ? "" : ", does not gate") + ")";
  if (check.compared > 0 && check.kind != "contract" && check.kind != "refused") {
    text += ": " + short_number(check.value) + " against " + short_number(check.reference) + ", error " +
            short_number(check.error) + ", tolerance " + short_number(check.tolerance);
    if (check.slack > 0.0) text += ", slack " + short_number(check.slack);
    if (const auto judged = slack_word(check); !judged.empty()) text += " (" + std::string(judged) + ")";
    if (check.compared > 1) text += ", worst of " + std::to_string(check.compared);
    if (check.setting >= 0) text += ", setting " + std::to_string(check.setting);
  }
  for (const OrderEstimate& order : check.orders)
    text += "\n      order " + short_number(order.order) + ", " + std::string(word(order.convergence)) + ", " +
            std::to_string(order.levels_used) + " levels";
  if (!check.message.empty()) text += "\n      " + check.message;
  return text + "\n";
}

}  // namespace

std::string short_number(double value, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

std::string report_text(const CaseResult& result) {
  std::string text =
      std::string(word(result.status)) + "  " + result.id + "  (" + short_number(result.cpu_seconds) + " CPU s)\n";
  if (!result.message.empty()) text += "  " + result.message + "\n";
  for (const CheckOutcome& check : result.checks) text += check_text(check);
  for (std::size_t i = 0; i < result.settings.size(); ++i) {
    const SettingRow& row = result.settings[i];
    if (row.status == Status::pass) continue;
    text += "  setting " + std::to_string(i) + ":";
    for (const auto& [key, value] : row.keys) text += " " + key + " = " + value;
    text += ": " + std::string(word(row.status)) + ": " + row.message + "\n";
  }
  if (result.first_failing_rung)
    text += "  first failing rung " + std::to_string(*result.first_failing_rung) + " of " +
            std::to_string(result.settings.size()) + "\n";
  for (const auto& [name, digits] : result.digits_trusted)
    text += "  " + short_number(digits) + " digits of " + name + "\n";
  for (const NegativeOutcome& negative : result.negatives) {
    text += "  " + std::string(word(negative.verdict)) + "  " + negative.fault + ": red";
    for (const std::string& name : negative.red) text += " " + name;
    text += negative.red.empty() ? " nothing\n" : "\n";
  }
  return text;
}

}  // namespace sunder::verification
