#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/nav2/global/PlannerParameters.h"

/// What is wrong with parameters: a sentence for each, beginning with the key.
namespace sim2d::nav2 {

std::vector<std::string> plannerComplaints(const NavfnParameters& parameters);
std::vector<std::string> plannerComplaints(const ThetaStarParameters& parameters);
std::vector<std::string> plannerComplaints(const Smac2DParameters& parameters);
std::vector<std::string> plannerComplaints(const SmacHybridParameters& parameters);
std::vector<std::string> plannerComplaints(const SmacLatticeParameters& parameters);

/// Collects them.
class Complaints {
 public:
  /// Unless `low` <= value <= `high`.
  Complaints& range(const char* key, double value, double low, double high);
  Complaints& oneOf(const char* key, const std::string& value,
                    const std::vector<std::string>& allowed);
  Complaints& unless(bool isGood, std::string sentence);
  std::vector<std::string> take() { return std::move(sentences_); }

 private:
  std::vector<std::string> sentences_;
};

}  // namespace sim2d::nav2
