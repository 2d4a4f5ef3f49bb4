#pragma once

#include <array>

#include "editor/canvas/FrameLayer.h"

namespace editor {

/// The optional overlays of a run: density, personal spaces, fields of view, planned paths,
/// velocities, contacts, thoughts. Some are limited to the selected people, or show all people if
/// none is selected.
class RunOverlays {
 public:
  explicit RunOverlays(const MapScene& scene) : scene_(scene) {}

  void show(sim2d::FramePtr frame, const sim2d::Recording* recording);
  void end();
  void themeChanged() {
    field_.reset();
    costs_ = {};
  }

  /// All contacts of the run so far; those after the shown time are not drawn.
  void setContacts(std::vector<sim2d::ContactMark> contacts) { contacts_ = std::move(contacts); }
  const std::vector<sim2d::ContactMark>& contacts() const { return contacts_; }
  /// The reasons for people's actions, by id.
  void setThoughts(std::map<int, QString> thoughts) { thoughts_ = std::move(thoughts); }
  QString thoughtOf(int id) const {
    const auto found = thoughts_.find(id);
    return found == thoughts_.end() ? QString() : found->second;
  }

  /// Paint beneath and over the bodies; the painter uses scene units.
  void paintGround(QPainter& painter, const QRectF& exposed);
  void paintTop(QPainter& painter, const QRectF& exposed) const;

  // For the legend
  double densityScaleMax() const { return most_; }  // Upper end of the scale [1/m²].
  /// Recorded runs contain neither forces nor plans.
  bool hasForces() const {
    return frame_ != nullptr && frame_->forces.goal.size() == frame_->humans.size() &&
           frame_->humans.size() > 0;
  }
  bool hasPlans() const { return frame_ != nullptr && frame_->humanPaths != nullptr; }
  std::size_t contactsSoFar(ContactCause cause) const;
  /// The distance at which a person notices others [m].
  double noticeDistance(int id) const;
  const sim2d::Frame* frame() const { return frame_.get(); }

 private:
  struct Field {
    metrics::DensityField field;
    QImage image;
  };
  void paintCosts(QPainter& painter);
  void paintDensity(const OverlayPainter& over);
  void paintSpaces(QPainter& painter, const OverlayPainter& over,
                   const std::vector<ShownBody>& bodies) const;
  void paintSight(const OverlayPainter& over, const std::vector<ShownBody>& bodies) const;
  void paintPlans(const OverlayPainter& over, const std::vector<ShownBody>& bodies) const;
  std::vector<ShownBody> bodiesIn(const QRectF& exposed) const;

  const MapScene& scene_;
  sim2d::FramePtr frame_;
  std::shared_ptr<const sim2d::TraceHeader> header_;
  std::optional<Field> field_;  // Density in the current frame.
  double most_ = 0.0;           // Does not decrease during a run.
  /// Local and global costmap images, recreated when the grid changes.
  struct CostPicture {
    sim2d::CostGridPtr grid;
    QImage image;
  };
  std::array<CostPicture, 2> costs_;
  std::map<sim2d::CostGridPtr, QImage> masks_;  // Planners make the grids once per run.
  bool isDark_ = false;                         // Theme of the images.
  std::vector<sim2d::ContactMark> contacts_;
  std::map<int, QString> thoughts_;
};

/// A layer for either the ground or the top overlays.
class OverlayLayer : public FullLayer {
 public:
  OverlayLayer(const MapScene& scene, RunOverlays& overlays, bool isGround)
      : FullLayer(scene), overlays_(overlays), isGround_(isGround) {}
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  RunOverlays& overlays_;
  bool isGround_;
};

}  // namespace editor
