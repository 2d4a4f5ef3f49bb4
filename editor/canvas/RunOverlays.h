#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QString>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/OverlayPainter.h"

namespace editor {

/// What a run shows beside its bodies when it is asked for: how dense people stand, their spaces,
/// what they see, their ways and velocities, contacts, thoughts. Of who is selected alone where
/// that is what one wants to know; of all where nobody is selected.
class RunOverlays {
 public:
  explicit RunOverlays(const MapScene& scene) : scene_(scene) {}

  void show(std::shared_ptr<const sim2d::Frame> frame, const sim2d::Recording* recording);
  void end();
  void themeChanged() {
    field_.reset();
    costs_ = {};
  }

  /// All of the run so far; those after the moment that is shown are not drawn.
  void setContacts(std::vector<sim2d::ContactMark> contacts) { contacts_ = std::move(contacts); }
  const std::vector<sim2d::ContactMark>& contacts() const { return contacts_; }
  /// Why people act, by id.
  void setThoughts(std::map<int, QString> thoughts) { thoughts_ = std::move(thoughts); }
  QString thoughtOf(int id) const;

  /// Beneath and over the bodies; the painter's units are those of the scene.
  void paintGround(QPainter& painter, const QRectF& exposed);
  void paintTop(QPainter& painter, const QRectF& exposed) const;

  // for the legend
  double densityMost() const { return most_; }  // end of the scale [1/m²]
  /// What is not known of this run, as recorded ones do not hold it.
  bool hasForces() const;
  bool hasPlans() const { return frame_ != nullptr && frame_->humanPaths != nullptr; }
  std::size_t contactsSoFar(ContactCause cause) const;
  /// How far a person notices others [m].
  double noticeDistance(int id) const;
  const sim2d::Frame* frame() const { return frame_.get(); }

 private:
  struct Field {
    metrics::DensityField field;
    QImage image;
  };
  void paintCosts(QPainter& painter);
  void paintDensity(const OverlayPainter& over);
  void paintSpaces(const OverlayPainter& over, const std::vector<ShownBody>& bodies) const;
  void paintSight(const OverlayPainter& over, const std::vector<ShownBody>& bodies) const;
  void paintPlans(const OverlayPainter& over, const std::vector<ShownBody>& bodies) const;
  std::vector<ShownBody> bodiesIn(const QRectF& exposed) const;

  const MapScene& scene_;
  std::shared_ptr<const sim2d::Frame> frame_;
  std::shared_ptr<const sim2d::TraceHeader> header_;
  std::optional<Field> field_;  // of the frame
  double most_ = 0.0;           // it does not fall in a run
  /// Of costmaps, made again when they have changed: local, global.
  struct CostPicture {
    sim2d::CostGridPtr grid;
    QImage image;
  };
  std::array<CostPicture, 2> costs_;
  std::vector<sim2d::ContactMark> contacts_;
  std::map<int, QString> thoughts_;
};

/// A layer with one half of them.
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
