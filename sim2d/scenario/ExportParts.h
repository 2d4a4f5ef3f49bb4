#pragma once

#include <string>

#include "sim2d/scenario/Export.h"

/// Parts of exportScenario. Private to this folder.
namespace sim2d {

/// What only we can express, one line per kind of thing.
void addExportLosses(const Scenario& scenario, base::Diagnostics& report);
/// Fills the keys that the wrapper asks for with the values that count, and keeps skins in range.
void completeExported(const Scenario& scenario, Human& human, const TargetInfo& target,
                      base::Diagnostics& report);
std::string exportStartCommand(const Scenario& scenario, const TargetInfo& target);
/// Which world that command starts when the scenario has no map.
base::Diagnostic worldWithoutMap(const TargetInfo& target);
/// The same for a map that is none of its worlds.
base::Diagnostic worldOfMap(const std::string& map, const TargetInfo& target);

}  // namespace sim2d
