#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim2d/base/Rng.h"
#include "tests/nav/MppiWorld.h"

/// Meetings of a robot with people who walk by the social force model, varied by a seed.
namespace mppitest {

enum class Meeting { Corridor, Doorway, Crossing, BlindCorner, Crowd, Talk };
constexpr std::array<Meeting, 6> kMeetings = {Meeting::Corridor, Meeting::Doorway,
                                              Meeting::Crossing, Meeting::BlindCorner,
                                              Meeting::Crowd,    Meeting::Talk};

inline const char* meetingName(Meeting meeting) {
  constexpr std::array<const char*, 6> kNames = {"corridor", "doorway", "crossing",
                                                 "corner",   "crowd",   "talk"};
  return kNames[static_cast<std::size_t>(meeting)];
}

struct Scene {
  std::unique_ptr<World> world;
  sim2d::Pose2 pose;
  Vec2 goal = Vec2::Zero();
  std::vector<Human> people;
};

inline Human walker(const Vec2& from, std::vector<Vec2> way, double speed) {
  Human human;
  human.position = from;
  human.speed = speed;
  human.heading = base::headingOf(way.front() - from);
  human.velocity = speed * base::directionOf(human.heading);
  human.way = std::move(way);
  return human;
}

inline Human standing(const Vec2& place, double heading) {
  Human human;
  human.position = place;
  human.heading = heading;
  human.reacts = false;
  human.speed = 0.0;
  return human;
}

class SceneMaker {
 public:
  SceneMaker(Meeting meeting, std::uint64_t seed)
      : meeting_(meeting), rng_(seed, static_cast<int>(meeting)) {}

  Scene make() {
    Scene scene;
    scene.pose = {Vec2(0.0, jitter(0.2)), 0.0};
    scene.goal = Vec2(10.0, 0.0);
    scene.world =
        std::make_unique<World>(walls(), std::vector<Vec2>{Vec2(-4.0, -6.0), Vec2(14.0, 10.0)});
    if (meeting_ == Meeting::BlindCorner) {
      scene.goal = Vec2(6.0, 6.5);
    }
    scene.people = people();
    return scene;
  }

 private:
  double jitter(double half) { return rng_.uniform(-half, half, base::DrawPurpose::Test, next_++); }

  std::vector<sim2d::Outline> walls() const {
    switch (meeting_) {
      case Meeting::Corridor:
        return {box(-6.0, 1.5, 16.0, 1.7), box(-6.0, -1.7, 16.0, -1.5)};
      case Meeting::Doorway:
        return {box(4.9, 0.6, 5.1, 8.0), box(4.9, -8.0, 5.1, -0.6)};
      case Meeting::BlindCorner:
        return {box(-5.0, 1.2, 4.8, 12.0), box(-5.0, -1.4, 7.4, -1.2), box(7.2, -1.2, 7.4, 12.0)};
      default:
        return {};
    }
  }

  std::vector<Human> people() {
    switch (meeting_) {
      case Meeting::Corridor:
        return {walker(Vec2(9.0, jitter(0.4)), {Vec2(-6.0, jitter(0.3))}, 1.1 + jitter(0.2))};
      case Meeting::Doorway:
        return {walker(Vec2(8.5 + jitter(1.0), jitter(0.8)),
                       {Vec2(5.8, 0.0), Vec2(4.2, 0.0), Vec2(-6.0, 1.0 + jitter(0.5))},
                       1.0 + jitter(0.2))};
      case Meeting::Crossing:
        return {walker(Vec2(4.0 + jitter(0.5), -4.5 + jitter(1.0)), {Vec2(4.0, 12.0)},
                       1.1 + jitter(0.2)),
                walker(Vec2(6.5 + jitter(0.5), 6.0 + jitter(1.0)), {Vec2(6.0, -12.0)},
                       1.1 + jitter(0.2))};
      case Meeting::BlindCorner:
        return {walker(Vec2(6.0 + jitter(0.3), 6.0 + jitter(1.0)),
                       {Vec2(5.9, 0.6), Vec2(4.5, 0.0), Vec2(-8.0, jitter(0.3))},
                       1.1 + jitter(0.2))};
      case Meeting::Crowd:
        return crowd();
      default:
        return {standing(Vec2(4.0 + jitter(0.2), 0.75), -0.5 * base::kPi),
                standing(Vec2(4.0 + jitter(0.2), -0.75), 0.5 * base::kPi),
                walker(Vec2(9.0, 2.0 + jitter(0.5)), {Vec2(-6.0, 1.5)}, 1.0 + jitter(0.2))};
    }
  }

  std::vector<Human> crowd() {
    std::vector<Human> people;
    people.reserve(10);
    for (int i = 0; i < 10; ++i) {
      const Vec2 from(5.0 + jitter(3.5), jitter(3.5));
      people.push_back(
          walker(from,
                 {Vec2(5.0 + jitter(4.0), jitter(4.0)), Vec2(5.0 + jitter(5.0), jitter(5.0)),
                  Vec2(5.0 + jitter(5.0), jitter(5.0))},
                 0.9 + jitter(0.3)));
    }
    return people;
  }

  Meeting meeting_;
  base::AgentRng rng_;
  std::uint32_t next_ = 0;
};

}  // namespace mppitest
