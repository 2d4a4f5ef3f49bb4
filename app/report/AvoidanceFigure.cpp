#include "app/report/AvoidanceFigure.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/studies/Manoeuvres.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr double kAvoidanceWidth = 480.0, kAvoidanceHeight = 360.0;  // [px]
constexpr double kRoomAround = 1.0;                                  // around the paths [m]
constexpr double kSmallestArea = 4.0;                                // shown area [m]
constexpr double kAvoidanceRow = 18.0;                               // [px]
constexpr std::size_t kRobotColor = 0, kPersonColor = 1;

/// The recorded states of both bodies from the instant of the action to the contact.
struct Approach {
  std::vector<base::Vec2> robot, person;
};

Approach approachOf(const sim2d::Trace& trace, const app::AvoidableContact& contact, double from) {
  constexpr double kRounding = 1e-6;  // [s]
  Approach approach;
  for (const sim2d::Frame& frame : trace.frames) {
    if (frame.time < from - kRounding || frame.step > contact.step) {
      continue;
    }
    const auto add = [&frame](int id, std::vector<base::Vec2>& path) {
      if (const std::optional<app::BodyState> state = app::bodyStateIn(frame, id)) {
        path.push_back(state->pose.position);
      }
    };
    add(contact.robot, approach.robot);
    add(contact.person, approach.person);
  }
  return approach;
}

class AvoidanceMap {
 public:
  AvoidanceMap(Figure& figure, const std::vector<const std::vector<base::Vec2>*>& paths)
      : figure_(figure) {
    bool isFirst = true;
    for (const auto* path : paths) {
      for (const base::Vec2& point : *path) {
        low_ = isFirst ? point : low_.cwiseMin(point).eval();
        high_ = isFirst ? point : high_.cwiseMax(point).eval();
        isFirst = false;
      }
    }
    const base::Vec2 centre = 0.5 * (low_ + high_);
    const base::Vec2 half =
        (0.5 * (high_ - low_) + base::Vec2(kRoomAround, kRoomAround)).cwiseMax(0.5 * kSmallestArea);
    scale_ = std::min(kAvoidanceWidth / (2.0 * half.x()), kAvoidanceHeight / (2.0 * half.y()));
    const base::Vec2 shown(kAvoidanceWidth / scale_, kAvoidanceHeight / scale_);
    low_ = centre - 0.5 * shown;
    high_ = centre + 0.5 * shown;
  }

  base::Vec2 at(const base::Vec2& world) const {
    return {(world.x() - low_.x()) * scale_, (high_.y() - world.y()) * scale_};
  }
  /// `role`: also the id of the shape, as its line width is part of the role.
  void outlines(const std::vector<sim2d::Outline>& outlines, const char* role) {
    std::string path;
    for (const sim2d::Outline& outline : outlines) {
      const char* move = "M";
      for (const base::Vec2& point : outline.points) {
        const base::Vec2 pixels = at(point);
        path += move + pixel(pixels.x()) + " " + pixel(pixels.y());
        move = "L";
      }
      path += "Z";
    }
    if (!path.empty()) {
      figure_.define(role, path, role);
      figure_.use(role, 0.0, 0.0);
    }
  }
  void path(const std::vector<base::Vec2>& path, const std::string& role, double width) {
    std::vector<base::Vec2> points;
    points.reserve(path.size());
    for (const base::Vec2& point : path) {
      points.push_back(at(point));
    }
    figure_.polyline(points, role, width);
  }
  void body(const base::Vec2& place, double radius, std::size_t color, double opacity) {
    const base::Vec2 pixels = at(place);
    figure_.disc(pixels.x(), pixels.y(), radius * scale_, fillOf(color), opacity);
  }
  double scale() const { return scale_; }

 private:
  Figure& figure_;
  base::Vec2 low_ = base::Vec2::Zero(), high_ = base::Vec2::Zero();  // [m]
  double scale_ = 1.0;                                               // [px/m]
};

std::string secondsText(double time) {
  return base::formatDecimals(std::round(100.0 * time) / 100.0, 2) + " s";
}

struct ContactBodies {
  std::string robot, person;                       // names
  double robotRadius = 0.35, personRadius = 0.35;  // [m]
};

ContactBodies contactBodiesOf(const sim2d::TraceHeader& header,
                              const app::AvoidableContact& contact) {
  ContactBodies bodies;
  if (const sim2d::TraceRobot* const robot = header.robot(contact.robot)) {
    bodies.robot = robot->name;
    bodies.robotRadius = robot->radius;
  }
  if (const sim2d::TraceHuman* const person = header.human(contact.person)) {
    bodies.person = person->name;
    bodies.personRadius = person->radius;
  }
  return bodies;
}

/// The last line of the legend and the caption.
std::string actionText(const ContactBodies& bodies, const app::AvoidableContact& contact) {
  const app::AvoidingAction* const action = contact.robotAction    ? &*contact.robotAction
                                            : contact.personAction ? &*contact.personAction
                                                                   : nullptr;
  if (action == nullptr) {
    return "no manoeuvre that was tried avoids the contact at " + secondsText(contact.time);
  }
  return (contact.robotAction ? bodies.robot : bodies.person) +
         " could still avoid the contact at " + secondsText(contact.time) + " until " +
         secondsText(action->time) + ": " + action->manoeuvre;
}

void drawAvoidanceLegend(Figure& figure, const AvoidanceMap& map, const ContactBodies& bodies,
                         const app::AvoidableContact& contact) {
  double y = kAvoidanceHeight + kAvoidanceRow;
  const auto sample = [&](std::size_t color, const std::string& text) {
    figure.line(4.0, y - 4.0, 26.0, y - 4.0, strokeOf(color), 2.0);
    figure.text(34.0, y, text);
    y += kAvoidanceRow;
  };
  sample(kRobotColor, bodies.robot + " with the manoeuvre");
  sample(kPersonColor, bodies.person + " in answer to it");
  figure.line(4.0, y - 4.0, 26.0, y - 4.0, "axis", 2.0);
  figure.text(34.0, y, "recorded, up to the contact");
  figure.line(kAvoidanceWidth - 10.0 - map.scale(), y - 4.0, kAvoidanceWidth - 10.0, y - 4.0,
              "line", 2.0);
  figure.text(kAvoidanceWidth - 16.0 - map.scale(), y, "1 m", "ink", Figure::Anchor::End);
  figure.text(4.0, y + kAvoidanceRow, actionText(bodies, contact));
}

}  // namespace

Figure avoidanceFigure(const std::string& name, const sim2d::Trace& trace,
                       const FloorPlan& floorPlan, const app::AvoidableContact& contact) {
  static const app::AvoidingAction kNone;
  const app::AvoidingAction& action = contact.robotAction    ? *contact.robotAction
                                      : contact.personAction ? *contact.personAction
                                                             : kNone;
  const bool hasAction = contact.robotAction || contact.personAction;
  const Approach recorded =
      approachOf(trace, contact, hasAction ? action.time : contact.time - 1.0);
  Figure figure(name, kAvoidanceWidth, kAvoidanceHeight + 5.0 * kAvoidanceRow);
  AvoidanceMap map(figure,
                   {&recorded.robot, &recorded.person, &action.robotPath, &action.personPath});
  const ContactBodies bodies = contactBodiesOf(trace.header, contact);
  figure.caption = actionText(bodies, contact);
  figure.rect(0.0, 0.0, kAvoidanceWidth, kAvoidanceHeight, "ground");
  figure.beginClip(0.0, 0.0, kAvoidanceWidth, kAvoidanceHeight);
  map.outlines(floorPlan.shapes, "solid");
  map.outlines(floorPlan.walls, "wall");
  const auto drawBody = [&map](const std::vector<base::Vec2>& path, double radius,
                               std::size_t color) {
    if (!path.empty()) {
      map.body(path.back(), radius, color, 0.25);
      map.body(path.front(), radius, color, 0.7);
    }
  };
  drawBody(recorded.person, bodies.personRadius, kPersonColor);
  drawBody(recorded.robot, bodies.robotRadius, kRobotColor);
  map.path(recorded.person, "axis", 6.0);
  map.path(recorded.robot, "axis", 6.0);
  map.path(action.personPath, strokeOf(kPersonColor), 2.0);
  map.path(action.robotPath, strokeOf(kRobotColor), 2.5);
  figure.endClip();
  drawAvoidanceLegend(figure, map, bodies, contact);
  return figure;
}

}  // namespace report
