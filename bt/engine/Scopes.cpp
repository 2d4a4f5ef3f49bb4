#include "bt/engine/Scopes.h"

#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"

namespace bt {

Scopes::Scopes() : scopes_(1) {}

int Scopes::add(int parent, bool autoRemap, const std::string& path) {
  constexpr std::size_t kShownPath = 300;  // the end of a longer one tells more than its beginning
  Scope scope;
  scope.parent = parent;
  scope.autoRemap = autoRemap;
  scope.path = path.size() > kShownPath ? path.substr(path.size() - kShownPath) : path;
  scopes_.push_back(std::move(scope));
  return static_cast<int>(scopes_.size()) - 1;
}

void Scopes::remap(int scope, const std::string& key, const std::string& parentKey) {
  scopes_[static_cast<std::size_t>(scope)].remaps[key] = parentKey;
}

/// Whole numbers become Int, other numbers Double, the rest text.
void Scopes::setConstant(int scope, const std::string& key, const std::string& text) {
  const int index = addSlot(scope, key);
  Slot& target = slot(index);
  if (const std::optional<long long> whole = base::parseInt(text); whole && intFromText(text)) {
    target.type = PortType::Int;
    target.value = Value::of(static_cast<std::int64_t>(*whole));
  } else if (const std::optional<double> number = base::parseDouble(text)) {
    target.type = PortType::Double;
    target.value = Value::of(*number);
  } else {
    target.type = PortType::String;
    target.value = Value::of(std::string_view(text));
  }
  target.exists = true;
  use(index).literal = true;
  use(index).written = true;
}

int Scopes::addSlot(int scope, const std::string& key) {
  Scope& owner = scopes_[static_cast<std::size_t>(scope)];
  const int index = static_cast<int>(slots_.size());
  owner.slots[key] = index;
  slots_.emplace_back();
  uses_.emplace_back();
  entries_.push_back({owner.path.empty() ? key : owner.path + "/" + key, index});
  return index;
}

int Scopes::slotOf(int scope, const std::string& key) {
  if (!key.empty() && key[0] == '@') {
    return slotOf(0, key.substr(1));
  }
  const Scope& own = scopes_[static_cast<std::size_t>(scope)];
  const auto known = own.slots.find(key);
  if (known != own.slots.end()) {
    return known->second;
  }
  const auto remapped = own.remaps.find(key);
  const bool isPrivate = !key.empty() && key[0] == '_';
  int index = -1;
  if (remapped != own.remaps.end()) {
    index = slotOf(own.parent, remapped->second);
  } else if (own.autoRemap && own.parent >= 0 && !isPrivate) {
    index = slotOf(own.parent, key);
  } else {
    return addSlot(scope, key);
  }
  scopes_[static_cast<std::size_t>(scope)].slots[key] = index;
  return index;
}

int Scopes::find(int scope, const std::string& key) const {
  const Scope& own = scopes_[static_cast<std::size_t>(scope)];
  const auto known = own.slots.find(key);
  return known == own.slots.end() ? -1 : known->second;
}

}  // namespace bt
