#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// By behaviour, or that of a tree of one's own.
inline Look lookOfPerson(const ScenarioDocument& document, const sim2d::Human& human) {
  return document.tree(human.key)
             ? Look::CustomTree
             : lookOf(human.behavior.type.value_or(sim2d::BehaviorType::Regular));
}

}  // namespace editor
