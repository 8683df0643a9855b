#include "verification/harness/junit.hpp"

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "verification/harness/report_text.hpp"

namespace sunder::verification {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
          result += c;  // the others are not allowed in XML
    }
  }
  return result;
}

}  // namespace

std::string junit_xml(const std::vector<CaseResult>& results) {
  std::map<std::string, std::vector<const CaseResult*>> families;
  for (const CaseResult& result : results) families[result.family].push_back(&result);
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"sunder-verify\">\n";
  for (const auto& [family, members] : families) {
    int failures = 0, skipped = 0;
    double seconds = 0.0;
    for (const CaseResult* result : members) {
      failures += fails(result->status);
      skipped += result->status == Status::skipped;
      seconds += result->cpu_seconds;
    }
    xml << "  <testsuite name=\"" << escaped(family) << "\" tests=\"" << members.size() << "\" failures=\"" << failures
        << "\" skipped=\"" << skipped << "\" time=\"" << seconds << "\">\n";
    for (const CaseResult* result : members) {
      xml << "    <testcase classname=\"" << escaped(family) << "\" name=\"" << escaped(result->id) << "\" time=\""
          << result->cpu_seconds << "\">\n";
      const std::string text = escaped(report_text(*result));
      if (fails(result->status))
        xml << "      <failure message=\"" << word(result->status) << "\">" << text << "</failure>\n";
      else if (result->status == Status::skipped)
        xml << "      <skipped message=\"" << escaped(result->message) << "\"/>\n";
      else
        xml << "      <system-out>" << text << "</system-out>\n";
      xml << "    </testcase>\n";
    }
    xml << "  </testsuite>\n";
  }
  xml << "</testsuites>\n";
  return xml.str();
}

void write_junit(const std::filesystem::path& file, const std::vector<CaseResult>& results) {
  if (!file.parent_path().empty()) std::filesystem::create_directories(file.parent_path());
  std::ofstream stream(file);
  stream << junit_xml(results);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace sunder::verification
