#pragma once

#include <string>
#include <vector>

#include "metrics/RunResults.h"
#include "sim2d/trace/Trace.h"

namespace report {

/// The complete HTML page; `withPlayer` includes the player script.
std::string htmlPage(const std::string& title, const std::string& body, bool withPlayer);
/// The HTML of the player with the data of runs (JSON).
std::string playerMarkup(const std::vector<std::string>& runs);

/// A page with a player for one run. `contacts`: as for playerJson().
std::string playerPage(const sim2d::Trace& trace,
                       const std::vector<metrics::RobotContact>& contacts,
                       const std::string& title);

// The files of resources/report, embedded by the build.
// HTML templates with placeholders {{name}}:
extern const char* const kPageText;        // every page
extern const char* const kRunText;         // body of the page of one run
extern const char* const kPlayerPageText;  // player
extern const char* const kStudyText;       // head of the page of a study
extern const char* const kMethodsText;     // section "Methods" of the page of a study
extern const char* const kMorrisText;      // the same of a sensitivity analysis with its method:
extern const char* const kSobolText;
extern const char* const kReferencesText;  // BibTeX entries of HuNavSim and of this program

extern const char* const kStyleText;   // CSS
extern const char* const kReportText;  // script of every page
extern const char* const kPlayerText;  // script of the player

}  // namespace report
