#include "editor/canvas/LabelLayout.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace editor {

namespace {

using Places = std::array<QRectF, 8>;

Places placesFor(const LabelWish& wish) {
  const double width = wish.size.width();
  const double height = wish.size.height();
  const QPointF c = wish.centre;
  const double middle = c.x() - 0.5 * width;
  const double below = c.y() + wish.clearance;
  const double above = c.y() - wish.clearance - height;
  const double right = c.x() + wish.clearance;
  const double left = c.x() - wish.clearance - width;
  const double first = wish.isAbove ? above : below;
  const double second = wish.isAbove ? below : above;
  const double beside = c.y() - 0.5 * height;
  return {QRectF(middle, first, width, height), QRectF(middle, second, width, height),
          QRectF(right, beside, width, height), QRectF(left, beside, width, height),
          QRectF(right, first, width, height),  QRectF(left, first, width, height),
          QRectF(right, second, width, height), QRectF(left, second, width, height)};
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
    const Places places = placesFor(wishes[i]);
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
