#include "sim2d/world/Physics.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <new>
#include <utility>

#include <box2d/b2_distance.h>
#include <box2d/box2d.h>

#include "sim2d/world/StepBuffers.h"

/// Replaces the function of the Box2D library, which returns nullptr when memory is exhausted while
/// Box2D does not check for it. Memory is still freed by the library's b2Free_Default(): std::free.
void* b2Alloc_Default(int32 size) {
  if (void* memory = std::malloc(static_cast<std::size_t>(size)); memory != nullptr) {
    return memory;
  }
  throw std::bad_alloc();
}

namespace sim2d {
namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 6;
constexpr double kDiscSkin = b2_linearSlop / 2.0F;  // [m], of discs: Box2D allows this much overlap
constexpr double kContactEndDistance = 0.02;        // [m]; a contact ends beyond this distance
constexpr double kRounding = 2e-5;                  // [m]; error of single precision
constexpr float kMinEdge = 0.0075F;                 // [m]; above the slop of Box2D
constexpr double kMinPieceArea = 1e-5;  // [m²]; smaller pieces of a footprint are ignored

bool isConvex(const std::vector<Vec2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& a = points[i];
    const Vec2& b = points[(i + 1) % points.size()];
    const Vec2& c = points[(i + 2) % points.size()];
    if (base::cross(b - a, c - b) < 0.0) {
      return false;
    }
  }
  return true;
}

bool isEar(const std::vector<Vec2>& points, std::size_t at) {
  const std::size_t count = points.size();
  const std::vector<Vec2> ear = {points[(at + count - 1) % count], points[at],
                                 points[(at + 1) % count]};
  if (base::cross(ear[1] - ear[0], ear[2] - ear[1]) <= 0.0) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const bool isCorner = i == at || i == (at + 1) % count || i == (at + count - 1) % count;
    if (!isCorner && isInside(ear, points[i])) {
      return false;
    }
  }
  return true;
}

/// Without friction.
void addShape(b2Body& body, const b2Shape& shape, bool passesSameKind) {
  b2FixtureDef definition;
  definition.friction = 0.0F;
  definition.density = 1.0F;
  definition.filter.groupIndex = passesSameKind ? -1 : 0;
  definition.shape = &shape;
  body.CreateFixture(&definition);
}

void addDisc(b2Body& body, float radius, bool passesSameKind) {
  b2CircleShape circle;
  circle.m_radius = radius;
  addShape(body, circle, passesSameKind);
}

void addFootprint(b2Body& body, const BodySpec& spec) {
  for (const std::vector<Vec2>& piece : convexPieces(spec.footprint, b2_maxPolygonVertices)) {
    std::vector<b2Vec2> corners;
    corners.reserve(piece.size());
    for (const Vec2& point : piece) {
      corners.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    }
    b2PolygonShape polygon;
    polygon.Set(corners.data(), static_cast<int32>(corners.size()));
    addShape(body, polygon, spec.passesSameKind);
  }
}

void scaleMass(b2Body& body, float factor) {
  b2MassData mass = {};
  body.GetMassData(&mass);
  mass.mass *= factor;
  mass.I *= factor;
  body.SetMassData(&mass);
}

void setMass(b2Body& body, float kilograms) {
  const float now = body.GetMass();
  scaleMass(body, now > 0.0F ? kilograms / now : 1.0F);
}

Contact contactOf(b2Contact& contact, const b2Body* walls) {
  b2Body* const first = contact.GetFixtureA()->GetBody();
  b2Body* const second = contact.GetFixtureB()->GetBody();
  Contact touch;
  if (first == walls || second == walls) {
    b2Fixture* const wall = first == walls ? contact.GetFixtureA() : contact.GetFixtureB();
    touch.body = static_cast<int>((first == walls ? second : first)->GetUserData().pointer);
    touch.part = static_cast<int>(wall->GetUserData().pointer);
    return touch;
  }
  touch.body =
      static_cast<int>(std::min(first->GetUserData().pointer, second->GetUserData().pointer));
  touch.other =
      static_cast<int>(std::max(first->GetUserData().pointer, second->GetUserData().pointer));
  return touch;
}

bool isTouching(b2Contact& contact, bool wasTouching, Contact& touch) {
  b2Fixture* const first = contact.GetFixtureA();
  b2Fixture* const second = contact.GetFixtureB();
  const b2Transform& firstPlace = first->GetBody()->GetTransform();
  const b2Transform& secondPlace = second->GetBody()->GetTransform();
  b2Manifold manifold;
  manifold.pointCount = 0;
  contact.Evaluate(&manifold, firstPlace, secondPlace);
  if (manifold.pointCount > 0) {
    b2WorldManifold inWorld = {};
    inWorld.Initialize(&manifold, firstPlace, first->GetShape()->m_radius, secondPlace,
                       second->GetShape()->m_radius);
    const bool isFirst = static_cast<int>(first->GetBody()->GetUserData().pointer) == touch.body &&
                         first->GetBody()->GetType() == b2_dynamicBody;
    const double side = isFirst ? 1.0 : -1.0;
    touch.normal = side * Vec2(inWorld.normal.x, inWorld.normal.y);
    return true;
  }
  if (!wasTouching) {
    return false;
  }
  b2DistanceInput input;
  input.proxyA.Set(first->GetShape(), contact.GetChildIndexA());
  input.proxyB.Set(second->GetShape(), contact.GetChildIndexB());
  input.transformA = firstPlace;
  input.transformB = secondPlace;
  input.useRadii = true;
  b2SimplexCache cache = {};
  b2DistanceOutput output = {};
  b2Distance(&output, &cache, &input);
  return static_cast<double>(output.distance) <= kContactEndDistance;
}

}  // namespace

std::vector<std::vector<Vec2>> convexPieces(std::vector<Vec2> rest, std::size_t mostCorners) {
  std::vector<std::vector<Vec2>> pieces;
  while (rest.size() > 3 && (rest.size() > mostCorners || !isConvex(rest))) {
    std::size_t ear = 0;
    while (ear + 1 < rest.size() && !isEar(rest, ear)) {
      ++ear;
    }
    const std::size_t count = rest.size();
    pieces.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  pieces.push_back(std::move(rest));
  const auto isSliver = [](const std::vector<Vec2>& piece) {
    return signedArea(piece) < kMinPieceArea;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isSliver), pieces.end());
  return pieces;
}

Physics::Physics(const Vec2& origin)
    : world_(std::make_unique<b2World>(b2Vec2(0.0F, 0.0F))), origin_(origin) {
  world_->SetContinuousPhysics(false);
  world_->SetAllowSleeping(false);
  world_->SetWarmStarting(false);  // velocities are set in each step
  const b2BodyDef definition;
  walls_ = world_->CreateBody(&definition);
}
Physics::~Physics() = default;

b2Vec2 Physics::toLocal(const Vec2& point) const {
  return {static_cast<float>(point.x() - origin_.x()), static_cast<float>(point.y() - origin_.y())};
}

void Physics::addLoop(const Outline& outline, int part, bool enabled) {
  std::vector<b2Vec2> corners;
  for (const Vec2& point : outline.points) {
    const b2Vec2 corner = toLocal(point);
    if (corners.empty() || b2Distance(corners.back(), corner) > kMinEdge) {
      corners.push_back(corner);
    }
  }
  while (corners.size() > 1 && b2Distance(corners.front(), corners.back()) <= kMinEdge) {
    corners.pop_back();
  }
  if (corners.size() < 3) {
    return;
  }
  b2ChainShape chain;
  chain.CreateLoop(corners.data(), static_cast<int32>(corners.size()));
  chain.m_radius = 0.0F;  // bodies may come as close as the wall itself
  b2FixtureDef definition;
  definition.shape = &chain;
  definition.friction = 0.0F;
  definition.userData.pointer = static_cast<uintptr_t>(part);
  definition.filter.maskBits = enabled ? 0xFFFF : 0;
  parts_.back().push_back(walls_->CreateFixture(&definition));
}

/// Enables or disables the body in the solver. A person has a shape only while enabled; most need
/// none.
void Physics::update(Body& body) {
  const bool isKnown = body.present && !body.isolated;
  b2Fixture* const shape = body.body->GetFixtureList();
  if (body.isPerson && isKnown && shape == nullptr) {
    addDisc(*body.body, body.radius, body.passesSameKind);
    setMass(*body.body, body.mass);
  }
  body.body->SetEnabled(isKnown);
  if (body.isPerson && !isKnown && shape != nullptr) {
    body.body->DestroyFixture(shape);
  }
}

/// A body that was not moved by a contact keeps its exact velocity and position, without rounding.
void Physics::readBack(Body& body, double dt) const {
  const b2Vec2 velocity = body.body->GetLinearVelocity();
  const b2Vec2 given(static_cast<float>(body.velocity.x()), static_cast<float>(body.velocity.y()));
  if (velocity != given) {
    body.velocity = Vec2(velocity.x, velocity.y);
  }
  const b2Vec2 moved = body.body->GetPosition();
  const Vec2 found = origin_ + Vec2(moved.x, moved.y);
  const Vec2 exact = body.position + body.velocity * dt;
  body.position = (found - exact).norm() <= kRounding ? exact : found;
  if (body.body->GetAngularVelocity() != static_cast<float>(body.omega)) {
    body.omega = static_cast<double>(body.body->GetAngularVelocity());
  }
  const double turned = base::wrapToPi(body.heading + body.omega * dt);
  const double angle = base::wrapToPi(static_cast<double>(body.body->GetAngle()));
  body.heading =
      body.body->IsFixedRotation() || std::fabs(base::angleDiff(angle, turned)) <= kRounding
          ? turned
          : angle;
}

void Physics::addPart(const std::vector<Outline>& outlines, bool enabled) {
  const int part = static_cast<int>(parts_.size());
  parts_.emplace_back();
  for (const Outline& outline : outlines) {
    addLoop(outline, part, enabled);
  }
}

void Physics::setPartEnabled(int part, bool enabled) {
  for (b2Fixture* const fixture : parts_[static_cast<std::size_t>(part)]) {
    b2Filter filter = fixture->GetFilterData();
    filter.maskBits = enabled ? 0xFFFF : 0;
    fixture->SetFilterData(filter);
  }
}

int Physics::addBody(const BodySpec& spec) {
  const int index = static_cast<int>(bodies_.size());
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = toLocal(spec.pose.position);
  definition.angle = static_cast<float>(spec.pose.heading);
  definition.fixedRotation = spec.fixedRotation;
  definition.enabled = false;
  definition.userData.pointer = static_cast<uintptr_t>(index);
  Body body;
  body.body = world_->CreateBody(&definition);
  body.position = spec.pose.position;
  body.heading = spec.pose.heading;
  body.radius = static_cast<float>(spec.radius + kDiscSkin);
  body.mass = static_cast<float>(spec.mass);
  body.isPerson = spec.fixedRotation && spec.footprint.empty();
  body.passesSameKind = spec.passesSameKind;
  body.isolated = spec.isolated;
  if (!body.isPerson) {
    spec.footprint.empty() ? addDisc(*body.body, body.radius, body.passesSameKind)
                           : addFootprint(*body.body, spec);
    setMass(*body.body, body.mass);
  }
  update(body);
  bodies_.push_back(body);
  return index;
}

void Physics::setPresent(int body, bool present) {
  Body& changed = at(body);
  changed.present = present;
  update(changed);
}

void Physics::place(int body, const Pose2& pose) {
  Body& moved = at(body);
  moved.position = pose.position;
  moved.heading = pose.heading;
  moved.velocity = Vec2::Zero();
  moved.omega = 0.0;
  moved.body->SetTransform(toLocal(pose.position), static_cast<float>(pose.heading));
}

void Physics::setVelocity(int body, const Vec2& velocity, double omega) {
  Body& moved = at(body);
  moved.velocity = velocity;
  moved.omega = omega;
  if (moved.isolated) {
    return;
  }
  moved.body->SetLinearVelocity(
      {static_cast<float>(velocity.x()), static_cast<float>(velocity.y())});
  moved.body->SetAngularVelocity(moved.body->IsFixedRotation() ? 0.0F : static_cast<float>(omega));
}

void Physics::setIsolated(int body, bool isolated) {
  Body& changed = at(body);
  if (changed.isolated == isolated) {
    return;
  }
  changed.isolated = isolated;
  if (!isolated) {  // it moved outside the solver
    changed.body->SetTransform(toLocal(changed.position), static_cast<float>(changed.heading));
  }
  update(changed);
}

void Physics::setBraked(int body, bool braked) {
  Body& changed = at(body);
  if (changed.braked == braked) {
    return;
  }
  changed.braked = braked;
  scaleMass(*changed.body,
            static_cast<float>(braked ? kBrakedMassFactor : 1.0 / kBrakedMassFactor));
}

void Physics::step(double dt, int subSteps) {
  for (int i = 0; i < subSteps; ++i) {
    world_->Step(static_cast<float>(dt / subSteps), kVelocityIterations, kPositionIterations);
  }
  for (Body& body : bodies_) {
    if (body.present && body.isolated) {
      body.position += body.velocity * dt;
      body.heading = base::wrapToPi(body.heading + body.omega * dt);
    } else if (body.present) {
      readBack(body, dt);
    }
  }
}

void Physics::currentContacts(const std::vector<Contact>& before, std::vector<Contact>& found) {
  found.clear();
  for (b2Contact* contact = world_->GetContactList(); contact != nullptr;
       contact = contact->GetNext()) {
    Contact touch = contactOf(*contact, walls_);
    const bool wasTouching = std::binary_search(before.begin(), before.end(), touch);
    if (isTouching(*contact, wasTouching, touch)) {
      found.push_back(touch);
    }
  }
  sortStably(found, std::less<>());
  const auto end = std::unique(found.begin(), found.end(),
                               [](const Contact& a, const Contact& b) { return !(a < b); });
  found.erase(end, found.end());
}

}  // namespace sim2d
