#include "sim2d/nav/nav2/global/PlannerChecks.h"

#include <algorithm>

#include "sim2d/base/Text.h"

namespace sim2d::nav2 {
namespace {

constexpr double kFarTolerance = 100.0;  // [m]
constexpr double kMostWeight = 1e6;      // of a cost
constexpr double kMostCount = 2147483647.0;

void addSmacComplaints(const SmacParameters& given, Complaints& complaints) {
  complaints.range("downsampling_factor", given.downsamplingFactor, 1.0, 1000.0)
      .range("terminal_checking_interval", given.terminalCheckingInterval, 1.0, kMostCount)
      .range("smoother.max_iterations", given.smootherMaxIterations, 0.0, 1e6)
      .range("smoother.w_data", given.smootherWData, 0.0, 1.0)
      .range("smoother.w_smooth", given.smootherWSmooth, 0.0, 0.5)
      .range("smoother.tolerance", given.smootherTolerance, 0.0, kFarTolerance)
      .range("smoother.refinement_num", given.smootherRefinementNum, 0.0, 1000.0);
}

}  // namespace

Complaints& Complaints::range(const char* key, double value, double low, double high) {
  return unless(value >= low && value <= high,
                std::string(key) + " is " + base::formatDecimals(value, 0) + ", not " +
                    base::formatDecimals(low, 0) + " to " + base::formatDecimals(high, 0));
}

Complaints& Complaints::oneOf(const char* key, const std::string& value,
                              const std::vector<std::string>& allowed) {
  std::string names;
  for (const std::string& each : allowed) {
    names += (names.empty() ? "" : ", ") + each;
  }
  return unless(std::find(allowed.begin(), allowed.end(), value) != allowed.end(),
                std::string(key) + " is '" + value + "', not one of " + names);
}

Complaints& Complaints::unless(bool isGood, std::string sentence) {
  if (!isGood) {
    sentences_.push_back(std::move(sentence));
  }
  return *this;
}

std::vector<std::string> plannerComplaints(const NavfnParameters& parameters) {
  return Complaints()
      .range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_cycles_factor", parameters.maxCyclesFactor, 1.0, 10000.0)
      .take();
}

std::vector<std::string> plannerComplaints(const ThetaStarParameters& parameters) {
  const int corners = parameters.howManyCorners;
  return Complaints()
      .unless(corners == 4 || corners == 8,
              "how_many_corners is " + std::to_string(corners) + ", not 4 or 8")
      .range("w_euc_cost", parameters.eucCost, 0.0, kMostWeight)
      .range("w_traversal_cost", parameters.traversalCost, 0.0, kMostWeight)
      .range("terminal_checking_interval", parameters.terminalCheckingInterval, 1.0, kMostCount)
      .take();
}

std::vector<std::string> plannerComplaints(const Smac2DParameters& parameters) {
  Complaints complaints;
  complaints.range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_planning_time", parameters.maxPlanningTime, 0.0, kMostWeight)
      .range("cost_travel_multiplier", parameters.costTravelMultiplier, 0.0, kMostWeight);
  addSmacComplaints(parameters, complaints);
  return complaints.take();
}

std::vector<std::string> plannerComplaints(const SmacHybridParameters& parameters) {
  Complaints complaints;
  complaints.range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_planning_time", parameters.maxPlanningTime, 0.0, kMostWeight)
      .oneOf("motion_model_for_search", parameters.motionModelForSearch, {"DUBIN", "REEDS_SHEPP"})
      .oneOf("goal_heading_mode", parameters.goalHeadingMode,
             {"DEFAULT", "BIDIRECTIONAL", "ALL_DIRECTION"})
      .range("minimum_turning_radius", parameters.minimumTurningRadius, 0.0, kFarTolerance)
      .range("angle_quantization_bins", parameters.angleQuantizationBins, 4.0, 720.0)
      .range("reverse_penalty", parameters.reversePenalty, 0.0, kMostWeight)
      .range("change_penalty", parameters.changePenalty, 0.0, kMostWeight)
      .range("non_straight_penalty", parameters.nonStraightPenalty, 0.0, kMostWeight)
      .range("cost_penalty", parameters.costPenalty, 0.0, kMostWeight)
      .range("retrospective_penalty", parameters.retrospectivePenalty, 0.0, 1.0)
      .range("lookup_table_size", parameters.lookupTableSize, 0.0, kMostWeight)
      .range("analytic_expansion_ratio", parameters.analyticExpansionRatio, 1e-3, kMostWeight)
      .range("analytic_expansion_max_length", parameters.analyticExpansionMaxLength, 0.0,
             kMostWeight)
      .range("analytic_expansion_max_cost", parameters.analyticExpansionMaxCost, 0.0, 255.0)
      .range("coarse_search_resolution", parameters.coarseSearchResolution, 1.0, 720.0);
  addSmacComplaints(parameters, complaints);
  return complaints.take();
}

std::vector<std::string> plannerComplaints(const SmacLatticeParameters& parameters) {
  Complaints complaints;
  complaints.range("tolerance", parameters.tolerance, 0.0, kFarTolerance)
      .range("max_planning_time", parameters.maxPlanningTime, 0.0, kMostWeight)
      .oneOf("goal_heading_mode", parameters.goalHeadingMode,
             {"DEFAULT", "BIDIRECTIONAL", "ALL_DIRECTION"})
      .range("reverse_penalty", parameters.reversePenalty, 0.0, kMostWeight)
      .range("change_penalty", parameters.changePenalty, 0.0, kMostWeight)
      .range("non_straight_penalty", parameters.nonStraightPenalty, 0.0, kMostWeight)
      .range("rotation_penalty", parameters.rotationPenalty, 0.0, kMostWeight)
      .range("cost_penalty", parameters.costPenalty, 0.0, kMostWeight)
      .range("retrospective_penalty", parameters.retrospectivePenalty, 0.0, 1.0)
      .range("analytic_expansion_ratio", parameters.analyticExpansionRatio, 1e-3, kMostWeight)
      .range("analytic_expansion_max_length", parameters.analyticExpansionMaxLength, 0.0,
             kMostWeight)
      .range("analytic_expansion_max_cost", parameters.analyticExpansionMaxCost, 0.0, 255.0);
  addSmacComplaints(parameters, complaints);
  return complaints.take();
}

}  // namespace sim2d::nav2
