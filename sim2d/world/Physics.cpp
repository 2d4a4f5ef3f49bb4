#include "sim2d/world/Physics.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <box2d/b2_distance.h>
#include <box2d/box2d.h>

#include "sim2d/world/ConvexPieces.h"
#include "sim2d/world/StepBuffers.h"

namespace sim2d {
namespace {

constexpr int kVelocityIterations = 8;
constexpr int kPositionIterations = 6;
constexpr double kSkin = b2_linearSlop / 2.0F;  // [m] of discs: Box2D lets them overlap no more
constexpr double kApart = 0.02;                 // [m]; a touch ends beyond
constexpr double kRounding = 2e-5;              // [m]; what single precision may be off
constexpr float kShortestEdge = 0.0075F;  // Box2D wants more than its slop between corners [m]

}  // namespace

struct Physics::World {
  struct Body {
    Vec2 position = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
    b2Body* body = nullptr;
    double heading = 0.0;
    double omega = 0.0;
    float radius = 0.0F, mass = 0.0F;  // of a person
    bool isPerson = false;
    bool passesItsKind = false;
    bool present = true;
    bool braked = false;
    bool lonely = false;

    Pose2 pose() const { return {position, heading}; }
  };

  explicit World(const Vec2& centre) : world(b2Vec2(0.0F, 0.0F)), origin(centre) {
    world.SetContinuousPhysics(false);
    world.SetAllowSleeping(false);
    world.SetWarmStarting(false);  // velocities are given anew in each step
    const b2BodyDef definition;
    walls = world.CreateBody(&definition);
  }

  b2Vec2 toLocal(const Vec2& point) const {
    return {static_cast<float>(point.x() - origin.x()), static_cast<float>(point.y() - origin.y())};
  }
  Body& at(int index) { return bodies[static_cast<std::size_t>(index)]; }

  void addLoop(const Outline& outline, int part, bool enabled);
  static void addFootprint(b2Body& body, const BodySpec& spec);
  static void addDisc(b2Body& body, float radius, bool passesItsKind);
  static void setMass(b2Body& body, float kilograms);
  static void update(Body& body);
  void readBack(Body& body, double dt) const;
  static void moveAlone(Body& body, double dt);
  Touch touchOf(b2Contact& contact) const;
  static bool isTouching(b2Contact& contact, bool wasTouching, Touch& touch);

  b2World world;
  Vec2 origin;
  b2Body* walls = nullptr;
  std::vector<std::vector<b2Fixture*>> parts;
  std::vector<Body> bodies;
};

void Physics::World::addLoop(const Outline& outline, int part, bool enabled) {
  std::vector<b2Vec2> corners;
  for (const Vec2& point : outline.points) {
    const b2Vec2 corner = toLocal(point);
    if (corners.empty() || b2Distance(corners.back(), corner) > kShortestEdge) {
      corners.push_back(corner);
    }
  }
  while (corners.size() > 1 && b2Distance(corners.front(), corners.back()) <= kShortestEdge) {
    corners.pop_back();
  }
  if (corners.size() < 3) {
    return;
  }
  b2ChainShape chain;
  chain.CreateLoop(corners.data(), static_cast<int32>(corners.size()));
  chain.m_radius = 0.0F;  // bodies come up to the very wall
  b2FixtureDef definition;
  definition.shape = &chain;
  definition.friction = 0.0F;
  definition.userData.pointer = static_cast<uintptr_t>(part);
  definition.filter.maskBits = enabled ? 0xFFFF : 0;
  parts.back().push_back(walls->CreateFixture(&definition));
}

void Physics::World::addDisc(b2Body& body, float radius, bool passesItsKind) {
  b2CircleShape circle;
  circle.m_radius = radius;
  b2FixtureDef definition;
  definition.friction = 0.0F;
  definition.density = 1.0F;
  definition.filter.groupIndex = passesItsKind ? -1 : 0;
  definition.shape = &circle;
  body.CreateFixture(&definition);
}

void Physics::World::addFootprint(b2Body& body, const BodySpec& spec) {
  b2FixtureDef definition;
  definition.friction = 0.0F;
  definition.density = 1.0F;
  definition.filter.groupIndex = spec.passesItsKind ? -1 : 0;
  for (const std::vector<Vec2>& piece : convexPieces(spec.footprint, b2_maxPolygonVertices)) {
    std::vector<b2Vec2> corners;
    corners.reserve(piece.size());
    for (const Vec2& point : piece) {
      corners.emplace_back(static_cast<float>(point.x()), static_cast<float>(point.y()));
    }
    b2PolygonShape polygon;
    polygon.Set(corners.data(), static_cast<int32>(corners.size()));
    definition.shape = &polygon;
    body.CreateFixture(&definition);
  }
}

void Physics::World::setMass(b2Body& body, float kilograms) {
  b2MassData mass = {};
  body.GetMassData(&mass);
  const float scale = mass.mass > 0.0F ? kilograms / mass.mass : 1.0F;
  mass.mass *= scale;
  mass.I *= scale;
  body.SetMassData(&mass);
}

/// Whether the solver knows a body. People have a shape only while it does: most need none.
void Physics::World::update(Body& body) {
  const bool isKnown = body.present && !body.lonely;
  b2Fixture* const shape = body.body->GetFixtureList();
  if (body.isPerson && isKnown && shape == nullptr) {
    addDisc(*body.body, body.radius, body.passesItsKind);
    setMass(*body.body, body.mass);
  }
  body.body->SetEnabled(isKnown);
  if (body.isPerson && !isKnown && shape != nullptr) {
    body.body->DestroyFixture(shape);
  }
}

/// A body that no contact moved keeps its exact velocity and position; rounding is not taken over.
void Physics::World::readBack(Body& body, double dt) const {
  const b2Vec2 velocity = body.body->GetLinearVelocity();
  const b2Vec2 given(static_cast<float>(body.velocity.x()), static_cast<float>(body.velocity.y()));
  if (velocity != given) {
    body.velocity = Vec2(velocity.x, velocity.y);
  }
  const b2Vec2 moved = body.body->GetPosition();
  const Vec2 found = origin + Vec2(moved.x, moved.y);
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

void Physics::World::moveAlone(Body& body, double dt) {
  body.position += body.velocity * dt;
  body.heading = base::wrapToPi(body.heading + body.omega * dt);
}

Touch Physics::World::touchOf(b2Contact& contact) const {
  b2Body* const first = contact.GetFixtureA()->GetBody();
  b2Body* const second = contact.GetFixtureB()->GetBody();
  Touch touch;
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

bool Physics::World::isTouching(b2Contact& contact, bool wasTouching, Touch& touch) {
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
  return static_cast<double>(output.distance) <= kApart;
}

Physics::Physics(const Vec2& origin) : world_(std::make_unique<World>(origin)) {}
Physics::~Physics() = default;

void Physics::addPart(const std::vector<Outline>& outlines, bool enabled) {
  const int part = static_cast<int>(world_->parts.size());
  world_->parts.emplace_back();
  for (const Outline& outline : outlines) {
    world_->addLoop(outline, part, enabled);
  }
}

void Physics::setPartEnabled(int part, bool enabled) {
  for (b2Fixture* const fixture : world_->parts[static_cast<std::size_t>(part)]) {
    b2Filter filter = fixture->GetFilterData();
    filter.maskBits = enabled ? 0xFFFF : 0;
    fixture->SetFilterData(filter);
  }
}

void Physics::reserve(std::size_t bodies) {
  world_->bodies.reserve(bodies);
}

int Physics::addBody(const BodySpec& spec, bool present) {
  const int index = static_cast<int>(world_->bodies.size());
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = world_->toLocal(spec.pose.position);
  definition.angle = static_cast<float>(spec.pose.heading);
  definition.fixedRotation = spec.keepsHeading;
  definition.enabled = false;
  definition.userData.pointer = static_cast<uintptr_t>(index);
  World::Body body;
  body.body = world_->world.CreateBody(&definition);
  body.position = spec.pose.position;
  body.heading = spec.pose.heading;
  body.radius = static_cast<float>(spec.radius + kSkin);
  body.mass = static_cast<float>(spec.mass);
  body.isPerson = spec.keepsHeading && spec.footprint.empty();
  body.passesItsKind = spec.passesItsKind;
  body.present = present;
  body.lonely = spec.lonely;
  if (!body.isPerson) {
    spec.footprint.empty() ? World::addDisc(*body.body, body.radius, body.passesItsKind)
                           : World::addFootprint(*body.body, spec);
    World::setMass(*body.body, body.mass);
  }
  World::update(body);
  world_->bodies.push_back(body);
  return index;
}

void Physics::setPresent(int body, bool present) {
  World::Body& changed = world_->at(body);
  changed.present = present;
  World::update(changed);
}

void Physics::place(int body, const Pose2& pose) {
  World::Body& moved = world_->at(body);
  moved.position = pose.position;
  moved.heading = pose.heading;
  moved.velocity = Vec2::Zero();
  moved.omega = 0.0;
  moved.body->SetTransform(world_->toLocal(pose.position), static_cast<float>(pose.heading));
}

void Physics::setVelocity(int body, const Vec2& velocity, double omega) {
  World::Body& moved = world_->at(body);
  moved.velocity = velocity;
  moved.omega = omega;
  if (moved.lonely) {
    return;
  }
  moved.body->SetLinearVelocity(
      {static_cast<float>(velocity.x()), static_cast<float>(velocity.y())});
  moved.body->SetAngularVelocity(moved.body->IsFixedRotation() ? 0.0F : static_cast<float>(omega));
}

void Physics::setLonely(int body, bool lonely) {
  World::Body& changed = world_->at(body);
  if (changed.lonely == lonely) {
    return;
  }
  changed.lonely = lonely;
  if (!lonely) {  // it went on alone
    changed.body->SetTransform(world_->toLocal(changed.position),
                               static_cast<float>(changed.heading));
  }
  World::update(changed);
}

void Physics::setBraked(int body, bool braked) {
  World::Body& changed = world_->at(body);
  if (changed.braked == braked) {
    return;
  }
  changed.braked = braked;
  b2MassData mass = {};
  changed.body->GetMassData(&mass);
  const auto factor = static_cast<float>(braked ? kBrakedMass : 1.0 / kBrakedMass);
  mass.mass *= factor;
  mass.I *= factor;
  changed.body->SetMassData(&mass);
}

void Physics::step(double dt, int subSteps) {
  for (int i = 0; i < subSteps; ++i) {
    world_->world.Step(static_cast<float>(dt / subSteps), kVelocityIterations, kPositionIterations);
  }
  for (World::Body& body : world_->bodies) {
    if (body.present && body.lonely) {
      world_->moveAlone(body, dt);
    } else if (body.present) {
      world_->readBack(body, dt);
    }
  }
}

Pose2 Physics::pose(int body) const {
  return world_->at(body).pose();
}
const Vec2& Physics::velocity(int body) const {
  return world_->at(body).velocity;
}
double Physics::omega(int body) const {
  return world_->at(body).omega;
}

void Physics::touches(const std::vector<Touch>& before, std::vector<Touch>& found) {
  found.clear();
  for (b2Contact* contact = world_->world.GetContactList(); contact != nullptr;
       contact = contact->GetNext()) {
    Touch touch = world_->touchOf(*contact);
    const bool wasTouching = std::binary_search(before.begin(), before.end(), touch);
    if (World::isTouching(*contact, wasTouching, touch)) {
      found.push_back(touch);
    }
  }
  sortStably(found, std::less<>());
  const auto end = std::unique(found.begin(), found.end(),
                               [](const Touch& a, const Touch& b) { return !(a < b); });
  found.erase(end, found.end());
}

}  // namespace sim2d
