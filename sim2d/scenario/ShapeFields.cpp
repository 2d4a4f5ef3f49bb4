#include "sim2d/scenario/FieldMaking.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

template <class T>
void readPoints(YamlMap& view, T& to, std::size_t least) {
  const std::vector<double> xs = view.numbers("xs");
  const std::vector<double> ys = view.numbers("ys");
  if (xs.size() != ys.size()) {
    view.error("ys", "scenario.points-uneven");
    return;
  }
  if (xs.size() < least) {
    view.error("xs", "scenario.too-few-points", {least});
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
  return FieldOf<T>("xs", "Its corners: their x", {"Corners"}, "m")
      .madeBy(std::move(readBoth), writeAxis<T>(0),
              [](const T& a, const T& b) { return a.points == b.points; })
      .typed(base::ParameterType::Numbers)
      .required();
}

template <class T>
FieldOf<T> ys() {
  return FieldOf<T>("ys", "Their y, as many", {}, "m")
      .madeBy([](YamlMap&, T&) {}, writeAxis<T>(1), [](const T&, const T&) { return true; })
      .typed(base::ParameterType::Numbers)
      .required();
}

/// A coordinate that must be there.
template <class T, class Access>
FieldOf<T> place(std::string key, std::string help, std::string label, Access access) {
  return FieldOf<T>(std::move(key), std::move(help), {std::move(label)}, "m")
      .keptAt(access)
      .required();
}

FieldOf<Obstacle> length(std::string key, double Obstacle::*member, std::string help,
                         std::string label) {
  return field(std::move(key), member, std::move(help), {std::move(label)}, "m", base::kPositive)
      .required();
}

std::function<bool(const Obstacle&)> oneOf(std::vector<ObstacleKind> kinds) {
  return [kinds = std::move(kinds)](const Obstacle& obstacle) {
    return std::find(kinds.begin(), kinds.end(), obstacle.kind) != kinds.end();
  };
}

template <class T>
FieldOf<T> thickness(double usual, double step) {
  return field("thickness", &T::thickness, "How thick it is", {"Thickness", 2, step}, "m",
               base::kPositive)
      .orElse(usual);
}

}  // namespace

Fields<Obstacle> obstacleFields() {
  const auto only = &Field<Obstacle>::applies;
  const auto placed = oneOf({ObstacleKind::Box, ObstacleKind::Circle});
  const auto box = oneOf({ObstacleKind::Box});
  const auto corners = oneOf({ObstacleKind::Polygon, ObstacleKind::Wall});
  const auto readCorners = [](YamlMap& view, Obstacle& to) {
    readPoints(view, to, to.kind == ObstacleKind::Wall ? 2 : 3);
  };
  return {field("kind", &Obstacle::kind, "Its shape; the other keys belong to some shapes")
              .words({"box", "circle", "polygon", "wall"})
              .required(),
          place<Obstacle>(
              "x", "Its centre", "X", [](auto& of) -> auto& { return of.pose.position.x(); })
              .with(only, placed),
          place<Obstacle>(
              "y", "Its centre", "Y", [](auto& of) -> auto& { return of.pose.position.y(); })
              .with(only, placed),
          FieldOf<Obstacle>("h", "Where its length points to", {"Heading"}, "rad")
              .keptAt([](auto& of) -> auto& { return of.pose.heading; })
              .orElse(0.0)
              .with(only, box),
          length("length", &Obstacle::length, "Along its heading", "Length").with(only, box),
          length("width", &Obstacle::width, "Across its heading", "Width").with(only, box),
          length("radius", &Obstacle::radius, "Of the circle", "Radius")
              .with(only, oneOf({ObstacleKind::Circle})),
          xs<Obstacle>(readCorners).with(only, corners),
          ys<Obstacle>().with(only, corners),
          thickness<Obstacle>(0.1, 0.05).with(only, oneOf({ObstacleKind::Wall}))};
}

Fields<Door> doorFields() {
  return {place<Door>(
              "x1", "One end", "From X", [](auto& of) -> auto& { return of.from.x(); }),
          place<Door>(
              "y1", "One end", "From Y", [](auto& of) -> auto& { return of.from.y(); }),
          place<Door>(
              "x2", "The other end", "To X", [](auto& of) -> auto& { return of.to.x(); }),
          place<Door>(
              "y2", "The other end", "To Y", [](auto& of) -> auto& { return of.to.y(); }),
          thickness<Door>(0.05, 0.01),
          field("open", &Door::open, "Open at the start", {"At the start"}).orElse(true),
          field("toggles", &Door::toggles, "It opens or closes at each of these times",
                {"Changes at"}, "s", base::kNotNegative)};
}

Fields<Area> areaFields() {
  return {field("kind", &Area::kind, "What it is for", {"Kind"})
              .words({"source", "sink", "wait", "exit"})
              .required(),
          xs<Area>([](YamlMap& view, Area& to) { readPoints(view, to, 3); }),
          ys<Area>(),
          field("like", &Area::like, "Source: the person it copies", {"Like"}),
          field("rate", &Area::rate, "Source: people per second", {"Rate", 3, 0.05}, "1/s",
                base::kNotNegative),
          field("from", &Area::from, "Source: people come from this time on", {"From", 1, 1.0}, "s",
                base::kNotNegative)
              .orElse(0.0),
          field("until", &Area::until, "Source: nobody comes after this time", {"Until", 1, 1.0},
                "s", base::kNotNegative),
          field("count", &Area::count, "Source: at most so many people", {"At most", 0, 1.0}, {},
                {0.0, 1000000.0})};
}

}  // namespace sim2d
