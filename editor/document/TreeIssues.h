#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace editor {

/// A tree that somebody wrote, as far as the document knows it.
struct WrittenTree {
  base::EntityId human;
  std::string path;                 // of its file; empty = not known
  std::optional<std::string> text;  // none: what the file says
};

/// What is wrong with the trees of listed people, in their order: files that cannot be read, XML,
/// nodes, ports, includes, and whether each tree fits its person. Equal texts of one folder are
/// looked at once. Any thread; reads files.
base::Diagnostics treeIssues(const sim2d::Scenario& scenario, const std::vector<WrittenTree>& trees,
                             const sim2d::FilePlaces& places);

}  // namespace editor
