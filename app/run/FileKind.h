#pragma once

#include <string>

namespace app {

/// What a text file of the user contains.
enum class FileKind { Scenario, Tree, NavigatorTree, Map, Experiment, Nav2 };

/// The kind of a file by its text, whatever its name is. Scenario: none of the others, so that the
/// reader of scenarios reports what is wrong.
FileKind fileKindOf(const std::string& text);

}  // namespace app
