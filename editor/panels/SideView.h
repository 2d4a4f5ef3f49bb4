#pragma once

#include <memory>

#include <QLabel>
#include <QWidget>

#include "editor/canvas/MapView.h"
#include "editor/document/ScenarioDocument.h"
#include "sim2d/trace/Recording.h"

namespace editor {

/// Another run beside the canvas, which it follows in place and time, and in zoom as far as it has
/// the room: what the canvas shows is seen here too.
class SideView : public QWidget {
  Q_OBJECT
 public:
  /// `document`: of the run; it is copied. The canvas must outlive the view.
  SideView(MapView& canvas, const DocumentSnapshot& document, QWidget* parent = nullptr);
  ~SideView() override;
  Q_DISABLE_COPY_MOVE(SideView)
  void setTitle(const QString& title) { title_->setText(title); }
  void setTheme(const Theme& theme);
  /// The state of the run at a time [s].
  void showAt(const std::shared_ptr<const sim2d::Recording>& recording, double time);
  const MapScene& scene() const { return scene_; }
  MapView& view() const { return *view_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void followCanvas();

  MapView& canvas_;
  ScenarioDocument document_;
  MapScene scene_;
  QLabel* title_;
  MapView* view_;
};

/// What such a view shows of a run: `edited` when the run is of it, else what the recording tells.
DocumentSnapshot documentOf(const sim2d::Recording& recording, const ScenarioDocument& edited,
                            bool isOfEdited);

}  // namespace editor
