#include <algorithm>

#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {

namespace {

template <class T>
std::set<std::string> keysWith(std::set<std::string> keys) {
  for (const Field<T>& field : fieldsOf<T>()) {
    keys.insert(field.spec.key);
  }
  return keys;
}

}  // namespace

const std::set<std::string>& loaderKeys() {
  static const std::set<std::string> kKeys = keysWith<Environment>({"global_goals", "agents"});
  return kKeys;
}

const std::set<std::string>& blockKeys() {
  // "map": a menu of HuNavSim searches the whole text for that key
  static const std::set<std::string> kKeys = keysWith<DesktopSettings>(
      {"format", "map", "robots", "obstacles", "doors", "areas", "metrics"});
  return kKeys;
}

bool isEntityName(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace sim2d
