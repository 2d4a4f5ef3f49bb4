#include "app/cli/RunProgress.h"

#include <cmath>

#include "sim2d/base/Text.h"

namespace app {

std::string runProgressText(std::size_t finished, std::size_t total, double rate,
                            bool mayEndEarlier) {
  const std::string most = mayEndEarlier ? "at most " : "";
  const bool isWithin = finished <= total;
  std::string text = std::to_string(finished);
  text += isWithin ? " / " + most + std::to_string(total) + " runs" : " runs";
  if (rate > 0.0) {
    text += ", " + base::formatDecimals(std::round(rate * 10.0) / 10.0, 1) + " runs/s";
    if (isWithin) {
      text += ", " + most + durationText(static_cast<double>(total - finished) / rate) + " left";
    }
  }
  return text;
}

void RunProgress::show(std::size_t finished, std::size_t executed) {
  if (!progress_.isDue()) {
    return;
  }
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  const double rate = executed > 0 ? static_cast<double>(executed) / elapsed.count() : 0.0;
  progress_.show((stage_.empty() ? "" : stage_ + ": ") +
                 runProgressText(finished, total_, rate, mayEndEarlier_) +
                 (note_.empty() ? "" : ", " + note_));
}

}  // namespace app
