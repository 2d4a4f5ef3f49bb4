#include "editor/canvas/RunOverlays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "bt/human/Motions.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RobotPainters.h"

namespace editor {

namespace {

constexpr double kAroundSight = 6.0;         // Margin around the visible part of the map [m].
constexpr double kLongestNotice = 30.0;      // [m]
constexpr double kUsualNotice = 5.0;         // For runs that do not contain the distance [m].
constexpr std::size_t kMaxSocialZones = 30;  // More zones are indistinguishable.
constexpr std::size_t kMaxDashedPlans = 100;
constexpr std::ptrdiff_t kMaxContacts = 500;  // Only the newest ones are drawn.
constexpr double kFieldMargin = 3.0;          // Margin around people [m].

}  // namespace

void RunOverlays::end() {
  frame_.reset();
  header_.reset();
  field_.reset();
  costs_ = {};
  masks_.clear();
  most_ = 0.0;
  contacts_.clear();
  thoughts_.clear();
}

void RunOverlays::show(sim2d::FramePtr frame, const sim2d::Recording* recording) {
  if (recording != nullptr && recording->size() > 0) {
    header_ = recording->header();
  }
  frame_ = std::move(frame);
  field_.reset();
}

std::size_t RunOverlays::contactsSoFar(ContactCause cause) const {
  const double now = frame_ != nullptr ? frame_->time : 0.0;
  return static_cast<std::size_t>(
      std::count_if(contacts_.begin(), contacts_.end(), [&](const sim2d::ContactMark& mark) {
        return mark.cause == cause && mark.time <= now + 1e-9;
      }));
}

double RunOverlays::noticeDistance(int id) const {
  const sim2d::TraceHuman* const human = header_ != nullptr ? header_->human(id) : nullptr;
  if (human == nullptr) {
    return kUsualNotice;
  }
  const auto found = std::find_if(human->parameters.begin(), human->parameters.end(),
                                  [](const auto& each) { return each.first == "dist"; });
  return found != human->parameters.end() && found->second > 0.0
             ? std::min(found->second, kLongestNotice)
             : kUsualNotice;
}

std::vector<ShownBody> RunOverlays::bodiesIn(const QRectF& exposed) const {
  const QRectF seen = exposed.adjusted(-kAroundSight, -kAroundSight, kAroundSight, kAroundSight);
  std::vector<ShownBody> bodies = scene_.frameLayer().shownBodies();
  bodies.erase(std::remove_if(bodies.begin(), bodies.end(),
                              [&](const ShownBody& body) {
                                return !seen.contains(toScene(body.pose.position));
                              }),
               bodies.end());
  return bodies;
}

void RunOverlays::paintGround(QPainter& painter, const QRectF& exposed) {
  const CanvasOptions& options = scene_.options();
  const bool isAnything = options.density || options.proxemics || options.gaussian ||
                          options.sight || options.plans || options.localCosts ||
                          options.globalCosts || options.masks;
  if (frame_ == nullptr || !isAnything) {
    return;
  }
  if (isDark_ != scene_.theme().isDark()) {  // the images have the colours of the theme
    isDark_ = scene_.theme().isDark();
    costs_ = {};
    masks_.clear();
    field_.reset();
  }
  painter.setRenderHint(QPainter::Antialiasing);
  if (options.localCosts || options.globalCosts || options.masks) {
    paintCosts(painter);
  }
  const double scale = pixelsPerMetreOf(painter);
  const PixelFrame pixels(painter, {});
  const OverlayPainter over(painter, scene_.theme(), {QPointF(), scale});
  const std::vector<ShownBody> bodies = bodiesIn(exposed);
  if (options.density) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::density);
    paintDensity(over);
  }
  paintSpaces(painter, over, bodies);
  if (options.sight) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::sight);
    paintSight(over, bodies);
  }
  if (options.plans) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::plans);
    paintPlans(over, bodies);
  }
}

/// Draws the masks of filters, and the local costmap instead of that part of the global one.
void RunOverlays::paintCosts(QPainter& painter) {
  const std::optional<ObservedRobot> robot = observedPlanner(scene_);
  if (!robot) {
    return;
  }
  const CanvasOptions& options = scene_.options();
  const auto picture = [this](CostPicture& kept, const sim2d::CostGridPtr& grid) -> const QImage& {
    if (kept.grid != grid) {
      kept = {grid, costImage(*grid, scene_.theme())};
    }
    return kept.image;
  };
  if (options.masks) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::masks);
    for (const sim2d::MaskGrid& mask : robot->senses->masks) {
      QImage& image = masks_[mask.grid];
      if (image.isNull()) {
        image = maskImage(mask, scene_.theme());
      }
      paintCells(painter, *mask.grid, image);
    }
  }
  const sim2d::CostGridPtr local = options.localCosts ? robot->senses->localCosts : nullptr;
  const sim2d::CostGridPtr global = options.globalCosts ? robot->senses->globalCosts : nullptr;
  if (global != nullptr) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::globalCosts);
    paintCells(painter, *global, picture(costs_[1], global), local ? areaOf(*local) : QRectF());
  }
  if (local != nullptr) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::localCosts);
    paintCells(painter, *local, picture(costs_[0], local));
    paintCostEdge(painter, scene_.theme(), *local);
  }
}

void RunOverlays::paintDensity(const OverlayPainter& over) {
  if (!field_) {
    std::vector<Vec2> people;
    people.reserve(frame_->humans.size());
    for (std::size_t k = 0; k < frame_->humans.size(); ++k) {
      people.emplace_back(frame_->humans.x[k], frame_->humans.y[k]);
    }
    if (people.empty()) {
      return;
    }
    const auto [low, high] = *extentOf(people);
    const Vec2 margin(kFieldMargin, kFieldMargin);
    Field made;
    made.field = metrics::densityField(people, low - margin, high + margin);
    most_ = densityScale(made.field.peak(), most_);
    made.image = densityImage(made.field, scene_.theme(), most_);
    field_ = std::move(made);
  }
  over.density(field_->field, field_->image);
}

void RunOverlays::paintSpaces(QPainter& painter, const OverlayPainter& over,
                              const std::vector<ShownBody>& bodies) const {
  const CanvasOptions& options = scene_.options();
  const bool isForAll = !scene_.frameLayer().hasSelectedBody();
  for (const ShownBody& body : bodies) {
    if (body.id < 0 || !(body.isChosen || isForAll)) {
      continue;
    }
    if (options.proxemics) {
      const LayerOpacity opacity(painter, options, &CanvasOptions::proxemics);
      over.hallZones(body.pose.position, scene_.theme().fill(body.look),
                     body.isChosen || bodies.size() <= kMaxSocialZones);
    }
    if (options.gaussian) {
      const LayerOpacity opacity(painter, options, &CanvasOptions::gaussian);
      over.gaussian(body.pose, body.velocity.norm(), scene_.theme().line(body.look));
    }
  }
}

void RunOverlays::paintSight(const OverlayPainter& over,
                             const std::vector<ShownBody>& bodies) const {
  for (const ShownBody& body : bodies) {
    if (body.id < 0 || !body.isChosen || header_ == nullptr) {
      continue;
    }
    const double range = noticeDistance(body.id);
    const Vec2& eye = body.pose.position;
    over.sight(
        metrics::visibilityPolygon(body.pose, bt::kDefaultHalfView, range,
                                   metrics::wallsAround(*header_, frame_->doorOpen, eye, range)),
        scene_.theme().line(body.look));
  }
}

void RunOverlays::paintPlans(const OverlayPainter& over,
                             const std::vector<ShownBody>& bodies) const {
  if (frame_->humanPaths == nullptr) {
    return;
  }
  const bool isForAll = !scene_.frameLayer().hasSelectedBody();
  std::map<int, std::size_t> rows;
  for (std::size_t k = 0; k < std::min(frame_->humans.size(), frame_->humanPaths->size()); ++k) {
    rows.emplace(frame_->humans.id[k], k);
  }
  for (const ShownBody& body : bodies) {
    const auto row = rows.find(body.id);
    if (row == rows.end()) {
      continue;
    }
    const QColor color =
        withAlpha(scene_.theme().line(body.look), body.isChosen || isForAll ? 0.9 : 0.35);
    over.plan(body.pose.position, (*frame_->humanPaths)[row->second], color,
              bodies.size() > kMaxDashedPlans && !body.isChosen);
  }
}

void RunOverlays::paintTop(QPainter& painter, const QRectF& exposed) const {
  const CanvasOptions& options = scene_.options();
  if (frame_ == nullptr || (!options.velocities && !options.contacts)) {
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = pixelsPerMetreOf(painter);
  const PixelFrame pixels(painter, {});
  const OverlayPainter over(painter, scene_.theme(), {QPointF(), scale});
  if (options.velocities) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::velocities);
    std::vector<MovingBody> moving;
    for (const ShownBody& body : bodiesIn(exposed)) {
      const bool isRobot = body.id < 0;
      moving.push_back(
          {body.pose.position, body.velocity, body.radiusPx + 1.0,
           isRobot ? scene_.theme().color(Role::RobotLine) : scene_.theme().line(body.look)});
    }
    over.velocities(moving);
  }
  if (options.contacts) {
    const LayerOpacity opacity(painter, options, &CanvasOptions::contacts);
    const auto end = std::partition_point(
        contacts_.begin(), contacts_.end(),
        [this](const sim2d::ContactMark& mark) { return mark.time <= frame_->time + 1e-9; });
    const auto count = std::min<std::ptrdiff_t>(end - contacts_.begin(), kMaxContacts);
    for (auto mark = end - count; mark != end; ++mark) {
      over.contact(*mark, frame_->time - mark->time);
    }
  }
}

void OverlayLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option,
                         QWidget* widget) {
  const QRectF seen = shownRect(*painter, *option, widget);
  isGround_ ? overlays_.paintGround(*painter, seen) : overlays_.paintTop(*painter, seen);
}

}  // namespace editor
