#pragma once

#include <string>
#include <vector>

#include "app/cli/CommandRegistry.h"
#include "app/run/Batch.h"

namespace app {

/// `check --certify` and `check --verify`.
struct CertifyOptions {
  bool certify = false, verify = false;
  bool all = false;  // all shipped scenarios with a card
  int jobs = processorCount();
  int seeds = 10;                     // number of seeds
  int firstSeed = 1001;               // of the seeds for evaluation
  std::vector<std::string> planners;  // empty: the default planners

  bool isGiven() const { return certify || verify; }
};

/// Adds the options to the command.
void addCertifyOptions(CLI::App& command, CertifyOptions& options);

/// Certifies scenarios and writes their certificates, or repeats the runs of existing ones. Exit
/// code 1: a scenario is not certified, or a certificate differs.
int certifyCommand(const std::vector<std::string>& files, const CertifyOptions& options,
                   const Invocation& given);

}  // namespace app
