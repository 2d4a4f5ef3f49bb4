#include <variant>

#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioYaml.h"

// Values that are valid, but most likely a typing error or a wrong unit.
namespace sim2d {
namespace {

struct UsualRange {
  const char* key;
  double low, high;
};

// Speed: crowds walk at 1.34 +- 0.26 m/s (Weidmann 1993), people who rush reach 5 m/s (Helbing,
// Farkas, Vicsek 2000). Radius: body ellipses of 0.46 x 0.61 m (Fruin 1971), up to powered
// wheelchairs of 1.2 x 0.8 m (ISO 7176-5) with space for luggage.
constexpr UsualRange kUsualPerson[] = {
    {"max_vel", 0.0, 5.0}, {"radius", 0.1, 1.0}, {"goal_radius", 0.0, 10.0}};
// A speed above 1.8 m/s has a problem of its own.
constexpr UsualRange kUsualReaction[] = {{"dist", 0.0, 100.0},
                                         {"stop_dist", 0.0, 100.0},
                                         {"front_dist", 0.0, 100.0},
                                         {"safe_distance", 0.0, 100.0}};
// Of configuration 3; HuNavSim's loader clamps the others to narrower ranges.
constexpr UsualRange kUsualFactors[] = {{"goal_force_factor", 0.0, 200.0},
                                        {"obstacle_force_factor", 0.0, 200.0},
                                        {"social_force_factor", 0.0, 200.0},
                                        {"other_force_factor", 0.0, 200.0}};
// From an infant to a person in a powered wheelchair.
constexpr UsualRange kUsualBody[] = {{"mass", 3.0, 400.0}};
// From toy robots to personal carriers (at most 20 km/h, ISO 13482) and automated trucks.
constexpr UsualRange kUsualRobot[] = {{"radius", 0.02, 5.0},      {"mass", 0.1, 5000.0},
                                      {"max_vel", 0.0, 6.0},      {"max_acc", 0.05, 20.0},
                                      {"max_omega", 0.05, 20.0},  {"max_alpha", 0.05, 200.0},
                                      {"goal_radius", 0.0, 10.0}, {"turning_radius", 0.0, 50.0}};
// The capacity of a doorway is about 1.2 people per metre and second (Weidmann 1993).
constexpr UsualRange kUsualArea[] = {{"rate", 0.0, 50.0}};

template <class T, std::size_t Count>
void checkRanges(const T& of, const UsualRange (&ranges)[Count], const Subject& subject,
                 CheckReport& report) {
  for (const UsualRange& usual : ranges) {
    const Field<T>& field = *fieldOf<T>(usual.key);
    const ParameterValue value = field.value(of);
    const double* const number = std::get_if<double>(&value);
    if (number != nullptr && (*number < usual.low || *number > usual.high)) {
      report.warning(subject, "scenario.implausible",
                     {usual.key, *number, usual.low, usual.high, field.spec.unit});
    }
  }
}

}  // namespace

void checkPlausibility(const Scenario& scenario, CheckReport& report) {
  forEachListed(scenario.humans, [&](const Human& human) {
    checkRanges(human, kUsualPerson, human, report);
    checkRanges(human.behavior, kUsualReaction, human, report);
    if (human.behavior.configuration == Configuration::Custom) {
      checkRanges(human.behavior, kUsualFactors, human, report);
    }
    checkRanges(human.ours, kUsualBody, human, report);
  });
  forEachListed(scenario.robots,
                [&](const Robot& robot) { checkRanges(robot, kUsualRobot, robot, report); });
  forEachListed(scenario.areas,
                [&](const Area& area) { checkRanges(area, kUsualArea, area, report); });
}

}  // namespace sim2d
