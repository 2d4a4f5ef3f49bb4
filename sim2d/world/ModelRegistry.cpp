#include "sim2d/world/models/PedestrianModel.h"

namespace sim2d {

void addAllModels(ModelRegistry& to);

std::vector<std::string> ModelRegistry::names() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries_) {
    names.push_back(entry.name);
  }
  return names;
}

std::unique_ptr<PedestrianModel> ModelRegistry::make(const std::string& name,
                                                     const ResolvedHuman& person) const {
  for (const Entry& entry : entries_) {
    if (entry.name == name) {
      return entry.maker(person);
    }
  }
  return nullptr;
}

const ModelRegistry& pedestrianModels() {
  static const ModelRegistry kRegistry = [] {
    ModelRegistry registry;
    addAllModels(registry);
    return registry;
  }();
  return kRegistry;
}

}  // namespace sim2d
