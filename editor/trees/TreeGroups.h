#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/trees/TreeEdits.h"

/// Edits of several nodes of a tree file at once. Each returns where they stand afterwards;
/// nothing: it cannot be done with all of them, and the file must not be used any more.
namespace editor {

using MaybePlaces = std::optional<std::vector<TreePlace>>;

/// In the order of the file, without those that stand below others of them.
std::vector<TreePlace> withoutInner(std::vector<TreePlace> places);
bool areSiblings(const std::vector<TreePlace>& places);  // children of one parent

/// Those that are left: one place, as of removeNode(). No roots.
MaybePlaces removeNodes(bt::TreeFile& file, const std::vector<TreePlace>& places);
/// To before what stands at `index` of `parent` now, in their order. Not into one of them.
MaybePlaces moveNodes(bt::TreeFile& file, const std::vector<TreePlace>& places,
                      const TreePlace& parent, int index);
/// Before the child that stands at `index` now, or behind all.
MaybePlaces addNodes(bt::TreeFile& file, const TreePlace& parent, int index,
                     const std::vector<bt::NodeSpec>& nodes);
/// `around` takes the place of the first and gets all of them; they are siblings.
MaybePlaces wrapNodes(bt::TreeFile& file, const std::vector<TreePlace>& places,
                      bt::NodeSpec around);
/// Each behind itself; siblings behind the last of them.
MaybePlaces duplicateNodes(bt::TreeFile& file, const std::vector<TreePlace>& places);

/// Nodes as XML, element after element, and back: what nodeFromText() reads, or several elements.
std::string nodesText(const std::vector<const bt::NodeSpec*>& nodes);
base::Result<std::vector<bt::NodeSpec>> nodesFromText(const std::string& text, bt::TreeFile& into);

}  // namespace editor
