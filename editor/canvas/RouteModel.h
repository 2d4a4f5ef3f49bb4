#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <QObject>
#include <QTimer>

#include "editor/document/Entity.h"
#include "editor/document/LatestTask.h"
#include "sim2d/base/Stop.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {
class KnownSurroundings;
}

namespace editor {

/// One leg of a route, from a start or goal to the next goal.
struct RouteLeg {
  std::vector<Vec2> points;  // world, both ends included
  bool isReachable = true;   // false: the straight line is given
  friend bool operator==(const RouteLeg& a, const RouteLeg& b) {
    return a.isReachable == b.isReachable && a.points == b.points;
  }
};
using EntityRoute = std::vector<RouteLeg>;
using Routes = std::map<EntityId, EntityRoute>;

/// The ways of all people and robots round walls, by the planner of the simulation. Planned beside
/// the GUI thread, some at a time; `routesChanged` tells when newer ones are there.
class RouteModel : public QObject {
  Q_OBJECT
 public:
  explicit RouteModel(QObject* parent = nullptr);
  ~RouteModel() override;
  Q_DISABLE_COPY_MOVE(RouteModel)

  struct Input {
    sim2d::Scenario scenario;
    std::shared_ptr<const sim2d::OccupancyGrid> map;
    std::shared_ptr<app::KnownSurroundings> known;  // never null
    base::StopFlagPtr stop;                         // idem
  };
  /// Soon asks `input` for what there is to plan, once for many requests. Ways that stay the same
  /// are not planned anew.
  void request(std::function<Input()> input);
  const EntityRoute* route(EntityId id) const;
  /// Whose ways the last `routesChanged` was about.
  const std::vector<EntityId>& changed() const { return changed_; }
  void finish();  // waits for what was asked for

 Q_SIGNALS:
  void routesChanged();

 private:
  struct Planning;
  void start();
  struct Planned {
    Routes routes;
    bool isComplete = true;  // false: some still wait to be planned
  };
  void take(Planned planned);
  Routes routes_;
  std::vector<EntityId> changed_;
  std::shared_ptr<Planning> planning_;  // kept from one task to the next, used by one at a time
  LatestTask<Planned> task_;
  std::function<Input()> input_;
  QTimer timer_;
};

}  // namespace editor
