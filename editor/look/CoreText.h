#pragma once

#include <string>

#include <QString>

namespace editor {

/// The translation of a text that comes from the parts without Qt: a label or explanation of a
/// parameter, metric, planner, node or block. resources/translations/core_texts.cpp lists them for
/// Qt Linguist. Texts that are not in the list are returned as they are.
QString coreText(const std::string& text);

}  // namespace editor
