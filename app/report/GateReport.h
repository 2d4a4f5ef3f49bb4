#pragma once

#include <string>
#include <vector>

#include "app/run/ManifestFiles.h"
#include "app/studies/Gate.h"

/// The results of a gate as files for people and build servers. Deterministic.
namespace report {

struct GateReport {
  std::string headline;  // "PASS: dwa is not worse than pursuit"
  std::string html;      // self-contained page
  std::string markdown;  // for a comment of a pull request
  std::string junit;     // JUnit XML: one test case per metric
  std::string json;
};

/// `command`: the command line of the gate; `inputs`: the files that its runs have read.
GateReport makeGateReport(const app::GateOptions& options, const app::GateResult& result,
                          const std::vector<std::string>& command,
                          const std::vector<app::InputHash>& inputs);

/// The rows of the verdict table as plain text, with a header.
std::vector<std::vector<std::string>> gateRows(const app::GateResult& result);
/// What their columns contain.
std::string gateColumnsText();

}  // namespace report
