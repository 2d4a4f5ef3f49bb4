#include "bt/robot/Nav2ParamFiles.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace bt {
namespace {

using sim2d::nav2::Nav2ReadOptions;
using sim2d::nav2::Nav2ReadResult;
using sim2d::nav2::ParameterFile;

/// A plugin class that is set outside the files changes which keys are read.
bool isPlugin(const std::string& path) {
  return path.find("plugin") != std::string::npos;
}

}  // namespace

Nav2ParamFiles::Nav2ParamFiles(const std::vector<std::string>& entries, const std::string& folder,
                               const Nav2Folders& shipped) {
  const bool hasFile = std::any_of(entries.begin(), entries.end(), [](const std::string& entry) {
    return !sim2d::nav2::parameterOverride(entry);
  });
  if (!hasFile) {
    addFile({}, folder, shipped);
  }
  for (const std::string& entry : entries) {
    if (auto single = sim2d::nav2::parameterOverride(entry)) {
      entries_.push_back({std::nullopt, *std::move(single)});
      overrides_.push_back(entry);
    } else {
      addFile(entry, folder, shipped);
    }
  }
}

void Nav2ParamFiles::addFile(const std::string& named, const std::string& folder,
                             const Nav2Folders& shipped) {
  const std::string path = nav2ParamsFile(named, folder, shipped);
  if (path.empty()) {
    problems_.push_back(missingNav2ParamsFile(named, folder, shipped));
    return;
  }
  paths_.push_back(path);
  base::Result<ParameterFile> file = ParameterFile::read(path);
  base::append(problems_, file.diagnostics());
  if (file) {
    entries_.push_back({*std::move(file)});
  }
}

ParameterFile Nav2ParamFiles::merged() const {
  ParameterFile all;
  for (const Entry& entry : entries_) {
    if (entry.file) {
      all.append(*entry.file);
    }
  }
  return all;
}

ParameterFile Nav2ParamFiles::overridden(Nav2ReadResult reading, const Nav2ReadOptions& options,
                                         base::Diagnostics& wrong) const {
  ParameterFile all;
  for (const Entry& entry : entries_) {
    if (entry.file) {
      all.append(*entry.file);
      continue;
    }
    base::append(wrong, overrideNav2Value(all, reading, entry.single));
    if (isPlugin(entry.single.name)) {
      ParameterFile so = merged();
      so.append(all);
      reading = readNav2Parameters(so, options);
    }
  }
  return all;
}

Nav2ReadResult Nav2ParamFiles::read(const std::vector<std::pair<std::string, std::string>>& values,
                                    Nav2ReadOptions options, base::Diagnostics& wrong) const {
  ParameterFile file = merged();
  Nav2ReadResult reading = readNav2Parameters(file, options);
  if (values.empty() && overrides_.empty()) {
    return reading;
  }
  const bool isGuessed = reading.parameters.isGuessed;
  std::vector<std::string> reasons = std::move(reading.parameters.distroReasons);
  options.distro = reading.parameters.distro;  // from the unmodified files
  if (!overrides_.empty()) {
    file = overridden(std::move(reading), options, wrong);
    reading = readNav2Parameters(file, options);
  }
  for (const auto& [path, yaml] : values) {
    base::append(wrong, setNav2Value(file, reading, path, yaml));
    if (isPlugin(path)) {
      reading = readNav2Parameters(file, options);
    }
  }
  reading = readNav2Parameters(file, options);
  reading.parameters.isGuessed = isGuessed;
  reading.parameters.distroReasons = std::move(reasons);
  return reading;
}

}  // namespace bt
