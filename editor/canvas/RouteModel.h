#pragma once

#include <map>
#include <memory>

#include "editor/document/Entity.h"
#include "editor/document/LatestTask.h"
#include "sim2d/map/OccupancyGrid.h"

namespace app {
class SurroundingsCache;
}

namespace editor {

/// One leg of a route, from a start or goal to the next goal.
struct RouteLeg {
  std::vector<Vec2> points;  // World frame, includes both ends.
  bool isReachable = true;   // False: `points` is the straight line.
  friend bool operator==(const RouteLeg& a, const RouteLeg& b) {
    return a.isReachable == b.isReachable && a.points == b.points;
  }
};
using EntityRoute = std::vector<RouteLeg>;
using Routes = std::map<EntityId, EntityRoute>;

/// The routes of all people and robots around walls, computed with the planner of the simulation.
/// Routes are planned in batches outside the GUI thread; `routesChanged` reports new results.
class RouteModel : public QObject {
  Q_OBJECT
 public:
  explicit RouteModel(QObject* parent = nullptr);
  ~RouteModel() override;
  Q_DISABLE_COPY_MOVE(RouteModel)

  struct Input {
    sim2d::Scenario scenario;
    std::shared_ptr<const sim2d::OccupancyGrid> map;
    std::shared_ptr<app::SurroundingsCache> known;  // Never null.
    base::StopFlagPtr stop;                         // Never null.
  };
  /// Schedules planning. `input` is called once for several requests. Unchanged routes are not
  /// planned again.
  void request(std::function<Input()> input);
  const EntityRoute* route(EntityId id) const {
    const auto found = routes_.find(id);
    return found == routes_.end() ? nullptr : &found->second;
  }
  /// The entities whose routes changed with the last `routesChanged`.
  const std::vector<EntityId>& changed() const { return changed_; }
  void finish();  // Blocks until all requests are done.

 Q_SIGNALS:
  void routesChanged();

 private:
  struct Planning;
  void start();
  struct Planned {
    Routes routes;
    bool isComplete = true;  // False: some routes are still to be planned.
  };
  void take(Planned planned);
  Routes routes_;
  std::vector<EntityId> changed_;
  std::shared_ptr<Planning> planning_;  // Passed from task to task; used by one task at a time.
  LatestTask<Planned> task_;
  std::function<Input()> input_;
  QTimer timer_;
};

}  // namespace editor
