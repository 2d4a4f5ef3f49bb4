#pragma once

#include <vector>

#include <QString>

namespace app {

/// One measured size of the open scene.
struct BenchPoint {
  int people = 0;
  double whole = 0.0;     // a step [ms]
  double forces = 0.0;    // of which the forces [ms]
  double plain = 0.0;     // the same forces over all pairs [ms]
  bool isScaled = false;  // `plain` is, from a smaller size
};

/// Times per step over the number of people, both on scales of powers of ten, as the file's ending
/// says: .png, .svg or .pdf. False = it cannot be written. Needs a QApplication.
bool drawBench(const std::vector<BenchPoint>& points, const QString& machine, const QString& file);

}  // namespace app
