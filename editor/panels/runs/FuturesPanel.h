#pragma once

#include "editor/canvas/ComparedRunLayers.h"
#include "editor/look/Fields.h"
#include "editor/panels/PanelRegistry.h"
#include "editor/panels/runs/RunPlots.h"
#include "editor/run/FuturesProcess.h"

namespace editor {

/// Predictions from the shown time: the same run with other random draws, simulated outside the GUI
/// thread. Shows the contact probability over time, and the trajectories on the map while the panel
/// is open.
class FuturesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit FuturesPanel(PanelContext& context);
  ~FuturesPanel() override;
  Q_DISABLE_COPY_MOVE(FuturesPanel)

  void start();  // Starts at the shown time.
  void cancel();
  bool isRunning() const { return process_.isRunning(); }
  const std::vector<app::Future>& futures() const { return *futures_; }
  QPushButton& button() const { return *start_; }
  QSpinBox& count() const { return *count_; }
  NumberField& horizon() const { return *horizon_; }
  NumberField& spread() const { return *spread_; }
  QString summary() const { return says_->text(); }
  FuturesProcess& process() { return process_; }

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeHead();
  void take(const app::Future& future);
  void finish(const QString& problems);
  void forget();
  void follow();
  void showAll();
  QString countText() const;

  PanelContext& context_;
  FuturesProcess process_;
  FuturesLayer* futuresLayer_;  // Belongs to the scene.
  QPushButton* start_ = new QPushButton(tr("Simulate futures"), this);
  QSpinBox* count_ = new QSpinBox(this);
  NumberField *horizon_ =
                  new NumberField({0.5, app::kLongestFuture, 1, 1.0}, QStringLiteral("s"), this),
              *spread_ = new NumberField({0.0, 1.0, 2, 0.05}, QStringLiteral("m/s"), this);
  QProgressBar* progress_ = new QProgressBar(this);
  QLabel* says_ = new QLabel(this);
  ContactProbabilityPlot* plot_ = new ContactProbabilityPlot(context_.theme());
  std::shared_ptr<std::vector<app::Future>> futures_ = std::make_shared<std::vector<app::Future>>();
  app::FuturesOptions asked_;
  double from_ = 0.0;        // [s]
  RecordingPtr of_;          // The run to which the futures belong.
  bool isComplete_ = false;  // False: cancelled or running.
};

}  // namespace editor
