#include "bt/human/Ports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bt/tree/TextValue.h"
#include "sim2d/base/Text.h"

namespace bt {

std::optional<std::vector<int>> parseIds(const std::string& text) {
  std::vector<int> ids;
  for (const std::string& part : base::split(text, ',')) {
    const std::string token = base::trimmed(part);
    if (token.empty()) {
      continue;
    }
    const std::optional<int> id = intFromText(token);
    if (!id) {
      return std::nullopt;
    }
    ids.push_back(*id);
  }
  return ids;
}

std::optional<std::vector<double>> parseWeights(std::string_view text) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const std::string& token : base::split(text, ';')) {
    const std::optional<double> weight = base::parseDouble(base::trimmed(token));
    if (!weight || !(*weight >= 0.0)) {
      return std::nullopt;
    }
    weights.push_back(*weight);
    sum += *weight;
  }
  const bool isUsable = sum > 0.0 && std::isfinite(sum);
  return isUsable ? std::optional<std::vector<double>>(std::move(weights)) : std::nullopt;
}

bool isPersonPort(std::string_view name) {
  constexpr std::array<std::string_view, 6> kPorts = {"agent_id",      "target_agent_id",
                                                      "target_id",     "observer_id",
                                                      "main_agent_id", "non_main_agent_ids"};
  return std::find(kPorts.begin(), kPorts.end(), name) != kPorts.end();
}

NodeCatalogue humanManifests(std::string_view text) {
  static const std::string kCommonPorts = R"(
agent_id int needed suggest {id}|Id of the person who acts or perceives.
target_agent_id int needed suggest 2|Id of the other person.
time_step seconds suggest {dt}|Step length for HuNavSim; here the step of the simulation counts.
duration duration atMost 36000 default 0.0 suggest 5.0|Ends after this time; 0 = goes on.
goal_id int unless target_x target_y suggest 1|Id of the global goal.
target_x metres|x of a point, when no goal_id is given.
target_y metres|y of a point, when no goal_id is given.
non_main_agent_ids any|Ids of the other members, with commas between them.
)";
  return nodesOf(kCommonPorts + std::string(text), NodeOrigin::HuNavSim);
}

}  // namespace bt
