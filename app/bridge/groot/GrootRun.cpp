#include "app/bridge/groot/GrootRun.h"

#include <algorithm>
#include <random>
#include <utility>

namespace groot {

namespace {

constexpr std::chrono::milliseconds kBetweenBlackboards{100};
constexpr int kMostNodes = 65535;  // a number has 16 bits

/// Runs are told apart by it; nothing of a run depends on it.
RunName newName() {
  std::random_device device;
  RunName name = {};
  std::generate(name.begin(), name.end(), [&] { return static_cast<char>(device() & 0xFFU); });
  return name;
}

}  // namespace

base::Result<std::unique_ptr<GrootRun>> GrootRun::open(std::uint16_t port, sim2d::World& world,
                                                       int human, const bt::TreeTable& tree) {
  WatchedTree watched = watchedTree(tree);
  if (watched.nodes > kMostNodes) {
    return base::error("groot.too-many", {watched.nodes, kMostNodes}, tree.file);
  }
  auto server = GrootServer::listen(port, WatchedRun(std::move(watched), newName()));
  if (!server) {
    return server.diagnostics();
  }
  return std::unique_ptr<GrootRun>(new GrootRun(world, human, *std::move(server)));  // NOLINT
}

GrootRun::GrootRun(sim2d::World& world, int human, std::unique_ptr<GrootServer> server)
    : world_(world),
      human_(human),
      id_(world.view().constants(human).id),
      server_(std::move(server)) {}

void GrootRun::show(const sim2d::Frame& frame) {
  const auto now = std::chrono::steady_clock::now();
  // Also without a client: one that connects during a pause gets the entries from before it.
  const bool isDue = !told_ || now - *told_ >= kBetweenBlackboards;
  server_->change([&](WatchedRun& run) {
    frame.treeChanges.forEach(
        [&](int id, const auto& /*paths*/, int node, base::NodeStatus status) {
          if (id == id_) {
            run.set(node, status, frame.time);
          }
        });
    if (isDue) {
      run.setBlackboard(world_.behavior().blackboard(human_));
    }
  });
  told_ = isDue ? now : told_;
}

}  // namespace groot
