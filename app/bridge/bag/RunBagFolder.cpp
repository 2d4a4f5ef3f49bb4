#include "app/bridge/bag/RunBagFolder.h"

#include <filesystem>

namespace bridge {

namespace fs = std::filesystem;

RunBagFolder::RunBagFolder(const std::string& staging, const sim2d::Scenario& scenario,
                           const sim2d::World& world)
    : bag_((fs::path(staging) / kBagFiles[0]).string(), world.header(), lidarsOf(scenario),
           [&world] { return world.header(); }) {}

base::Diagnostics RunBagFolder::finish(app::OutputFolder& output,
                                       const sim2d::TraceHeader& header) {
  base::Diagnostics problems = bag_.finish(header);
  const std::string name = fs::path(kBagFiles[0]).filename().string();
  base::append(problems, output.write(kBagFiles[1], bag_.metadata(name)));
  base::append(problems, output.write(kBagFiles[2], foxgloveLayout()));
  return problems;
}

}  // namespace bridge
