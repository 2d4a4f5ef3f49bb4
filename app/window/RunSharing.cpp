#include "app/window/RunSharing.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QPointer>

#include "app/cli/RunGuests.h"

namespace app {

using editor::SimulationRunner;

namespace {

constexpr const char* kWatched = "live-view";
constexpr const char* kWarning = "run-guests";

}  // namespace

RunSharing::RunSharing(Workspace& workspace, QAction& foxglove, QAction& ros2, NoticeBar& notices,
                       QObject* parent)
    : QObject(parent), workspace_(workspace), foxglove_(foxglove), ros2_(ros2), notices_(notices) {
  ros2_.setVisible(speaksRos2());
  for (QAction* const action : {&foxglove_, &ros2_}) {
    connect(action, &QAction::toggled, this, &RunSharing::choose);
  }
  const SimulationRunner* runner = &workspace_.runner();
  connect(runner, &SimulationRunner::stateChanged, this, &RunSharing::followRun);
  connect(runner, &SimulationRunner::finished, this, &RunSharing::followRun);
  connect(runner, &SimulationRunner::branchesChanged, this, &RunSharing::followRun);
}

/// Guests speak in other threads: their words are taken over to this one.
void RunSharing::choose() {
  if (!foxglove_.isChecked() && !ros2_.isChecked()) {
    workspace_.runner().setGuests({});
    return;
  }
  RunGuests guests;
  if (foxglove_.isChecked()) {
    guests.foxglove = static_cast<std::uint16_t>(kUsualPort);
  }
  guests.ros2 = ros2_.isChecked();
  const QPointer<RunSharing> here(this);
  const auto later = [here](auto act) {
    const auto tell = [here, act] {
      if (here) {
        act(*here);
      }
    };
    if (QCoreApplication* const application = QCoreApplication::instance()) {
      const QObject sender;  // its end is the signal; clang-tidy takes invokeMethod for a leak
      connect(&sender, &QObject::destroyed, application, tell, Qt::QueuedConnection);
    }
  };
  guests.isWatched = [later](const std::string& url) {
    later([url](RunSharing& sharing) { sharing.tellWatched(QString::fromStdString(url)); });
  };
  guests.tell = [later](const base::Diagnostics& said) {
    later([said](RunSharing& sharing) { sharing.tellWarning(said); });
  };
  workspace_.runner().setGuests(
      [guests](Session& session, sim2d::World& world, const std::shared_ptr<const Bundle>& bundle) {
        return letIn(guests, session, world, bundle);
      });
}

bool RunSharing::isLive() const {
  const SimulationRunner& runner = workspace_.runner();
  return runner.state() != SimulationRunner::State::Editing && !runner.isFinished();
}

void RunSharing::tellWatched(const QString& url) {
  if (!isLive()) {
    return;  // it was left meanwhile
  }
  notices_.inform(QString::fromLatin1(kWatched),
                  tr("This run can be watched at %1 (Foxglove: Open connection)").arg(url),
                  {{tr("Copy address"), [url] { QGuiApplication::clipboard()->setText(url); }}});
}

/// The newest counts; the first of what was said at once.
void RunSharing::tellWarning(const base::Diagnostics& said) {
  notices_.warn(QString::fromLatin1(kWarning), QString::fromStdString(said.front().message));
}

void RunSharing::followRun() {
  const int branch = workspace_.runner().branch();
  const bool isAnother = branch != branch_;
  branch_ = branch;
  if (!isLive() || isAnother) {
    notices_.drop(QString::fromLatin1(kWatched));
    notices_.drop(QString::fromLatin1(kWarning));
  }
}

}  // namespace app
