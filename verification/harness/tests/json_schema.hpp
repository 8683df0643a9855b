#pragma once
/// As much of JSON Schema (2020-12) as the schemas of this folder use; an unknown keyword is an error, so that none is
/// passed over in silence.

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace sunder::verification {

class JsonSchema {
 public:
  explicit JsonSchema(nlohmann::json schema) : whole_(std::move(schema)) {}

  /// The first complaint, "path: what"; empty where the value follows the schema.
  std::string complaint(const nlohmann::json& value) const { return check(value, whole_, "record"); }

 private:
  using Json = nlohmann::json;

  static bool is_of(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number_integer();
    return type == "null" && value.is_null();
  }

  static bool is_of_any(const Json& value, const Json& types) {
    if (types.is_string()) return is_of(value, types);
    return std::any_of(types.begin(), types.end(), [&](const Json& type) { return is_of(value, type); });
  }

  std::string object(const Json& value, const Json& schema, const std::string& path) const {
    const Json properties = schema.value("properties", Json::object());
    const Json further = schema.value("additionalProperties", Json(true));
    for (const Json& key : schema.value("required", Json::array()))
      if (!value.contains(key)) return path + ": " + key.get<std::string>() + " is missing";
    for (const auto& [key, entry] : value.items()) {
      std::string wrong;
      if (properties.contains(key))
        wrong = check(entry, properties[key], path + "." + key);
      else if (further == Json(false))
        wrong = path + ": " + key + " is not known";
      else if (further.is_object())
        wrong = check(entry, further, path + "." + key);
      if (!wrong.empty()) return wrong;
    }
    return "";
  }

  std::string check(const Json& value, const Json& schema, const std::string& path) const {
    for (const auto& [word, rule] : schema.items()) {
      std::string wrong;
      if (word == "$ref")
        wrong = check(value, whole_.at(Json::json_pointer(rule.get<std::string>().substr(1))), path);
      else if (word == "type" && !is_of_any(value, rule))
        wrong = path + ": " + value.dump() + " is no " + rule.dump();
      else if (word == "enum" && std::find(rule.begin(), rule.end(), value) == rule.end())
        wrong = path + ": " + value.dump() + " is none of " + rule.dump();
      else if (word == "const" && value != rule)
        wrong = path + ": " + value.dump() + " is not " + rule.dump();
      else if (word == "minimum" && value.get<double>() < rule.get<double>())
        wrong = path + ": " + value.dump() + " is less than " + rule.dump();
      else if (word == "items")
        for (std::size_t i = 0; i < value.size() && wrong.empty(); ++i)
          wrong = check(value[i], rule, path + "[" + std::to_string(i) + "]");
      else if (!known(word))
        wrong = path + ": this test does not know the keyword " + word;
      if (!wrong.empty()) return wrong;
    }
    return value.is_object() ? object(value, schema, path) : "";
  }

  static bool known(const std::string& word) {
    for (const char* one : {"$ref", "type", "enum", "const", "minimum", "items", "properties", "required",
                            "additionalProperties", "description", "title", "$schema", "$defs"})
      if (word == one) return true;
    return false;
  }

  Json whole_;
};

}  // namespace sunder::verification
