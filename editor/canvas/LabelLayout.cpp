#include "editor/canvas/LabelLayout.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace editor {

namespace {

std::array<QRectF, 4> placesFor(const LabelWish& wish) {
  const double width = wish.size.width();
  const double height = wish.size.height();
  const QPointF c = wish.centre;
  const QRectF below(c.x() - 0.5 * width, c.y() + wish.clearance, width, height);
  const QRectF above(c.x() - 0.5 * width, c.y() - wish.clearance - height, width, height);
  const QRectF right(c.x() + wish.clearance, c.y() - 0.5 * height, width, height);
  const QRectF left(c.x() - wish.clearance - width, c.y() - 0.5 * height, width, height);
  return wish.isAbove ? std::array<QRectF, 4>{above, below, right, left}
                      : std::array<QRectF, 4>{below, above, right, left};
}

bool isFree(const QRectF& place, const std::vector<QRectF>& taken) {
  return std::none_of(taken.begin(), taken.end(),
                      [&](const QRectF& other) { return other.intersects(place); });
}

}  // namespace

std::vector<QRectF> layoutLabels(const std::vector<LabelWish>& wishes,
                                 const std::vector<QRectF>& taken) {
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return wishes[a].priority > wishes[b].priority;
  });
  std::vector<QRectF> occupied = taken;
  std::vector<QRectF> result(wishes.size());
  for (const std::size_t i : order) {
    const std::array<QRectF, 4> places = placesFor(wishes[i]);
    const auto found = std::find_if(places.begin(), places.end(),
                                    [&](const QRectF& place) { return isFree(place, occupied); });
    if (found != places.end()) {
      result[i] = *found;
      occupied.push_back(*found);
    }
  }
  return result;
}

}  // namespace editor
