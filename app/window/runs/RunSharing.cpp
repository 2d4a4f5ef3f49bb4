#include "app/window/runs/RunSharing.h"

#include <QtWidgets>

#include "app/cli/RunObservers.h"

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kWatched = "live-view";
constexpr const char* kWarning = "run-guests";

}  // namespace

RunSharing::RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
                       QObject* parent)
    : QObject(parent), workspace_(workspace), foxglove_(foxglove), ros2_(ros2), notices_(notices) {
  ros2_.setVisible(hasRos2Support());
  for (QAction* const action : {&foxglove_, &ros2_}) {
    connect(action, &QAction::toggled, this, &RunSharing::choose);
  }
  const SimulationRunner* runner = &workspace_.runner();
  connect(runner, &SimulationRunner::stateChanged, this, &RunSharing::updateNotices);
  connect(runner, &SimulationRunner::finished, this, &RunSharing::updateNotices);
  connect(runner, &SimulationRunner::branchesChanged, this, &RunSharing::updateNotices);
}

/// Guests call back in other threads; their messages are queued to this thread.
void RunSharing::choose() {
  if (!foxglove_.isChecked() && !ros2_.isChecked()) {
    workspace_.runner().setObserverFactory({});
    return;
  }
  RunObservers guests;
  if (foxglove_.isChecked()) {
    guests.foxglove = static_cast<std::uint16_t>(kUsualPort);
  }
  guests.ros2 = ros2_.isChecked();
  const QPointer<RunSharing> here(this);
  const auto later = [here](auto act) {
    const auto report = [here, act] {
      if (here) {
        act(*here);
      }
    };
    if (QCoreApplication* const application = QCoreApplication::instance()) {
      const QObject sender;  // its destruction is the signal; avoids a clang-tidy warning
      connect(&sender, &QObject::destroyed, application, report, Qt::QueuedConnection);
    }
  };
  guests.liveViewOpened = [later](const std::string& url) {
    later([url](RunSharing& sharing) { sharing.reportUrl(QString::fromStdString(url)); });
  };
  guests.report = [later](const base::Diagnostics& diagnostics) {
    later([diagnostics](RunSharing& sharing) { sharing.reportWarning(diagnostics); });
  };
  workspace_.runner().setObserverFactory(
      [guests](Session& session, sim2d::World& world, const std::shared_ptr<const Bundle>& bundle) {
        return attachObservers(guests, session, world, bundle);
      });
}

bool RunSharing::isLive() const {
  const SimulationRunner& runner = workspace_.runner();
  return runner.state() != SimulationRunner::State::Editing && !runner.isFinished();
}

void RunSharing::reportUrl(const QString& url) {
  if (!isLive()) {
    return;  // the run was closed meanwhile
  }
  notices_.inform(QString::fromLatin1(kWatched),
                  tr("Watch this run at %1 (Foxglove: Open connection)").arg(url),
                  {{tr("Copy address"), [url] { QGuiApplication::clipboard()->setText(url); }}});
}

/// Shows the newest warning, or the first of several.
void RunSharing::reportWarning(const base::Diagnostics& diagnostics) {
  notices_.warn(QString::fromLatin1(kWarning), QString::fromStdString(diagnostics.front().message));
}

void RunSharing::updateNotices() {
  const int branch = workspace_.runner().branch();
  const bool isAnother = branch != branch_;
  branch_ = branch;
  if (!isLive() || isAnother) {
    notices_.drop(QString::fromLatin1(kWatched));
    notices_.drop(QString::fromLatin1(kWarning));
  }
}

}  // namespace app
