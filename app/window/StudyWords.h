#pragma once

#include <QString>

#include "app/run/Experiment.h"

namespace app {

/// "48 s", "12 min", "3 h 20 min".
QString studyTimeText(double seconds);
/// "2 scenarios × 3 planners × 30 seeds = 180 runs"
QString sizeText(const Experiment& experiment);
/// "error: this went wrong" -> "This went wrong"
QString withoutSeverity(const QString& line);

}  // namespace app
