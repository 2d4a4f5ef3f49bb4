#pragma once

#include <memory>
#include <tuple>
#include <vector>

#include "sim2d/map/Outlines.h"

class b2Body;
class b2Fixture;
class b2World;
struct b2Vec2;

namespace sim2d {

/// A disc, or a polygon in body frame if `footprint` is not empty.
struct BodySpec {
  Pose2 pose;
  double radius = 0.35;  // [m]
  double mass = 80.0;    // [kg]
  std::vector<Vec2> footprint;
  bool fixedRotation = false;   // people: contacts do not rotate them
  bool passesSameKind = false;  // bodies with this flag pass through each other
  bool isolated = false;        // see setIsolated()
};

/// Contact after the step between two bodies, or between a body and a part of the surroundings.
struct Contact {
  int body = 0;
  int other = -1;              // body, or -1
  int part = -1;               // part of the surroundings, or -1
  Vec2 normal = Vec2::Zero();  // unit vector from `body` to the other

  friend bool operator<(const Contact& a, const Contact& b) {
    return std::tie(a.body, a.other, a.part) < std::tie(b.body, b.other, b.part);
  }
};

/// Splits a simple counter-clockwise polygon into convex pieces with at most `mostCorners` (>= 3)
/// vertices, by ear clipping until the rest is one.
std::vector<std::vector<Vec2>> convexPieces(std::vector<Vec2> polygon, std::size_t mostCorners);

constexpr double kBrakedMassFactor = 1000.0;  // mass factor of a body with brakes on

/// Rigid bodies that do not penetrate each other or walls, based on Box2D 2.4. Single precision
/// relative to `origin`; a body without contacts moves in double precision. Bodies are numbered in
/// the order of creation.
class Physics {
 public:
  explicit Physics(const Vec2& origin);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;
  Physics(Physics&&) = delete;
  Physics& operator=(Physics&&) = delete;

  /// Adds a part of the surroundings, numbered from 0; solid on the left of its outlines.
  void addPart(const std::vector<Outline>& outlines, bool enabled);
  void setPartEnabled(int part, bool enabled);

  void reserve(std::size_t bodies) { bodies_.reserve(bodies); }
  int addBody(const BodySpec& spec);
  void setPresent(int body, bool present);
  void place(int body, const Pose2& pose);
  /// Sets the velocity for the next step; people (`fixedRotation`) have omega 0.
  void setVelocity(int body, const Vec2& velocity, double omega);
  /// A body with this flag has no contacts in the next step: it moves outside the solver. Call
  /// before `setVelocity`. The flag is initially off.
  void setIsolated(int body, bool isolated);
  /// A braked body counts 1000 times its mass, so that others hardly push it.
  void setBraked(int body, bool braked);
  /// More `subSteps` reduce the penetration of fast bodies.
  void step(double dt, int subSteps = 1);

  Pose2 pose(int body) const { return {at(body).position, at(body).heading}; }
  const Vec2& velocity(int body) const { return at(body).velocity; }  // after contacts [m/s]
  double omega(int body) const { return at(body).omega; }             // [rad/s]

  /// Touching pairs, sorted by body, other and part. A pair from `before` counts as touching until
  /// the distance exceeds 2 cm.
  void currentContacts(const std::vector<Contact>& before, std::vector<Contact>& found);

 private:
  struct Body {
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    b2Body* body = nullptr;
    double heading = 0.0;
    double omega = 0.0;
    float radius = 0.0F, mass = 0.0F;  // of a person
    bool isPerson = false;
    bool passesSameKind = false;
    bool present = true;
    bool braked = false;
    bool isolated = false;
  };

  Body& at(int body) { return bodies_[static_cast<std::size_t>(body)]; }
  const Body& at(int body) const { return bodies_[static_cast<std::size_t>(body)]; }
  b2Vec2 toLocal(const Vec2& point) const;
  void addLoop(const Outline& outline, int part, bool enabled);
  static void update(Body& body);
  void readBack(Body& body, double dt) const;

  std::unique_ptr<b2World> world_;
  Vec2 origin_;
  b2Body* walls_ = nullptr;
  std::vector<std::vector<b2Fixture*>> parts_;
  std::vector<Body> bodies_;
};

}  // namespace sim2d
