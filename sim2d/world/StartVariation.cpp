#include "sim2d/world/StartVariation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim2d/scenario/Variation.h"

namespace sim2d {
namespace {

constexpr std::uint32_t kTrials = 16;
constexpr double kStride = 0.05;    // [m] between the places of a way that are looked at
constexpr double kFarRoom = 50.0;   // [m], beyond what distances of a map are rounded by
constexpr double kRobotRoom = 1.0;  // [m] about the middle of any robot; larger ones have more
constexpr double kRounding = 1e-9;  // [m]

struct RobotDisc {
  Vec2 position = Vec2::Zero();  // [m]
  double room = kRobotRoom;      // [m]
};

/// All robots of the scenario, and those of the run where they were moved to.
std::vector<RobotDisc> robotsOf(const Scenario& scenario, const NavigationMap& navigation,
                                const WorldModel& model) {
  std::vector<RobotDisc> discs;
  const auto add = [&discs](const Vec2& place, double reach) {
    discs.push_back({place, std::max(kRobotRoom, reach)});
  };
  for (const Robot& robot : scenario.robots) {
    const ResolvedRobot resolved = resolveRobot(scenario, robot, -1);
    const Vec2& written = resolved.start.position;
    add(navigation.nearestFit(reachOf(resolved), written).value_or(written), reachOf(resolved));
  }
  for (const ResolvedRobot& robot : model.robots) {
    add(robot.start.position, reachOf(robot));
  }
  return discs;
}

/// Where everybody begins, while it is being drawn.
class Starts {
 public:
  Starts(const Scenario& scenario, const NavigationMap& navigation, const WorldModel& model)
      : navigation_(navigation), model_(model), robots_(robotsOf(scenario, navigation, model)) {
    forEachListed(scenario.humans,
                  [this](const Human& human) { people_.emplace(human.id, &human); });
    for (const Person& person : model.people) {
      written_.push_back(person.constants.start.position);
      radii_.push_back(radiusOf(person));
      largest_ = std::max(largest_, radii_.back());
      comesLater_.push_back(writtenOf(person).ours.startTime.value_or(0.0) > 0.0 ? 1 : 0);
    }
    drawn_ = written_;
    grid_.rebuild(written_, std::vector<char>(written_.size(), 1));
  }

  void draw(std::size_t human) {
    const ResolvedHuman& person = model_.people[human].constants;
    const PersonVariation draws(model_.environment->desktop.variation,
                                static_cast<long long>(model_.seed), person.id, person.groupId);
    for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
      const Vec2 place = written_[human] + draws.startOffset(trial);
      if (base::isInReach(place) && isInRing(place) && isClear(human, place) &&
          isAwayFromPeople(human, place) && isAwayFromRobots(human, place)) {
        drawn_[human] = place;
        farthest_ = std::max(farthest_, (place - written_[human]).norm());
        return;
      }
    }
  }
  const Vec2& placeOf(std::size_t human) const { return drawn_[human]; }

 private:
  const Human& writtenOf(const Person& person) const { return *people_.at(person.constants.id); }
  /// The written one, also where the model has a smaller body: places do not depend on the model.
  double radiusOf(const Person& person) const {
    return std::max(writtenOf(person).radius.value_or(ResolvedHuman().radius),
                    person.constants.radius);
  }

  bool isInRing(const Vec2& place) const { return model_.ring.inside(place) == place; }

  /// With the room of a body, or as little as the written place has.
  bool isClear(std::size_t human, const Vec2& place) const {
    if (navigation_.isOpenPlane()) {
      return true;
    }
    const Vec2 way = place - written_[human];
    const double wanted =
        std::min(radii_[human], navigation_.clearance(written_[human])) - kRounding;
    const double room = std::max(wanted, model_.people[human].constants.radius);
    const int steps = static_cast<int>(std::ceil(way.norm() / kStride));
    for (int i = steps; i > 0;) {
      const double clearance =
          navigation_.clearance(written_[human] + way * (static_cast<double>(i) / steps));
      if (clearance < room) {
        return false;
      }
      // Far from walls the next places are free too and need not be checked.
      i -= 1 + static_cast<int>(std::clamp((clearance - room - kFarRoom) / kStride, 0.0, 1e6));
    }
    return true;
  }

  double gap(const Vec2& from, const Vec2& to) const {
    return (to + model_.ring.shift(to, from) - from).norm();
  }

  /// As far as bodies need, or as the two are written. People who come later wait until their place
  /// is free, and may begin where others of them do.
  bool isAwayFromPeople(std::size_t human, const Vec2& place) const {
    bool isAway = true;
    const double reach = radii_[human] + largest_ + farthest_;
    model_.ring.forEachImage(place, [&](const Vec2& centre) {
      grid_.forEachNear(centre, reach, [&](int index) {
        const auto other = static_cast<std::size_t>(index);
        const bool mayShare = comesLater_[human] != 0 && comesLater_[other] != 0;
        if (other == human || mayShare) {
          return;
        }
        const double needed =
            std::min(radii_[human] + radii_[other], gap(written_[human], written_[other]));
        isAway = isAway && gap(place, drawn_[other]) >= needed;
      });
    });
    return isAway;
  }

  bool isAwayFromRobots(std::size_t human, const Vec2& place) const {
    return std::all_of(robots_.begin(), robots_.end(), [&](const RobotDisc& robot) {
      const double needed =
          std::min(radii_[human] + robot.room, gap(written_[human], robot.position));
      return gap(place, robot.position) >= needed;
    });
  }

  const NavigationMap& navigation_;
  const WorldModel& model_;
  const std::vector<RobotDisc> robots_;
  std::map<int, const Human*> people_;  // by id
  std::vector<Vec2> written_, drawn_;
  std::vector<double> radii_;  // [m]
  std::vector<char> comesLater_;
  double largest_ = 0.0, farthest_ = 0.0;  // radius, way from the written place [m]
  NeighborGrid grid_;                      // of the written places
};

}  // namespace

void varyStarts(const Scenario& scenario, const NavigationMap& navigation, WorldModel& model) {
  const VariationSettings& variation = model.environment->desktop.variation;
  if (spreadOf(variation, Varied::Start).kind == SpreadKind::None) {
    return;
  }
  Starts starts(scenario, navigation, model);
  for (std::size_t i = 0; i < model.people.size(); ++i) {
    starts.draw(i);
    model.people[i].constants.start.position = starts.placeOf(i);
  }
}

}  // namespace sim2d
