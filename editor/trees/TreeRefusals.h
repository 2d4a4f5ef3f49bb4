#pragma once

#include <QString>

#include "editor/trees/TreeEdits.h"

/// Why an edit of a tree is impossible, as a sentence for the user; empty: it is possible. Each
/// function belongs to the edit of the same name in TreeEdits.h, which it does not perform.
namespace editor {

/// "An Inverter takes one child only". For nodes without a limit, empty.
QString childLimitText(const bt::NodeSpec& node);

QString whyNotAdded(const bt::TreeFile& file, const NodeLocation& parent, std::size_t count);
QString whyNotRemoved(const bt::TreeFile& file, const std::vector<NodeLocation>& places);
QString whyNotDuplicated(const bt::TreeFile& file, const std::vector<NodeLocation>& places);
QString whyNotWrapped(const bt::TreeFile& file, const std::vector<NodeLocation>& places,
                      const bt::NodeSpec& around);
QString whyNotReplaced(const bt::TreeFile& file, const NodeLocation& place, const bt::NodeSpec& by);
QString whyNotUnwrapped(const bt::TreeFile& file, const NodeLocation& place);
QString whyNotExtracted(const bt::TreeFile& file, const NodeLocation& place);
QString whyNotInlined(const bt::TreeFile& file, const NodeLocation& place);
/// `by`: number of places among the siblings, -1 = earlier, 1 = later.
QString whyNotMovedBy(const bt::TreeFile& file, const NodeLocation& place, int by);

}  // namespace editor
