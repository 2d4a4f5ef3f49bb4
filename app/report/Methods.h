#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/Study.h"

/// The end of the methods section of a page: versions, input files and commands of its results.
namespace report {

/// A name with its value: a version, a file with its SHA-256.
using Fact = std::pair<std::string, std::string>;
/// A file with its SHA-256 each.
void addInputs(const std::vector<app::InputHash>& inputs, std::vector<Fact>& facts);

/// Markup of a list of facts (those without a value are left out) and the command lines, one per
/// line; without commands only the list.
std::string provenanceMarkup(const std::vector<Fact>& facts, const std::string& commands);
/// The same with this program, the input files and one command line.
std::string provenanceMarkup(const std::vector<app::InputHash>& inputs,
                             const std::vector<std::string>& command);
/// The same of a study: versions, input files, seeds and drawn values.
std::string provenanceMarkup(const Study& study, const std::string& commands);

}  // namespace report
