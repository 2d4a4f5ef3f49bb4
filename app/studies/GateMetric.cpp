#include "app/studies/GateMetric.h"

#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr const char* kOption = "--metric";

/// Sets scale and margin; false: no margin, or out of range.
bool readMargin(std::string text, bool isRate, GateMetric& metric) {
  const bool isPercent = base::endsWith(text, "%");
  if (isPercent) {
    text.pop_back();
  }
  const std::optional<double> number = base::parseDouble(base::trimmed(text));
  if (!number) {
    return false;
  }
  metric.scale = isRate      ? GateMetric::Scale::Rate
                 : isPercent ? GateMetric::Scale::Ratio
                             : GateMetric::Scale::Difference;
  metric.margin = isPercent ? *number / 100.0 : *number;
  const bool isShare = metric.scale != GateMetric::Scale::Difference;
  return metric.margin > 0.0 && metric.margin < (isShare ? 1.0 : 1e6);
}

/// The value of a run that counts: for rates 0 or 1.
std::optional<double> valueIn(const GateMetric& metric, const ResultRow& row) {
  const std::optional<double> value = numberOf(row, metric.key);
  return value && metric.threshold ? std::optional(*value > *metric.threshold ? 1.0 : 0.0) : value;
}

double logRatio(double candidate, double base) {
  if (candidate == base) {
    return 0.0;
  }
  if (candidate <= 0.0 || base <= 0.0) {
    return std::copysign(std::numeric_limits<double>::infinity(), candidate - base);
  }
  return std::log(candidate / base);
}

}  // namespace

std::string GateMetric::label() const {
  return key + (threshold ? ">" + base::formatDouble(*threshold) : std::string());
}

std::string GateMetric::title() const {
  const std::string above =
      threshold && *threshold != 0.0 ? " (more than " + base::formatDouble(*threshold) + ")" : "";
  return name + above + (unit.empty() || unit == "-" ? "" : " [" + unit + "]");
}

base::Result<GateMetric> parseGateMetric(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::string key = text.substr(0, colon);
  GateMetric metric;
  metric.isRequested = true;
  if (const std::size_t above = key.find('>'); above != std::string::npos) {
    metric.threshold = base::parseDouble(base::trimmed(key.substr(above + 1)));
    if (!metric.threshold) {
      return base::error("gate.metric", {text}, kOption);
    }
    key.resize(above);
  }
  metric.key = base::trimmed(key);
  const std::optional<ColumnInfo> info = columnInfo(metric.key);
  if (!info) {
    return base::error("metrics.unknown-metric",
                       {metric.key, base::nearestName(metric.key, knownColumns())}, kOption);
  }
  if (info->sense == 0) {
    return base::error("gate.no-better", {metric.key}, kOption);
  }
  metric.name = info->name;
  metric.unit = metric.threshold ? std::string() : info->unit;
  metric.sense = info->sense;
  const bool isRate = metric.threshold || info->isBoolean;
  if (colon == std::string::npos || !readMargin(text.substr(colon + 1), isRate, metric)) {
    return base::error("gate.metric", {text}, kOption);
  }
  return metric;
}

std::vector<GateMetric> defaultGateMetrics() {
  std::vector<GateMetric> metrics;
  for (const char* text : {"success:5%", "time_to_reach_goal:5%", "intimate_space_intrusions:2",
                           "robot_on_person_collision>0:5%"}) {
    metrics.push_back(*parseGateMetric(text));
    metrics.back().isRequested = false;
  }
  return metrics;
}

double marginAsGain(const GateMetric& metric) {
  return metric.scale == GateMetric::Scale::Ratio ? std::log1p(metric.margin) : metric.margin;
}

statistics::Interval gainRange(const GateMetric& metric) {
  const double most =
      metric.scale == GateMetric::Scale::Rate ? 1.0 : kMarginsPerPair * marginAsGain(metric);
  return {-most, most};
}

GateGain gainOf(const GateMetric& metric, const ResultRow& base, const ResultRow& candidate) {
  const statistics::Interval range = gainRange(metric);
  GateGain result;
  result.base = valueIn(metric, base);
  result.candidate = valueIn(metric, candidate);
  if (result.base && result.candidate) {
    const double difference = metric.scale == GateMetric::Scale::Ratio
                                  ? logRatio(*result.candidate, *result.base)
                                  : *result.candidate - *result.base;
    result.gain = std::clamp(metric.sense * difference, range.low, range.high);
  } else {
    const bool isBaseWorst = !result.base && isUnsuccessful(base);
    const bool isCandidateWorst = !result.candidate && isUnsuccessful(candidate);
    result.gain = isBaseWorst == isCandidateWorst ? 0.0 : isBaseWorst ? range.high : range.low;
  }
  return result;
}

}  // namespace app
