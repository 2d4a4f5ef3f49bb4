#include "app/cli/help/OptionLayout.h"

#include <iterator>

#include "sim2d/base/Find.h"

namespace app {

namespace {

constexpr const char* kAny = nullptr;
constexpr const char* kByType = nullptr;
constexpr const char* kWindow = "";

/// In the order of the help: groups by their first row, the most common options first.
constexpr OptionLayout kLayouts[] = {
    {"scenario", "Arguments", "SCENARIO", kAny},
    {"params", "Arguments", "PARAMS", "tune"},
    {"experiment", "Arguments", "EXPERIMENT", kAny},
    {"base", "Arguments", "BASE", kAny},
    {"candidate", "Arguments", "CANDIDATE", kAny},
    {"source", "Arguments", "SOURCE", kAny},
    {"files", "Arguments", "FILE", kAny},
    {"run", "Arguments", "RUN", kAny},
    {"folder", "Arguments", "DIR", kAny},
    {"shard", "Arguments", "DIR", kAny},
    {"study", "Arguments", "DIR", "pack"},
    {"capsule", "Arguments", "FILE.hnv", kAny},
    {"moment", "Arguments", "RUN@SECONDS", kAny},
    {"what", "Arguments", "WHAT", kAny},
    {"names", "Arguments", "TEST", kAny},

    {"--scenarios", "Scenario", "NAME", kAny},
    {"--map", "Scenario", "FILE|none", kAny},
    {"--trees", "Scenario", "DIR", kAny},
    {"--set", "Scenario", "PATH=VALUE", kAny},
    {"--certify", "Certificates", kByType, kAny},
    {"--all", "Certificates", kByType, kAny},
    {"--verify", "Certificates", kByType, kAny},
    {"--planners", "Certificates", "NAME,…", kAny},
    {"--first-seed", "Certificates", "N", kAny},
    {"--seeds", "Certificates", "N", "check"},
    {"--jobs", "Certificates", "N", "check"},

    {"--target", "Scenario", kByType, kAny},
    {"--dialect", "Scenario", kByType, kAny},
    {"--style", "Scenario", kByType, kAny},

    {"--columns", "Input file", "NAME=COLUMN,…", "evaluate"},
    {"--format", "Input file", "NAME", "evaluate"},
    {"--fps", "Input file", "N", "evaluate"},
    {"--unit", "Input file", "mm|cm|m|METRES", kAny},
    {"--time-unit", "Input file", kByType, kAny},
    {"--degrees", "Input file", kByType, kAny},
    {"--radius", "Input file", "METRES", kAny},
    {"--dt", "Input file", "SECONDS", "evaluate"},
    {"--robot", "Input file", "ID|NAME", "evaluate"},
    {"--robot-goal", "Input file", "\"X Y\"", "evaluate"},
    {"--topics", "Input file", "PART=NAME,…", kAny},
    {"--reference", "Input file", "RUN|FILE", kAny},

    {"--worst", "Search", "KEY", kAny},
    {"--until-failure", "Search", kByType, kAny},
    {"--cover", "Search", kByType, kAny},
    {"--failures", "Search", "N", kAny},
    {"--runs", "Search", "N", kAny},
    {"--objective", "Search", "KEY[=WEIGHT]", kAny},
    {"--parameters", "Search", "FILE", kAny},
    {"--max-changes", "Search", "N", kAny},
    {"--max-loss", "Search", "PERCENT", kAny},
    {"--population", "Search", "N", kAny},
    {"--held-out", "Search", "NAME", kAny},
    {"--held-out-seeds", "Search", "N", kAny},
    {"--search-seed", "Search", "N", kAny},
    {"--descriptor", "Search", "KEY:LOW:HIGH:CELLS", kAny},
    {"--shrink-runs", "Search", "N", kAny},
    {"--all-contacts", "Search", kByType, kAny},

    {"--seed", "Run", "N", kAny},
    {"--seeds", "Run", "N", kAny},
    {"--first-seed", "Run", "N", "gate"},
    {"--duration", "Run", "SECONDS", kAny},
    {"--horizon", "Run", "SECONDS", kAny},
    {"--spread", "Run", "M/S", kAny},
    {"--lookback", "Run", "SECONDS", kAny},
    {"--settle", "Run", "SECONDS", kAny},
    {"--range", "Run", "METRES", "contacts"},
    {"--model", "Run", "NAME", kAny},
    {"--jobs", "Run", "N", kAny},
    {"--resume", "Run", kByType, kAny},
    {"--retry-failed", "Run", kByType, kAny},
    {"--shard", "Run", "K/N", kAny},
    {"--time-limit", "Run", "SECONDS", kAny},
    {"--sample", "Run", "PERCENT", "verify"},
    {"--runs", "Run", "N", "verify"},
    {"--stop-on-collision", "Run", kByType, kAny},
    {"--stuck-after", "Run", "SECONDS", kAny},
    {"--from", "Run", "RUN@SECONDS", kAny},
    {"--move", "Run", "\"NAME X Y HEADING\"", kAny},
    {"--counterfactual", "Run", kByType, kAny},
    {"--play", "Run", "FILE", kAny},
    {"--script", "Run", "FILE", "trees"},
    {"--ticks", "Run", "N", kAny},
    {"--quick", "Run", kByType, kAny},
    {"--threads", "Run", "N", kAny},
    {"--dt", "Run", "SECONDS", kAny},

    {"--robot", "Robot", "TYPE", kAny},
    {"--planner", "Robot", "NAME", kAny},
    {"--robot-start", "Robot", "\"X Y HEADING\"", kAny},
    {"--robot-goal", "Robot", "\"X Y\"", kAny},
    {"--nav2-params", "Robot", "FILE|NAME:=VALUE", kAny},
    {"--nav2-tree", "Robot", "FILE", kAny},
    {"--nav2-distro", "Robot", kByType, kAny},
    {"--nav2-body", "Robot", kByType, kAny},
    {"--allow-code", "Robot", kByType, kAny},

    {"--metric", "Statistics", "KEY:MARGIN", kAny},
    {"--method", "Statistics", kByType, "sensitivity"},
    {"--points", "Statistics", "N", "sensitivity"},
    {"--compare", "Statistics", "PATH", kAny},
    {"--contacts", "Statistics", kByType, kAny},
    {"--pareto", "Statistics", "KEY,KEY", kAny},
    {"--weights", "Statistics", "KEY=WEIGHT,…", kAny},
    {"--level", "Statistics", "0.5…0.999", kAny},
    {"--resamples", "Statistics", "N", kAny},

    {"--at", "Window", "SECONDS", kWindow},
    {"--screenshot", "Window", "FILE.png", kAny},
    {"--size", "Window", "WxH", kAny},
    {"--scale", "Window", "FACTOR", kAny},
    {"--theme", "Window", kByType, kAny},
    {"--overlay", "Window", "NAME,…", kWindow},
    {"--select", "Window", "NAME", kAny},
    {"--tree", "Window", "PERSON", kAny},
    {"--dock", "Window", "NAME", kAny},

    {"--output", "Output", "FILE", "render"},
    {"--output", "Output", "FILE.hnv", "pack"},
    {"--with-code", "Output", kByType, kAny},
    {"--output", "Output", "DIR", kAny},
    {"--metrics", "Output", "KEY,…", "report"},
    {"--metrics", "Output", "KEY,…", "sensitivity"},
    {"--metrics", "Output", "FILE|KEY,…", kAny},
    {"--metrics-profile", "Output", kByType, kAny},
    {"--record", "Output", "mcap", kAny},
    {"--record-every", "Output", "STEPS", kAny},
    {"--totals", "Output", kByType, kAny},
    {"--at", "Output", "SECONDS", kAny},
    {"--width", "Output", "MM|PIXELS", kAny},
    {"--overlay", "Output", "NAME,…", kAny},
    {"--strip", "Output", "N|T1,T2,…", kAny},
    {"--plot", "Output", "KEY,…", kAny},
    {"--time-marks", "Output", "SECONDS", kAny},
    {"--fps", "Output", "N", kAny},
    {"--speed", "Output", "FACTOR", "render"},
    {"--format", "Output", kByType, kAny},
    {"--picture", "Output", "FILE", kAny},
    {"--coverage", "Output", "DIR", kAny},
    {"--no-pdf", "Output", kByType, kAny},
    {"--layout", "Output", kByType, kAny},
    {"--tag", "Output", "NAME", kAny},
    {"--run-id", "Output", "N", kAny},
    {"--rows", "Output", kByType, kAny},
    {"--force", "Output", kByType, kAny},
    {"--json", "Output", kByType, kAny},
    {"--quiet", "Output", kByType, kAny},

    {"--speed", "Live view and ROS 2", "FACTOR|max", kAny},
    {"--foxglove", "Live view and ROS 2", "PORT", kAny},
    {"--foxglove-address", "Live view and ROS 2", "ADDRESS", kAny},
    {"--foxglove-origin", "Live view and ROS 2", "URL", kAny},
    {"--groot2", "Live view and ROS 2", "PORT", kAny},
    {"--groot2-of", "Live view and ROS 2", "PERSON", kAny},
    {"--ros2", "Live view and ROS 2", kByType, kAny},
    {"--domain", "Live view and ROS 2", "ID", kAny},
    {"--rmw", "Live view and ROS 2", kByType, kAny},
    {"--ros-distro", "Live view and ROS 2", kByType, kAny},
    {"--network", "Live view and ROS 2", kByType, kAny},
    {"--namespace", "Live view and ROS 2", "NAME", kAny},
    {"--also", "Live view and ROS 2", kByType, kAny},
    {"--by-services", "Live view and ROS 2", kByType, kAny},
    {"--ros2-send-goals", "Live view and ROS 2", kByType, kAny},
    {"--lockstep", "Live view and ROS 2", kByType, kAny},
    {"--stamped", "Live view and ROS 2", kByType, kAny},

    {"--script", "Cluster", kByType, kAny},
    {"--chunks", "Cluster", "N", kAny},

    {"--compat", "Advanced", "hunav2|Q-13,…", kAny},
    {"--exact", "Advanced", kByType, kAny},
    {"--strict", "Advanced", kByType, kAny},
    {"--help", "Advanced", kByType, kAny},
    {"--version", "Advanced", kByType, kAny},
};

struct CommandPlace {
  const char* name;
  const char* group;
};

/// In the order of the help.
constexpr CommandPlace kCommands[] = {
    {"run", "Run and measure"},
    {"evaluate", "Run and measure"},
    {"render", "Run and measure"},
    {"futures", "Run and measure"},
    {"contacts", "Run and measure"},
    {"batch", "Studies"},
    {"merge", "Studies"},
    {"report", "Studies"},
    {"sensitivity", "Studies"},
    {"gate", "Studies"},
    {"tune", "Studies"},
    {"search", "Studies"},
    {"pack", "Studies"},
    {"verify", "Studies"},
    {"check", "Scenarios"},
    {"convert", "Scenarios"},
    {"trees", "Scenarios"},
    {"list", "Scenarios"},
    {"validate", "Program"},
    {"bench", "Program"},
    {"serve", "Live view and ROS 2"},
};

}  // namespace

const OptionLayout* optionLayout(const std::string& command, const std::string& option) {
  const OptionLayout* found = nullptr;
  for (const OptionLayout& row : kLayouts) {
    const bool isGeneral = row.command == nullptr;
    if (option == row.name && (isGeneral ? found == nullptr : command == row.command)) {
      found = &row;
      if (!isGeneral) {
        return found;
      }
    }
  }
  return found;
}

std::size_t rankOf(const OptionLayout* layout) {
  return layout == nullptr ? std::size(kLayouts) : static_cast<std::size_t>(layout - kLayouts);
}

std::string groupOfCommand(const std::string& command) {
  for (const CommandPlace& place : kCommands) {
    if (command == place.name) {
      return place.group;
    }
  }
  return "More commands";
}

std::size_t rankOfCommand(const std::string& command) {
  for (const CommandPlace& place : kCommands) {
    if (command == place.name) {
      return static_cast<std::size_t>(&place - kCommands);
    }
  }
  return std::size(kCommands);
}

}  // namespace app
