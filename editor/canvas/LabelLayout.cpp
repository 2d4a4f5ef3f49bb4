#include "editor/canvas/LabelLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace editor {

namespace {

using Places = std::array<QRectF, 8>;

/// Where a length begins that would begin at `begin`, moved between `low` and `high`.
double movedInto(double begin, double length, double low, double high) {
  return high - low < length ? begin : std::clamp(begin, low, high - length);
}

Places placesFor(const LabelWish& wish, const QRectF& window) {
  const double width = wish.size.width();
  const double height = wish.size.height();
  const QPointF c = wish.centre;
  const double middle = movedInto(c.x() - 0.5 * width, width, window.left(), window.right());
  const double below = c.y() + wish.clearance;
  const double above = c.y() - wish.clearance - height;
  const double right = c.x() + wish.clearance;
  const double left = c.x() - wish.clearance - width;
  const double first = wish.isAbove ? above : below;
  const double second = wish.isAbove ? below : above;
  const double beside = movedInto(c.y() - 0.5 * height, height, window.top(), window.bottom());
  return {QRectF(middle, first, width, height), QRectF(middle, second, width, height),
          QRectF(right, beside, width, height), QRectF(left, beside, width, height),
          QRectF(right, first, width, height),  QRectF(left, first, width, height),
          QRectF(right, second, width, height), QRectF(left, second, width, height)};
}

/// What a label has to touch, so that it is seen whose name it is.
QRectF aroundOf(const LabelWish& wish) {
  const double reach = wish.clearance + 1.0;
  return {wish.centre.x() - reach, wish.centre.y() - reach, 2.0 * reach, 2.0 * reach};
}

/// Rectangles by the tiles of the plane that they touch.
class Occupied {
 public:
  void add(const QRectF& rect) {
    forTiles(rect, [&](const Tile& tile) {
      tiles_[tile].push_back(rect);
      return true;
    });
  }
  bool isFree(const QRectF& place) const {
    return forTiles(place, [&](const Tile& tile) {
      const auto found = tiles_.find(tile);
      return found == tiles_.end() ||
             std::none_of(found->second.begin(), found->second.end(),
                          [&](const QRectF& other) { return other.intersects(place); });
    });
  }

 private:
  using Tile = std::pair<int, int>;
  static constexpr double kSide = 96.0;  // [px]

  /// Until `visit` gives false; gives whether it never did.
  template <class Visit>
  static bool forTiles(const QRectF& rect, Visit&& visit) {
    const auto tileOf = [](double x) { return static_cast<int>(std::floor(x / kSide)); };
    for (int x = tileOf(rect.left()); x <= tileOf(rect.right()); ++x) {
      for (int y = tileOf(rect.top()); y <= tileOf(rect.bottom()); ++y) {
        if (!visit(Tile(x, y))) {
          return false;
        }
      }
    }
    return true;
  }

  std::map<Tile, std::vector<QRectF>> tiles_;
};

}  // namespace

std::vector<QRectF> layoutLabels(const std::vector<LabelWish>& wishes,
                                 const std::vector<QRectF>& taken, const QRectF& window) {
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return wishes[a].priority > wishes[b].priority;
  });
  Occupied bodies, labels;
  for (const QRectF& part : taken) {
    bodies.add(part);
  }
  std::vector<QRectF> result(wishes.size());
  for (const std::size_t i : order) {
    const Places places = placesFor(wishes[i], window);
    const QRectF near = aroundOf(wishes[i]);
    const auto isOffLabels = [&](const QRectF& place) {
      return window.contains(place) && near.intersects(place) && labels.isFree(place);
    };
    const auto* found = std::find_if(places.begin(), places.end(), [&](const QRectF& place) {
      return isOffLabels(place) && bodies.isFree(place);
    });
    if (found == places.end() && wishes[i].isNeeded) {
      found = std::find_if(places.begin(), places.end(), isOffLabels);
    }
    if (found != places.end()) {
      result[i] = *found;
      labels.add(*found);
    }
  }
  return result;
}

}  // namespace editor
