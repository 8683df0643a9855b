#include <algorithm>
#include <ostream>

#include "solver/app/commands.hpp"
#include "solver/scene/reference.hpp"

namespace sunder::app {

int keys_command(const Arguments& arguments, const Console& console) {
  if (arguments.markdown) {
    console.out << scene::reference_markdown() << std::flush;
    return completed;
  }
  for (const scene::TableReference& table : scene::reference()) {
    console.out << table.heading << "  " << table.meaning << '\n';
    for (const scene::KeyReference& key : table.keys) {
      console.out << "  " << key.name << " = " << key.type << (key.accepted.empty() ? "" : " " + key.accepted)
                  << (key.unit.empty() ? "" : " [" + key.unit + "]") << "; "
                  << (key.default_value == "required" ? "" : "default ") << key.default_value << "\n      "
                  << key.meaning << '\n';
    }
    console.out << '\n';
  }
  console.out << std::flush;
  return completed;
}

}  // namespace sunder::app
