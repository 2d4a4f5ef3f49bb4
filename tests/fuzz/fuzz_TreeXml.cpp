#include <cstddef>
#include <cstdint>
#include <string_view>

#include "bt/engine/TreeState.h"
#include "bt/tree/TreeXml.h"
#include "tests/bt/ScriptedNavigator.h"
#include "tests/fuzz/Require.h"

/// Any bytes as a tree file: read, written and read again, checked, compiled, ticked as the tree of
/// a person and of a robot. Its includes are dropped, so that no other file is opened.
namespace {

using base::NodeStatus;

struct Countdown {
  int left;
};

bt::PortSpec port(const char* name, bt::PortType type, bt::PortDirection direction) {
  bt::PortSpec result;
  result.key = name;
  result.portType = type;
  result.direction = direction;
  return result;
}

bt::NodeManifest manifest(const char* id) {
  bt::NodeManifest result;
  result.id = id;
  result.ports = {port("value", bt::PortType::Double, bt::PortDirection::Input),
                  port("text", bt::PortType::String, bt::PortDirection::Input),
                  port("result", bt::PortType::Int, bt::PortDirection::Output)};
  return result;
}

NodeStatus readAll(bt::LeafContext& leaf) {
  const bool isPositive = leaf.getOr<double>(0, 1.0) > 0.0;
  leaf.set(2, leaf.text(1) ? 1 : 0);
  return isPositive ? NodeStatus::Success : NodeStatus::Failure;
}

bt::StatefulFunctions waiting() {
  bt::StatefulFunctions functions;
  functions.onStart = [](bt::LeafContext& leaf) {
    leaf.memory<Countdown>().left = 2;
    return NodeStatus::Running;
  };
  functions.onRunning = [](bt::LeafContext& leaf) {
    return --leaf.memory<Countdown>().left > 0 ? NodeStatus::Running : readAll(leaf);
  };
  return functions;
}

const bt::NodeLibrary& library() {
  static const bt::NodeLibrary all = [] {
    bt::NodeLibrary made;
    made.add(manifest("IsFine"), bt::synchronous(readAll));
    made.add(manifest("Act"), bt::synchronous(readAll));
    made.add(manifest("Wait"), bt::stateful<Countdown>(waiting()));
    return made;
  }();
  return all;
}

void tick(const bt::TreeTable& table) {
  const auto program = bt::compile(table, library());
  if (!program) {
    return;
  }
  bt::TreeState state(*program);
  state.set((*program)->hostSlot(0), 1);
  state.set((*program)->hostSlot(1), 0.1);
  for (std::int64_t step = 1; step <= 5; ++step) {
    state.tickOnce({step, 0.1, nullptr});
  }
  state.halt({6, 0.1, nullptr});
  require(state.entries().size() <= (*program)->entries().size(), "entries are the program's");
}

const bt::NodeLibrary& navigatorNodes() {
  static const bt::NodeLibrary all = bt::robotNodes();
  return all;
}

/// The same as the tree of a robot.
void navigate(const bt::TreeTable& table) {
  bt::CompileOptions options;
  options.mainTree = table.mainTree;
  options.hostEntries = {{"goal", bt::PortType::Any}, {"goals", bt::PortType::Any}};
  const auto program = bt::compile(table, navigatorNodes(), options);
  if (!program) {
    return;
  }
  navigator::Scripted host;
  bt::TreeState state(*program);
  state.set((*program)->hostSlot(0), static_cast<int>(host.goal));
  for (std::int64_t step = 1; step <= 5; ++step) {
    host.step = step;
    state.tickOnce({step, 0.1, static_cast<bt::NavigatorHost*>(&host)});
  }
  state.halt({6, 0.1, static_cast<bt::NavigatorHost*>(&host)});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  base::Result<bt::TreeFile> file = bt::readTreeText(text, "fuzz.xml");
  if (!file) {
    return 0;
  }
  const std::string written = bt::writeTree(*file, library().catalogue());
  const base::Result<bt::TreeFile> again = bt::readTreeText(written, "fuzz.xml");
  require(bool(again), "what is written can be read");
  require(*again == *file, "reading what is written gives the same file");
  require(bt::writeTree(*again, library().catalogue()) == written, "writing twice gives one text");
  file->includes.clear();
  const base::Result<bt::TreeTable> table = bt::resolveIncludes(*file);
  if (table) {
    bt::checkForImport(*table, library().catalogue());
    tick(*table);
    navigate(*table);
  }
  return 0;
}
