#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QtWidgets>

#include "editor/canvas/MapView.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/panels/runs/RunOverlayReader.h"
#include "sim2d/trace/Recording.h"

namespace editor {

/// A view of another run beside the canvas with the same centre and time. The zoom is limited so
/// that everything visible on the canvas is visible here too.
class SideView : public QWidget {
  Q_OBJECT
 public:
  /// `document`: the document of the run; it is copied. `isOfEdited`: it is that of the canvas, so
  /// the selection of the canvas is followed. The canvas must outlive the view.
  SideView(MapView& canvas, const DocumentSnapshot& document, const sim2d::Recording& run,
           bool isOfEdited, QWidget* parent = nullptr);
  ~SideView() override;
  Q_DISABLE_COPY_MOVE(SideView)
  QString title() const { return title_->text(); }
  void setTitle(const QString& title);
  bool hasEnded() const { return !veil_->isHidden(); }  // The run ends before the shown time.
  void setTheme(const Theme& theme);
  /// Shows the state of the run at a time [s].
  void showAt(const std::shared_ptr<const sim2d::Recording>& recording, double time);
  const MapScene& scene() const { return scene_; }
  MapView& view() const { return *view_; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void followCanvas();
  void readOverlays();
  void showEnd(double time);

  MapView& canvas_;
  ScenarioDocument document_;
  MapScene scene_;
  RunOverlayReader overlays_{scene_};
  std::shared_ptr<const sim2d::Recording> recording_;
  sim2d::FramePtr frame_;  // shown
  QString name_;
  QLabel* title_ = new QLabel(this);
  MapView* view_ = new MapView(scene_, this);
  QWidget* veil_ = new QWidget(view_);  // Fades the view of a run that has ended.
};

/// The end of a recording that no longer has states at this time [s]; none: it still has states.
std::optional<double> endBefore(const sim2d::Recording& recording, double time);

/// The style of the title above a view of a run.
void stylePaneTitle(QLabel& title, const Theme& theme);

/// The document shown for a run: `edited` if the run belongs to it, else one from the recording.
DocumentSnapshot documentOf(const sim2d::Recording& recording, const ScenarioDocument& edited,
                            bool isOfEdited);

/// Views of other runs beside the canvas: one, two stacked, or up to four in two columns. All show
/// the same place, time and overlays; the senses of robots, which only the newest state of a run
/// has, are left out on the canvas, too.
class SideBySide : public QWidget {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxViews = 4;

  struct Run {
    QString title;
    std::shared_ptr<const sim2d::Recording> recording;
    bool isOfEdited = false;  // Run of the open document.
  };
  SideBySide(MapView& canvas, const ScenarioDocument& edited, QWidget* parent = nullptr);
  ~SideBySide() override;
  Q_DISABLE_COPY_MOVE(SideBySide)

  /// Shows the first kMaxViews runs; views of runs already shown are kept.
  void showRuns(const std::vector<Run>& runs);
  void showAt(double time);  // [s]
  void setTheme(const Theme& theme);
  int columns() const { return views_.size() > 2 ? 2 : 1; }
  const std::vector<std::unique_ptr<SideView>>& views() const { return views_; }

 private:
  void showSenses(bool shown);
  void showColors(const Theme& theme);

  MapView& canvas_;
  const ScenarioDocument& edited_;
  QGridLayout* grid_ = new QGridLayout(this);
  std::vector<std::unique_ptr<SideView>> views_;
  std::vector<Run> runs_;  // The runs of the views.
};

}  // namespace editor
