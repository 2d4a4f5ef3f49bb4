#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/nav/Body.h"

/// Reference pages that are written from the tables of the program, in Markdown. Pages of metrics
/// and scenario keys: metrics::metricsMarkdown(), sim2d::keysMarkdown().

namespace app {

/// Nodes of agents' trees, then those that only navigator trees of robots may use; with "people",
/// "robots" or "both".
std::vector<std::pair<bt::NodeManifest, const char*>> allNodes();

/// "r 0.35 m" for a disc, otherwise "0.51 x 0.43 m".
std::string robotSizeText(const sim2d::Footprint& footprint);

/// Text for a cell of a table, in which bars separate cells and `<` begins a tag.
std::string markdownCell(const std::string& text);

/// Each planner or pedestrian model with its parameters.
std::string plannersMarkdown();
std::string modelsMarkdown();
/// The robot types with size, limits and sources.
std::string robotsMarkdown();
/// Each node with its ports and an example in XML.
std::string nodesMarkdown();
/// All problems by their ids, in sections by area.
std::string problemsMarkdown();

}  // namespace app
