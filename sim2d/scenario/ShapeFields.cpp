#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/FieldTables.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

template <class T>
void readPoints(YamlMap& view, T& to, std::size_t least) {
  const std::vector<double> xs = view.numbers("xs");
  const std::vector<double> ys = view.numbers("ys");
  if (xs.size() != ys.size()) {
    view.error("ys", "must have as many numbers as xs");
    return;
  }
  if (xs.size() < least) {
    view.error("xs", "needs at least " + std::to_string(least) + " points");
  }
  for (std::size_t i = 0; i < xs.size(); ++i) {
    to.points.emplace_back(xs[i], ys[i]);
  }
}

template <class T>
std::function<void(YamlNode&, const T&)> writeAxis(int axis) {
  return [axis](YamlNode& tree, const T& of) {
    std::vector<double> values;
    for (const Vec2& point : of.points) {
      values.push_back(point(axis));
    }
    if (!values.empty()) {
      setChild(tree, axis == 0 ? "xs" : "ys", decimalList(values));
    }
  };
}

/// Corners: the lists `xs` and `ys`, which are read together.
template <class T>
FieldOf<T> xs(std::function<void(YamlMap&, T&)> readBoth) {
  return FieldOf<T>("xs", "Its corners: their x")
      .madeBy(std::move(readBoth), writeAxis<T>(0),
              [](const T& a, const T& b) { return a.points == b.points; })
      .required()
      .in("m")
      .form("Corners");
}

template <class T>
FieldOf<T> ys() {
  return FieldOf<T>("ys", "Their y, as many")
      .madeBy([](YamlMap&, T&) {}, writeAxis<T>(1), [](const T&, const T&) { return true; })
      .required()
      .in("m");
}

/// A coordinate or a length that must be there.
template <class T, class Access>
FieldOf<T> length(std::string key, std::string help, Access access) {
  return FieldOf<T>(std::move(key), std::move(help)).keptAt(access).required().in("m");
}

std::function<bool(const Obstacle&)> oneOf(std::vector<ObstacleKind> kinds) {
  return [kinds = std::move(kinds)](const Obstacle& obstacle) {
    return std::find(kinds.begin(), kinds.end(), obstacle.kind) != kinds.end();
  };
}

template <class T>
FieldOf<T> thickness(double usual, double step) {
  return field("thickness", &T::thickness, "How thick it is")
      .in("m")
      .within(base::kPositive)
      .orElse(usual)
      .form("Thickness", 2, step);
}

}  // namespace

Fields<Obstacle> obstacleFields() {
  const auto box = oneOf({ObstacleKind::Box});
  const auto placed = oneOf({ObstacleKind::Box, ObstacleKind::Circle});
  const auto corners = oneOf({ObstacleKind::Polygon, ObstacleKind::Wall});
  return {field("kind", &Obstacle::kind, "Its shape; the other keys belong to some shapes")
              .words({"box", "circle", "polygon", "wall"})
              .required(),
          length<Obstacle>(
              "x", "Its centre", [](auto& of) -> auto& { return of.pose.position.x(); })
              .only(placed)
              .form("X"),
          length<Obstacle>(
              "y", "Its centre", [](auto& of) -> auto& { return of.pose.position.y(); })
              .only(placed)
              .form("Y"),
          FieldOf<Obstacle>("h", "Where its length points to")
              .keptAt([](auto& of) -> auto& { return of.pose.heading; })
              .in("rad")
              .orElse(0.0)
              .only(box)
              .form("Heading"),
          field("length", &Obstacle::length, "Along its heading")
              .required()
              .in("m")
              .within(base::kPositive)
              .only(box)
              .form("Length"),
          field("width", &Obstacle::width, "Across its heading")
              .required()
              .in("m")
              .within(base::kPositive)
              .only(box)
              .form("Width"),
          field("radius", &Obstacle::radius, "Of the circle")
              .required()
              .in("m")
              .within(base::kPositive)
              .only(oneOf({ObstacleKind::Circle}))
              .form("Radius"),
          xs<Obstacle>([](YamlMap& view, Obstacle& to) {
            readPoints(view, to, to.kind == ObstacleKind::Wall ? 2 : 3);
          }).only(corners),
          ys<Obstacle>().only(corners),
          thickness<Obstacle>(0.1, 0.05).only(oneOf({ObstacleKind::Wall}))};
}

Fields<Door> doorFields() {
  return {length<Door>(
              "x1", "One end", [](auto& of) -> auto& { return of.from.x(); })
              .form("From X"),
          length<Door>(
              "y1", "One end", [](auto& of) -> auto& { return of.from.y(); })
              .form("From Y"),
          length<Door>(
              "x2", "The other end", [](auto& of) -> auto& { return of.to.x(); })
              .form("To X"),
          length<Door>(
              "y2", "The other end", [](auto& of) -> auto& { return of.to.y(); })
              .form("To Y"),
          thickness<Door>(0.05, 0.01),
          field("open", &Door::open, "Open at the start").orElse(true).form("At the start"),
          field("toggles", &Door::toggles, "It opens or closes at each of these times")
              .in("s")
              .within(base::kNotNegative)
              .form("Changes at")};
}

Fields<Area> areaFields() {
  return {field("kind", &Area::kind, "What it is for")
              .words({"source", "sink", "wait", "exit"})
              .required()
              .form("Kind"),
          xs<Area>([](YamlMap& view, Area& to) { readPoints(view, to, 3); }),
          ys<Area>(),
          field("like", &Area::like, "Source: the person it copies").form("Like"),
          field("rate", &Area::rate, "Source: people per second")
              .in("1/s")
              .within(base::kNotNegative)
              .form("Rate", 3, 0.05),
          field("from", &Area::from, "Source: people come from this time on")
              .in("s")
              .within(base::kNotNegative)
              .orElse(0.0)
              .form("From", 1, 1.0),
          field("until", &Area::until, "Source: nobody comes after this time")
              .in("s")
              .within(base::kNotNegative)
              .form("Until", 1, 1.0),
          field("count", &Area::count, "Source: at most so many people")
              .within({0.0, 1000000.0})
              .form("At most", 0, 1.0)};
}

}  // namespace sim2d
