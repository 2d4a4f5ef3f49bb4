#include <nlohmann/json.hpp>

#include "app/run/Certificate.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/JsonText.h"

namespace app {

namespace {

using Json = nlohmann::ordered_json;

Json expectationsJson(const std::vector<ExpectationOutcome>& outcomes) {
  Json all = Json::array();
  for (const ExpectationOutcome& outcome : outcomes) {
    all.push_back({{"text", outcome.text},
                   {"holds", outcome.holds},
                   {"time", outcome.time ? Json(*outcome.time) : Json()}});
  }
  return all;
}

Json armJson(const CertifiedArm& arm) {
  return {{"planner", arm.planner},
          {"runs", arm.runs},
          {"mean", base::jsonNumber<Json>(arm.mean)},
          {"low", base::jsonNumber<Json>(arm.interval.low)},
          {"high", base::jsonNumber<Json>(arm.interval.high)}};
}

Json metricsJson(const std::vector<CertifiedMetric>& metrics) {
  Json all = Json::array();
  for (const CertifiedMetric& metric : metrics) {
    Json arms = Json::array();
    for (const CertifiedArm& arm : metric.arms) {
      arms.push_back(armJson(arm));
    }
    const Json pair = metric.separated
                          ? Json::array({metric.separated->first, metric.separated->second})
                          : Json();
    all.push_back({{"key", metric.key},
                   {"separates", pair},
                   {"planners", arms},
                   {"baseline", armJson(metric.baseline)}});
  }
  return all;
}

/// Everything but the program.
Json contentOf(const Certificate& certificate) {
  Json inputs = Json::object();
  for (const InputHash& input : certificate.inputs) {
    inputs[input.path] = input.sha256;
  }
  Json successes = Json::object();
  for (const auto& [planner, count] : certificate.successes) {
    successes[planner] = count;
  }
  return {{"scenario", certificate.scenario},
          {"certified", certificate.isCertified()},
          {"separates", certificate.separates()},
          {"problems", certificate.problems},
          {"inputs", inputs},
          {"seeds", certificate.seeds},
          {"expectations", expectationsJson(certificate.expectations)},
          {"successes", successes},
          {"metrics", metricsJson(certificate.metrics)}};
}

base::Result<Json> parsed(const std::string& text, const std::string& path) {
  const Json json = Json::parse(base::shallowJson(text), nullptr, false);
  const bool isCertificate = json.is_object() && json.value("hunavsim_certificate", Json()) == 1 &&
                             json.value("seeds", Json()).is_array() &&
                             json.value("successes", Json()).is_object();
  return isCertificate ? base::Result<Json>(json)
                       : base::Result<Json>(base::error("certificate.damaged", {}, path));
}

}  // namespace

std::string certificateText(const Certificate& certificate) {
  Json json = {{"hunavsim_certificate", 1},
               {"program", {{"version", programVersion()}, {"commit", programCommit()}}}};
  json.update(contentOf(certificate));
  return base::jsonText(json) + "\n";
}

base::Result<std::vector<std::string>> certificateDifferences(const std::string& storedText,
                                                              const Certificate& repeated,
                                                              const std::string& path) {
  const base::Result<Json> stored = parsed(storedText, path);
  if (!stored) {
    return stored.diagnostics();
  }
  std::vector<std::string> differences;
  const Json now = contentOf(repeated);
  for (const auto& [key, value] : now.items()) {
    if (!stored->contains(key) || stored->at(key) != value) {
      differences.push_back(key);
    }
  }
  return differences;
}

base::Result<CertificationPlan> planOfCertificate(const std::string& text,
                                                  const std::string& path) {
  const base::Result<Json> stored = parsed(text, path);
  if (!stored) {
    return stored.diagnostics();
  }
  CertificationPlan plan;
  for (const Json& seed : stored->at("seeds")) {
    if (!seed.is_number_integer()) {
      return base::error("certificate.damaged", {}, path);
    }
    plan.seeds.push_back(seed.get<long long>());
  }
  for (const auto& [planner, count] : stored->at("successes").items()) {
    if (planner != kBaselinePlanner) {
      plan.planners.push_back(planner);
    }
  }
  if (plan.seeds.empty() || plan.planners.empty()) {
    return base::error("certificate.damaged", {}, path);
  }
  return plan;
}

}  // namespace app
